// What the samples of a rectangle show of a model of triangles: each looks into the model for itself.
//
// Of a model `Piece.pattern` is the row that it begins with, and whether it is seen from both sides.

struct OfModel {
    triangle: u32,
    ray: Ray,
    // Rest-frame distance along the ray beyond the middle of its group.
    beyond: f32,
    // The point, from the body's middle.
    place: vec3f,
    normal: vec3f,
    number: u32,
    weights: vec3f,
    doppler: f32,
}

fn none_of_model(ray: Ray) -> OfModel {
    return OfModel(0u, ray, 0.0, vec3f(0.0), vec3f(0.0), 0u, vec3f(0.0), 1.0);
}

// The same of a model that turns.
fn turning_model_at(fragment: Fragment, ray: Ray, body: Body) -> OfModel {
    let row = u32(fragment.pattern.x);
    let spin = spin_of(fragment.spin, fragment.rim);
    let path = path_of(body, ray, spin);
    let hub_along = dot(spin.hub, ray.direction);
    let met = first_met_by_path(row, path, -(ray.to_centre + hub_along), fragment.pattern.y > 0.0);
    if met.triangle == 0u {
        return none_of_model(ray);
    }
    let triangle = triangle_at(row, met.triangle & ~IS_LEAF);
    let q = path.nearest + path.direction * met.distance;
    let place = (spin.hub + q) - middle(body);
    let own = normal_of(triangle, path_at(path, met.distance).tangent);
    let normal = rest_from_body(own, standing(body, place, spin).body);
    let doppler = doppler_of(body, place, normal, ray.sight, ray.doppler, spin);
    let beyond = hub_along + met.distance;
    return OfModel(met.triangle, ray, beyond, place, normal, triangle.number, met.weights, doppler);
}

fn model_at(fragment: Fragment, place: vec2f) -> OfModel {
    let ray = rest_ray(place);
    let body = body_of(fragment);
    if TURNS == 2u {
        return turning_model_at(fragment, ray, body);
    }
    let row = u32(fragment.pattern.x);
    let own = own_ray(body, ray);
    let along = dot(body.place, ray.direction);
    let behind = -(ray.to_centre + along);
    let reach = length(body.form.xyz);
    if !(dot(own.nearest, own.nearest) < reach * reach) {
        return none_of_model(ray);
    }
    let met = first_met(row, own.nearest, own.direction, behind, fragment.pattern.y > 0.0);
    let triangle = triangle_at(row, met.triangle & ~IS_LEAF);
    let there = triangle.a * met.weights.x + triangle.b * met.weights.y + triangle.c * met.weights.z;
    let normal = normal_of(triangle, own.direction);
    return OfModel(
        met.triangle,
        ray,
        along + met.distance,
        rest_from_body(there, body),
        rest_from_body(normal, body),
        triangle.number,
        met.weights,
        ray.doppler,
    );
}

// The sample at this place, px.
fn sample_at(fragment: Fragment, place: vec2f) -> Sample {
    let hit = model_at(fragment, place);
    let body = body_of(fragment);
    let own_height = frame.middle.z + body.place.z + hit.place.z;
    let height = height_on_ground(own_height, body.place + hit.place);
    if !(hit.triangle != 0u && height >= frame.ground.z) {
        discard;
    }
    let spin = spin_of(fragment.spin, fragment.rim);
    let facing = facing_of(body, hit.place, hit.normal, spin);
    let row = u32(fragment.pattern.x);
    let record = hit.triangle & ~IS_LEAF;
    let there = standing(body, hit.place, spin).body;
    let normal = body_from_rest(hit.normal, there);
    let distance = (hit.ray.to_centre + hit.beyond) * hit.ray.ground_per_rest;
    // A sample is half a pixel wide.
    let paint = paint_at(row, record, hit.weights)
        * texture_at(row, record, hit.weights, there, hit.ray, normal, distance, 0.5);
    let painted = vec4f(paint, material_at(row, record));
    let colour = received_colour(fragment.light, painted, hit.doppler, hit.normal, facing, floor(place) + 0.5)
        * fragment.index_brightness.y;
    return Sample(vec4f(colour, 1.0), depth(hit.ray, hit.beyond));
}

@fragment
fn hits(fragment: Fragment) -> Hit {
    let hit = model_at(fragment, pixel_at(fragment.position));
    if hit.triangle == 0u {
        discard;
    }
    let distance = (hit.ray.to_centre + hit.beyond) * hit.ray.ground_per_rest;
    return Hit(
        bitcast<vec4u>(vec4f(fragment.index_brightness.x, distance, hit.doppler, 1.0)),
        bitcast<vec4u>(vec4f(
            place_of_hit(body_of(fragment), hit.place, spin_of(fragment.spin, fragment.rim)),
            f32(hit.number),
        )),
        depth(hit.ray, hit.beyond),
    );
}
