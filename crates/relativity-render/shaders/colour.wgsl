// Received light: from a Doppler factor to linear sRGB. The same as `light.rs`, `tone.rs` and `shade.rs`, by tables.

// A table per row, see `palette.rs`; the last component is log2 of what the colour is multiplied by.
@group(0) @binding(1) var tables: texture_2d<f32>;

// How colours are found: 0 as at rest, 1 by one place in a table, 2 daylight, 3 by the Doppler factor.
override SPECTRUM: u32;
// Whether the Doppler factor shifts the wavelength.
override DOPPLER_SHIFT: bool;
// Whether what eyes do not see keeps its form.
override INVISIBLE: bool;
// Whether form is shown by shading.
override FORM: bool;
// Unit vector towards the light of the shading, in the rest frame.
override LIGHT_X: f32;
override LIGHT_Y: f32;
override LIGHT_Z: f32;
// Brightness of a surface at right angles to that light, and how much turning towards it adds.
override FORM_ACROSS: f32;
override FORM_TOWARDS: f32;
// Up to here light is shown as it is.
override KNEE: f32;
// Of the tables: entries per octave, the place of daylight at rest, and that of D = 1.
override GLOW_PER_OCTAVE: f32;
override BAND_PER_OCTAVE: f32;
override DAYLIGHT_PLACE: f32;
override MAP_MIDDLE: f32;
override MAP_PER_OCTAVE: f32;

// The tables' rows. What eyes do not see of a light stands in the row after it.
const LINE_ROW = 0;
const GLOW_ROW = 2;
const BAND_ROW = 4;
const MAP_ROW = 5;

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

// `light` as a screen shows it, with what eyes do not see of it under it, where it is all but black.
fn shown(light: vec3f, row: i32, place: f32) -> vec3f {
    let largest = max(light.r, max(light.g, light.b));
    let toned = shoulder(largest);
    var colour = light * (toned / max(largest, 1e-30));
    if INVISIBLE {
        let left = 1.0 - toned;
        let last = f32(textureDimensions(tables).x) - 1.0;
        let entry = vec2i(i32(clamp(place, 0.0, last) + 0.5), row + 1);
        colour += textureLoad(tables, entry, 0).rgb * (left * left * left * left);
    }
    return colour;
}

// `light`: of one place in a table that place at rest, how far it moves per octave of the shift (back for light of one
// wavelength, forth for a black body), the exponent n of D^n, and log2 of the exposure.
fn of_one_place(light: vec4f, octaves: f32, shift: f32) -> vec3f {
    let row = select(GLOW_ROW, LINE_ROW, light.y < 0.0);
    let place = light.x + light.y * shift;
    let entry = looked_up(row, place);
    return shown(entry.rgb * power_of_two(entry.a + light.z * octaves + light.w), row, place);
}

// `light`: of daylight the band's place at rest, log2 of the exposure for the band and for all wavelengths, and the
// exponent with which the band becomes brighter.
fn of_daylight(light: vec4f, octaves: f32, shift: f32) -> vec3f {
    let place = DAYLIGHT_PLACE + GLOW_PER_OCTAVE * shift;
    let white = looked_up(GLOW_ROW, place);
    let own = looked_up(BAND_ROW, light.x - BAND_PER_OCTAVE * shift);
    let exponent = select(light.w, 0.0, DOPPLER_SHIFT);
    let white_power = white.a + exponent * octaves + light.z;
    let own_power = own.a + light.w * octaves + light.y;
    // Beyond what floats hold both are held back alike: so their mixture keeps its hue.
    let beyond = max(max(white_power, own_power) - MOST_POWER, 0.0);
    let sum = white.rgb * power_of_two(white_power - beyond) + own.rgb * power_of_two(own_power - beyond);
    return shown(sum, GLOW_ROW, place);
}

fn colour_of(light: vec4f, doppler: f32) -> vec3f {
    let octaves = log2(doppler);
    let shift = select(0.0, octaves, DOPPLER_SHIFT);
    switch SPECTRUM {
        case 0u: { return light.rgb; }
        case 1u: { return of_one_place(light, octaves, shift); }
        case 2u: { return of_daylight(light, octaves, shift); }
        default: { return looked_up(MAP_ROW, MAP_MIDDLE + MAP_PER_OCTAVE * octaves).rgb; }
    }
}

// Of a body with this `light`, which is rgb at rest, else as above. Form comes after the shoulder: so it shows in what is
// very bright, and in what is all but black.
fn received_colour(light: vec4f, doppler: f32, normal: vec3f) -> vec3f {
    let colour = colour_of(light, doppler);
    if FORM {
        return colour * (FORM_ACROSS + FORM_TOWARDS * dot(normal, vec3f(LIGHT_X, LIGHT_Y, LIGHT_Z)));
    }
    return colour;
}
