// House fronts beside a road, an upright plane.
//
// Repeats `street.rs`, which says what each line is for and gives these.

override HOUSE_WIDTH: f32;
override FRAME_WIDTH: f32;
override COURSE_FROM: f32;
override COURSE_TO: f32;
override CORNICE: f32;

fn band_cover(coordinate: f32, lowest: f32, highest: f32, pixel: f32) -> f32 {
    let half = max(0.5 * pixel, 1e-6);
    let covered = min(coordinate + half, highest) - max(coordinate - half, lowest);
    return clamp(covered / (2.0 * half), 0.0, 1.0);
}

fn repeated_cover(coordinate: f32, length: f32, period: f32, pixel: f32) -> f32 {
    let half = max(0.5 * pixel, 1e-6);
    let ends = vec2f(coordinate - half, coordinate + half);
    let before = floor(ends / period);
    let within = min(ends - before * period, vec2f(length));
    return ((before.y - before.x) * length + (within.y - within.x)) / (2.0 * half);
}

// Shade, share below the roof, share within the cornice.
fn of_house(house: vec4f, place: vec2f, pixel: vec2f) -> vec3f {
    let cover = band_cover(place.y, 0.0, house.x, pixel.y);
    return vec3f(house.y, cover, band_cover(place.y, house.x - CORNICE, house.x, pixel.y));
}

fn house_in_turn(number: f32) -> vec4f {
    return frame.houses[u32(number - 3.0 * floor(number / 3.0))];
}

fn houses(place: vec2f, pixel: vec2f) -> vec3f {
    let end = place.x + 0.5 * pixel.x;
    let right = floor(end / HOUSE_WIDTH);
    let left = floor((place.x - 0.5 * pixel.x) / HOUSE_WIDTH);
    let share = clamp((end - right * HOUSE_WIDTH) / max(pixel.x, 1e-6), 0.0, 1.0);
    let fine = clamp(pixel.x / HOUSE_WIDTH - 0.5, 0.0, 1.0);
    let at_right = of_house(house_in_turn(right), place, pixel);
    let coarse = mix(of_house(house_in_turn(left), place, pixel), at_right, share);
    return mix(coarse, of_house(frame.houses[3], place, pixel), fine);
}

fn opening_cover(number: u32, margin: f32, place: vec2f, pixel: vec2f) -> f32 {
    let opening = frame.openings[number];
    let period = select(HOUSE_WIDTH, 0.5 * HOUSE_WIDTH, number < 2u);
    let along = repeated_cover(place.x - opening.x + margin, opening.y + 2.0 * margin, period, pixel.x);
    return along * band_cover(place.y, opening.z - margin, opening.w + margin, pixel.y);
}

// Colour, and the share of the pixel that is covered.
fn front(place: vec2f, pixel: vec2f) -> vec4f {
    let house = houses(place, pixel);
    var openings = vec4f(0.0);
    var stone = band_cover(place.y, COURSE_FROM, COURSE_TO, pixel.y) + house.z;
    for (var number = 0u; number < 4u; number++) {
        openings[number] = opening_cover(number, 0.0, place, pixel);
        stone += opening_cover(number, FRAME_WIDTH, place, pixel);
    }
    var colour = mix(frame.backdrop[6].rgb * house.x, frame.backdrop[7].rgb, min(stone, 1.0));
    colour = mix(colour, frame.backdrop[8].rgb, openings.x + openings.y);
    colour = mix(colour, frame.backdrop[9].rgb, openings.z);
    return vec4f(mix(colour, frame.backdrop[10].rgb, openings.w), house.y);
}
