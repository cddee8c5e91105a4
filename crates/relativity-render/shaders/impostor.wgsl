// One bounding rectangle per piece of a body; the ray test runs in the fragment stage and gives the depth.

struct Piece {
    // Rectangle in the picture (clip coordinates): centre and first half axis.
    @location(0) place: vec4f,
    // Second half axis, number of the body, its brightness.
    @location(1) second_axis_index_brightness: vec4f,
    // The `Body`.
    @location(2) place_radius: vec4f,
    @location(3) form: vec4f,
    @location(4) turn: vec4f,
    // As `received_colour` takes it.
    @location(5) light: vec4f,
    // As `mark` reads it.
    @location(6) pattern: vec3f,
    // The `Spin`.
    @location(7) spin: vec4f,
    @location(8) rim: vec2f,
}

struct Fragment {
    @builtin(position) position: vec4f,
    @location(0) @interpolate(flat) place_radius: vec4f,
    @location(1) @interpolate(flat) form: vec4f,
    @location(2) @interpolate(flat) turn: vec4f,
    @location(3) @interpolate(flat) light: vec4f,
    @location(4) @interpolate(flat) index_brightness: vec2f,
    @location(5) @interpolate(flat) pattern: vec3f,
    @location(6) @interpolate(flat) spin: vec4f,
    @location(7) @interpolate(flat) rim: vec2f,
}

@vertex
fn rectangle(@builtin(vertex_index) vertex: u32, piece: Piece) -> Fragment {
    let corner = vec2f(f32(vertex & 1u), f32(vertex >> 1u)) * 2.0 - 1.0;
    let place = piece.place.xy + piece.place.zw * corner.x + piece.second_axis_index_brightness.xy * corner.y;
    return Fragment(
        vec4f(place, 0.5, 1.0),
        piece.place_radius,
        piece.form,
        piece.turn,
        piece.light,
        piece.second_axis_index_brightness.zw,
        piece.pattern,
        piece.spin,
        piece.rim,
    );
}

fn body_of(fragment: Fragment) -> Body {
    return Body(fragment.place_radius.xyz, fragment.place_radius.w, fragment.form, fragment.turn);
}

// What a pixel shows of a body, and how deep inside the outline each of its samples lies, in pixels.
struct Shaded {
    colour: vec4f,
    depth: f32,
    clearances: vec4f,
}

// The four samples of a pixel, from its centre, in the standard places.
const SAMPLE_U = vec4f(-0.125, 0.375, -0.375, 0.125);
const SAMPLE_V = vec4f(-0.375, -0.125, 0.125, 0.375);

fn shaded(fragment: Fragment) -> Shaded {
    let ray = rest_ray(fragment.position.xy);
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
    let height = frame.middle.z + middle(body).z + hit.place.z;
    // So that what is no number is nowhere: where light leaves farther away than f32 can say.
    if !(distance > 0.0 && height >= frame.ground.z) {
        discard;
    }
    let doppler = doppler_of(body, hit.place, hit.normal, ray.sight, ray.doppler, spin);
    let facing = facing_of(body, hit.place, hit.normal, spin);
    var colour = received_colour(fragment.light, doppler, hit.normal, facing, fragment.position.xy)
        * fragment.index_brightness.y;
    if PATTERNS {
        let there = standing(body, hit.place, spin);
        let ground_distance = distance * ray.ground_per_rest;
        colour *= mark(there.body, fragment.pattern, there.place, hit.normal, ray, ground_distance);
    }
    let clearances = vec4f(clearance) + gradient.x * SAMPLE_U + gradient.y * SAMPLE_V;
    return Shaded(vec4f(colour * alpha, alpha), depth(ray, hit.beyond), clearances);
}

struct Picture {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
    @builtin(sample_mask) samples: u32,
}

@fragment
fn picture(fragment: Fragment) -> Picture {
    let shaded = shaded(fragment);
    let inside = select(vec4u(0u), vec4u(1u, 2u, 4u, 8u), shaded.clearances > vec4f(0.0));
    return Picture(shaded.colour, shaded.depth, inside.x + inside.y + inside.z + inside.w);
}

struct Sample {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
}

// The same sample by sample, at four times the cost: for OpenGL, where wgpu cannot write a sample mask.
@fragment
fn picture_sample(fragment: Fragment, @builtin(sample_index) index: u32) -> Sample {
    let shaded = shaded(fragment);
    if !(shaded.clearances[index] > 0.0) {
        discard;
    }
    return Sample(shaded.colour, shaded.depth);
}

// Floats as their bits: OpenGL ES does not draw to 32-bit floats.
struct Hit {
    // Number of the body, ground distance, Doppler factor, 1 (a hit).
    @location(0) measures: vec4u,
    // The point, in the rest frame, as `place_of_hit` has it.
    @location(1) place: vec4u,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn hits(fragment: Fragment) -> Hit {
    let ray = rest_ray(fragment.position.xy);
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
