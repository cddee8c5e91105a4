// Ray against a torus. `anchor` is its centre, `extent` the radius R of its middle circle, `radius` r.
//
// With rho the distance from the axis and z the height, F = (rho - R)^2 + z^2 - r^2 is negative inside.
// Along a ray F'' = 2 - 2 R rho'', and rho'' is bounded where rho is within r of R; so a parabola lies below
// F, and stepping to its first root never passes a root of F and converges quadratically. Where the
// parabola has no root, the ray is proved to miss. Quartic solvers lose the outline in f32; this does not.

const MAX_STEPS = 24;

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
    let from_circle = rho - body.extent;
    return Torus(
        from_circle * from_circle + z * z - body.radius * body.radius,
        2.0 * (from_circle * rho_first + z * course.slope),
        2.0 - 2.0 * body.extent * rho_second,
    );
}

fn surface(body: Body, ray: Ray) -> Surface {
    let n = ray.direction;
    let nearest = nearest_to(body.anchor, ray);
    let middle = dot(body.anchor, n);
    let height = dot(nearest, body.axis);
    let slope = dot(n, body.axis);
    let start = nearest - body.axis * height;
    let flat_direction = n - body.axis * slope;
    let course = Course(
        max(dot(flat_direction, flat_direction), 1e-12),
        dot(start, flat_direction),
        dot(start, start),
        height,
        slope,
    );
    // Widened by about a pixel, so that the neighbourhood of the outline is searched too.
    let margin = 2.0 * abs(ray.to_centre + middle) * pixel_angle(ray);
    let widened = body.radius + margin;
    let lateral = cross(start, flat_direction);
    let closest_squared = dot(lateral, lateral) / course.a;

    let outer = body.extent + widened;
    let inner = max(body.extent - widened, 0.25 * body.extent);
    let outer_half = sqrt(max(outer * outer - closest_squared, 0.0) / course.a);
    let inner_half = sqrt(max(inner * inner - closest_squared, 0.0) / course.a);
    let turn = -course.b / course.a;
    let steep = select(-1.0, 1.0, slope >= 0.0) / max(abs(slope), 1e-12);
    let slab_middle = -height * steep;
    let slab_half = widened * abs(steep);
    let first = max(turn - outer_half, slab_middle - slab_half);
    let last = min(turn + outer_half, slab_middle + slab_half);
    // rho'' = a rho_closest^2/rho^3, at most this where the torus is.
    let least = max(sqrt(closest_squared), inner);
    let curvature = 2.0 - 2.0 * body.extent * course.a * closest_squared / (least * least * least);

    var s = first;
    var best = 1e30;
    var best_s = first;
    var in_front = true;
    var found = false;
    if outer * outer > closest_squared && first < last {
        for (var i = 0; i < MAX_STEPS; i++) {
            if in_front && s > turn - inner_half {
                // Through the hole: nothing there.
                in_front = false;
                s = max(s, turn + inner_half);
            }
            if s > last {
                break;
            }
            let at = torus_at(course, body, s);
            if at.value < best {
                best = at.value;
                best_s = s;
            }
            if at.value <= 1e-6 * body.extent * body.radius {
                found = true;
                break;
            }
            let discriminant = at.first * at.first - 2.0 * curvature * at.value;
            let divisor = sqrt(max(discriminant, 0.0)) - at.first;
            if discriminant < 0.0 || divisor <= 0.0 {
                if !in_front || inner_half <= 0.0 {
                    break;
                }
                in_front = false;
                s = max(turn + inner_half, first);
                continue;
            }
            s += 2.0 * at.value / divisor;
        }
    }
    // How deep inside the outline: the least F of this passage.
    var deepest_s = best_s;
    for (var i = 0; i < 3; i++) {
        let at = torus_at(course, body, deepest_s);
        deepest_s -= at.first / max(at.second, 0.5);
    }
    deepest_s = clamp(deepest_s, first, max(first, last));
    let deepest = min(torus_at(course, body, deepest_s).value, best);
    let miss = sqrt(max(deepest + body.radius * body.radius, 0.0));
    var clearance = body.radius - miss;
    if !found {
        clearance = min(clearance, 0.0);
    } else {
        clearance = max(clearance, 1e-30);
    }
    if best > 1e29 {
        clearance = -1e30;
    }
    let place = nearest + n * best_s;
    return Surface(
        clearance,
        torus_normal(nearest + n * deepest_s, body),
        middle + best_s,
        place,
        torus_normal(place, body),
    );
}

// From the nearest point of the middle circle, towards `place`.
fn torus_normal(place: vec3f, body: Body) -> vec3f {
    let height = dot(place, body.axis);
    let from_axis = place - body.axis * height;
    let rho = max(sqrt(dot(from_axis, from_axis)), 1e-30);
    let outward = place - from_axis * (body.extent / rho);
    return outward / max(sqrt(dot(outward, outward)), 1e-30);
}
