// Corners of a cylinder with flat ends.

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: place along the axis in units of half its length, and off it in radii; then the unit normal along
// the axis and off it.
fn corner_place(corner: Corner, body: Body) -> Shape {
    let along = all_spaced(vec3f(0.0, 0.0, corner.profile.x), halves(body), body).z;
    let place = vec3f(corner.turn * corner.profile.y * halves(body).xy, along);
    let normal = vec3f(corner.turn * corner.profile.w, corner.profile.z);
    return Shape(rest_from_body(place, body), rest_from_body(normal, body));
}
