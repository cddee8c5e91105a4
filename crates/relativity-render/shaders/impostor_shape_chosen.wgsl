// The picture of a shape on devices whose shaders choose the samples of a pixel: all four at once.

struct Picture {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
    @builtin(sample_mask) samples: u32,
}

@fragment
fn picture(fragment: Fragment) -> Picture {
    let shaded = shaded(fragment, fragment.position.xy);
    let clearances = vec4f(shaded.clearance) + shaded.gradient.x * SAMPLE_U + shaded.gradient.y * SAMPLE_V;
    let inside = select(vec4u(0u), vec4u(1u, 2u, 4u, 8u), clearances > vec4f(0.0));
    return Picture(shaded.colour, shaded.depth, inside.x + inside.y + inside.z + inside.w);
}
