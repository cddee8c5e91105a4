// How a line of sight passes what moves evenly.

// How a line of sight passes a group.
struct Passage {
    // Unit vector towards the source in the rest frame.
    direction: vec3f,
    // Ground distance per rest-frame distance.
    ground_per_rest: f32,
    doppler: f32,
}

// `v` with x reversed where `sign` is -1.
fn reflected(v: vec3f, sign: f32) -> vec3f {
    return vec3f(v.x * sign, v.yz);
}

// How the line of sight along the unit vector `sight` passes a group of this `speed`, with the `sign` of its
// motion.
fn passage(sight: vec3f, geometry: u32, speed: vec4f, sign: f32) -> Passage {
    if geometry == 0u {
        // Aberration: n* = (n_x + beta, n_y/gamma, n_z/gamma)/(1 + beta n_x), D = 1/(gamma (1 + beta n_x)),
        // from 1 + n_x = (n_y^2 + n_z^2)/(1 - n_x) where the printed forms cancel.
        let n = reflected(sight, sign);
        let transverse_squared = n.y * n.y + n.z * n.z;
        let one_plus_x = select(1.0 + n.x, transverse_squared / (1.0 - n.x), n.x < 0.0);
        let reciprocal = 1.0 / (speed.y + speed.x * one_plus_x);
        let doppler = speed.z * reciprocal;
        let direction = vec3f((one_plus_x - speed.y) * reciprocal, n.yz * doppler);
        return Passage(reflected(direction, sign), doppler, doppler);
    }
    if geometry == 1u {
        // The contracted body stretched back to its rest shape, and the ray with it: by 1 along x and 1/gamma
        // across, brought up to 1 before it is squared.
        let flattened = vec3f(sight.x, sight.yz * speed.z);
        let largest = max(abs(flattened.x), max(abs(flattened.y), abs(flattened.z)));
        let scaled = flattened / largest;
        let reciprocal = 1.0 / sqrt(dot(scaled, scaled));
        return Passage(scaled * reciprocal, speed.z * reciprocal / largest, 1.0);
    }
    return Passage(sight, 1.0, 1.0);
}
