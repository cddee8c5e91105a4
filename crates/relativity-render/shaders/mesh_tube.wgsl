// Corners of a tube with rounded ends, or of a ball.

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: place along the axis in units of half its length, then the unit normal along and off the axis.
fn corner_place(corner: Corner, body: Body) -> Shape {
    let half = 0.5 * (body.form.xyz - body.place);
    let normal = rest_from_body(vec3f(corner.turn * corner.profile.z, corner.profile.y), body);
    let camera = camera_from_body(body);
    let extent = max(sqrt(dot(half, half)), 1e-30);
    let off = max(sqrt(dot(camera.xy, camera.xy)) - body.radius, 0.0);
    let along = spaced(corner.profile.x, camera.z / extent, off / extent);
    return Shape(half * along + normal * body.radius, normal);
}
