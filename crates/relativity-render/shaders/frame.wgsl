// The frame: one aperture's camera, and how one group of bodies moves and where it is.
//
// Physics uses only + - * / and sqrt, whose accuracy WGSL bounds; whatever needs more is computed in f64
// on the CPU and arrives here.

struct Frame {
    // Line of sight (unnormalised) = base + right * (u - pole.x) + down * (v - pole.y), u and v in pixels.
    // The pole is the pixel towards where the group comes from (-x, if it moves along +x) when that is in front of the
    // camera: there n_y and n_z are small, matter relatively, and must not come out of a difference.
    base: vec4f,
    right: vec4f,
    down: vec4f,
    // xy: the pole, px; zw: what f32 loses of it.
    pole: vec4f,
    // Of the group against the camera: beta, 1 - beta, 1/gamma, gamma.
    speed: vec4f,
    // 1, or -1 if the group moves towards -x: all is reflected then, to move along +x, and back; the same for the
    // reference of depths.
    motion: vec4f,
    // xyz: where the camera is from the middle between the eyes, where these have one light cone, else 0; reflected as the
    // group is; w: 1 if that is not 0. And the same, reflected as the reference is.
    eye: vec4f,
    reference_eye: vec4f,
    // `speed` and `middle` of the reference.
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
    // xy: y of the near and the far kerb of a road, equal where there is none; z: y of house fronts from the camera.
    road: vec4f,
    // Of houses in turn, and of all together: height, and shade of the walls.
    houses: array<vec4f, 4>,
    // What is let into the walls: from where, how long, lowest, highest.
    openings: array<vec4f, 4>,
    // Linear sRGB: horizon, zenith, ground, its grid's lines, the paint on it, a road; walls, frames, glass, doors, shops.
    backdrop: array<vec4f, 11>,
    // Products with an apparent position give its clip coordinates x, y and w.
    clip_right: vec4f,
    clip_up: vec4f,
    forward: vec4f,
}

@group(0) @binding(0) var<uniform> frame: Frame;

// xyz: unit vector towards the source; w: 1/length of the unnormalised line of sight.
fn line_of_sight(pixel: vec2f) -> vec4f {
    let offset = (pixel - frame.pole.xy) - frame.pole.zw;
    let unnormalised = frame.base.xyz + frame.right.xyz * offset.x + frame.down.xyz * offset.y;
    let scale = 1.0 / sqrt(dot(unnormalised, unnormalised));
    return vec4f(unnormalised * scale, scale);
}
