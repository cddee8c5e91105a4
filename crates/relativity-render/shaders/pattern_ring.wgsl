// Patterns on a ring.

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
