// Models of triangles, and rays against them: the records of `geometry/triangles/packed.rs`, which says what
// is in them.

// Each model begins with a row of its own; rows are a power of two long.
@group(0) @binding(2) var models: texture_2d<u32>;

// Links that wait while others are followed; Rust packs no model that needs more.
const MOST_WAITING = 64u;
const IS_LEAF = 0x80000000u;

// Where a ray meets a triangle.
struct Met {
    // Record of the triangle, with `IS_LEAF` set; 0 where none is met.
    triangle: u32,
    // Along the ray, from its place nearest to the middle of the model.
    distance: f32,
    // Weights of the corners.
    weights: vec3f,
}

struct Triangle {
    // From the middle of the model's box, along its axes.
    a: vec3f,
    b: vec3f,
    c: vec3f,
    number: u32,
}

// A ray in the axes of a model, made ready for triangles: sheared to run along its greatest part, whose axis
// this is.
struct Sheared {
    start: vec3f,
    direction: vec3f,
    axis: u32,
    // Shear across that axis, and scale along it.
    shear: vec3f,
}

// The texel of this number in a record of the model that begins with `row`.
fn texel(row: u32, record: u32, number: u32) -> vec4u {
    return texel_at(row, 4u * record + number);
}

// The texel of this number in the model that begins with `row`.
fn texel_at(row: u32, place: u32) -> vec4u {
    let bits = firstTrailingBit(textureDimensions(models).x);
    return textureLoad(models, vec2u(place & ((1u << bits) - 1u), row + (place >> bits)), 0);
}

fn triangle_at(row: u32, record: u32) -> Triangle {
    let a = texel(row, record, 0u);
    let b = texel(row, record, 1u);
    let c = texel(row, record, 2u);
    return Triangle(bitcast<vec3f>(a.xyz), bitcast<vec3f>(b.xyz), bitcast<vec3f>(c.xyz), a.w);
}

// The paint of a triangle where its corners have these weights: reflectances in linear sRGB.
fn paint_at(row: u32, record: u32, weights: vec3f) -> vec3f {
    let packed = texel(row, record, 3u);
    let first = unpack2x16unorm(packed.x);
    let second = unpack2x16unorm(packed.y);
    let third = unpack2x16unorm(packed.z);
    let fourth = unpack2x16unorm(packed.w);
    let last = unpack2x16unorm(texel(row, record, 1u).w);
    return weights.x * vec3f(first, second.x)
        + weights.y * vec3f(second.y, third)
        + weights.z * vec3f(fourth, last.x);
}

// One more than the number of a triangle's measured material; 0 if it has smooth paint.
fn material_at(row: u32, record: u32) -> f32 {
    return f32(texel(row, record, 1u).w >> 16u);
}

// `v` turned in a circle of its parts, so that the part along `axis` is the last.
fn permuted(v: vec3f, axis: u32) -> vec3f {
    return select(select(v.xyz, v.zxy, axis == 1u), v.yzx, axis == 0u);
}

fn sheared(start: vec3f, direction: vec3f) -> Sheared {
    let steep = abs(direction);
    var axis = select(2u, 1u, steep.y >= steep.z);
    if steep.x >= max(steep.y, steep.z) {
        axis = 0u;
    }
    let along = permuted(direction, axis);
    let scale = 1.0 / along.z;
    return Sheared(start, direction, axis, vec3f(along.xy * scale, scale));
}

fn sheared_corner(corner: vec3f, ray: Sheared) -> vec3f {
    let from_start = permuted(corner - ray.start, ray.axis);
    return vec3f(from_start.xy - ray.shear.xy * from_start.z, ray.shear.z * from_start.z);
}

// On which side of the edge between two corners the ray passes. Both triangles there work it out in the same
// order, so that however products are rounded, or fused with the sum, it is for one what it is not for the
// other.
fn side(first: vec2f, second: vec2f) -> f32 {
    let is_swapped = first.x > second.x || (first.x == second.x && first.y > second.y);
    let p = select(first, second, is_swapped);
    let q = select(second, first, is_swapped);
    let product = q.x * p.y - q.y * p.x;
    let turned = select(product, -product, is_swapped);
    return select(turned, 0.0, all(first == second));
}

// Whether the ray meets the triangle: weights and distance, else a distance that is not above `behind`.
// Reference: Woop, Benthin, Wald, Watertight ray/triangle intersection, as in
// `geometry/triangles/crossing.rs`.
fn met_triangle(ray: Sheared, triangle: Triangle, is_two_sided: bool, behind: f32) -> vec4f {
    let a = sheared_corner(triangle.a, ray);
    let b = sheared_corner(triangle.b, ray);
    let c = sheared_corner(triangle.c, ray);
    let sides = vec3f(side(b.xy, c.xy), side(c.xy, a.xy), side(a.xy, b.xy));
    let sum = sides.x + sides.y + sides.z;
    let is_beside = any(sides < vec3f(0.0)) && any(sides > vec3f(0.0));
    let is_front = sum * ray.shear.z > 0.0;
    if is_beside || sum == 0.0 || !(is_two_sided || is_front) {
        return vec4f(0.0, 0.0, 0.0, behind);
    }
    let weights = sides / sum;
    return vec4f(weights, dot(weights, vec3f(a.z, b.z, c.z)));
}

// Where the ray enters a box and leaves it; of one that holds nothing it leaves before.
fn passed(middle: vec3f, half: vec3f, start: vec3f, reciprocal: vec3f) -> vec2f {
    let centred = (middle - start) * reciprocal;
    let reaches = half * abs(reciprocal);
    let enters = centred - reaches;
    let leaves = centred + reaches;
    return vec2f(max(enters.x, max(enters.y, enters.z)), min(leaves.x, min(leaves.y, leaves.z)));
}

// One over each part of a direction, of which none is taken for 0.
fn reciprocal_of(direction: vec3f) -> vec3f {
    let least = vec3f(1e-12);
    let steep = select(direction, select(least, -least, direction < vec3f(0.0)), abs(direction) < least);
    return 1.0 / steep;
}

// Those of the two boxes below a node that a ray enters: how many, the link to the nearer, and that to the
// other.
struct Entered {
    count: u32,
    nearer: u32,
    other: u32,
}

// The boxes below the node at `link`, larger by `room` on all sides, that a ray is in somewhere between
// `least` and `most` along it.
fn entered(row: u32, link: u32, start: vec3f, reciprocal: vec3f, room: f32, least: f32, most: f32) -> Entered {
    let one = texel(row, link, 0u);
    let other = texel(row, link, 2u);
    let half = bitcast<vec3f>(texel(row, link, 1u).xyz) + room;
    let other_half = bitcast<vec3f>(texel(row, link, 3u).xyz) + room;
    let near = passed(bitcast<vec3f>(one.xyz), half, start, reciprocal);
    let far = passed(bitcast<vec3f>(other.xyz), other_half, start, reciprocal);
    let is_one = near.x <= near.y && near.y >= least && near.x <= most;
    let is_other = far.x <= far.y && far.y >= least && far.x <= most;
    let other_first = !is_one || (is_other && far.x < near.x);
    return Entered(
        u32(is_one) + u32(is_other),
        select(one.w, other.w, other_first),
        select(other.w, one.w, other_first),
    );
}

// The first triangle of the model in `row` that a ray meets further on than `behind`, of equally near ones
// that of the lowest number.
fn first_met(row: u32, start: vec3f, direction: vec3f, behind: f32, is_two_sided: bool) -> Met {
    let ray = sheared(start, direction);
    let reciprocal = reciprocal_of(direction);
    var first = Met(0u, 1e30, vec3f(0.0));
    var number = 0u;
    var waiting: array<u32, MOST_WAITING>;
    var count = 0u;
    var link = 0u;
    loop {
        if (link & IS_LEAF) != 0u {
            let record = link & 0x1fffffffu;
            let last = record + ((link >> 29u) & 3u);
            for (var i = record; i <= last; i++) {
                let triangle = triangle_at(row, i);
                let met = met_triangle(ray, triangle, is_two_sided, behind);
                let is_first = met.w < first.distance || (met.w == first.distance && triangle.number < number);
                if met.w > behind && is_first && is_solid(row, i, met.xyz) {
                    first = Met(IS_LEAF | i, met.w, met.xyz);
                    number = triangle.number;
                }
            }
        } else {
            let below = entered(row, link, start, reciprocal, 0.0, behind, first.distance);
            if below.count > 0u {
                link = below.nearer;
                if below.count == 2u {
                    waiting[count] = below.other;
                    count++;
                }
                continue;
            }
        }
        if count == 0u {
            break;
        }
        count--;
        link = waiting[count];
    }
    return first;
}

// The unit normal of a triangle, on the side from which its corners run counter-clockwise. Lengths are
// brought up to 1 before they are squared.
fn outward(triangle: Triangle) -> vec3f {
    let u = triangle.b - triangle.a;
    let v = triangle.c - triangle.a;
    let largest = max(max(length_of_largest(u), length_of_largest(v)), 1e-30);
    let across = cross(u / largest, v / largest);
    let normal = across / max(length_of_largest(across), 1e-30);
    return normal / max(length(normal), 1e-30);
}

// The same, on the side from which a ray along `direction` comes.
fn normal_of(triangle: Triangle, direction: vec3f) -> vec3f {
    let normal = outward(triangle);
    return normal * -sign_of(dot(normal, direction));
}

fn length_of_largest(v: vec3f) -> f32 {
    return max(abs(v.x), max(abs(v.y), abs(v.z)));
}
