// Received light: from Doppler factor and wavelength to linear sRGB.

@group(0) @binding(1) var colour_table: texture_2d<f32>;

// Whether the Doppler factor shifts the wavelength.
override DOPPLER_SHIFT: bool;
// Intensity D^n: 0 leaves it out, 2, 3 and 4 are n, anything else takes n from the frame.
override INTENSITY: u32;
// Whether form is shown by shading.
override FORM: bool;
// Unit vector towards the light of the shading, in the rest frame.
override LIGHT_X: f32;
override LIGHT_Y: f32;
override LIGHT_Z: f32;
// Brightness of a surface at right angles to that light, and how much turning towards it adds.
override FORM_ACROSS: f32;
override FORM_TOWARDS: f32;

fn table_colour(wavelength_nm: f32) -> vec3f {
    let last = i32(textureDimensions(colour_table).x) - 1;
    let place = clamp((log2(wavelength_nm) - frame.light.z) * frame.light.w, 0.0, f32(last));
    let below = min(i32(place), last - 1);
    let low = textureLoad(colour_table, vec2i(below, 0), 0).rgb;
    let high = textureLoad(colour_table, vec2i(below + 1, 0), 0).rgb;
    return mix(low, high, place - f32(below));
}

fn intensity(doppler: f32) -> f32 {
    let squared = doppler * doppler;
    switch INTENSITY {
        case 0u: { return 1.0; }
        case 2u: { return squared; }
        case 3u: { return squared * doppler; }
        case 4u: { return squared * squared; }
        default: { return pow(doppler, frame.light.y); }
    }
}

// `rest_colour` is the colour without Doppler shift. Too bright a colour is dimmed, which keeps its hue.
fn received_colour(rest_colour: vec3f, rest_wavelength_nm: f32, doppler: f32, normal: vec3f) -> vec3f {
    var light = rest_colour;
    if DOPPLER_SHIFT && rest_wavelength_nm > 0.0 {
        light = table_colour(rest_wavelength_nm / doppler);
    }
    light *= frame.light.x * intensity(doppler);
    if FORM {
        light *= FORM_ACROSS + FORM_TOWARDS * dot(normal, vec3f(LIGHT_X, LIGHT_Y, LIGHT_Z));
    }
    return light / max(1.0, max(light.r, max(light.g, light.b)));
}
