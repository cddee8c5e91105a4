// Ray against a box: `place` is its middle, `form` half its lengths along its own axes.

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
    let steep = abs(n);
    // Along the ray the box is a hexagon, inside three pairs of lines along the images of its axes. The image
    // of an axis along the ray is a point, and its lines cut off less than f32 resolves.
    let sines = sqrt(n.yzx * n.yzx + n.zxy * n.zxy);
    let is_point = sines < vec3f(1e-5);
    let divisors = max(sines, vec3f(1e-5));
    let spans = half.yzx * steep.zxy + half.zxy * steep.yzx;
    let widths = select(spans / divisors, vec3f(1e30), is_point);
    let inside = select((spans - abs(own.moment)) / divisors, vec3f(1e30), is_point);
    let clearance = min(inside.x, min(inside.y, inside.z));
    let side = first_of(inside == vec3f(clearance));
    let outward = cross(n, side) * (-sign_of(dot(own.moment, side)) / max(dot(divisors, side), 1e-5));

    let towards = select(vec3f(1.0), vec3f(-1.0), n < vec3f(0.0));
    let slopes = max(steep, vec3f(1e-12));
    let enters = -(half + towards * own.nearest) / slopes;
    let leaves = (half - towards * own.nearest) / slopes;
    let last_entry = max(enters.x, max(enters.y, enters.z));
    let s = min(last_entry, min(leaves.x, min(leaves.y, leaves.z)));
    // A ray that misses has its place where it comes close.
    let place = clamp(own.nearest + n * s, -half, half);
    let beyond = dot(body.place, ray.direction) + dot(place, n);

    // The three faces in sight meet in the nearest corner, from which three edges run along the axes.
    let face = first_of(enters == vec3f(last_entry));
    let others = select(enters, vec3f(-1e30), face > vec3f(0.0));
    let second = first_of(others == vec3f(max(others.x, max(others.y, others.z))));
    let edge = vec3f(1.0) - face - second;
    let divisor = max(dot(sines, edge), 1e-5);
    let of_edge = dot(cross(towards * half, n), edge);
    let from_edge = abs(dot(own.moment, edge) - of_edge) / divisor;
    let width = (dot(spans, edge) - abs(of_edge)) / divisor;
    let across = rest_from_body(cross(n, edge) / divisor, body);
    let share = share_of_other(from_edge, width, across, ray, beyond);
    let normal = -towards * mix(face, second, share);

    return Surface(
        clearance,
        min(widths.x, min(widths.y, widths.z)),
        rest_from_body(outward, body),
        beyond,
        rest_from_body(place, body),
        rest_from_body(normal, body),
    );
}

// The first axis among those `chosen`.
fn first_of(chosen: vec3<bool>) -> vec3f {
    if chosen.x {
        return vec3f(1.0, 0.0, 0.0);
    }
    return select(vec3f(0.0, 0.0, 1.0), vec3f(0.0, 1.0, 0.0), chosen.y);
}
