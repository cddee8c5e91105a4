// Corners of a model's triangles, divided, and what their pixels show. `MeshInstance.pattern` is as
// `Piece.pattern`.

// Corners have the record of their triangle in the place of a normal.
const HAS_NORMALS = false;

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: place from the middle of the model's box, along its axes; turn: the record of the triangle in
// thousands (of 4096) and ones, which are small enough to come out of an interpolation as they are. They
// stand in the place of a normal.
fn corner_place(corner: Corner, body: Body) -> Shape {
    return Shape(rest_from_body(corner.profile.xyz, body), vec3f(corner.turn, 0.0));
}

// Of triangles that are seen from one side, those that show the other are not drawn: where the pixel has a
// straight ray that says which it is, since the image of a triangle that is seen aslant may be turned by less
// than the bound.
fn prepare(fragment: Fragment, is_front: bool) {
    let body = body_of(fragment);
    let spin = spin_of(fragment.spin, fragment.rim);
    let there = standing(body, fragment.place, spin);
    current = triangle_at(u32(fragment.pattern.x), record_in(fragment));
    current_place = body_from_rest(there.place, there.body);
    current_from_hub = (middle(body) - spin.hub) + fragment.place;
    let outside = outward(current);
    var is_seen = is_front;
    if MAP < 3u {
        var passes = rest_ray(pixel_at(fragment.position)).direction;
        if TURNS == 2u {
            // As somebody finds it who turns with the model.
            passes += velocity_at(current_from_hub, spin) * dot(later(current_from_hub, spin).slowness, passes);
        }
        is_seen = dot(rest_from_body(outside, there.body), passes) < 0.0;
    }
    if !is_seen && fragment.pattern.y == 0.0 {
        discard;
    }
    current_normal = select(-outside, outside, is_seen);
}

fn record_in(fragment: Fragment) -> u32 {
    let parts = vec2u(round(fragment.normal.xy));
    return parts.x * 4096u + parts.y;
}

fn normal_in(fragment: Fragment) -> vec3f {
    return rest_from_body(current_normal, standing(body_of(fragment), fragment.place, spin_of(fragment.spin, fragment.rim)).body);
}

// The weights of the triangle's corners where it is seen.
fn weights_in(body: Body, place: vec3f) -> vec3f {
    let first = body_from_rest(place, body) - current.a;
    let u = current.b - current.a;
    let v = current.c - current.a;
    let scale = 1.0 / max(max(length_of_largest(u), length_of_largest(v)), 1e-30);
    let across = cross(u * scale, v * scale);
    let divisor = max(dot(across, across), 1e-30);
    let second = dot(cross(first * scale, v * scale), across) / divisor;
    let third = dot(cross(u * scale, first * scale), across) / divisor;
    let weights = clamp(vec3f(1.0 - second - third, second, third), vec3f(0.0), vec3f(1.0));
    return weights / (weights.x + weights.y + weights.z);
}

fn is_hole(fragment: Fragment, measure: Measure) -> bool {
    if cutoff_at(u32(fragment.pattern.x), record_in(fragment)) == 0u {
        return false;
    }
    let there = standing(body_of(fragment), measure.place, spin_of(fragment.spin, fragment.rim));
    return !is_solid(u32(fragment.pattern.x), record_in(fragment), weights_in(there.body, there.place));
}

fn paint_in(fragment: Fragment, measure: Measure) -> vec4f {
    let there = standing(body_of(fragment), measure.place, spin_of(fragment.spin, fragment.rim));
    let body = there.body;
    let shares = weights_in(body, there.place);
    let row = u32(fragment.pattern.x);
    let record = record_in(fragment);
    let normal = body_from_rest(measure.normal, body);
    let paint = paint_at(row, record, shares)
        * texture_at(row, record, shares, body, measure.ray, normal, measure.distance, 1.0);
    return vec4f(paint, material_at(row, record));
}

fn part_in(fragment: Fragment) -> f32 {
    return f32(current.number);
}
