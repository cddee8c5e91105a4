// The picture of a model on devices whose shaders choose the samples of a pixel: each by itself.

@fragment
fn picture(fragment: Fragment, @builtin(sample_index) index: u32) -> Sample {
    let middle = floor(fragment.position.xy) + 0.5;
    return sample_at(fragment, middle + vec2f(SAMPLE_U[index], SAMPLE_V[index]));
}
