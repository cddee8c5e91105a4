// Triangles whose corners go through the apparent position: where the light cone of the aperture meets the
// worldline of each corner.

// As GEOMETRY; 3 is the published model's right eye.
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
    // Anchor from the scene's centre, and the number of the body.
    @location(5) @interpolate(flat) anchor_index: vec4f,
    @location(6) @interpolate(flat) cover: f32,
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
        case 0u: { return sighting(c); }
        case 1u: { return Sighting(vec3f(c.x * frame.speed.z, c.yz), 1.0); }
        case 2u: { return Sighting(c, 1.0); }
        default: {
            // The left eye's sighting at T - Delta T, as Appendix A prints it.
            let shift = frame.speed.x * frame.speed.w * delay(sighting(c).position);
            return sighting(c - vec3f(shift, 0.0, 0.0));
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
        vec4f(solid.anchor_radius.xyz, solid.across_index.w),
        solid.cover,
    );
}

// Nothing nearer than this is drawn.
const NEAR = 1e-4;

struct Measure {
    depth: f32,
    doppler: f32,
}

// From the pixel's own ray, which is better than what is interpolated between corners: the Doppler factor
// depends on the line of sight alone, and in the rest frame depth is not contracted.
fn measure(fragment: Fragment) -> Measure {
    if MAP == 3u {
        return Measure(1.0 / (1.0 + length(fragment.apparent)), fragment.doppler);
    }
    let ray = rest_ray(fragment.position.xy);
    let from_centre = fragment.anchor_index.xyz + fragment.place;
    return Measure(depth(dot(from_centre, ray.direction)), ray.doppler);
}

struct Picture {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn picture(fragment: Fragment) -> Picture {
    let measure = measure(fragment);
    let normal = fragment.normal / max(length(fragment.normal), 1e-30);
    let colour = received_colour(
        fragment.colour_wavelength.rgb,
        fragment.colour_wavelength.w,
        measure.doppler,
        normal,
    );
    if fragment.apparent.z < frame.ground.z {
        discard;
    }
    return Picture(vec4f(colour, 1.0) * fragment.cover, measure.depth);
}

// Floats as their bits: OpenGL ES does not draw to 32-bit floats.
struct Hit {
    // As the impostors'.
    @location(0) measures: vec4u,
    @location(1) place: vec4u,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn hits(fragment: Fragment) -> Hit {
    let measure = measure(fragment);
    return Hit(
        bitcast<vec4u>(
            vec4f(fragment.anchor_index.w, length(fragment.apparent), measure.doppler, 1.0),
        ),
        bitcast<vec4u>(vec4f(fragment.place, 0.0)),
        measure.depth,
    );
}
