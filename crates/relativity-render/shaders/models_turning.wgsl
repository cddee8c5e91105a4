// Rays against models of triangles that turn: arc by arc, as `scene/wheel/model.rs` searches in f64.

// Greatest distance of an arc from its chord, in parts of how far the model reaches from the axle, and
// greatest number of arcs.
const BULGE = 0.01;
const MOST_ARCS = 100.0;
// Most steps of Newton's method to a triangle's plane, and the step, in parts of the reach, after which it is
// there.
const MOST_ROOT_STEPS = 10;
const ON_PLANE = 1e-6;
// Weights of corners that are below 0 by no more than this are taken for 0, so that no ray passes between
// triangles.
const EDGE = 1e-5;
// Triangles with a smaller square of their area, of edges up to 1, have none to f32.
const NO_AREA = 1e-12;

// A ray in the frame that turns with a model.
struct Path {
    // From the hub to the ray, where it is nearest, and the direction of the ray.
    nearest: vec3f,
    direction: vec3f,
    spin: Spin,
    body: Body,
    // How far the model reaches from the axle.
    reach: f32,
    // The path is bent no more than this.
    curvature: f32,
}

// A part of a path: its ends along the ray, and their places and tangents.
struct PathPart {
    low: f32,
    high: f32,
    begin: vec3f,
    begin_tangent: vec3f,
    end: vec3f,
    end_tangent: vec3f,
}

fn path_of(body: Body, ray: Ray, spin: Spin) -> Path {
    let speed = abs(spin.omega) * body.form.w;
    let curvature = abs(spin.omega) * (2.0 * length(ray.direction.xz) + speed);
    return Path(nearest_to(spin.hub, ray), ray.direction, spin, body, body.form.w, curvature);
}

// The place and the tangent of the path at `s` along the ray, from the middle of the model along its axes.
fn path_at(path: Path, s: f32) -> CoMoving {
    let at = co_moving(path.nearest + path.direction * s, path.direction, path.spin);
    let place = path.spin.hub + at.place - middle(path.body);
    return CoMoving(body_from_rest(place, path.body), body_from_rest(at.tangent, path.body));
}

// Between which parameters the path is where the model may be at some angle; the first is the larger where it
// is nowhere.
fn passage_through(path: Path) -> vec2f {
    let body = path.body;
    let form = body.form;
    let half_width = abs(rest_from_body(vec3f(form.x, 0.0, 0.0), body).y)
        + abs(rest_from_body(vec3f(0.0, form.y, 0.0), body).y)
        + abs(rest_from_body(vec3f(0.0, 0.0, form.z), body).y)
        + 1e-5 * path.reach;
    let reach = path.reach * 1.00001;
    let n = path.direction;
    let off = path.nearest;
    let rise = middle(body).y - path.spin.hub.y - off.y;
    let steep = select(n.y, select(1e-9, -1e-9, n.y < 0.0), abs(n.y) < 1e-9);
    let flat = max(dot(n.xz, n.xz), 1e-18);
    let along = dot(off.xz, n.xz);
    let lateral = clamp(off.x * n.z - off.z * n.x, -1e15, 1e15);
    let squared = reach * reach * flat - lateral * lateral;
    if squared < 0.0 {
        return vec2f(1.0, 0.0);
    }
    let across = vec2f(-along - sqrt(squared), -along + sqrt(squared)) / flat;
    let planes = vec2f(rise - half_width, rise + half_width) / steep;
    return vec2f(
        max(across.x, min(planes.x, planes.y)),
        min(across.y, max(planes.x, planes.y)),
    );
}

// Where an arc meets a triangle: weights, and the place along the ray, 1e30 where it does not. An arc that
// begins and ends on one side of the triangle's plane meets that twice if it comes nearer at first and goes
// away at last.
fn met_by_arc(path: Path, arc: PathPart, triangle: Triangle, is_two_sided: bool, bulge: f32) -> vec4f {
    let normal = outward(triangle);
    let first = dot(normal, arc.begin - triangle.a);
    let last = dot(normal, arc.end - triangle.a);
    if first * last > 0.0 {
        let nears = first * dot(normal, arc.begin_tangent) < 0.0 && last * dot(normal, arc.end_tangent) > 0.0;
        if !nears || min(abs(first), abs(last)) > bulge {
            return vec4f(0.0, 0.0, 0.0, 1e30);
        }
        let one = met_near(arc.low, 0.0, path, arc, triangle, normal, is_two_sided);
        if one.w < 1e30 {
            return one;
        }
        return met_near(arc.high, 0.0, path, arc, triangle, normal, is_two_sided);
    }
    let change = first - last;
    let share = select(0.5, clamp(first / change, 0.0, 1.0), abs(change) > 1e-12);
    return met_near(mix(arc.low, arc.high, share), first, path, arc, triangle, normal, is_two_sided);
}

// The same from a place along the ray, by Newton's method. Where the arc begins on the side `first` of the
// plane, unless that is 0, and ends on the other, what is left is halved where that method would leave it.
fn met_near(
    start: f32,
    first: f32,
    path: Path,
    arc: PathPart,
    triangle: Triangle,
    normal: vec3f,
    is_two_sided: bool,
) -> vec4f {
    let nowhere = vec4f(0.0, 0.0, 0.0, 1e30);
    let length_of_arc = arc.high - arc.low;
    var s = start;
    var at = path_at(path, s);
    var step = 1e30;
    var low = arc.low;
    var high = arc.high;
    for (var i = 0; i < MOST_ROOT_STEPS; i++) {
        let slope = dot(normal, at.tangent);
        let value = dot(normal, at.place - triangle.a);
        low = select(low, s, value * first > 0.0);
        high = select(high, s, value * first < 0.0);
        let newton = s - value / select(slope, 1e-9, abs(slope) < 1e-9);
        let is_outside = first != 0.0 && (newton < low || newton > high);
        let next = clamp(
            select(newton, 0.5 * (low + high), is_outside),
            arc.low - length_of_arc,
            arc.high + length_of_arc,
        );
        step = s - next;
        s = next;
        at = path_at(path, s);
        if abs(step) <= ON_PLANE * path.reach {
            break;
        }
    }
    let room = 1e-5 * path.reach;
    let is_there = abs(step) <= 1e-4 * path.reach && s >= arc.low - room && s <= arc.high + room;
    let is_front = dot(normal, at.tangent) < 0.0;
    if !is_there || !(is_two_sided || is_front) {
        return nowhere;
    }
    let u = triangle.b - triangle.a;
    let v = triangle.c - triangle.a;
    let scale = 1.0 / max(max(length_of_largest(u), length_of_largest(v)), 1e-30);
    let place = (at.place - triangle.a) * scale;
    let across = cross(u * scale, v * scale);
    let divisor = dot(across, across);
    if divisor < NO_AREA {
        return nowhere;
    }
    let second = dot(cross(place, v * scale), across) / divisor;
    let third = dot(cross(u * scale, place), across) / divisor;
    let weights = vec3f(1.0 - second - third, second, third);
    if any(weights < vec3f(-EDGE)) {
        return nowhere;
    }
    return vec4f(weights, s);
}

// The first triangle of the model in `row` that an arc meets, of equally near ones that of the lowest number.
fn first_met_by_arc(row: u32, path: Path, arc: PathPart, is_two_sided: bool) -> Met {
    let length_of_arc = max(arc.high - arc.low, 1e-30);
    let chord = length(arc.end - arc.begin);
    let direction = (arc.end - arc.begin) / max(chord, 1e-30);
    let bulge = 0.125 * path.curvature * length_of_arc * length_of_arc + 1e-6 * path.reach;
    let reciprocal = reciprocal_of(direction);
    var first = Met(0u, 1e30, vec3f(0.0));
    var farthest = chord + bulge;
    var number = 0u;
    var waiting: array<u32, MOST_WAITING>;
    var count = 0u;
    var link = 0u;
    loop {
        if (link & IS_LEAF) != 0u {
            let record = link & 0x1fffffffu;
            let last = record + ((link >> 29u) & 3u);
            for (var i = record; i <= last; i++) {
                let triangle = triangle_at(row, i);
                let met = met_by_arc(path, arc, triangle, is_two_sided, bulge);
                let is_first = met.w < first.distance || (met.w == first.distance && triangle.number < number);
                if met.w < 1e30 && is_first && is_solid(row, i, met.xyz) {
                    first = Met(IS_LEAF | i, met.w, met.xyz);
                    number = triangle.number;
                    farthest = chord * ((met.w - arc.low) / length_of_arc) + bulge;
                }
            }
        } else {
            let below = entered(row, link, arc.begin, reciprocal, bulge, -bulge, farthest);
            if below.count > 0u {
                link = below.nearer;
                if below.count == 2u {
                    waiting[count] = below.other;
                    count++;
                }
                continue;
            }
        }
        if count == 0u {
            break;
        }
        count--;
        link = waiting[count];
    }
    return first;
}

// The first triangle that a path meets further on than `behind`; its distance counts from the path's place
// nearest to the hub.
fn first_met_by_path(row: u32, path: Path, behind: f32, is_two_sided: bool) -> Met {
    var first = Met(0u, 1e30, vec3f(0.0));
    let ends = passage_through(path);
    let low = max(ends.x, behind);
    let whole = ends.y - low;
    if whole < 0.0 {
        return first;
    }
    let needed = whole * sqrt(path.curvature / (8.0 * BULGE * path.reach));
    let count = clamp(ceil(needed), 1.0, MOST_ARCS);
    let step = whole / count;
    let begin = path_at(path, low);
    var arc = PathPart(low, low, begin.place, begin.tangent, begin.place, begin.tangent);
    for (var i = 0.0; i < count; i += 1.0) {
        let end = path_at(path, low + step * (i + 1.0));
        arc = PathPart(arc.high, low + step * (i + 1.0), arc.end, arc.end_tangent, end.place, end.tangent);
        first = first_met_by_arc(row, path, arc, is_two_sided);
        if first.triangle != 0u {
            break;
        }
    }
    return first;
}
