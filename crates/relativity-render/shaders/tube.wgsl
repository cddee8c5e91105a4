// Ray against a cylinder with rounded ends: `place` and `form` are their centres. A ball has both in one
// place.

// Whether `around` is all of it.
const IS_TUBE = true;

fn middle(body: Body) -> vec3f {
    return 0.5 * (body.place + body.form.xyz);
}

fn around(body: Body) -> Capsule {
    return Capsule(body.place, body.form.xyz, body.radius);
}

fn surface(body: Body, ray: Ray) -> Surface {
    let n = ray.direction;
    let anchor = middle(body);
    let half = 0.5 * (body.form.xyz - body.place);
    let extent = sqrt(dot(half, half));
    let axis = half / max(extent, 1e-30);
    // The ray is nearest + s n, from the middle, with nearest perpendicular to n.
    let nearest = nearest_to(anchor, ray);
    let cosine = dot(axis, n);
    let across = cross(axis, n);
    let sine = max(sqrt(dot(across, across)), 1e-9);
    let nearest_along = dot(nearest, axis);
    // Where on the axis (as a line) the ray comes closest.
    let closest = nearest_along / (sine * sine);

    let on_segment = clamp(closest, -extent, extent);
    let miss_vector = nearest + (n * cosine - axis) * on_segment;
    let miss = sqrt(dot(miss_vector, miss_vector));
    let outward = miss_vector / max(miss, 1e-30);

    let line_miss = abs(dot(nearest, across)) / sine;
    let half_chord = sqrt(max((body.radius - line_miss) * (body.radius + line_miss), 0.0)) / sine;
    let s = closest * cosine - half_chord;
    var beyond = dot(anchor, n) + s;
    var place = nearest + n * s;
    let along = nearest_along + s * cosine;
    if abs(along) >= extent {
        // From the end itself: tubes that share a rounded end get the same depth there to the bit.
        let end = select(body.form.xyz, body.place, along < 0.0);
        let from_end = nearest_to(end, ray);
        let depth_squared = body.radius * body.radius - dot(from_end, from_end);
        let half_cap = sqrt(max(depth_squared, 0.0));
        beyond = dot(end, n) - half_cap;
        place = (end - anchor) + (from_end - n * half_cap);
    }
    var normal = outward;
    if miss < body.radius {
        let from_axis = place - axis * clamp(dot(place, axis), -extent, extent);
        normal = from_axis / max(sqrt(dot(from_axis, from_axis)), 1e-30);
    }
    return Surface(body.radius - miss, body.radius, outward, beyond, place, normal);
}

// The normal by which a pattern is looked up.
fn normal_at(body: Body, place: vec3f, normal: vec3f) -> vec3f {
    return normal;
}

fn darkness(body: Body, pattern: vec3f, place: vec3f, normal: vec3f, covered: Covered) -> f32 {
    let length = body.form.xyz - body.place;
    let half = 0.5 * sqrt(dot(length, length));
    let off_axis = max(sqrt(dot(place.xy, place.xy)), 1e-30);
    let outward = vec3f(place.xy / off_axis, 0.0);
    let beyond = place.z - clamp(place.z, -half, half);
    let arc = arc_to(off_axis, outward, beyond, body.radius);
    let chart = Chart(
        half + (place.z - beyond) + arc.length,
        arc.gradient,
        angle_to(place.y, place.x),
        vec3f(-outward.y, outward.x, 0.0) / off_axis,
        off_axis,
        place.z - normal.z * NUDGE * pattern.y + half,
        vec3f(0.0, 0.0, 1.0),
    );
    return darkness_of_chart(chart, pattern, covered);
}
