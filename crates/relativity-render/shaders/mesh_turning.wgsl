// Corners of bodies that turn: each is shown where it is when it is shown.

// Most steps of the root's search, and from which one on they halve what is left: near the speed of light
// Newton's method may creep.
const MOST_NEWTON = 20;
const MOST_HALVINGS = 44;

// Of the place `q` from the hub, where that is at `hub` from the camera's event.
fn later_before(hub: vec3f, q: vec3f, spin: Spin) -> Later {
    if MAP == 1u {
        return later(q, spin);
    }
    return later_from(hub, q);
}

// By how much later than the hub what is at `q` from it then is shown itself: the one root between -|q|
// and |q|, to 1e-7 of that over 1 + v.n' (f32).
fn shown_later(hub: vec3f, q: vec3f, spin: Spin) -> f32 {
    let reach = sqrt(dot(q, q));
    var low = -reach;
    var high = reach;
    var at = 0.0;
    for (var i = 0; i < MOST_HALVINGS; i++) {
        let there = about_y(q, sine_cosine(spin.omega * at));
        let shown = later_before(hub, there, spin);
        let value = at - shown.time;
        if value > 0.0 {
            high = at;
        } else {
            low = at;
        }
        let newton = at - value / (1.0 + dot(velocity_at(there, spin), shown.slowness));
        let is_inside = newton > low && newton < high && i < MOST_NEWTON;
        let next = select(0.5 * (low + high), newton, is_inside);
        let step = abs(next - at);
        at = next;
        if step <= 1e-7 * reach {
            break;
        }
    }
    return at;
}

// The hub from the camera's event.
fn hub_from_camera(spin: Spin) -> vec3f {
    return from_camera_event(spin.hub);
}

// Where a corner is shown, from the group's middle, that is at `place` when the hub is shown; and its normal.
fn corner_when_shown(place: vec3f, normal: vec3f, spin: Spin) -> Shape {
    if TURNS != 2u {
        return Shape(place, normal);
    }
    let q = place - spin.hub;
    let turn = sine_cosine(spin.omega * shown_later(hub_from_camera(spin), q, spin));
    return Shape(spin.hub + about_y(q, turn), select(normal, about_y(normal, turn), HAS_NORMALS));
}

// What the published model's right eye sees of a corner that turns and is shown at `place` to the left eye:
// as the left one does Delta T earlier. From the group's middle.
struct Earlier {
    place: vec3f,
    from_camera: vec3f,
}

fn corner_seen_earlier(place: vec3f, spin: Spin) -> Earlier {
    let sign = frame.motion.x;
    let q = place - spin.hub;
    let hub = reflected(hub_from_camera(spin), sign);
    let delayed = frame.speed.w * delay(sighting(hub + reflected(q, sign)).position);
    let earlier = hub - vec3f(frame.speed.x * delayed, 0.0, 0.0);
    // By how much later the hub is shown then.
    let way = frame.speed.x * (hub.x + earlier.x) / max(length(hub) + length(earlier), 1e-30);
    let before = later(q, spin).time + delayed * (1.0 - way);
    let start = about_y(q, sine_cosine(-spin.omega * before));
    let from_hub = reflected(earlier, sign);
    let turn = sine_cosine(spin.omega * shown_later(from_hub, start, spin));
    let there = about_y(start, turn);
    return Earlier(spin.hub + there, from_hub + there);
}
