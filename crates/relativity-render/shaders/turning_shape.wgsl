// Where a ray meets a shape as it is shown.
fn surface_when_shown(body: Body, ray: Ray, spin: Spin) -> Surface {
    if TURNS != 2u {
        return surface(body, ray);
    }
    let capsule = around(body);
    let course = course_through(capsule, ray, spin);
    if IS_TUBE {
        return tube_when_shown(body, course, spin);
    }
    let length = course.end - course.start;
    if abs(spin.omega) * length < SHORT {
        return surface_near(body, ray, spin, 0.5 * (course.start + course.end), 1.5 * length);
    }
    let start = first_at_tube(course).s;
    return surface_near(body, ray, spin, start, 0.5 * SHORT / abs(spin.omega) + capsule.radius);
}
