// Patterns on a tube with rounded ends, or on a ball.

fn normal_at(body: Body, place: vec3f, normal: vec3f) -> vec3f {
    return normal;
}

fn darkness(body: Body, pattern: vec3f, place: vec3f, normal: vec3f, covered: Covered) -> f32 {
    let length = body.form.xyz - body.place;
    let half = 0.5 * sqrt(dot(length, length));
    let off_axis = max(sqrt(dot(place.xy, place.xy)), 1e-30);
    let outward = vec3f(place.xy / off_axis, 0.0);
    let beyond = place.z - clamp(place.z, -half, half);
    let arc = arc_to(off_axis, outward, beyond, body.radius);
    let chart = Chart(
        half + (place.z - beyond) + arc.length,
        arc.gradient,
        angle_to(place.y, place.x),
        vec3f(-outward.y, outward.x, 0.0) / off_axis,
        off_axis,
        place.z - normal.z * NUDGE * pattern.y + half,
        vec3f(0.0, 0.0, 1.0),
    );
    return darkness_of_chart(chart, pattern, covered);
}
