// The textures of models, by the steps of `geometry/triangles/texture.rs`; `packed.rs` there says how they
// are stored.

// As `Wrap`; copies follow each other where it is neither.
const MIRROR = 1u;
const CLAMP = 2u;

// The colour of a triangle's texture where its corners have these weights, on average over the `share` of a
// pixel that is met along `ray`, at this ground distance, where the normal in the axes of the model is this.
fn texture_at(
    row: u32,
    record: u32,
    weights: vec3f,
    body: Body,
    ray: Ray,
    normal: vec3f,
    distance: f32,
    share: f32,
) -> vec3f {
    let places = texel(row, record, 2u).w;
    if places == 0u {
        return vec3f(1.0);
    }
    let packed = texel_at(row, places);
    let rest = texel_at(row, places + 1u);
    if rest.w != 0u {
        return vec3f(1.0);
    }
    let a = bitcast<vec2f>(packed.xy);
    let to_b = bitcast<vec2f>(packed.zw) - a;
    let to_c = bitcast<vec2f>(rest.xy) - a;
    let covered = covered_by_pixel(ray, normal, distance, body);
    // How fast the place in the texture changes along the triangle, of lengths that are brought up to 1.
    let triangle = triangle_at(row, record);
    let largest = max(max(length_of_largest(triangle.b - triangle.a), length_of_largest(triangle.c - triangle.a)), 1e-30);
    let u = (triangle.b - triangle.a) / largest;
    let v = (triangle.c - triangle.a) / largest;
    let across = cross(u, v);
    let scale = share / (max(dot(across, across), 1e-30) * largest);
    let along = vec2f(
        covered_of(cross(v, across) * to_b.x + cross(across, u) * to_c.x, covered),
        covered_of(cross(v, across) * to_b.y + cross(across, u) * to_c.y, covered),
    );
    return texture_colour(row, texel_at(row, rest.z), a + to_b * weights.y + to_c * weights.z, along * scale);
}

// The least opacity of a triangle's surface, in parts of 65535; 0 where it has no holes.
fn cutoff_at(row: u32, record: u32) -> u32 {
    let places = texel(row, record, 2u).w;
    if places == 0u {
        return 0u;
    }
    return texel_at(row, texel_at(row, places + 1u).z).z >> 16u;
}

// Whether there is a surface where the corners of a triangle have these weights: not in a hole of its
// texture.
fn is_solid(row: u32, record: u32, weights: vec3f) -> bool {
    let cutoff = cutoff_at(row, record);
    if cutoff == 0u {
        return true;
    }
    let places = texel(row, record, 2u).w;
    let packed = texel_at(row, places);
    let rest = texel_at(row, places + 1u);
    let header = texel_at(row, rest.z);
    let a = bitcast<vec2f>(packed.xy);
    let place = a + (bitcast<vec2f>(packed.zw) - a) * weights.y + (bitcast<vec2f>(rest.xy) - a) * weights.z;
    let near = nearest_texels(header.w, header.xy, header.z, place);
    let upper = mix(packed_texel(row, near.texels.x).w, packed_texel(row, near.texels.y).w, near.share.x);
    let lower = mix(packed_texel(row, near.texels.z).w, packed_texel(row, near.texels.w).w, near.share.x);
    return mix(upper, lower, near.share.y) * 65535.0 >= f32(cutoff);
}

// The linear colour at a place of the texture with this `header`, on average over what is `covered` of it
// each way.
fn texture_colour(row: u32, header: vec4u, place: vec2f, covered: vec2f) -> vec3f {
    let texels = covered * vec2f(header.xy);
    let last = f32(firstLeadingBit(max(header.x, header.y)));
    let depth = clamp(log2(max(texels.x, max(texels.y, 1.0))), 0.0, last);
    var side = header.xy;
    var first = header.w;
    for (var level = 0.0; level < floor(depth); level += 1.0) {
        first += side.x * side.y;
        side = max(side / 2u, vec2u(1u));
    }
    let large = between_texels(row, first, side, header.z, place);
    let smaller = max(side / 2u, vec2u(1u));
    // Of one texel there is no smaller copy.
    let next = select(first, first + side.x * side.y, floor(depth) < last);
    let small = between_texels(row, next, smaller, header.z, place);
    return mix(large, small, depth - floor(depth));
}

// The words of the four texels that are nearest to a place, upper left, upper right, and below; and how far
// it is from the upper left one to the others.
struct Nearest {
    texels: vec4u,
    share: vec2f,
}

// The linear colour at a place between the nearest four texels, of which a row has `side.x`.
fn between_texels(row: u32, first: u32, side: vec2u, wraps: u32, place: vec2f) -> vec3f {
    let near = nearest_texels(first, side, wraps, place);
    let upper = mix(linear_texel(row, near.texels.x), linear_texel(row, near.texels.y), near.share.x);
    let lower = mix(linear_texel(row, near.texels.z), linear_texel(row, near.texels.w), near.share.x);
    return mix(upper, lower, near.share.y);
}

fn nearest_texels(first: u32, side: vec2u, wraps: u32, place: vec2f) -> Nearest {
    let wrap = vec2u(wraps & 255u, (wraps >> 8u) & 255u);
    let at = vec2f(near_place(place.x, wrap.x), near_place(place.y, wrap.y)) * vec2f(side) - 0.5;
    let low = floor(at);
    let share = at - low;
    let left = wrapped(i32(low.x), i32(side.x), wrap.x);
    let right = wrapped(i32(low.x) + 1, i32(side.x), wrap.x);
    let top = first + side.x * wrapped(i32(low.y), i32(side.y), wrap.y);
    let bottom = first + side.x * wrapped(i32(low.y) + 1, i32(side.y), wrap.y);
    return Nearest(vec4u(top + left, top + right, bottom + left, bottom + right), share);
}

// The same place of a texture, not far from its first copy: there f32 has more digits for it.
fn near_place(place: f32, wrap: u32) -> f32 {
    let copied = place - 2.0 * floor(0.5 * place);
    return select(copied, clamp(place, -1.0, 2.0), wrap == CLAMP);
}

fn wrapped(number: i32, count: i32, wrap: u32) -> u32 {
    if wrap == CLAMP {
        return u32(clamp(number, 0, count - 1));
    }
    let period = select(count, 2 * count, wrap == MIRROR);
    let there = ((number % period) + period) % period;
    return u32(select(there, min(there, 2 * count - 1 - there), wrap == MIRROR));
}

// Four texels are one of this device's, red in the lowest byte.
fn packed_texel(row: u32, word: u32) -> vec4f {
    let packed = texel_at(row, word >> 2u);
    return unpack4x8unorm(packed[word & 3u]);
}

fn linear_texel(row: u32, word: u32) -> vec3f {
    let encoded = packed_texel(row, word).xyz;
    let above = pow((encoded + 0.055) / 1.055, vec3f(2.4));
    return select(above, encoded / 12.92, encoded <= vec3f(0.04045));
}
