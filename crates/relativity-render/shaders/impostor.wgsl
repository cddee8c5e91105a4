// One bounding rectangle per piece of a body; the ray test runs in the fragment stage and gives the depth.

struct Piece {
    // Rectangle in the picture (clip coordinates): centre and first half axis; without axes it is the
    // `footprint`.
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
    let corner = vec2f(f32(vertex & 1u), f32(vertex >> 1u));
    let axes = vec4f(piece.place.zw, piece.second_axis_index_brightness.xy);
    let along = 2.0 * corner - 1.0;
    var place = piece.place.xy + axes.xy * along.x + axes.zw * along.y;
    if all(axes == vec4f(0.0)) {
        let own = footprint(Body(piece.place_radius.xyz, piece.place_radius.w, piece.form, piece.turn));
        place = mix(own.low, own.high, corner);
    }
    return Fragment(
        vec4f(place, 0.5, 1.0),
        piece.place_radius,
        piece.form,
        piece.turn,
        exposed(piece.light),
        piece.second_axis_index_brightness.zw,
        piece.pattern,
        piece.spin,
        piece.rim,
    );
}

fn body_of(fragment: Fragment) -> Body {
    return Body(fragment.place_radius.xyz, fragment.place_radius.w, fragment.form, fragment.turn);
}

// The four samples of a pixel, from its centre, in the standard places.
const SAMPLE_U = vec4f(-0.125, 0.375, -0.375, 0.125);
const SAMPLE_V = vec4f(-0.375, -0.125, 0.125, 0.375);

// A sample of a picture.
struct Sample {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
}

// Floats as their bits: OpenGL ES does not draw to 32-bit floats.
struct Hit {
    // Number of the body, ground distance, Doppler factor, 1 (a hit).
    @location(0) measures: vec4u,
    // The point, in the rest frame, as `place_of_hit` has it, and of a model the number of its triangle.
    @location(1) place: vec4u,
    @builtin(frag_depth) depth: f32,
}
