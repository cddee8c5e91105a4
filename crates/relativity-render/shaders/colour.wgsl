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
// The largest gamma beta that the street's daylight lights; and of its table: the numbers of speeds, of turns
// and of entries, and how close they are.
override MOST_RAPID: f32;
override SKY_SPEEDS: i32;
override SKY_SPEEDS_PER_OCTAVE: f32;
override SKY_TURNS: i32;
override SKY_ENTRIES: i32;
override SKY_PER_OCTAVE: f32;

// The street's daylight as what moves reflects it, see `light/sky.rs`: a row for each speed and turn, and in
// it red, green and blue paint side by side.
@group(0) @binding(3) var sky: texture_2d<f32>;

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

// `light`, as `Light::packed` in `light/screen_light.rs` has it, with the exposure of the picture.
fn exposed(light: vec4f) -> vec4f {
    if SPECTRUM == 0u {
        return vec4f(light.rgb * frame.exposure.y, light.a);
    }
    return vec4f(light.xyz, light.w + frame.exposure.x);
}

// `light` is exposed. Of `paint` the last number is below 0 where there is none, else it is one more than the
// number of a measured material, or 0 for the others.
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

// log2 of e to what has this hyperbolic sine.
fn octaves_of_sinh(x: f32) -> f32 {
    let octaves = log2(abs(x) + sqrt(1.0 + x * x));
    return select(octaves, -octaves, x < 0.0);
}

// The colour of paint with these shares of red, green and blue, at a place in a row of the sky; w: log2 of
// white's level.
fn sky_at(row: i32, place: f32, shares: vec3f) -> vec4f {
    let below = min(i32(place), SKY_ENTRIES - 2);
    var sum = vec3f(0.0);
    var level = 0.0;
    for (var primary = 0; primary < 3; primary++) {
        let at = vec2i(primary * SKY_ENTRIES + below, row);
        let entry = mix(textureLoad(sky, at, 0), textureLoad(sky, at + vec2i(1, 0), 0), place - f32(below));
        sum += entry.rgb * shares[primary];
        level = entry.a;
    }
    return vec4f(sum, level);
}

// As `reflected` in `light/sky.rs`, of paint with these shares, where `octaves` is log2 of the mean Doppler
// factor.
fn reflected_of_sky(facing: Facing, octaves: f32, shares: vec3f) -> vec4f {
    let motion = octaves_of_sinh(facing.rapid);
    let of_normal = clamp(octaves_of_sinh(facing.rapid * facing.ahead) / max(motion, 1e-30), -1.0, 1.0);
    let speed = clamp(motion * SKY_SPEEDS_PER_OCTAVE, 0.0, f32(SKY_SPEEDS - 1));
    let turn = arc_cosine(-of_normal) / 3.14159265 * f32(SKY_TURNS - 1);
    let first = SUNLIT_AT_REST / SUNLIT_PER_OCTAVE;
    let place = (octaves + first) * SKY_PER_OCTAVE;
    let inside = clamp(place, 0.0, f32(SKY_ENTRIES - 1));
    let corner = vec2i(min(i32(speed), SKY_SPEEDS - 2), min(i32(turn), SKY_TURNS - 2));
    let share = vec2f(speed, turn) - vec2f(corner);
    let row = corner.x * SKY_TURNS + corner.y;
    let slower = mix(sky_at(row, inside, shares), sky_at(row + 1, inside, shares), share.y);
    let faster = row + SKY_TURNS;
    let found = mix(slower, mix(sky_at(faster, inside, shares), sky_at(faster + 1, inside, shares), share.y), share.x);
    return vec4f(found.rgb, found.a + max(place - f32(SKY_ENTRIES - 1), 0.0) / SKY_PER_OCTAVE);
}

// log2 of the mean Doppler factor of the light of a hemisphere: see `light/daylight.rs`.
fn mean_octaves(facing: Facing) -> f32 {
    let time = facing.rapid * facing.ahead;
    let across = sqrt(1.0 + time * time);
    let gamma = sqrt(1.0 + facing.rapid * facing.rapid);
    return log2(gamma / across * (1.0 - time / (3.0 * across))) + octaves_of_sinh(time);
}

// `light` and `paint` as above. Paint other than white is smooth paint that stands for it, and what is left
// of its colour: see `colour/sunlit.rs`.
fn of_street_daylight(light: vec4f, shift: f32, facing: Facing, paint: vec4f) -> vec4f {
    let row = kind_of(light, paint);
    let seen_at = SUNLIT_AT_REST + SUNLIT_PER_OCTAVE * shift;
    var stand_in = vec3f(1.0);
    var rest = vec3f(0.0);
    if row != WHITE_ROW {
        if row < 0 {
            let of_paint = shares_of(light, paint);
            stand_in = sunlit(FIRST_SUNLIT + PAINTS, of_paint, seen_at).rgb;
            rest = sunlit(FIRST_SUNLIT, of_paint, seen_at).rgb;
        } else {
            stand_in = looked_up(row + PAINTS, seen_at).rgb;
            rest = looked_up(row, seen_at).rgb;
        }
        rest -= sunlit(FIRST_SUNLIT + 2 * PAINTS, stand_in, seen_at).rgb;
    }
    let octaves = shift + mean_octaves(facing);
    let found = reflected_of_sky(facing, octaves, stand_in);
    let seen = on_screen((found.rgb + rest) * power_of_two(found.a + light.w));
    return shown(seen, unseen_at(FIRST_SUNLIT, SUNLIT_AT_REST + SUNLIT_PER_OCTAVE * octaves));
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
// the pixel with this middle. Form comes after the shoulder: so it shows in what is very bright, and in what
// is all but black.
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
