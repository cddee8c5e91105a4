// A model of triangles in a box, one of whose triangles a pixel shows: that is the surface which a ray meets
// there.

// Whether `around` is all of it.
const IS_TUBE = false;

// The triangle of this pixel, its place there in the axes of the model, and its unit normal on the side that
// is seen; and that place from the hub, as it is shown, of a model that turns.
var<private> current: Triangle;
var<private> current_place: vec3f;
var<private> current_normal: vec3f;
var<private> current_from_hub: vec3f;

fn middle(body: Body) -> vec3f {
    return body.place;
}

fn around(body: Body) -> Capsule {
    return Capsule(body.place, body.place, length(halves(body)));
}

// Where a ray meets the triangle as it is shown: of one that turns, in rounds from where the pixel shows it.
fn surface_when_shown(body: Body, ray: Ray, spin: Spin) -> Surface {
    if TURNS != 2u {
        return surface(body, ray);
    }
    return surface_near(body, ray, spin, dot(current_from_hub, ray.direction), length(body.form.xyz));
}

// A ray that misses the triangle has its place where the pixel shows that.
fn surface(body: Body, ray: Ray) -> Surface {
    let own = own_ray(body, ray);
    let along = dot(body.place, ray.direction);
    let met = met_triangle(sheared(own.nearest, own.direction), current, true, -1e30);
    if met.w > -1e30 {
        let place = current.a * met.x + current.b * met.y + current.c * met.z;
        let normal = normal_of(current, own.direction);
        let beyond = along + met.w;
        return Surface(1.0, 1e30, vec3f(0.0), beyond, rest_from_body(place, body), rest_from_body(normal, body));
    }
    let beyond = along + dot(current_place, own.direction);
    let normal = rest_from_body(current_normal, body);
    return Surface(-1.0, 1e30, vec3f(0.0), beyond, rest_from_body(current_place, body), normal);
}
