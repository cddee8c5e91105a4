// The tables of colours, see `light/palette.rs`, and the shoulder of `light/tone.rs`.

// A table per row, see `light/palette.rs`; the last component is log2 of what the colour is multiplied by.
@group(0) @binding(1) var tables: texture_2d<f32>;

// Up to here light is shown as it is.
override KNEE: f32;
// Of tables over the Doppler factor: the place of D = 1, and entries per octave.
override MAP_MIDDLE: f32;
override MAP_PER_OCTAVE: f32;
override SUNLIT_AT_REST: f32;
override SUNLIT_PER_OCTAVE: f32;

// The tables' rows: see `Row` of `light/palette.rs`.
const LINE_ROW = 0;
const MAP_ROW = 4;
const FALSE_ROW = 5;
const UNSEEN_DAYLIGHT_ROW = 6;
const SKY_ROW = 7;
const FIRST_SUNLIT = 8;
const WHITE_ROW = 11;

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

// The entry at a place of a row with so many entries per octave: beyond the end light rises on.
fn risen(entry: vec4f, place: f32, per_octave: f32) -> vec4f {
    let last = f32(textureDimensions(tables).x) - 1.0;
    return vec4f(entry.rgb, entry.a + max(place - last, 0.0) / per_octave);
}

// The sum of the colours of red, green and blue paint with these shares, in the rows from `first` on; w: log2
// of what it is multiplied by.
fn sunlit(first: i32, shares: vec3f, place: f32) -> vec4f {
    let red = looked_up(first, place);
    let sum = red.rgb * shares.r
        + looked_up(first + 1, place).rgb * shares.g
        + looked_up(first + 2, place).rgb * shares.b;
    return risen(vec4f(sum, red.a), place, SUNLIT_PER_OCTAVE);
}

// `light` as a screen can show it: where a component is below 0 the colour moves towards grey of the same
// luminance until none is.
fn on_screen(light: vec3f) -> vec3f {
    let least = min(min(light.r, min(light.g, light.b)), 0.0);
    if least == 0.0 {
        return light;
    }
    let grey = max(dot(light, vec3f(0.2126, 0.7152, 0.0722)), 0.0);
    return max(grey + (light - grey) * (grey / max(grey - least, 1e-30)), vec3f(0.0));
}
