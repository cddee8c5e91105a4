// The rest-frame ray of a pixel, and where along it things lie.

// 0 as seen, 1 contracted only, 2 at rest.
override GEOMETRY: u32;

struct Ray {
    // Unit vector towards the source, in the ground frame.
    sight: vec3f,
    // 1/length of the unnormalised line of sight.
    scale: f32,
    // Unit vector towards the source in the rest frame.
    direction: vec3f,
    // Ground distance per rest-frame distance.
    ground_per_rest: f32,
    doppler: f32,
    // Of the scene's centre: its moment about the ray, and its distance along it.
    moment: vec3f,
    to_centre: f32,
}

fn rest_ray(pixel: vec2f) -> Ray {
    let sight = line_of_sight(pixel);
    let n = sight.xyz;
    var direction = n;
    var ground_per_rest = 1.0;
    var doppler = 1.0;
    if GEOMETRY == 0u {
        // Aberration: n* = (n_x + beta, n_y/gamma, n_z/gamma)/(1 + beta n_x), D = 1/(gamma (1 + beta n_x)),
        // from 1 + n_x = (n_y^2 + n_z^2)/(1 - n_x) where the printed forms cancel.
        let transverse_squared = n.y * n.y + n.z * n.z;
        let one_plus_x = select(1.0 + n.x, transverse_squared / (1.0 - n.x), n.x < 0.0);
        let reciprocal = 1.0 / (frame.speed.y + frame.speed.x * one_plus_x);
        doppler = frame.speed.z * reciprocal;
        direction = vec3f((one_plus_x - frame.speed.y) * reciprocal, n.yz * doppler);
        ground_per_rest = doppler;
    } else if GEOMETRY == 1u {
        // The contracted body stretched back to its rest shape, and the ray with it: by 1 along x and 1/gamma
        // across, brought up to 1 before it is squared.
        let flattened = vec3f(n.x, n.yz * frame.speed.z);
        let largest = max(abs(flattened.x), max(abs(flattened.y), abs(flattened.z)));
        let scaled = flattened / largest;
        let reciprocal = 1.0 / sqrt(dot(scaled, scaled));
        ground_per_rest = frame.speed.z * reciprocal / largest;
        direction = scaled * reciprocal;
    }
    let centre = frame.scene.xyz;
    let moment = cross(centre, direction) + cross(frame.scene_fine.xyz, direction);
    return Ray(n, sight.w, direction, ground_per_rest, doppler, moment, dot(centre, direction));
}

// How far the ray's direction (rest frame) moves along the unit vector `across`, perpendicular to it, from
// one pixel to the next, to the right and down.
fn movement(ray: Ray, across: vec3f) -> vec2f {
    var ground = across;
    if GEOMETRY == 0u {
        // The transpose of the differential of aberration, which is conformal with scale D.
        let along = frame.speed.x * frame.speed.w * dot(across.yz, ray.direction.yz);
        ground = ray.doppler * vec3f(ray.doppler * across.x - along, across.yz);
    } else if GEOMETRY == 1u {
        ground = vec3f(across.x * frame.speed.w, across.yz) * ray.ground_per_rest;
    }
    let turned = (ground - ray.sight * dot(ray.sight, ground)) * ray.scale;
    return vec2f(dot(turned, frame.right.xyz), dot(turned, frame.down.xyz));
}

// Where the ray comes closest to `anchor` (from the scene's centre), from there. The double cross product
// keeps its digits however far the camera is; |c|^2 - (c.n)^2 would not.
fn nearest_to(anchor: vec3f, ray: Ray) -> vec3f {
    return -cross(ray.direction, ray.moment + cross(anchor, ray.direction));
}

// Depth of what lies `beyond` the scene's centre along a ray: 1 is nearest. Measured from the centre,
// since distances from a camera far away in the rest frame differ by less than f32 resolves.
fn depth(beyond: f32) -> f32 {
    return 0.5 - beyond * frame.scene.w;
}
