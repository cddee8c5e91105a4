// What the pixels of a rectangle show of a body with a shape of its own.

// What is seen of a body at a place, how deep inside the outline that lies, and how fast that changes from
// pixel to pixel; in pixels.
struct Shaded {
    colour: vec4f,
    depth: f32,
    clearance: f32,
    gradient: vec2f,
}

fn shaded(fragment: Fragment, place: vec2f) -> Shaded {
    let ray = rest_ray(place);
    let body = body_of(fragment);
    let spin = spin_of(fragment.spin, fragment.rim);
    let hit = surface_when_shown(body, ray, spin);
    // How fast the ray moves across the outline from pixel to pixel.
    let distance = ray.to_centre + hit.beyond;
    let gradient = -max(distance, 0.0) * movement(ray, hit.outward);
    var clearance = hit.clearance;
    var alpha = 1.0;
    if THIN {
        let half_pixel = 0.5 * length(gradient);
        alpha = min(hit.half_width / max(half_pixel, 1e-30), 1.0);
        clearance += max(half_pixel - hit.half_width, 0.0);
    }
    let own_height = frame.middle.z + middle(body).z + hit.place.z;
    let height = height_on_ground(own_height, middle(body) + hit.place);
    // So that what is no number is nowhere: where light leaves farther away than f32 can say.
    if !(distance > 0.0 && height >= frame.ground.z) {
        discard;
    }
    let doppler = doppler_of(body, hit.place, hit.normal, ray.sight, ray.doppler, spin);
    let facing = facing_of(body, hit.place, hit.normal, spin);
    let paint = vec4f(1.0, 1.0, 1.0, -1.0);
    var colour = received_colour(fragment.light, paint, doppler, hit.normal, facing, floor(place) + 0.5)
        * fragment.index_brightness.y;
    if PATTERNS {
        let there = standing(body, hit.place, spin);
        let ground_distance = distance * ray.ground_per_rest;
        colour *= mark(there.body, fragment.pattern, there.place, hit.normal, ray, ground_distance);
    }
    return Shaded(vec4f(colour * alpha, alpha), depth(ray, hit.beyond), clearance, gradient);
}

// The sample at this place, px.
fn sample_at(fragment: Fragment, place: vec2f) -> Sample {
    let shaded = shaded(fragment, place);
    if !(shaded.clearance > 0.0) {
        discard;
    }
    return Sample(shaded.colour, shaded.depth);
}

@fragment
fn hits(fragment: Fragment) -> Hit {
    let ray = rest_ray(pixel_at(fragment.position));
    let body = body_of(fragment);
    let spin = spin_of(fragment.spin, fragment.rim);
    let hit = surface_when_shown(body, ray, spin);
    let distance = ray.to_centre + hit.beyond;
    if !(hit.clearance > 0.0 && distance > 0.0) {
        discard;
    }
    let doppler = doppler_of(body, hit.place, hit.normal, ray.sight, ray.doppler, spin);
    return Hit(
        bitcast<vec4u>(vec4f(fragment.index_brightness.x, distance * ray.ground_per_rest, doppler, 1.0)),
        bitcast<vec4u>(vec4f(place_of_hit(body, hit.place, spin), 0.0)),
        depth(ray, hit.beyond),
    );
}
