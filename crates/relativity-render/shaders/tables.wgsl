// The tables of colours, see `light/palette.rs`, and the shoulder of `light/tone.rs`.

// A table per row, see `light/palette.rs`; the last component is log2 of what the colour is multiplied by.
@group(0) @binding(1) var tables: texture_2d<f32>;

// Up to here light is shown as it is.
override KNEE: f32;
// Of tables over the Doppler factor: the place of D = 1, and entries per octave.
override MAP_MIDDLE: f32;
override MAP_PER_OCTAVE: f32;

fn looked_up(row: i32, place: f32) -> vec4f {
    let last = i32(textureDimensions(tables).x) - 1;
    let inside = clamp(place, 0.0, f32(last));
    let below = min(i32(inside), last - 1);
    let low = textureLoad(tables, vec2i(below, row), 0);
    let high = textureLoad(tables, vec2i(below + 1, row), 0);
    return mix(low, high, inside - f32(below));
}

// The largest power of two that light is multiplied by: within what floats hold with room to spare.
const MOST_POWER = 100.0;

// 2^x, held within that.
fn power_of_two(x: f32) -> f32 {
    return exp2(clamp(x, -MOST_POWER, MOST_POWER));
}

fn shoulder(x: f32) -> f32 {
    let above = max(x - KNEE, 0.0) / (1.0 - KNEE);
    return min(x, KNEE) + (1.0 - KNEE) * (above / (1.0 + above));
}
