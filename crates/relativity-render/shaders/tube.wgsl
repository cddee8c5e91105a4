// Ray against a cylinder with rounded ends. `anchor` is its middle, `extent` half the length of its axis.

fn surface(body: Body, ray: Ray) -> Surface {
    let n = ray.direction;
    let axis = body.axis;
    // The ray is nearest + s n, from the middle, with nearest perpendicular to n.
    let nearest = nearest_to(body.anchor, ray);
    let cosine = dot(axis, n);
    let across = cross(axis, n);
    let sine = max(sqrt(dot(across, across)), 1e-9);
    let nearest_along = dot(nearest, axis);
    // Where on the axis (as a line) the ray comes closest.
    let closest = nearest_along / (sine * sine);

    let on_segment = clamp(closest, -body.extent, body.extent);
    let miss_vector = nearest + (n * cosine - axis) * on_segment;
    let miss = sqrt(dot(miss_vector, miss_vector));
    let outward = miss_vector / max(miss, 1e-30);

    let line_miss = abs(dot(nearest, across)) / sine;
    let half_chord = sqrt(max((body.radius - line_miss) * (body.radius + line_miss), 0.0)) / sine;
    var s = closest * cosine - half_chord;
    let along = nearest_along + s * cosine;
    let foot = axis * clamp(along, -body.extent, body.extent);
    if abs(along) > body.extent || line_miss >= body.radius {
        s = cap_entry(nearest - foot, n, body.radius);
    }
    let place = nearest + n * s;
    var normal = outward;
    if miss < body.radius {
        let from_axis = place - axis * clamp(dot(place, axis), -body.extent, body.extent);
        normal = from_axis / max(sqrt(dot(from_axis, from_axis)), 1e-30);
    }
    return Surface(body.radius - miss, outward, dot(body.anchor, n) + s, place, normal);
}

// Where the ray start + s n enters the ball of `radius` around the origin, or comes closest to it.
fn cap_entry(start: vec3f, n: vec3f, radius: f32) -> f32 {
    let along = dot(start, n);
    let nearest = start - n * along;
    return -along - sqrt(max(radius * radius - dot(nearest, nearest), 0.0));
}
