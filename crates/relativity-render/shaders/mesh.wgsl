// Triangles whose corners go through the apparent position: where the light cone of the aperture meets the
// worldline of each corner.

// 0 as seen, 1 contracted only, 2 at rest (as GEOMETRY), 3 the published model's right eye.
override MAP: u32 = 0u;

struct Corner {
    // Place on the unit shape; see the shape's `corner_place`.
    @location(0) profile: vec4f,
    @location(1) turn: vec2f,
}

struct Solid {
    // Anchor from the scene's centre in the rest frame, and the radius.
    @location(2) anchor_radius: vec4f,
    // Unit axis and extent along it (tube) or radius of the middle circle (ring).
    @location(3) axis_extent: vec4f,
    // Unit vector across the axis; number of the body.
    @location(4) across_index: vec4f,
    // Linear sRGB without Doppler shift; rest wavelength in nm.
    @location(5) colour_wavelength: vec4f,
    // How much of a pixel a body thinner than one covers.
    @location(6) cover: f32,
}

struct Fragment {
    @builtin(position) position: vec4f,
    // From the anchor, rest frame.
    @location(0) place: vec3f,
    @location(1) normal: vec3f,
    // From the aperture.
    @location(2) apparent: vec3f,
    @location(3) doppler: f32,
    @location(4) @interpolate(flat) colour_wavelength: vec4f,
    @location(5) @interpolate(flat) index_cover: vec2f,
}

struct Sighting {
    position: vec3f,
    doppler: f32,
}

// What is seen of a point at rest at `c` from the camera's event: X = gamma (c_x - beta |c|) and
// R = gamma (|c| - beta c_x), for c_x > 0 as quotients of what does not cancel.
fn sighting(c: vec3f) -> Sighting {
    let beta = frame.speed.x;
    let gamma = frame.speed.w;
    let rho_squared = c.y * c.y + c.z * c.z;
    let rest_distance = max(sqrt(c.x * c.x + rho_squared), 1e-30);
    var x = gamma * (c.x - beta * rest_distance);
    var distance = gamma * (rest_distance - beta * c.x);
    if c.x > 0.0 {
        let along = c.x * frame.speed.z;
        let contracted_squared = along * along;
        x = gamma * (contracted_squared - beta * beta * rho_squared) / (c.x + beta * rest_distance);
        distance = gamma * (contracted_squared + rho_squared) / (rest_distance + beta * c.x);
    }
    return Sighting(vec3f(x, c.yz), distance / rest_distance);
}

// The paper's Delta T (eq. 5): how much longer the light that the left eye sees takes to the right eye.
fn delay(left: vec3f) -> f32 {
    let separation = frame.ground.w;
    let event_x = left.x - 0.5 * separation;
    let to_right = left - vec3f(separation, 0.0, 0.0);
    return -2.0 * event_x * separation / (sqrt(dot(left, left)) + sqrt(dot(to_right, to_right)));
}

fn mapped(c: vec3f) -> Sighting {
    switch MAP {
        case 0u: {
            let seen = sighting(c);
            return Sighting(seen.position, 1.0 / seen.doppler);
        }
        case 1u: { return Sighting(vec3f(c.x * frame.speed.z, c.yz), 1.0); }
        case 2u: { return Sighting(c, 1.0); }
        default: {
            // The left eye's sighting at T - Delta T, as Appendix A prints it.
            let shift = frame.speed.x * frame.speed.w * delay(sighting(c).position);
            let seen = sighting(c - vec3f(shift, 0.0, 0.0));
            return Sighting(seen.position, 1.0 / seen.doppler);
        }
    }
}

@vertex
fn corner(corner: Corner, solid: Solid) -> Fragment {
    let side = cross(solid.axis_extent.xyz, solid.across_index.xyz);
    let outward = corner.turn.x * solid.across_index.xyz + corner.turn.y * side;
    let shape = corner_place(corner, solid, outward);
    let seen = mapped(frame.scene.xyz + (solid.anchor_radius.xyz + shape.place));
    let clip = vec4f(
        dot(seen.position, frame.clip_right.xyz),
        dot(seen.position, frame.clip_up.xyz),
        NEAR,
        dot(seen.position, frame.forward.xyz),
    );
    return Fragment(
        clip,
        shape.place,
        shape.normal,
        seen.position,
        seen.doppler,
        solid.colour_wavelength,
        vec2f(solid.across_index.w, solid.cover),
    );
}

// Nothing nearer than this is drawn.
const NEAR = 1e-4;

fn doppler_of(fragment: Fragment) -> f32 {
    if MAP == 0u {
        // It depends on the line of sight alone, so the pixel's own is better than the corners'.
        return rest_ray(fragment.position.xy).doppler;
    }
    return fragment.doppler;
}

@fragment
fn picture(fragment: Fragment) -> @location(0) vec4f {
    let normal = fragment.normal / max(sqrt(dot(fragment.normal, fragment.normal)), 1e-30);
    let colour = received_colour(
        fragment.colour_wavelength.rgb,
        fragment.colour_wavelength.w,
        doppler_of(fragment),
        normal,
    );
    if fragment.apparent.z < frame.ground.z {
        discard;
    }
    let cover = fragment.index_cover.y;
    return vec4f(colour * cover, cover);
}

struct Hit {
    // As the impostors'.
    @location(0) measures: vec4f,
    @location(1) place: vec4f,
}

@fragment
fn hits(fragment: Fragment) -> Hit {
    let distance = sqrt(dot(fragment.apparent, fragment.apparent));
    return Hit(
        vec4f(fragment.index_cover.x, distance, doppler_of(fragment), 1.0),
        vec4f(fragment.place, 0.0),
    );
}
