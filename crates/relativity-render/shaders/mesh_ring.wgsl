// Corners of a ring.

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: unit normal off and along the axis.
fn corner_place(corner: Corner, body: Body) -> Shape {
    let outward = rest_from_body(vec3f(corner.turn, 0.0), body);
    let normal = rest_from_body(vec3f(corner.turn * corner.profile.x, corner.profile.y), body);
    return Shape(outward * body.form.w + normal * body.radius, normal);
}
