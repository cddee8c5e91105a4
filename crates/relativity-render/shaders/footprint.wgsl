// The rectangle that surely contains a body in the picture, for bodies that are small there: the vertex stage
// finds it as `picture/footprint/mod.rs` explains.

// Room around an outline, px: that of footprints from the processor, and what f32 loses.
const MARGIN = 2.0;
// In front is what lies deeper than this many radii.
const CLEAR_OF_APERTURE = 1.001;
// Balls that reach this much of the way to the baseline bound nothing; and at less than this part of the way
// to the camera from the baseline f32 loses the place.
const MOST_NEAR = 0.8;
const LEAST_OFF = 1e-4;

// An upright rectangle, clip coordinates.
struct Rectangle {
    low: vec2f,
    high: vec2f,
}

const EVERYWHERE = Rectangle(vec2f(-1.0), vec2f(1.0));
const NOWHERE = Rectangle(vec2f(2.0), vec2f(2.0));

fn footprint(body: Body) -> Rectangle {
    let capsule = around(body);
    let beginning = motion_from_group(from_camera_event(capsule.place));
    let end = motion_from_group(from_camera_event(capsule.end));
    if CONFORMAL {
        return conformal_footprint(0.5 * (beginning + end), capsule.radius + 0.5 * length(end - beginning));
    }
    let first = apparent_centre(beginning, capsule.radius);
    let last = apparent_centre(end, capsule.radius);
    let moved = vec3f(bulge(beginning, end, capsule.radius), 0.0, 0.0);
    let reach = capsule.radius + 0.5 * length(last - first) + moved.x;
    if is_aside(motion_from_sight(0.5 * (first + last)), reach) {
        return NOWHERE;
    }
    let balls = array<vec3f, 4>(first, last, first + moved, last + moved);
    let forward = motion_from_sight(frame.forward.xyz);
    let least_depth = CLEAR_OF_APERTURE * capsule.radius * sqrt(metric(forward, forward));
    var around_all = Rectangle(vec2f(1e30), vec2f(-1e30));
    for (var i = 0; i < 4; i++) {
        let ball = motion_from_sight(balls[i]);
        let depth = dot(ball, frame.forward.xyz);
        if !(depth > least_depth) {
            return EVERYWHERE;
        }
        let x = extent(ball, depth, frame.clip_right.xyz, capsule.radius);
        let y = extent(ball, depth, frame.clip_up.xyz, capsule.radius);
        around_all.low = min(around_all.low, vec2f(x.x, y.x));
        around_all.high = max(around_all.high, vec2f(x.y, y.y));
    }
    return with_room(around_all, MARGIN * frame.base.w);
}

// Whether a ball is surely beside or behind the cone about the optical axis that a flat picture is in.
fn is_aside(centre: vec3f, radius: f32) -> bool {
    let depth = dot(centre, frame.forward.xyz);
    let off = length(cross(centre, frame.forward.xyz));
    // In a sheared picture the axis is not in the middle.
    let shift = abs(dot(frame.clip_right.xyz, frame.forward.xyz));
    let corner = length(vec2f((1.0 + shift) / frame.clip_right.w, 1.0 / frame.clip_up.w)) + MARGIN * frame.base.w;
    return off - depth * corner > radius * sqrt(1.0 + corner * corner);
}

// `rectangle` with this many focal lengths, or radians, of room around it.
fn with_room(rectangle: Rectangle, room: f32) -> Rectangle {
    let margin = room * vec2f(frame.clip_right.w, frame.clip_up.w);
    return Rectangle(rectangle.low - margin, rectangle.high + margin);
}

// The centre of the ground's ball that looks as the ball around `c` does: x is that of a point as near to the
// camera as the outline is.
fn apparent_centre(c: vec3f, radius: f32) -> vec3f {
    if GEOMETRY == 0u {
        let across_squared = dot(c.yz, c.yz) - radius * radius;
        return vec3f(sighting(vec3f(c.x, sqrt(max(across_squared, 0.0)), 0.0)).position.x, c.yz);
    }
    return vec3f(select(c.x, c.x * frame.speed.z, GEOMETRY == 1u), c.yz);
}

// How far, along the motion, the image of a tube departs from the straight one between its ends' images.
fn bulge(beginning: vec3f, end: vec3f, radius: f32) -> f32 {
    let span = end - beginning;
    let length_squared = dot(span, span);
    if GEOMETRY != 0u || length_squared == 0.0 {
        return 0.0;
    }
    let nearest = beginning + span * clamp(-dot(beginning, span) / length_squared, 0.0, 1.0);
    let least = sqrt(max(dot(nearest, nearest) - radius * radius, 1e-30));
    let slope = dot(beginning + end, span) / (length(beginning) + length(end));
    return frame.speed.x * frame.speed.w * max(length_squared - slope * slope, 0.0) / (8.0 * least);
}

// The product in which a ball that is contracted is round.
fn metric(p: vec3f, q: vec3f) -> f32 {
    let along = select(1.0, frame.speed.z * frame.speed.z, GEOMETRY == 1u);
    return along * p.x * q.x + dot(p.yz, q.yz);
}

// Between which clip coordinates the outline of a ball is, along the axis of the picture that `axis` is the
// row of.
fn extent(ball: vec3f, depth: f32, axis: vec3f, radius: f32) -> vec2f {
    let e = motion_from_sight(axis);
    let forward = motion_from_sight(frame.forward.xyz);
    let size = radius / depth;
    let ee = size * size * metric(e, e);
    let ef = size * size * metric(e, forward);
    let ff = size * size * metric(forward, forward);
    let place = dot(ball, axis) / depth;
    let root = sqrt(max(ee - 2.0 * ef * place + ff * place * place - (ee * ff - ef * ef), 0.0));
    return (vec2f(place - ef) + vec2f(-root, root)) / (1.0 - ff);
}

fn conformal_footprint(c: vec3f, radius: f32) -> Rectangle {
    let position = motion_from_sight(apparent_centre(c, radius));
    let from_baseline = length(vec2f(dot(position, frame.forward.xyz), dot(position, frame.clip_up.xyz)));
    let near = radius / max(from_baseline, 1e-30);
    if !(near < MOST_NEAR && from_baseline > LEAST_OFF * length(position)) {
        return EVERYWHERE;
    }
    let seen = coordinates_of(position);
    let room = MARGIN * frame.base.w - log(1.0 - near);
    // A picture that goes nearly around shows what is behind at both of its edges.
    if abs(seen.v) + room + 1.0 / frame.clip_up.w > 6.2831853 {
        return EVERYWHERE;
    }
    let place = vec2f((seen.u - frame.forward.w) * frame.clip_right.w, seen.v * frame.clip_up.w);
    return with_room(Rectangle(place, place), room);
}
