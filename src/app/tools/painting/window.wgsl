// Paints what the toolkit has made triangles of, and shows what was painted. No branches and no noise:
// software runs both sides of a branch for each pixel.

struct Painted {
    @builtin(position) position: vec4<f32>,
    @location(0) colour: vec4<f32>,
    @location(1) place: vec2<f32>,
};

// 2 over the window's size in points.
@group(0) @binding(0) var<uniform> scale: vec4<f32>;

@vertex
fn vertex(@location(0) position: vec2<f32>, @location(1) place: vec2<f32>, @location(2) colour: vec4<f32>) -> Painted {
    var out: Painted;
    out.position = vec4<f32>(position.x * scale.x - 1.0, 1.0 - position.y * scale.y, 0.0, 1.0);
    out.colour = colour;
    out.place = place;
    return out;
}

@group(1) @binding(0) var image: texture_2d<f32>;
@group(1) @binding(1) var image_sampler: sampler;

@fragment
fn fragment(in: Painted) -> @location(0) vec4<f32> {
    return in.colour * textureSample(image, image_sampler, in.place);
}

@vertex
fn whole(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let corner = vec2<f32>(f32(index & 1u), f32(index >> 1u));
    return vec4<f32>(4.0 * corner - 1.0, 0.0, 1.0);
}

@group(0) @binding(1) var kept: texture_2d<f32>;

@fragment
fn show(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    return textureLoad(kept, vec2<i32>(position.xy), 0);
}
