// The sRGB curve, fitted in square roots: within 0.1 of 255 levels, and cheaper than a power.
fn srgb_encoded(linear: vec3f) -> vec3f {
    let root = sqrt(linear);
    let curved = 0.8337236 * root + 0.2981398 * sqrt(root) - 0.0553132 * linear - 0.0769116;
    return select(curved, 12.92 * linear, linear <= vec3f(0.0031308));
}

