// A ray as the curve that it is in the frame that turns with a body, and where it first enters a tube.
//
// Along a ray the times of what is shown pass evenly. So at s along it, it is turned back by an angle that
// grows by w per length, |w| <= |omega|. With n the ray's direction, n_perp its part across the axle and rho
// the greatest distance from that, the curve a(s) has
//
// |a'| <= sqrt(n_y^2 + (n_perp + |w| rho)^2), |a''| <= 2 |w| n_perp + w^2 rho.
//
// Its distance from a straight axis bends towards that no faster. So a parabola lies below that distance, and
// stepping to its first root never passes an entry: the one that is found is the first, however often the ray
// enters.

// Most steps to an entry: of 58 million rays (`tests/spokes.rs`) none took more than half.
const MOST_STEPS = 64;
// What is no farther from a tube than this part of its radius, and this part of how far it reaches from the
// axle, is at it.
const AT_TUBE = 1e-4;
const ROUNDING = 1e-7;
// Steps to where a ray passes that does not enter.
const PASSING_STEPS = 2;

// A ray among what a tube sweeps, from its point nearest to the hub.
struct TubeCourse {
    // From the hub: where the tube's axis begins, and from there to its end.
    beginning: vec3f,
    axis: vec3f,
    radius: f32,
    direction: vec3f,
    nearest: vec3f,
    // Between which distances along the ray it may meet the tube.
    start: f32,
    end: f32,
    // By which angle the ray is turned back at the start, and how much more per distance.
    turn: f32,
    rate: f32,
    // By how much earlier places are shown per step from there.
    slowness: vec3f,
    // The curve is no faster, and not bent more.
    speed: f32,
    bend: f32,
    at_tube: f32,
}

// A place on a course.
struct Passing {
    // Sine and cosine.
    turn: vec2f,
    // From the tube's axis, and how fast and with which acceleration that changes.
    off: vec3f,
    velocity: vec3f,
    acceleration: vec3f,
    distance: f32,
}

struct Found {
    s: f32,
    enters: bool,
}

// Between the planes across the axle and in the cylinder about it that hold the tube, in front of the camera.
fn course_through(capsule: Capsule, ray: Ray, spin: Spin) -> TubeCourse {
    let n = ray.direction;
    let nearest = nearest_to(spin.hub, ray);
    let ends = array<vec3f, 2>(capsule.place - spin.hub, capsule.end - spin.hub);
    let off_axle = sqrt(max(dot(ends[0].xz, ends[0].xz), dot(ends[1].xz, ends[1].xz))) + capsule.radius;
    let flat_squared = max(dot(n.xz, n.xz), 1e-12);
    let closest = -dot(nearest.xz, n.xz) / flat_squared;
    let side = nearest.x * n.z - nearest.z * n.x;
    let half_chord = sqrt(max(off_axle * off_axle - side * side / flat_squared, 0.0) / flat_squared);
    let slope = select(max(n.y, 1e-9), min(n.y, -1e-9), n.y < 0.0);
    let low = min(ends[0].y, ends[1].y) - capsule.radius;
    let high = max(ends[0].y, ends[1].y) + capsule.radius;
    let crossings = (vec2f(low, high) - nearest.y) / slope;
    let before = closest - half_chord;
    let after = closest + half_chord;
    let camera = -(ray.to_centre + dot(spin.hub, n));
    let end = clamp(max(crossings.x, crossings.y), before, after);
    let start = min(max(clamp(min(crossings.x, crossings.y), before, after), camera), end);
    let shown = later(nearest + n * start, spin);
    let rate = spin.omega * dot(shown.slowness, n);
    let flat = sqrt(flat_squared);
    let own_speed = abs(rate) * off_axle;
    return TubeCourse(
        ends[0],
        ends[1] - ends[0],
        capsule.radius,
        n,
        nearest,
        start,
        end,
        -spin.omega * shown.time,
        rate,
        shown.slowness,
        sqrt(n.y * n.y + (flat + own_speed) * (flat + own_speed)),
        abs(rate) * (2.0 * flat + own_speed),
        AT_TUBE * capsule.radius + ROUNDING * off_axle,
    );
}

fn course_at(course: TubeCourse, s: f32) -> Passing {
    let turn = sine_cosine(course.turn + course.rate * (s - course.start));
    let n = course.direction;
    let q = course.nearest + n * s;
    let across = vec3f(q.z, 0.0, -q.x);
    let outward = vec3f(q.x, 0.0, q.z);
    let from_beginning = about_y(q, turn) - course.beginning;
    let velocity = about_y(n + across * course.rate, turn);
    let turning = vec3f(n.z, 0.0, -n.x) * (2.0 * course.rate) - outward * (course.rate * course.rate);
    let acceleration = about_y(turning, turn);
    let axis = course.axis;
    let per_length_squared = 1.0 / max(dot(axis, axis), 1e-30);
    let along = dot(from_beginning, axis) * per_length_squared;
    let off = from_beginning - axis * clamp(along, 0.0, 1.0);
    // Beside the axis what is along it does not count.
    let beside = axis * select(0.0, per_length_squared, along > 0.0 && along < 1.0);
    return Passing(
        turn,
        off,
        velocity - beside * dot(velocity, axis),
        acceleration - beside * dot(acceleration, axis),
        sqrt(dot(off, off)),
    );
}

// Where a ray first comes to the tube, or else where it was found closest to it.
fn first_at_tube(course: TubeCourse) -> Found {
    var closest = 0.5 * (course.start + course.end);
    var least = course_at(course, closest).distance;
    // Where the middle is farther off than the curve goes from there, all of it is.
    if least - course.radius > 0.5 * (course.end - course.start) * course.speed {
        return Found(closest, false);
    }
    var s = course.start;
    for (var i = 0; i < MOST_STEPS; i++) {
        let at = course_at(course, s);
        if at.distance < least {
            least = at.distance;
            closest = s;
        }
        let outside = max(at.distance - course.radius, 0.0);
        let slope = dot(at.off, at.velocity) / max(at.distance, 1e-30);
        if outside <= course.at_tube {
            // What only grazes it may enter later.
            let is_on_its_way = slope < 0.0 && miss_squared(at) < course.radius * course.radius;
            if outside <= 0.0 || is_on_its_way {
                return Found(s, true);
            }
        }
        let root = sqrt(slope * slope + 2.0 * course.bend * outside);
        if slope > 0.0 {
            s += (slope + root) / max(course.bend, 1e-30);
        } else {
            s += 2.0 * outside / max(root - slope, 1e-30);
        }
        if s > course.end {
            break;
        }
    }
    return Found(closest, false);
}

// The second derivative of half the distance squared.
fn growth(at: Passing) -> f32 {
    return dot(at.velocity, at.velocity) + dot(at.off, at.acceleration);
}

// How far it is from here to where the ray is closest to the axis, by Newton's method; 0 where it is farthest
// there.
fn to_closest(at: Passing) -> f32 {
    let grows = growth(at);
    return select(0.0, -dot(at.off, at.velocity) / max(grows, 1e-30), grows > 0.0);
}

// The square of the least distance, as the parabola through this place has it: 0 where it bends inwards.
fn miss_squared(at: Passing) -> f32 {
    let least = at.distance * at.distance + dot(at.off, at.velocity) * to_closest(at);
    return select(0.0, max(least, 0.0), growth(at) > 0.0);
}

// Where a ray meets the tube itself.
fn tube_when_shown(body: Body, course: TubeCourse, spin: Spin) -> Surface {
    let found = first_at_tube(course);
    var s = found.s;
    var at = course_at(course, s);
    for (var i = 0; i < PASSING_STEPS && !found.enters; i++) {
        s = clamp(s + to_closest(at), course.start - course.radius, course.end + course.radius);
        at = course_at(course, s);
    }
    var clearance = min(course.radius - at.distance, 0.0);
    var closest = at.off;
    if found.enters {
        // As the parabola through the entry has it.
        let step = to_closest(at);
        closest += (at.velocity + at.acceleration * (0.5 * step)) * step;
        clearance = course.radius - sqrt(miss_squared(at));
    }
    let back = vec2f(-at.turn.x, at.turn.y);
    let n = course.direction;
    let q = course.nearest + n * s;
    // The outline moves by what is across the ray alone, but is shown at another time, too.
    let across = about_y(closest / max(sqrt(dot(closest, closest)), 1e-30), back);
    let outward = across + course.slowness * dot(across, velocity_at(q, spin));
    return Surface(
        clearance,
        course.radius,
        outward - n * dot(outward, n),
        dot(spin.hub, n) + s,
        (spin.hub + q) - middle(body),
        about_y(at.off / max(at.distance, 1e-30), back),
    );
}

