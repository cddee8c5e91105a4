// Corners of a tube with rounded ends, or of a ball.

struct Shape {
    place: vec3f,
    normal: vec3f,
}

// profile: place along the axis in units of its extent, then the unit normal along and off the axis.
fn corner_place(corner: Corner, solid: Solid, outward: vec3f) -> Shape {
    let axis = solid.axis_extent.xyz;
    let normal = axis * corner.profile.y + outward * corner.profile.z;
    let place = axis * (corner.profile.x * solid.axis_extent.w) + normal * solid.anchor_radius.w;
    return Shape(place, normal);
}
