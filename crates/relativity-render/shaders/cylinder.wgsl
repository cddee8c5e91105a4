// Ray against a cylinder with flat ends: `place` is its middle, `form` half its lengths along its own axes.

// Whether `around` is all of it.
const IS_TUBE = false;

fn middle(body: Body) -> vec3f {
    return body.place;
}

fn around(body: Body) -> Capsule {
    return Capsule(body.place, body.place, length(halves(body)));
}

fn surface(body: Body, ray: Ray) -> Surface {
    let own = own_ray(body, ray);
    let n = own.direction;
    let half = halves(body);
    let radius = half.x;
    let extent = half.z;
    // Across the axis. A ray along it is treated as turned by a millionth: over the body's size it moves by
    // less than f32 resolves.
    let is_along = dot(n.xy, n.xy) < 1e-12;
    let sine = select(sqrt(dot(n.xy, n.xy)), 1e-6, is_along);
    let cosine = abs(n.z);
    let flat = select(n.xy / sine, vec2f(1.0, 0.0), is_along);
    // As seen along the ray: off the axis, and along its image.
    let towards = dot(flat, own.nearest.xy);
    let x = flat.x * own.nearest.y - flat.y * own.nearest.x;
    let y = sine * own.nearest.z - n.z * towards;
    let off_axis = vec3f(-flat.y, flat.x, 0.0);
    let along_axis = vec3f(-n.z * flat, sine);

    // The ends are ellipses, and between their middles are two straight lines.
    let beyond_end = abs(y) - extent * sine;
    let chord = sqrt(max((radius - x) * (radius + x), 0.0));
    let end = ellipse(x, beyond_end, radius, cosine);
    var clearance = radius - abs(x);
    var outward = off_axis * sign_of(x);
    if beyond_end > 0.0 {
        clearance = end.inside;
        outward = off_axis * end.outward.x + along_axis * (end.outward.y * sign_of(y));
    } else {
        // Seen from the side an end is a line.
        let slant = vec2f(cosine * x, chord) / max(length(vec2f(cosine * x, chord)), 1e-30);
        let to_end = (cosine * chord - beyond_end) * slant.y;
        if to_end < clearance {
            clearance = to_end;
            outward = off_axis * slant.x + along_axis * (slant.y * sign_of(y));
        }
    }

    let rise = sign_of(n.z);
    let slope = max(cosine, 1e-12);
    let enters_side = (-towards - chord) / sine;
    let enters_end = -(extent + rise * own.nearest.z) / slope;
    let leaves = min((chord - towards) / sine, (extent - rise * own.nearest.z) / slope);
    let s = min(max(enters_side, enters_end), leaves);
    // A ray that misses has its place where it comes close.
    let reached = own.nearest + n * s;
    let shrunk = radius / max(length(reached.xy), radius);
    let place = vec3f(reached.xy * shrunk, clamp(reached.z, -extent, extent));
    let beyond = dot(body.place, ray.direction) + dot(place, n);

    // The rim of the end in sight, as an ellipse about that end's middle. Where it is no outline, the side
    // adjoins.
    let from_end = y + rise * extent * sine;
    let rim = ellipse(x, from_end, radius, cosine);
    let across = rest_from_body(off_axis * rim.outward.x + along_axis * rim.outward.y, body);
    let is_side = enters_side > enters_end;
    let width = select(extent * sine, cosine * chord, is_side) * 2.0 * abs(rim.outward.y);
    let adjoins = is_side || from_end * rise > 0.0;
    let share = select(0.0, share_of_other(abs(rim.inside), width, across, ray, beyond), adjoins);
    let side_normal = vec3f(place.xy / max(length(place.xy), 1e-30), 0.0);
    let end_normal = vec3f(0.0, 0.0, -rise);
    let normal = mix(end_normal, side_normal, select(share, 1.0 - share, is_side));

    return Surface(
        clearance,
        min(radius, extent * sine + radius * cosine),
        rest_from_body(outward, body),
        beyond,
        rest_from_body(place, body),
        rest_from_body(normal, body),
    );
}

struct Ellipse {
    // How far inside it is, to first order near the outline.
    inside: f32,
    // Unit vector across the outline.
    outward: vec2f,
}

// Where (x, y) is in an ellipse with the half axes `radius` and `radius` times `cosine`.
fn ellipse(x: f32, y: f32, radius: f32, cosine: f32) -> Ellipse {
    let level = length(vec2f(cosine * x, y));
    let gradient = vec2f(cosine * cosine * x, y);
    let steepness = max(length(gradient), 1e-30);
    return Ellipse(level * (radius * cosine - level) / steepness, gradient / steepness);
}

// The normal of the side or of an end, not what lies between them where a pixel shows both.
fn normal_at(body: Body, place: vec3f, normal: vec3f) -> vec3f {
    let half = halves(body);
    if half.z - abs(place.z) < half.x - length(place.xy) {
        return vec3f(0.0, 0.0, sign_of(place.z));
    }
    return vec3f(place.xy / max(length(place.xy), 1e-30), 0.0);
}

fn darkness(body: Body, pattern: vec3f, place: vec3f, normal: vec3f, covered: Covered) -> f32 {
    let half = halves(body);
    let off_axis = max(length(place.xy), 1e-30);
    let outward = vec3f(place.xy / off_axis, 0.0);
    var along = place.z + half.z;
    var along_gradient = vec3f(0.0, 0.0, 1.0);
    if normal.z != 0.0 {
        along = half.z + normal.z * (half.z + half.x - off_axis);
        along_gradient = -normal.z * outward;
    }
    let chart = Chart(
        along,
        along_gradient,
        angle_to(place.y, place.x),
        vec3f(-outward.y, outward.x, 0.0) / off_axis,
        off_axis,
        place.z - normal.z * NUDGE * pattern.y + half.z,
        vec3f(0.0, 0.0, 1.0),
    );
    return darkness_of_chart(chart, pattern, covered);
}
