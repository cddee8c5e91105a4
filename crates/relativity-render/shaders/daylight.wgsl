// The street's daylight as surfaces receive it: see `light/daylight.rs`.

// How a surface moves through the street's light: its gamma beta there; and the cosine, in its own frame, of
// the angle between its normal and its motion.
struct Facing {
    rapid: f32,
    ahead: f32,
}

// How what is at `place`, from the body's middle, with this `normal` faces the street's light, where that is
// shown.
fn facing_of(body: Body, place: vec3f, normal: vec3f, spin: Spin) -> Facing {
    if SPECTRUM != 2u {
        return Facing(0.0, 0.0);
    }
    let sign = frame.motion.w;
    let n = reflected(normal, sign);
    var own = vec3f(0.0);
    if TURNS != 0u {
        own = reflected(velocity_at((middle(body) - spin.hub) + place, spin), sign);
    }
    let own_gamma = 1.0 / sqrt(max(1.0 - dot(own, own), 1e-30));
    let along = (own.x + frame.on_ground.x) * own_gamma * frame.on_ground.w;
    let upwards = own_gamma * own.z;
    let rapid = min(sqrt(along * along + upwards * upwards), MOST_RAPID);
    let turning = dot(n, own);
    let scale = sqrt(max(1.0 - turning * turning, 1e-30));
    let time = (turning + n.x * frame.on_ground.x) / scale * frame.on_ground.w;
    return Facing(rapid, clamp(time / max(rapid, 1e-30), -1.0, 1.0));
}
