// Patterns on a box.

// That of the face, not what lies between two where a pixel shows both.
fn normal_at(body: Body, place: vec3f, normal: vec3f) -> vec3f {
    let below = halves(body) - abs(place);
    let sides = vec3f(sign_of(place.x), sign_of(place.y), sign_of(place.z));
    if below.x < min(below.y, below.z) {
        return vec3f(sides.x, 0.0, 0.0);
    }
    return select(vec3f(0.0, 0.0, sides.z), vec3f(0.0, sides.y, 0.0), below.y < below.z);
}

fn darkness(body: Body, pattern: vec3f, place: vec3f, normal: vec3f, covered: Covered) -> f32 {
    let half = halves(body);
    if pattern.x == FACES {
        return face(half, place, normal, covered);
    }
    let levels = (place - normal * (NUDGE * pattern.y) + half) / pattern.y;
    let along_x = wave(levels.x, covered_of(vec3f(1.0, 0.0, 0.0), covered) / pattern.y);
    if pattern.x != CHEQUER {
        return 0.5 - 0.5 * along_x;
    }
    let along_y = wave(levels.y, covered_of(vec3f(0.0, 1.0, 0.0), covered) / pattern.y);
    let along_z = wave(levels.z, covered_of(vec3f(0.0, 0.0, 1.0), covered) / pattern.y);
    return 0.5 - 0.5 * along_x * along_y * along_z;
}

// How dark a die's face is.
fn face(half: vec3f, place: vec3f, normal: vec3f, covered: Covered) -> f32 {
    let side = abs(normal);
    // The axes of the face: those that follow its normal's.
    let a = side.zxy;
    let b = side.yzx;
    let first = dot(side, vec3f(1.0, 2.0, 3.0));
    let number = select(7.0 - first, first, dot(side, normal) > 0.0);
    let half_a = dot(half, a);
    let half_b = dot(half, b);
    let at_a = dot(place, a);
    let at_b = dot(place, b);
    let smaller = min(half_a, half_b);
    let corner_a = at_a - PIP_PLACE * half_a * sign_of(at_a);
    let corner_b = at_b - PIP_PLACE * half_b * sign_of(at_b);
    let radius = PIP_RADIUS * smaller;
    var dark = max(
        rim(half_a - abs(at_a), RIM * smaller, covered_of(a, covered)),
        rim(half_b - abs(at_b), RIM * smaller, covered_of(b, covered)),
    );
    if number > select(3.5, 1.5, at_a * at_b > 0.0) {
        dark = max(dark, pip(corner_a * a + corner_b * b, radius, covered));
    }
    if number == 1.0 || number == 3.0 || number == 5.0 {
        dark = max(dark, pip(at_a * a + at_b * b, radius, covered));
    }
    if number == 6.0 {
        dark = max(dark, pip(corner_a * a + at_b * b, radius, covered));
    }
    return dark;
}

// At this place from its middle.
fn pip(off: vec3f, radius: f32, covered: Covered) -> f32 {
    let distance = length(off);
    let width = covered_of(off / max(distance, 1e-30), covered);
    let wide = max(radius, 0.5 * width);
    let share = clamp((wide - distance) / max(width, 1e-30) + 0.5, 0.0, 1.0);
    return share * (radius / wide) * (radius / wide);
}

fn rim(distance: f32, width: f32, covered: f32) -> f32 {
    let wide = max(covered, 1e-6 * width);
    return max((min(distance + 0.5 * wide, width) - max(distance - 0.5 * wide, 0.0)) / wide, 0.0);
}
