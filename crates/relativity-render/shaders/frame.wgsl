// The frame: one aperture's camera, and how one group of bodies moves and where it is.
//
// Physics uses only + - * / and sqrt, whose accuracy WGSL bounds; whatever needs more is computed in f64
// on the CPU and arrives here.

// Samples of a pixel beside each other, where each is drawn as a pixel of its own; else 1.
override ACROSS: u32;

struct FrameUniform {
    // Line of sight (unnormalised) = base + right * (u - pole.x) + down * (v - pole.y), u and v in pixels; of
    // a conformal picture see `conformal_line`. The pole is the pixel towards where the group comes from (-x,
    // if it moves along +x) when that is in front of the camera: there n_y and n_z are small, matter
    // relatively, and must not come out of a difference. base.w: the size of a pixel in focal lengths, or in
    // u and v.
    base: vec4f,
    right: vec4f,
    down: vec4f,
    // Unit vector from the baseline to the pole, of a conformal picture.
    radial: vec4f,
    // xy: the pole, px; zw: what f32 loses of it.
    pole: vec4f,
    // Of the group against the camera: beta, 1 - beta, 1/gamma, gamma.
    speed: vec4f,
    // 1, or -1 if the group moves towards -x: all is reflected then, to move along +x, and back; the same for
    // the reference of depths. z: 1 if the picture is conformal. w: 1, or -1 if the group moves towards -x on
    // the ground.
    motion: vec4f,
    // 1 if a group of the picture moves past the camera otherwise than along x; the same of the street. All
    // vectors before the camera are in the axes along the group's motion then, and `motion` is 1.
    oblique: vec4f,
    // Unit vectors along the motion, in the group's axes.
    group_axes: mat3x3f,
    // From these vectors before the camera to those of the reference, and to axes along the street's motion;
    // unit vectors along that, in the ground's axes.
    reference_axes: mat3x3f,
    to_street: mat3x3f,
    street_axes: mat3x3f,
    // Of what rides along otherwise than along the street: what its place from the camera, and its distance,
    // add to its height on the ground.
    rising: vec4f,
    // beta, 1 - beta, 1/gamma, gamma on the ground.
    on_ground: vec4f,
    // xyz: where the camera is from the middle between the eyes, where these have one light cone, else 0; in
    // axes along the group's motion. And the same along the reference's.
    eye: vec4f,
    reference_eye: vec4f,
    // `speed` and `middle` of the reference, this in axes along its motion in a picture of oblique motion.
    reference_speed: vec4f,
    reference_middle: vec4f,
    // xyz: middle of the group from the camera's event, rest frame; w: 1/(2 reach), reach being the
    // greatest distance of any body's surface from that middle.
    middle: vec4f,
    // xyz: what f32 loses of the middle, which matters however far it is: across a ray, all of it does not.
    middle_fine: vec4f,
    // Camera x and y, height of the ground above the camera (far below if there is none), and
    // the published model's aperture separation.
    ground: vec4f,
    // xy: y of the near and the far kerb of a road, equal where there is none; z: y of house fronts from the
    // camera.
    road: vec4f,
    // Of the street against the camera: V, 1 - V, 1/Gamma, Gamma; -1 if it moves towards -x, else 1, its
    // GEOMETRY, and the row of its colours.
    street_speed: vec4f,
    street_motion: vec4f,
    // How much the Doppler factor moves the place in that row, and the row's logarithm counts; the exponent
    // of the Doppler factor; log2 of the exposure.
    street_light: vec4f,
    // Of bodies: log2 of the exposure, and the exposure.
    exposure: vec4f,
    // xyz: from the middle between the eyes to the camera, where these have one light cone, else 0; w: how
    // many places there are where bodies touch a road.
    contact_eye: vec4f,
    // Two of each, as OpenGL ES 3.0 has no arrays of arrays: where it is from the camera, its distance from
    // the middle, gamma v; half the length and the width of its shadow, both squared, and gamma.
    contacts: array<vec4f, 16>,
    // Of houses in turn, and of all together: height, and shade of the walls.
    houses: array<vec4f, 4>,
    // What is let into the walls: from where, how long, lowest, highest.
    openings: array<vec4f, 4>,
    // Linear sRGB: horizon, zenith, ground, its grid's lines, the paint on it, a road; walls, frames, glass,
    // doors, shops.
    backdrop: array<vec4f, 11>,
    // Of the hatch: the period, px, its reciprocal times cos 45 degrees, half the width of a line, px, and
    // what is added on lines; between them the colour of infrared, and the grey of ultraviolet.
    hatch: array<vec4f, 2>,
    // Products with an apparent position give its clip coordinates x, y and w. In a conformal picture the
    // unit vectors along the baseline, up and ahead. w: the clip coordinates of a focal length, or of a unit
    // of u and a radian of v; and u in the middle.
    clip_right: vec4f,
    clip_up: vec4f,
    forward: vec4f,
}

@group(0) @binding(0) var<uniform> frame: FrameUniform;

// Whether the picture is conformal.
override CONFORMAL: bool;

// sinh and cosh - 1 of the first number, sin and cos - 1 of the second.
struct Arcs {
    sines: vec2f,
    versines: vec2f,
}

// 1 + a x (1 + b x (1 + c x (1 + d x))).
fn series(x: vec2f, factors: vec4f) -> vec2f {
    let last = 1.0 + factors.w * x;
    return 1.0 + factors.x * x * (1.0 + factors.y * x * (1.0 + factors.z * x * last));
}

// Of numbers up to 6: both from the series of a quarter of them, doubled twice. No sum cancels, so that small
// ones keep all their digits.
fn arcs(angles: vec2f) -> Arcs {
    let quarters = 0.25 * angles;
    let square = vec2f(quarters.x * quarters.x, -quarters.y * quarters.y);
    // Products with constants: a software GPU really divides, at several times the cost.
    var sines = quarters * series(square, vec4f(1.0 / 6.0, 1.0 / 20.0, 1.0 / 42.0, 1.0 / 72.0));
    var versines = 0.5 * square * series(square, vec4f(1.0 / 12.0, 1.0 / 30.0, 1.0 / 56.0, 1.0 / 90.0));
    for (var i = 0; i < 2; i++) {
        sines = 2.0 * sines * (1.0 + versines);
        versines = 2.0 * versines * (2.0 + versines);
    }
    return Arcs(sines, versines);
}

// cosh u times the line of sight at this much u and v from the pole: with w half of that u and P at the pole,
// sinh(P + 2 w) = sinh P + sinh w (e^P e^w + e^-P e^-w).
fn conformal_line(from_pole: vec2f) -> vec3f {
    let half = arcs(0.5 * from_pole);
    let grown = 1.0 + half.versines.x + abs(half.sines.x);
    let grows = from_pole.x >= 0.0;
    let powers = select(vec2f(1.0 / grown, grown), vec2f(grown, 1.0 / grown), grows);
    let along = half.sines.x * (frame.right.w * powers.x + frame.down.w * powers.y);
    let sine = 2.0 * half.sines.y * (1.0 + half.versines.y);
    let versine = -2.0 * half.sines.y * half.sines.y;
    return frame.base.xyz + frame.clip_right.xyz * along + frame.radial.xyz * versine + frame.down.xyz * sine;
}

// How any line of sight moves to the next pixel on the right, up to multiples of itself: of a conformal
// picture, dn/du = b - n (n . b) without its second part, b along the baseline.
fn step_right_but_along() -> vec3f {
    if CONFORMAL {
        return frame.clip_right.xyz * frame.base.w;
    }
    return frame.right.xyz;
}

// How the line of sight `sight` (unit vector) moves to the next pixel on the right and below. What is along
// it does not count, and is 0 in a conformal picture, where none of them comes out of a difference.
fn step_right(sight: vec3f) -> vec3f {
    if CONFORMAL {
        let along = frame.clip_right.xyz;
        let cosine = dot(sight, along);
        let across = sight - along * cosine;
        return (along * dot(across, across) - across * cosine) * frame.base.w;
    }
    return frame.right.xyz;
}

fn step_down(sight: vec3f) -> vec3f {
    if CONFORMAL {
        return cross(sight, frame.clip_right.xyz) * frame.base.w;
    }
    return frame.down.xyz;
}

// xyz: unit vector towards the source; w: 1/length of the unnormalised line of sight, by which steps to the
// next pixels are multiplied; those of a conformal picture are not.
fn line_of_sight(pixel: vec2f) -> vec4f {
    if CONFORMAL {
        let from_pole = ((pixel - frame.pole.xy) - frame.pole.zw) * vec2f(frame.base.w, -frame.base.w);
        let line = conformal_line(from_pole);
        return vec4f(line * (1.0 / sqrt(dot(line, line))), 1.0);
    }
    let offset = (pixel - frame.pole.xy) - frame.pole.zw;
    let unnormalised = frame.base.xyz + frame.right.xyz * offset.x + frame.down.xyz * offset.y;
    let scale = 1.0 / sqrt(dot(unnormalised, unnormalised));
    return vec4f(unnormalised * scale, scale);
}
