// Ray against a ball.

fn surface(body: Body, ray: Ray) -> Surface {
    let n = ray.direction;
    let nearest = nearest_to(body.anchor, ray);
    let miss = sqrt(dot(nearest, nearest));
    let half_chord = sqrt(max((body.radius - miss) * (body.radius + miss), 0.0));
    let outward = nearest / max(miss, 1e-30);
    let place = nearest - n * half_chord;
    var normal = outward;
    if half_chord > 0.0 {
        normal = place / body.radius;
    }
    return Surface(body.radius - miss, outward, dot(body.anchor, n) - half_chord, place, normal);
}
