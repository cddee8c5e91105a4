// A picture in which each sample is a pixel of its own.

@fragment
fn picture(fragment: Fragment) -> Sample {
    return sample_at(fragment, pixel_at(fragment.position));
}
