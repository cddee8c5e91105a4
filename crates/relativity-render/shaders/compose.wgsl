// One picture from those of two eyes.
//
// Repeats `picture/compose.rs`, which says what is composed how and gives these.

// What is composed: none of these is a clipped mixture.
override HUE_KEPT: bool;
override BY_ROWS: bool;
override HALVES_BESIDE: bool;
override HALVES_ABOVE: bool;

struct Composing {
    // Weights of red, green, blue and the largest of them in each component.
    first: array<vec4f, 3>,
    second: array<vec4f, 3>,
    // x: of interleaved rows, the number of the picture that the topmost is of.
    top: vec4u,
}

@group(0) @binding(0) var<uniform> composing: Composing;
// sRGB-encoded.
@group(0) @binding(1) var first: texture_2d<f32>;
@group(0) @binding(2) var second: texture_2d<f32>;

@vertex
fn whole(@builtin(vertex_index) vertex: u32) -> @builtin(position) vec4f {
    return vec4f(vec2f(f32(vertex & 1u), f32(vertex >> 1u)) * 4.0 - 1.0, 0.5, 1.0);
}

fn srgb_decoded(encoded: vec3f) -> vec3f {
    let curved = pow((encoded + 0.055) / 1.055, vec3f(2.4));
    return select(curved, encoded / 12.92, encoded <= vec3f(0.04045));
}

// The pixel there, or the nearest at the edge.
fn pixel_of(number: u32, place: vec2u) -> vec3f {
    let inside = min(place, textureDimensions(first) - 1u);
    if number == 0u {
        return textureLoad(first, inside, 0).rgb;
    }
    return textureLoad(second, inside, 0).rgb;
}

fn with_largest(encoded: vec3f) -> vec4f {
    let linear = srgb_decoded(encoded);
    return vec4f(linear, max(linear.r, max(linear.g, linear.b)));
}

fn mean(number: u32, place: vec2u, next: vec2u) -> vec3f {
    return 0.5 * (srgb_decoded(pixel_of(number, place)) + srgb_decoded(pixel_of(number, place + next)));
}

fn mixture(place: vec2u) -> vec3f {
    let one = with_largest(pixel_of(0u, place));
    let two = with_largest(pixel_of(1u, place));
    var mixed: vec3f;
    for (var part = 0u; part < 3u; part++) {
        mixed[part] = dot(composing.first[part], one) + dot(composing.second[part], two);
    }
    if HUE_KEPT {
        return mixed / max(1.0, max(mixed.r, max(mixed.g, mixed.b)));
    }
    return clamp(mixed, vec3f(0.0), vec3f(1.0));
}

@fragment
fn compose(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let place = vec2u(position.xy);
    if BY_ROWS {
        return vec4f(pixel_of((place.y + composing.top.x) & 1u, place), 1.0);
    }
    // Halves are of one size.
    let half = (textureDimensions(first) + 1u) / 2u;
    var linear: vec3f;
    if HALVES_BESIDE {
        let number = place.x / half.x;
        linear = mean(number, vec2u(2u * (place.x - number * half.x), place.y), vec2u(1u, 0u));
    } else if HALVES_ABOVE {
        let number = place.y / half.y;
        linear = mean(number, vec2u(place.x, 2u * (place.y - number * half.y)), vec2u(0u, 1u));
    } else {
        linear = mixture(place);
    }
    return vec4f(srgb_encoded(linear), 1.0);
}
