// A body, and where a ray meets it. Each shape has `middle(body)` and `surface(body, ray)`.

struct Body {
    // From the middle of its group: its centre, or one end of a tube.
    place: vec3f,
    radius: f32,
    // The other end of a tube, or a ring's unit axis and the radius of its middle circle.
    form: vec4f,
    // Unit quaternion from the body's own axes to those of the rest frame.
    turn: vec4f,
}

struct Surface {
    // How far inside the outline the ray passes, rest-frame length at the surface; negative outside.
    clearance: f32,
    // Unit vector from the body to the ray where they come closest: across the outline.
    outward: vec3f,
    // Rest-frame distance along the ray beyond the middle of its group.
    beyond: f32,
    // The point, from the body's middle.
    place: vec3f,
    normal: vec3f,
}

// `v` turned by the unit quaternion `turn`.
fn turned(v: vec3f, turn: vec4f) -> vec3f {
    let twist = 2.0 * cross(turn.xyz, v);
    return v + turn.w * twist + cross(turn.xyz, twist);
}

// From the body's own axes to those of the rest frame.
fn rest_from_body(v: vec3f, body: Body) -> vec3f {
    return turned(v, body.turn);
}

// And back.
fn body_from_rest(v: vec3f, body: Body) -> vec3f {
    return turned(v, vec4f(-body.turn.xyz, body.turn.w));
}
