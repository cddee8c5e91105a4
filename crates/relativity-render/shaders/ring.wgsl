// Ray against a torus: `place` is its centre, `form` its axis and the radius R of its middle circle, `radius`
// is r.
//
// With rho the distance from the axis and z the height, F = (rho - R)^2 + z^2 - r^2 is negative inside.
// Along a ray F'' = 2 - 2 R rho'', and rho'' is bounded where rho is within r of R; so a parabola lies below
// F, and stepping to its first root never passes a root of F and converges quadratically. Where the
// parabola has no root, the ray is proved to miss. Quartic solvers lose the outline in f32; this does not.

// Reached only where the ray grazes within rounding; to pass a near miss before it enters takes about twenty.
const MAX_STEPS = 32;
// F'' is about 2 sin^2 of the angle between the ray and the tube where it passes. A search for the least F
// takes it for no less than this, 6 degrees: so it stays near, and finds it in the second step wherever the
// tube is not seen almost end on.
const LEAST_SECOND = 0.02;

struct Course {
    // rho^2 = a s^2 + 2 b s + c, z = height + s slope.
    a: f32,
    b: f32,
    c: f32,
    height: f32,
    slope: f32,
}

struct Torus {
    // F, F' and F'' at some s.
    value: f32,
    first: f32,
    second: f32,
}

fn torus_at(course: Course, body: Body, s: f32) -> Torus {
    let rho = sqrt(max((course.a * s + 2.0 * course.b) * s + course.c, 1e-30));
    let rho_first = (course.a * s + course.b) / rho;
    let rho_second = (course.a - rho_first * rho_first) / rho;
    let z = course.height + s * course.slope;
    let from_circle = rho - body.form.w;
    return Torus(
        from_circle * from_circle + z * z - body.radius * body.radius,
        2.0 * (from_circle * rho_first + z * course.slope),
        2.0 - 2.0 * body.form.w * rho_second,
    );
}

struct Search {
    found: bool,
    // Where F was least so far, and that F.
    s: f32,
    value: f32,
}

// The first root of F in [start, end], where F'' is at least `curvature`.
fn entry(body: Body, course: Course, curvature: f32, start: f32, end: f32, before: Search) -> Search {
    var search = before;
    var s = start;
    for (var i = 0; i < MAX_STEPS; i++) {
        if s > end {
            break;
        }
        let at = torus_at(course, body, s);
        // F changes by 2 r across the surface, and rho is known to some 1e-7 R: on the surface as f32 sees
        // it.
        if at.value <= 1e-6 * body.form.w * body.radius {
            return Search(true, s, at.value);
        }
        search = nearer(search, s, at.value);
        let discriminant = at.first * at.first - 2.0 * curvature * at.value;
        let divisor = sqrt(max(discriminant, 0.0)) - at.first;
        if discriminant < 0.0 || divisor <= 0.0 {
            break;
        }
        s += 2.0 * at.value / divisor;
    }
    return search;
}

// Whether `around` is all of it.
const IS_TUBE = false;

fn middle(body: Body) -> vec3f {
    return body.place;
}

fn around(body: Body) -> Capsule {
    return Capsule(body.place, body.place, body.form.w + body.radius);
}

fn surface(body: Body, ray: Ray) -> Surface {
    let n = ray.direction;
    let nearest = nearest_to(body.place, ray);
    let height = dot(nearest, body.form.xyz);
    let slope = dot(n, body.form.xyz);
    let start = nearest - body.form.xyz * height;
    let flat_direction = n - body.form.xyz * slope;
    // A ray along the axis, or one across it (below), is treated as turned by a millionth: its distances stay
    // finite, and over the ring's size it moves by less than f32 resolves.
    let a = max(dot(flat_direction, flat_direction), 1e-12);
    let course = Course(a, dot(start, flat_direction), dot(start, start), height, slope);
    let lateral = cross(start, flat_direction);
    let closest_squared = dot(lateral, lateral) / a;

    // The torus lies between two cylinders and two planes.
    let outer = body.form.w + body.radius;
    let inner = body.form.w - body.radius;
    let outer_half = sqrt(max(outer * outer - closest_squared, 0.0) / a);
    let inner_half = sqrt(max(inner * inner - closest_squared, 0.0) / a);
    let turn = -course.b / a;
    let steep = select(-1.0, 1.0, slope >= 0.0) / max(abs(slope), 1e-12);
    let level = -height * steep;
    // From the camera on: one in the hole has a part of the torus behind it.
    let here = -(ray.to_centre + dot(body.place, n));
    let first = max(here, max(turn - outer_half, level - body.radius * abs(steep)));
    let last = min(turn + outer_half, level + body.radius * abs(steep));
    // rho'' = a rho_closest^2/rho^3, at most this where the torus is.
    let least = max(sqrt(closest_squared), inner);
    let curvature = 2.0 - 2.0 * body.form.w * a * closest_squared / (least * least * least);

    var search = Search(false, turn, torus_at(course, body, turn).value);
    if outer * outer > closest_squared && first < last {
        search = entry(body, course, curvature, first, min(last, turn - inner_half), search);
        // Nothing is in the hole, and the bound on rho'' does not hold there.
        if !search.found {
            search = entry(body, course, curvature, max(first, turn + inner_half), last, search);
        }
    }
    if !search.found {
        search = nearer(search, level, torus_at(course, body, level).value);
    }
    // How deep inside the outline: the least F of this passage, by Newton's method from where F was least so
    // far.
    var deepest = search;
    var s = search.s;
    for (var i = 0; i < 4; i++) {
        let at = torus_at(course, body, s);
        deepest = nearer(deepest, s, at.value);
        s -= at.first / max(at.second, LEAST_SECOND);
    }
    let miss = sqrt(max(deepest.value + body.radius * body.radius, 0.0));
    // What was entered is inside, whatever rounding makes of a graze.
    let clearance = select(
        min(body.radius - miss, 0.0),
        max(body.radius - miss, 1e-6 * body.radius),
        search.found,
    );
    let place = nearest + n * search.s;
    return Surface(
        clearance,
        body.radius,
        torus_normal(nearest + n * deepest.s, body),
        dot(body.place, n) + search.s,
        place,
        torus_normal(place, body),
    );
}

fn nearer(search: Search, s: f32, value: f32) -> Search {
    if value < search.value {
        return Search(search.found, s, value);
    }
    return search;
}

// From the nearest point of the middle circle, towards `place`.
fn torus_normal(place: vec3f, body: Body) -> vec3f {
    let height = dot(place, body.form.xyz);
    let from_axis = place - body.form.xyz * height;
    let rho = max(sqrt(dot(from_axis, from_axis)), 1e-30);
    let outward = place - from_axis * (body.form.w / rho);
    return outward / max(sqrt(dot(outward, outward)), 1e-30);
}

// The normal by which a pattern is looked up.
fn normal_at(body: Body, place: vec3f, normal: vec3f) -> vec3f {
    return normal;
}

fn darkness(body: Body, pattern: vec3f, place: vec3f, normal: vec3f, covered: Covered) -> f32 {
    let off_axis = max(sqrt(dot(place.xy, place.xy)), 1e-30);
    let outward = vec3f(place.xy / off_axis, 0.0);
    let arc = arc_to(off_axis - body.form.w, outward, place.z, body.radius);
    let around = angle_to(place.y, place.x);
    let around_gradient = vec3f(-outward.y, outward.x, 0.0) / off_axis;
    let chart = Chart(
        arc.length,
        arc.gradient,
        around,
        around_gradient,
        off_axis,
        body.form.w * around,
        around_gradient * body.form.w,
    );
    return darkness_of_chart(chart, pattern, covered);
}
