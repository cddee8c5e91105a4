// Corners of a box.

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: place on the cube from -1 to 1, and the number of the axis that its face is across.
fn corner_place(corner: Corner, body: Body) -> Shape {
    let axis = vec3f(vec3i(0, 1, 2) == vec3i(i32(corner.profile.w)));
    let place = corner.profile.xyz;
    return Shape(rest_from_body(all_spaced(place, halves(body), body), body), rest_from_body(place * axis, body));
}
