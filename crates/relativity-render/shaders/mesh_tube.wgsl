// Corners of a tube with rounded ends, or of a ball.

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: place along the axis in units of half its length, then the unit normal along and off the axis.
fn corner_place(corner: Corner, body: Body, across: vec3f) -> Shape {
    let half = 0.5 * (body.form.xyz - body.place);
    let length = sqrt(dot(half, half));
    let axis = select(vec3f(1.0, 0.0, 0.0), half / max(length, 1e-30), length > 0.0);
    let outward = corner.turn.x * across + corner.turn.y * cross(axis, across);
    let normal = axis * corner.profile.y + outward * corner.profile.z;
    return Shape(half * corner.profile.x + normal * body.radius, normal);
}
