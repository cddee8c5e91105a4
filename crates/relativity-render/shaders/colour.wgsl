// Received light: from a Doppler factor to linear sRGB. The same as `screen_light.rs`, `tone.rs`, `hatch.rs`
// and `shade.rs` in `light/`, by tables.

// How colours are found: 0 as at rest, 1 by a place in the tables, 2 the street's daylight, 3 by the Doppler
// factor.
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
// Of the tables: entries per octave, and the number of rows of paints in daylight.
override LINE_PER_OCTAVE: f32;
override GLOW_PER_OCTAVE: f32;
override PAINTS: i32;
// Below this speed the parts of the street's daylight are weighted as at it; and the largest gamma beta that
// it lights.
override LEAST_BETA: f32;
override MOST_RAPID: f32;

const LUMINANCE = vec3f(0.2126, 0.7152, 0.0722);

// `light` as a screen shows it; w: its unseen share, where it is all but black.
fn shown(light: vec3f, unseen: f32) -> vec4f {
    let largest = max(light.r, max(light.g, light.b));
    let toned = shoulder(largest);
    let left = 1.0 - toned;
    return vec4f(light * (toned / max(largest, 1e-30)), unseen * (left * left * left * left));
}

// The unseen share of light of this row.
fn unseen_at(row: i32, place: f32) -> f32 {
    if !INVISIBLE {
        return 0.0;
    }
    let last = f32(textureDimensions(tables).x) - 1.0;
    let entry = i32(clamp(place, 0.0, last) + 0.5);
    return textureLoad(tables, vec2i(entry, select(row + 2, UNSEEN_DAYLIGHT_ROW, row >= FIRST_SUNLIT)), 0).r;
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

// How far a place in this row moves per octave of the shift: back for light of one wavelength.
fn per_octave_of(row: i32) -> f32 {
    return select(select(GLOW_PER_OCTAVE, -LINE_PER_OCTAVE, row == LINE_ROW), SUNLIT_PER_OCTAVE, row >= FIRST_SUNLIT);
}

// `light` as `Light::packed` in `light/screen_light.rs` has it. Of `paint` the last number is below 0 where
// there is none, else it is one more than the number of a measured material, or 0 for the others.
fn of_place(light: vec4f, octaves: f32, shift: f32, paint: vec4f) -> vec4f {
    var row = kind_of(light, paint);
    var place: f32;
    var entry: vec4f;
    if row < 0 {
        place = SUNLIT_AT_REST + SUNLIT_PER_OCTAVE * shift;
        row = FIRST_SUNLIT;
        entry = sunlit(FIRST_SUNLIT, shares_of(light, paint), place);
    } else {
        place = light.y + per_octave_of(row) * shift;
        entry = risen(looked_up(row, place), place, abs(per_octave_of(row)));
    }
    var linear = entry.rgb * power_of_two(entry.a + light.z * octaves + light.w);
    if row >= FIRST_SUNLIT {
        linear = on_screen(linear);
    } else if paint.w >= 0.0 {
        linear *= paint.rgb;
    }
    return shown(linear, unseen_at(row, place));
}

// The row of this light on this paint; -1 for smooth paint.
fn kind_of(light: vec4f, paint: vec4f) -> i32 {
    if light.x >= 0.0 {
        return -1;
    }
    let row = i32(-light.x) - 1;
    if paint.w >= 0.0 && row == WHITE_ROW {
        return select(-1, WHITE_ROW + i32(paint.w), paint.w > 0.0);
    }
    return row;
}

// The shares of red, green and blue in smooth paint.
fn shares_of(light: vec4f, paint: vec4f) -> vec3f {
    return select(paint.rgb, vec3f(light.xy, 1.0 - light.x - light.y), light.x >= 0.0);
}

// The angle with this cosine, within 7e-5: M. Abramowitz, I. A. Stegun, Handbook of Mathematical Functions,
// 4.4.45.
fn arc_cosine(cosine: f32) -> f32 {
    let x = abs(cosine);
    let sum = 1.5707288 + x * (-0.2121144 + x * (0.074261 - 0.0187293 * x));
    let angle = sqrt(max(1.0 - x, 0.0)) * sum;
    return select(angle, 3.14159265 - angle, cosine < 0.0);
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

// `light` and `paint` as above; its parts as `light/daylight.rs` has them, the hottest first. Paint other than
// white is smooth paint that stands for it, and what is left of its colour: see `colour/sunlit.rs`.
fn of_street_daylight(light: vec4f, shift: f32, facing: Facing, paint: vec4f) -> vec4f {
    let row = kind_of(light, paint);
    let seen_at = SUNLIT_AT_REST + SUNLIT_PER_OCTAVE * shift;
    var stand_in = vec3f(0.0);
    var rest = vec3f(0.0);
    if row < 0 {
        let of_paint = shares_of(light, paint);
        stand_in = sunlit(FIRST_SUNLIT + PAINTS, of_paint, seen_at).rgb;
        rest = sunlit(FIRST_SUNLIT, of_paint, seen_at).rgb;
    } else if row != WHITE_ROW {
        stand_in = looked_up(row + PAINTS, seen_at).rgb;
        rest = looked_up(row, seen_at).rgb;
    }
    let first_light = FIRST_SUNLIT + 2 * PAINTS;
    if row != WHITE_ROW {
        rest -= sunlit(first_light, stand_in, seen_at).rgb;
    }
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
        let place = SUNLIT_AT_REST + SUNLIT_PER_OCTAVE * (shift + log2_doppler);
        var entry: vec4f;
        if row == WHITE_ROW {
            entry = risen(looked_up(WHITE_ROW, place), place, SUNLIT_PER_OCTAVE);
        } else {
            entry = sunlit(first_light, stand_in, place) + vec4f(rest, 0.0);
        }
        let power = entry.a + light.w;
        if i == 0 {
            // Beyond what floats hold all are held back alike: so their mixture keeps its hue.
            beyond = max(power - MOST_POWER, 0.0);
            hottest_place = place;
        }
        sum += entry.rgb * (share * power_of_two(power - beyond));
        shares += share;
    }
    return shown(on_screen(sum / max(shares, 1e-30)), unseen_at(FIRST_SUNLIT, hottest_place));
}

fn colour_of(light: vec4f, doppler: f32, facing: Facing, paint: vec4f) -> vec4f {
    let factors = select(vec3f(1.0), paint.rgb, paint.w >= 0.0);
    if SPECTRUM == 0u {
        return shown(light.rgb * factors, light.a);
    }
    let octaves = log2(doppler);
    if SPECTRUM == 3u {
        let grey = dot(factors, LUMINANCE);
        return vec4f(looked_up(MAP_ROW, MAP_MIDDLE + MAP_PER_OCTAVE * octaves).rgb * grey, 0.0);
    }
    let shift = select(0.0, octaves, DOPPLER_SHIFT);
    let is_daylight = light.x >= 0.0 || i32(-light.x) - 1 >= FIRST_SUNLIT;
    if SPECTRUM == 2u && is_daylight {
        return of_street_daylight(light, shift, facing, paint);
    }
    return of_place(light, octaves, shift, paint);
}

// Of a body with this `light`, which is rgb and the unseen share at rest, else as above, on this `paint`, in
// the pixel with this middle. Form comes after the shoulder: so it shows in what is very bright, and in what is all but
// black.
fn received_colour(
    light: vec4f,
    paint: vec4f,
    doppler: f32,
    normal: vec3f,
    facing: Facing,
    pixel: vec2f,
) -> vec3f {
    let found = colour_of(light, doppler, facing, paint);
    var colour = found.rgb;
    if INVISIBLE {
        colour += hatched(found.a, pixel);
    }
    if FORM {
        return colour * (FORM_ACROSS + FORM_TOWARDS * dot(normal, vec3f(LIGHT_X, LIGHT_Y, LIGHT_Z)));
    }
    return colour;
}
