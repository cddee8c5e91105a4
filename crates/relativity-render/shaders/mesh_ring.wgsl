// Corners of a ring.

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: unit normal off and along the axis.
fn corner_place(corner: Corner, solid: Solid, outward: vec3f) -> Shape {
    let normal = outward * corner.profile.x + solid.axis_extent.xyz * corner.profile.y;
    let place = outward * solid.axis_extent.w + normal * solid.anchor_radius.w;
    return Shape(place, normal);
}
