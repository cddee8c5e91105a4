// A body, and where a ray meets it. Each shape has `middle(body)`, `around(body)` and `surface(body, ray)`.

// Whether bodies may be thinner than a pixel: then they are drawn a pixel wide and faded instead.
override THIN: bool;

// Where a fragment is in the picture, px.
fn pixel_at(position: vec4f) -> vec2f {
    return position.xy / f32(ACROSS);
}

struct Body {
    // From the middle of its group: its centre, or one end of a tube.
    place: vec3f,
    // Of a body with flat faces the least of its `halves`.
    radius: f32,
    // The other end of a tube; a ring's unit axis and the radius of its middle circle; half the lengths of a
    // body with flat faces along its own axes, and how far a model that turns reaches from its axle.
    form: vec4f,
    // Unit quaternion from the body's own axes to those of the rest frame.
    turn: vec4f,
}

// A tube with rounded ends.
struct Capsule {
    place: vec3f,
    end: vec3f,
    radius: f32,
}

struct Surface {
    // How far inside the outline the ray passes, rest-frame length at the surface; negative outside.
    clearance: f32,
    // Half the least width that the body is seen with.
    half_width: f32,
    // From the body to the ray where they come closest, across the outline: how fast the clearance falls as
    // the ray moves. A unit vector where the body stands still.
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

// Half its lengths along its own axes, of a body with flat faces: at least `radius`, which is raised where it
// is drawn a pixel wide.
fn halves(body: Body) -> vec3f {
    return max(body.form.xyz, vec3f(body.radius));
}

// A ray in the own axes of a body, from its `place`: the ray is nearest + s direction, and moment their cross
// product.
struct OwnRay {
    direction: vec3f,
    moment: vec3f,
    nearest: vec3f,
}

fn own_ray(body: Body, ray: Ray) -> OwnRay {
    let direction = body_from_rest(ray.direction, body);
    // A ray that passes farther off than bodies are large misses: nearer, no product of its distances
    // overflows.
    let far = vec3f(1e15);
    let moment = clamp(body_from_rest(ray.moment + cross(body.place, ray.direction), body), -far, far);
    return OwnRay(direction, moment, cross(moment, direction));
}

// How much of what a pixel shows of two faces is the other than that which its ray meets: the ray passes
// their common edge at the distance `from_edge`, `across` is the unit vector across the edge and the ray, and
// `width` that of the other face as it is seen.
fn share_of_other(from_edge: f32, width: f32, across: vec3f, ray: Ray, beyond: f32) -> f32 {
    let pixel = max((ray.to_centre + beyond) * length(movement(ray, across)), 1e-30);
    let own = 0.5 + min(from_edge / pixel, 0.5);
    let other = clamp(0.5 - from_edge / pixel, 0.0, max(width / pixel, 0.0));
    return other / (own + other);
}

// 1, or -1 below 0.
fn sign_of(x: f32) -> f32 {
    return select(1.0, -1.0, x < 0.0);
}
