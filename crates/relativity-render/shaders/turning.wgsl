// Bodies that turn about an axle along y, as parts of a wheel, at one camera event.
//
// Such a body is given as it is when the hub is shown. What is shown at another place q, from the hub, is
// shown `later` by the clocks of the rest frame, and has turned by omega times that. So a body of revolution
// about the axle stays where it is. Any other is met in the frame that turns with it, where it stands still
// and the ray is a curve.

// 0 not at all, 1 bodies of revolution about the axle, 2 others.
override TURNS: u32;

// A tube is met where a course says (`course.wgsl`). What is none and turns by less than this angle (radians)
// while a ray passes it is met in rounds from the middle; else the course is followed first, to the tube
// around it.
const SHORT = 0.4;
// Most rounds, each along the tangent where the one before met the body, and when one is the last: what is
// off then is this part of the body's radius.
const MOST_ROUNDS = 6;
const SETTLED = 1e-4;

struct Spin {
    // The middle of the axle, from the group's.
    hub: vec3f,
    // About +y.
    omega: f32,
    // By how much the speed of the rim is below 1, and that of a ring's outermost circle below the rim's,
    // along the group's motion.
    below_light: f32,
    lag: f32,
}

// By how much later a place is shown than the hub, and how much earlier per step from there.
struct Later {
    time: f32,
    slowness: vec3f,
}

fn spin_of(spin: vec4f, rim: vec2f) -> Spin {
    return Spin(spin.xyz, spin.w, rim.x, rim.y);
}

// Of the place `q` from the hub.
fn later(q: vec3f, spin: Spin) -> Later {
    if GEOMETRY == 1u {
        // One time of the camera's.
        let slowness = group_from_motion(vec3f(frame.speed.x, 0.0, 0.0));
        return Later(-dot(slowness, q), slowness);
    }
    return later_from(from_camera_event(spin.hub), q);
}

// The same for the light to a camera event from which the hub is at `hub`. No product overflows, however far
// that is.
fn later_from(hub: vec3f, q: vec3f) -> Later {
    let largest = max(max(abs(hub.x), max(abs(hub.y), abs(hub.z))), 1e-12);
    let scaled = hub / largest;
    let reach = sqrt(dot(scaled, scaled));
    let towards = scaled / reach;
    let step = q / (largest * reach);
    let there = towards + step;
    let distance = max(sqrt(dot(there, there)), 1e-12);
    return Later(-dot(q, towards + there) / (1.0 + distance), there / distance);
}

// Sine and cosine within 2e-7 for moderate angles; those of WGSL are less accurate. Polynomials of S. L.
// Moshier's Cephes library (1989).
fn sine_cosine(angle: f32) -> vec2f {
    let quarters = round(angle * 0.6366197724);
    let x = (angle - quarters * 1.5703125) - quarters * 4.8382679e-4;
    let xx = x * x;
    let sine = x + x * xx * (-0.16666654611 + xx * (0.0083321608736 - xx * 0.00019515295891));
    let cosine = 1.0 - 0.5 * xx
        + xx * xx * (0.041666645683 + xx * (-0.0013887316255 + xx * 0.000024433157118));
    let quarter = quarters - 4.0 * floor(0.25 * quarters);
    let along = select(vec2f(sine, cosine), vec2f(cosine, -sine), quarter == 1.0 || quarter == 3.0);
    return select(along, -along, quarter >= 2.0);
}

// `v` turned about +y by the angle with this sine and cosine: from z towards x.
fn about_y(v: vec3f, turn: vec2f) -> vec3f {
    return vec3f(v.x * turn.y + v.z * turn.x, v.y, v.z * turn.y - v.x * turn.x);
}

// The velocity of what turns so at `q` from the hub.
fn velocity_at(q: vec3f, spin: Spin) -> vec3f {
    return spin.omega * vec3f(q.z, 0.0, -q.x);
}

// What is shown at `q`, from the hub, along a ray in the direction of `n`, in the frame that turns.
struct CoMoving {
    // From the hub.
    place: vec3f,
    // How fast the place changes along the ray.
    tangent: vec3f,
}

fn co_moving(q: vec3f, n: vec3f, spin: Spin) -> CoMoving {
    let shown = later(q, spin);
    let turn = sine_cosine(-spin.omega * shown.time);
    let tangent = n + velocity_at(q, spin) * dot(shown.slowness, n);
    return CoMoving(about_y(q, turn), about_y(tangent, turn));
}

// Where a ray meets a body that turns, as one round after the other finds it, from `start` along the ray,
// counted from its point nearest to the hub, and no farther from there than `reach`.
fn surface_near(body: Body, ray: Ray, spin: Spin, start: f32, reach: f32) -> Surface {
    let n = ray.direction;
    let nearest = nearest_to(spin.hub, ray);
    let hub_along = dot(spin.hub, n);
    var s = start;
    var met: Surface;
    for (var i = 0; i < MOST_ROUNDS; i++) {
        let at = co_moving(nearest + n * s, n, spin);
        let rate = max(sqrt(dot(at.tangent, at.tangent)), 1e-6);
        let direction = at.tangent / rate;
        let place = spin.hub + at.place;
        let along = dot(place, direction);
        let moment = cross(direction, place);
        let to_centre = ray.to_centre + (hub_along + s) - along;
        met = surface(
            body,
            Ray(ray.sight, ray.scale, direction, ray.ground_per_rest, ray.doppler, moment, to_centre),
        );
        let reached = clamp(s + (met.beyond - along) / rate, start - reach, start + reach);
        // The curve departs from its tangent by no more than about this.
        let off = abs(spin.omega) * (reached - s) * (reached - s);
        met.clearance -= off;
        s = reached;
        if off < SETTLED * body.radius {
            break;
        }
    }
    let q = nearest + n * s;
    let shown = later(q, spin);
    let turn = sine_cosine(spin.omega * shown.time);
    // The outline moves by what is across the ray alone, but is shown at another time, too.
    let across = about_y(met.outward, turn);
    let outward = across + shown.slowness * dot(across, velocity_at(q, spin));
    return Surface(
        met.clearance,
        met.half_width,
        outward - n * dot(outward, n),
        hub_along + s,
        (spin.hub + q) - middle(body),
        about_y(met.normal, turn),
    );
}

// From the hub if it turns about it, as its middle does; else from the body's middle: `place`, which is from
// its middle as it is given.
fn place_of_hit(body: Body, place: vec3f, spin: Spin) -> vec3f {
    if TURNS == 2u {
        return (middle(body) - spin.hub) + place;
    }
    return place;
}

// A body as it is when what is at `place`, from its middle, is shown.
struct Standing {
    body: Body,
    place: vec3f,
}

fn standing(body: Body, place: vec3f, spin: Spin) -> Standing {
    if TURNS == 0u {
        return Standing(body, place);
    }
    let q = (middle(body) - spin.hub) + place;
    let angle = spin.omega * later(q, spin).time;
    let half = sine_cosine(0.5 * angle);
    let by = vec4f(0.0, half.x, 0.0, half.y);
    let own = body.turn;
    let turn = vec4f(by.w * own.xyz + own.w * by.xyz + cross(by.xyz, own.xyz), by.w * own.w - dot(by.xyz, own.xyz));
    let there = select(
        place,
        q - about_y(middle(body) - spin.hub, sine_cosine(angle)),
        TURNS == 2u,
    );
    return Standing(Body(body.place, body.radius, body.form, turn), there);
}

// By which factor of that the own motion of what turns changes the Doppler factor: sqrt(1 - v^2)/(1 + v.n'),
// of light that is received along `sight` in a picture of oblique motion.
fn own_doppler_of(body: Body, place: vec3f, normal: vec3f, sight: vec3f, spin: Spin) -> f32 {
    let n = own_passage(sight, GEOMETRY).direction;
    let q = (middle(body) - spin.hub) + place;
    let off_axle = max(sqrt(dot(q.xz, q.xz)), 1e-30);
    let rim = 1.0 - spin.below_light;
    var lag = rim - spin.omega * off_axle;
    if TURNS == 1u && body.form.w > 0.0 {
        let cosine = dot(normal.xz, q.xz) / off_axle;
        let gap = select(1.0 - cosine, normal.y * normal.y / (1.0 + cosine), cosine > 0.0);
        lag = spin.lag + spin.omega * body.radius * gap;
    }
    let dilation_squared = spin.below_light * (1.0 + rim) + lag * (2.0 * rim - lag);
    return sqrt(max(dilation_squared, 0.0)) / max(1.0 + dot(velocity_at(q, spin), n), 1e-30);
}

// The Doppler factor of what is at `place`, from the body's middle, with this `normal`: that of the light
// received along the unit vector `sight`, in the camera's frame, if it stood still, or with its own motion.
//
// The speed is told by how much it is below that of the rim, v_x = lag - rim: where a wheel rolls, rim = beta
// and lag = 0 where it touches the road, and nothing cancels in D = sqrt(1 - v^2)/(gamma (1 + beta v_x +
// (beta + v_x) n_x + v_z n_z/gamma)).
fn doppler_of(body: Body, place: vec3f, normal: vec3f, sight: vec3f, doppler: f32, spin: Spin) -> f32 {
    if TURNS == 0u || GEOMETRY == 1u {
        return doppler;
    }
    if OBLIQUE {
        return doppler * own_doppler_of(body, place, normal, sight, spin);
    }
    let sign = frame.motion.x;
    let n = reflected(sight, sign);
    let q = reflected((middle(body) - spin.hub) + place, sign);
    let omega = sign * spin.omega;
    let rim = 1.0 - spin.below_light;
    let off_axle = max(sqrt(dot(q.xz, q.xz)), 1e-30);
    var lag = rim - omega * off_axle;
    if TURNS == 1u && body.form.w > 0.0 {
        // A ring, from its outermost circle: 1 - cos, without the difference, of the place on its tube.
        let cosine = dot(reflected(normal, sign).xz, q.xz) / off_axle;
        let gap = select(1.0 - cosine, normal.y * normal.y / (1.0 + cosine), cosine > 0.0);
        lag = spin.lag + omega * body.radius * gap;
    }
    // And from the lowest point of its own circle.
    let above = select(off_axle + q.z, q.x * q.x / (off_axle - q.z), q.z < 0.0);
    let behind = lag + omega * above;
    let faster = (spin.below_light - frame.speed.y) + behind;
    let upwards = -omega * q.x * n.z * frame.speed.z;
    var receding = frame.speed.y + frame.speed.x * (spin.below_light + behind) + faster * n.x;
    if n.x < 0.0 {
        let one_plus_x = (n.y * n.y + n.z * n.z) / (1.0 - n.x);
        receding = frame.speed.y * (1.0 + rim - behind) + faster * one_plus_x;
    }
    let dilation_squared = spin.below_light * (1.0 + rim) + lag * (2.0 * rim - lag);
    return sqrt(max(dilation_squared, 0.0)) * frame.speed.z / max(receding + upwards, 1e-30);
}
