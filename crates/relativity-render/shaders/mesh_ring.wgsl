// Corners of a ring.

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: unit normal off and along the axis.
fn corner_place(corner: Corner, body: Body, across: vec3f) -> Shape {
    let axis = body.form.xyz;
    let outward = corner.turn.x * across + corner.turn.y * cross(axis, across);
    let normal = outward * corner.profile.x + axis * corner.profile.y;
    return Shape(outward * body.form.w + normal * body.radius, normal);
}
