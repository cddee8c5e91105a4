// Patterns on a cylinder with flat ends.

// That of the side or of an end, not what lies between them where a pixel shows both.
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
