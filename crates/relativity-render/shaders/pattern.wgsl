// Patterns on bodies: the share of its light, in (0, 1], that a body shows where a ray meets it.
//
// Repeats `scene/pattern/mod.rs`, which says what each line is for and gives these. Each shape has
// `normal_at` and `darkness`, in the body's own axes.

// Whether any body of this draw carries a pattern.
override PATTERNS: bool;
// Whether both eyes have one light cone.
override ONE_CONE: bool;
override DARK: f32;
override LINE_REACH: f32;
override PIP_RADIUS: f32;
override PIP_PLACE: f32;
override RIM: f32;
override LEAST_COVERED: f32;
override MOST_COVERED: f32;
override NUDGE: f32;
override GRAZING: f32;

// As `Ruling`; 0 is none.
const FACES = 1.0;
const GRATICULE = 2.0;
const CHEQUER = 3.0;

// How far the place that a pixel shows moves on the surface towards the pixel on the right, and below.
struct Covered {
    right: vec3f,
    down: vec3f,
}

// Where a place is on a round shape, in the body's own axes.
struct Chart {
    // Arc along the axis, and its gradient.
    along: f32,
    along_gradient: vec3f,
    // Angle around the axis, and its gradient.
    around: f32,
    around_gradient: vec3f,
    off_axis: f32,
    // What stripes lie across, and its gradient.
    level: f32,
    level_gradient: vec3f,
}

// The mark of `pattern` (its ruling, and its steps along and around) on `body` at `place` (from its middle),
// at this ground distance along the ray.
fn mark(body: Body, pattern: vec3f, place: vec3f, normal: vec3f, ray: Ray, distance: f32) -> f32 {
    if pattern.x == 0.0 {
        return 1.0;
    }
    let own_place = body_from_rest(place, body);
    let own_normal = normal_at(body, own_place, body_from_rest(normal, body));
    let covered = covered_by_pixel(ray, own_normal, distance, body);
    let dark = darkness(body, pattern, own_place, own_normal, covered);
    return 1.0 - (1.0 - DARK) * clamp(dark, 0.0, 1.0);
}

fn covered_by_pixel(ray: Ray, normal: vec3f, distance: f32, body: Body) -> Covered {
    let direction = body_from_rest(ray.direction, body);
    let right = body_from_rest(shift(ray, step_right(ray.sight), distance), body);
    let down = body_from_rest(shift(ray, step_down(ray.sight), distance), body);
    return Covered(
        on_surface(right, direction, normal) * distance,
        on_surface(down, direction, normal) * distance,
    );
}

// As `GroupView::shift` where both eyes have one light cone.
fn shift_in_one_cone(ray: Ray, turn: vec3f, distance: f32) -> vec3f {
    let n = motion_from_group(ray.direction);
    let place = motion_from_sight(ray.sight) * distance + frame.eye.xyz;
    let step = motion_from_sight(turn);
    let later = frame.speed.x * dot(place, step) / max(length(place), 1e-30);
    let moved = vec3f(frame.speed.w * (step.x + later), step.yz);
    let off = moved - n * dot(moved, n);
    // At great speeds most of it was along the motion, and along the ray.
    return group_from_motion(vec3f(select(off.x, -dot(off.yz, n.yz) / n.x, abs(n.x) >= 0.5), off.yz));
}

// How far what is seen moves in the rest frame from pixel to pixel along `across`, per ground distance, but
// for what is along the ray.
fn shift(ray: Ray, across: vec3f, distance: f32) -> vec3f {
    let turn = (across - ray.sight * dot(ray.sight, across)) * ray.scale;
    if ONE_CONE {
        return shift_in_one_cone(ray, turn, distance);
    }
    if GEOMETRY == 0u {
        let step = motion_from_sight(turn);
        let along = frame.speed.x * frame.speed.w * step.x;
        let direction = motion_from_group(ray.direction);
        return group_from_motion(vec3f(ray.doppler * step.x, step.yz - along * direction.yz));
    }
    if GEOMETRY == 1u {
        let step = motion_from_sight(turn);
        return group_from_motion(vec3f(frame.speed.w * step.x, step.yz));
    }
    if OBLIQUE {
        return group_from_motion(turn);
    }
    return turn;
}

fn on_surface(shift: vec3f, direction: vec3f, normal: vec3f) -> vec3f {
    return shift - direction * (dot(shift, normal) / min(dot(direction, normal), -GRAZING));
}

fn covered_of(gradient: vec3f, covered: Covered) -> f32 {
    let right = dot(gradient, covered.right);
    let down = dot(gradient, covered.down);
    return sqrt(right * right + down * down);
}

fn darkness_of_chart(chart: Chart, pattern: vec3f, covered: Covered) -> f32 {
    if pattern.x > CHEQUER {
        return 0.5 - 0.5 * wave(chart.level / pattern.y, covered_of(chart.level_gradient, covered) / pattern.y);
    }
    let along = chart.along / pattern.y;
    let around = chart.around / pattern.z;
    let along_covered = covered_of(chart.along_gradient, covered) / pattern.y;
    let around_covered = covered_of(chart.around_gradient, covered) / pattern.z;
    if pattern.x == CHEQUER {
        return 0.5 - 0.5 * wave(along, along_covered) * wave(around, around_covered);
    }
    let width = LINE_REACH * pattern.y / max(chart.off_axis * pattern.z, 1e-30);
    let quarter = 1.5707963268 / pattern.z;
    return max(line(along, LINE_REACH, quarter, along_covered), line(around, width, quarter, around_covered));
}

struct Arc {
    length: f32,
    gradient: vec3f,
}

fn arc_to(off: f32, outward: vec3f, z: f32, radius: f32) -> Arc {
    let gradient = vec3f(-outward.xy * z, off) / max(sqrt(off * off + z * z), 1e-30);
    return Arc(radius * angle_to(z, off), gradient);
}

// atan2(y, x), within 1e-6. M. Abramowitz and I. A. Stegun, *Handbook of Mathematical Functions* (1964),
// 4.4.49.
fn angle_to(y: f32, x: f32) -> f32 {
    let width = abs(x);
    let height = abs(y);
    let slope = min(width, height) / max(max(width, height), 1e-30);
    let s = slope * slope;
    let high = 0.0429096138 + s * (-0.0161657367 + s * 0.0028662257);
    let low = -0.1420889944 + s * (0.1065626393 + s * (-0.0752896400 + s * high));
    let small = slope * (1.0 + s * (-0.3333314528 + s * (0.1999355085 + s * low)));
    let steep = select(small, 1.5707963268 - small, height > width);
    let angle = select(steep, 3.1415926536 - steep, x < 0.0);
    return select(angle, -angle, y < 0.0);
}

fn line(x: f32, half_width: f32, quarter: f32, covered: f32) -> f32 {
    let nearest = round(x);
    let from_quarter = abs(nearest - quarter * round(nearest / quarter));
    let half = min(select(half_width, 2.0 * half_width, from_quarter < 0.5), 0.5);
    let width = clamp(covered, LEAST_COVERED, MOST_COVERED);
    let low = line_before(x - nearest - 0.5 * width, half);
    return (line_before(x - nearest + 0.5 * width, half) - low) / width;
}

fn line_before(x: f32, half: f32) -> f32 {
    return 2.0 * half * round(x) + clamp(x - round(x), -half, half);
}

fn wave(x: f32, covered: f32) -> f32 {
    let near = x - 2.0 * round(0.5 * x);
    let width = clamp(covered, LEAST_COVERED, MOST_COVERED);
    return (sawtooth(near + 0.5 * width) - sawtooth(near - 0.5 * width)) / width;
}

fn sawtooth(x: f32) -> f32 {
    return abs(x - 2.0 * round(0.5 * x));
}
