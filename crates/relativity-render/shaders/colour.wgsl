// Received light: from a Doppler factor to linear sRGB. The same as `screen_light.rs`, `tone.rs`, `hatch.rs`
// and `shade.rs` in `light/`, by tables.

// How colours are found: 0 as at rest, 1 by one place in a table, 2 daylight, 3 by the Doppler factor, 4 the
// street's daylight.
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
// Of the tables: entries per octave, and the place of daylight at rest.
override GLOW_PER_OCTAVE: f32;
override BAND_PER_OCTAVE: f32;
override DAYLIGHT_PLACE: f32;
// log2 of the quanta of daylight at the beginning of the table of bands.
override DAYLIGHT_QUANTA: f32;
// Below this speed the parts of the street's daylight are weighted as at it; and the largest gamma beta that
// it lights.
override LEAST_BETA: f32;
override MOST_RAPID: f32;

// The tables' rows. The share of a light that eyes do not see stands in the row after it.
const LINE_ROW = 0;
const GLOW_ROW = 2;
const BAND_ROW = 4;
const MAP_ROW = 5;

// `light` as a screen shows it; w: its unseen share, where it is all but black.
fn shown(light: vec3f, row: i32, place: f32) -> vec4f {
    let largest = max(light.r, max(light.g, light.b));
    let toned = shoulder(largest);
    let colour = light * (toned / max(largest, 1e-30));
    var unseen = 0.0;
    if INVISIBLE {
        let left = 1.0 - toned;
        let last = f32(textureDimensions(tables).x) - 1.0;
        let entry = vec2i(i32(clamp(place, 0.0, last) + 0.5), row + 1);
        unseen = textureLoad(tables, entry, 0).r * (left * left * left * left);
    }
    return vec4f(colour, unseen);
}

// The colour of light with this unseen share, from -1 (ultraviolet) to 1 (infrared), in the pixel with this
// middle.
fn hatched(unseen: f32, pixel: vec2f) -> vec3f {
    let periods = (pixel.x + select(-pixel.y, pixel.y, unseen > 0.0)) * frame.hatch[0].y;
    let from_line = abs(fract(periods) - 0.5) * frame.hatch[0].x;
    let cover = clamp(frame.hatch[0].z - from_line + 0.5, 0.0, 1.0);
    let between = select(frame.hatch[1].www, frame.hatch[1].rgb, unseen > 0.0);
    return abs(unseen) * (between + frame.hatch[0].w * cover);
}

// `light`: of one place in a table that place at rest, how far it moves per octave of the shift (back for
// light of one wavelength, forth for a black body), the exponent n of D^n, and log2 of the exposure.
fn of_one_place(light: vec4f, octaves: f32, shift: f32) -> vec4f {
    let row = select(GLOW_ROW, LINE_ROW, light.y < 0.0);
    let place = light.x + light.y * shift;
    let entry = looked_up(row, place);
    return shown(entry.rgb * power_of_two(entry.a + light.z * octaves + light.w), row, place);
}

// `light`: of daylight the band's place at rest, log2 of the exposure for the band and for all wavelengths,
// and the exponent with which the band becomes brighter.
fn of_daylight(light: vec4f, octaves: f32, shift: f32) -> vec4f {
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

// The angle with this cosine, within 7e-5: M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions,
// 4.4.45.
fn arc_cosine(cosine: f32) -> f32 {
    let x = abs(cosine);
    let sum = 1.5707288 + x * (-0.2121144 + x * (0.074261 - 0.0187293 * x));
    let angle = sqrt(max(1.0 - x, 0.0)) * sum;
    return select(angle, 3.14159265 - angle, cosine < 0.0);
}

// 1 - 2^-octaves.
fn missing(octaves: f32) -> f32 {
    let natural = octaves * 0.69314718;
    return select(1.0 - power_of_two(-octaves), natural * (1.0 - 0.5 * natural), natural < 0.01);
}

// Places of Gauss and Legendre in [0, 1], and their weights.
const PARTS = array<vec2f, 6>(
    vec2f(0.0337652429, 0.0856622462),
    vec2f(0.1693953068, 0.1803807865),
    vec2f(0.380690407, 0.2339569673),
    vec2f(0.619309593, 0.2339569673),
    vec2f(0.8306046932, 0.1803807865),
    vec2f(0.9662347571, 0.0856622462),
);

// `light` as of daylight; its parts as `light/daylight.rs` has them, the hottest first.
fn of_street_daylight(light: vec4f, shift: f32, facing: Facing) -> vec4f {
    let ahead = facing.ahead;
    let gamma = sqrt(1.0 + facing.rapid * facing.rapid);
    let beta = facing.rapid / gamma;
    let below_light = 1.0 / (gamma * gamma * (1.0 + beta));
    let weighed = max(beta, LEAST_BETA);
    let beside = select(below_light, 1.0 - LEAST_BETA, beta < LEAST_BETA);
    let across = sqrt(max(1.0 - ahead * ahead, 0.0));
    let faces_back = ahead < 0.0;
    let hottest = beside + select(0.0, weighed * ahead * ahead / (1.0 + across), faces_back);
    let coldest = 1.0 + weighed * select(across, 1.0, faces_back);
    let first = log2(hottest);
    let octaves = log2(coldest / hottest);
    let own = looked_up(BAND_ROW, light.x - BAND_PER_OCTAVE * shift);
    let quanta = power_of_two(DAYLIGHT_QUANTA - light.x / BAND_PER_OCTAVE);
    let own_power = own.a + light.w * shift + light.y + quanta;
    let at_rest = missing(quanta);
    let last = f32(textureDimensions(tables).x) - 1.0;
    var parts = PARTS;
    var sum = vec3f(0.0);
    var shares = 0.0;
    var beyond = 0.0;
    var hottest_place = 0.0;
    for (var i = 0; i < 6; i++) {
        let slowed = exp2(first + octaves * parts[i].x);
        let aside = clamp((slowed - beside) / weighed, 0.0, 2.0);
        let along = ahead * (1.0 - aside);
        let sideways = across * sqrt(max(aside * (2.0 - aside), 0.0));
        let half_turn = arc_cosine(clamp(-along / max(sideways, 1e-9), -1.0, 1.0));
        let seen = along * half_turn + sqrt(max(sideways * sideways - along * along, 0.0));
        let share = parts[i].y * slowed * seen;
        let log2_doppler = -log2(gamma * (below_light + beta * aside));
        let place = DAYLIGHT_PLACE + GLOW_PER_OCTAVE * (shift + log2_doppler);
        let white = looked_up(GLOW_ROW, place);
        let received = quanta * power_of_two(-log2_doppler);
        // Hotter than the table, light of any wavelength rises as the temperature.
        let hotter = max(place - last, 0.0) / GLOW_PER_OCTAVE;
        let white_power = white.a + light.z + hotter;
        if i == 0 {
            // Beyond what floats hold all are held back alike: so their mixture keeps its hue.
            beyond = max(max(white_power, own_power - received) - MOST_POWER, 0.0);
            hottest_place = place;
        }
        let more = at_rest / max(missing(received), 1e-30);
        sum += share * (white.rgb * power_of_two(white_power - beyond)
            + own.rgb * (power_of_two(own_power - received - beyond) * more));
        shares += share;
    }
    return shown(sum / max(shares, 1e-30), GLOW_ROW, hottest_place);
}

fn colour_of(light: vec4f, doppler: f32, facing: Facing) -> vec4f {
    let octaves = log2(doppler);
    let shift = select(0.0, octaves, DOPPLER_SHIFT);
    switch SPECTRUM {
        case 0u: { return light; }
        case 1u: { return of_one_place(light, octaves, shift); }
        case 2u: { return of_daylight(light, octaves, shift); }
        case 4u: { return of_street_daylight(light, shift, facing); }
        default: { return vec4f(looked_up(MAP_ROW, MAP_MIDDLE + MAP_PER_OCTAVE * octaves).rgb, 0.0); }
    }
}

// Of a body with this `light`, which is rgb and the unseen share at rest, else as above, in the pixel with
// this middle. Form comes after the shoulder: so it shows in what is very bright, and in what is all but
// black.
fn received_colour(light: vec4f, doppler: f32, normal: vec3f, facing: Facing, pixel: vec2f) -> vec3f {
    let found = colour_of(light, doppler, facing);
    var colour = found.rgb;
    if INVISIBLE || SPECTRUM == 0u {
        colour += hatched(found.a, pixel);
    }
    if FORM {
        return colour * (FORM_ACROSS + FORM_TOWARDS * dot(normal, vec3f(LIGHT_X, LIGHT_Y, LIGHT_Z)));
    }
    return colour;
}
