// The frame: one aperture's camera and the speed, and the rest-frame ray of a pixel.
//
// Physics uses only + - * / and sqrt, whose accuracy WGSL bounds; whatever needs more is computed in f64
// on the CPU and arrives here.

struct Frame {
    // Line of sight (unnormalised) = base + right * (u - pole.x) + down * (v - pole.y), u and v in pixels.
    // The pole is the pixel towards -x when that is in front of the camera: there n_y and n_z are small,
    // matter relatively, and must not come out of a difference.
    base: vec4f,
    right: vec4f,
    down: vec4f,
    // xy: the pole, px; zw: what f32 loses of it.
    pole: vec4f,
    // beta, 1 - beta, 1/gamma, gamma.
    speed: vec4f,
    // 2^exposure, intensity exponent, log2 of the colour table's first wavelength, table entries per octave.
    light: vec4f,
    // Camera x and y, height of the ground above the camera, whether there is a ground (1) or not (0).
    ground: vec4f,
}

@group(0) @binding(0) var<uniform> frame: Frame;

// 0 as seen, 1 contracted only, 2 at rest.
override GEOMETRY: u32 = 0u;

struct Ray {
    // Unit vector towards the source in the rest frame; the ray starts at the origin.
    direction: vec3f,
    // Its change from one pixel to the next, to the right and down.
    along_u: vec3f,
    along_v: vec3f,
    // Ground distance per rest-frame distance.
    ground_per_rest: f32,
    doppler: f32,
}

struct LineOfSight {
    n: vec3f,
    along_u: vec3f,
    along_v: vec3f,
}

fn line_of_sight(pixel: vec2f) -> LineOfSight {
    let offset = (pixel - frame.pole.xy) - frame.pole.zw;
    let unnormalised = frame.base.xyz + frame.right.xyz * offset.x + frame.down.xyz * offset.y;
    let scale = 1.0 / sqrt(dot(unnormalised, unnormalised));
    let n = unnormalised * scale;
    let along_u = (frame.right.xyz - n * dot(n, frame.right.xyz)) * scale;
    let along_v = (frame.down.xyz - n * dot(n, frame.down.xyz)) * scale;
    return LineOfSight(n, along_u, along_v);
}

// Aberration: n* = (n_x + beta, n_y/gamma, n_z/gamma)/(1 + beta n_x), D = 1/(gamma (1 + beta n_x)).
fn seen_ray(sight: LineOfSight) -> Ray {
    let n = sight.n;
    let beta = frame.speed.x;
    let gamma = frame.speed.w;
    var numerator = n.x + beta;
    var denominator = 1.0 + beta * n.x;
    if n.x < 0.0 {
        // 1 + n_x = (n_y^2 + n_z^2)/(1 - n_x): sums of positive terms where the printed forms cancel.
        let one_plus_x = (n.y * n.y + n.z * n.z) / (1.0 - n.x);
        numerator = one_plus_x - frame.speed.y;
        denominator = frame.speed.y + beta * one_plus_x;
    }
    let doppler = frame.speed.z / denominator;
    let direction = vec3f(numerator / denominator, n.y * doppler, n.z * doppler);
    return Ray(
        direction,
        aberrated_change(direction, doppler, beta * gamma, sight.along_u),
        aberrated_change(direction, doppler, beta * gamma, sight.along_v),
        doppler,
        doppler,
    );
}

// The differential of aberration; conformal, with scale D.
fn aberrated_change(direction: vec3f, doppler: f32, beta_gamma: f32, change: vec3f) -> vec3f {
    let transverse = doppler * (change.yz - beta_gamma * direction.yz * change.x);
    return vec3f(doppler * doppler * change.x, transverse);
}

// The contracted body stretched back to its rest shape, and the rays with it.
fn contracted_ray(sight: LineOfSight) -> Ray {
    let stretch = vec3f(frame.speed.w, 1.0, 1.0);
    let stretched = sight.n * stretch;
    let ground_per_rest = 1.0 / sqrt(dot(stretched, stretched));
    let direction = stretched * ground_per_rest;
    let u = sight.along_u * stretch * ground_per_rest;
    let v = sight.along_v * stretch * ground_per_rest;
    return Ray(
        direction,
        u - direction * dot(direction, u),
        v - direction * dot(direction, v),
        ground_per_rest,
        1.0,
    );
}

fn rest_ray(pixel: vec2f) -> Ray {
    let sight = line_of_sight(pixel);
    if GEOMETRY == 0u {
        return seen_ray(sight);
    }
    if GEOMETRY == 1u {
        return contracted_ray(sight);
    }
    return Ray(sight.n, sight.along_u, sight.along_v, 1.0, 1.0);
}

// Depth of a ground distance: 1 at the camera, 0 at infinity, with f32's relative resolution all the way.
fn depth(ground_distance: f32) -> f32 {
    return 1.0 / (1.0 + max(ground_distance, 0.0));
}
