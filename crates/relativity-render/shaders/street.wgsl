// House fronts beside a road, an upright plane.
//
// Repeats `street/house_fronts.rs`, which says what each line is for and gives these.

override HOUSE_WIDTH: f32;
override FRAME_WIDTH: f32;
override COURSE_FROM: f32;
override COURSE_TO: f32;
override CORNICE: f32;

fn band_cover(coordinate: f32, lowest: f32, highest: f32, pixel: f32) -> f32 {
    let half = max(0.5 * pixel, 1e-6);
    let covered = min(coordinate + half, highest) - max(coordinate - half, lowest);
    return clamp(covered * (0.5 / half), 0.0, 1.0);
}

fn repeated_cover(coordinate: f32, length: f32, period: f32, pixel: f32) -> f32 {
    let half = max(0.5 * pixel, 1e-6);
    let ends = vec2f(coordinate - half, coordinate + half);
    let before = floor(ends * (1.0 / period));
    let within = min(ends - before * period, vec2f(length));
    return ((before.y - before.x) * length + (within.y - within.x)) * (0.5 / half);
}

// Shade, share below the roof, share within the cornice.
fn of_house(house: vec4f, place: vec2f, pixel: vec2f) -> vec3f {
    let cover = band_cover(place.y, 0.0, house.x, pixel.y);
    return vec3f(house.y, cover, band_cover(place.y, house.x - CORNICE, house.x, pixel.y));
}

fn house_in_turn(number: f32) -> vec4f {
    let turn = number - 3.0 * floor(number / 3.0);
    return select(select(frame.houses[2], frame.houses[1], turn < 1.5), frame.houses[0], turn < 0.5);
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

// Share of a pixel that openings of this number cover along the fronts, with a `margin` around them.
fn along_openings(number: u32, period: f32, margin: f32, place: vec2f, pixel: vec2f) -> f32 {
    let opening = frame.openings[number];
    return repeated_cover(place.x - opening.x + margin, opening.y + 2.0 * margin, period, pixel.x);
}

// And upwards.
fn up_openings(number: u32, margin: f32, place: vec2f, pixel: vec2f) -> f32 {
    let opening = frame.openings[number];
    return band_cover(place.y, opening.z - margin, opening.w + margin, pixel.y);
}

// Windows (those of both floors stand above each other), doors, shops.
fn openings_cover(margin: f32, place: vec2f, pixel: vec2f) -> vec3f {
    let along = vec3f(
        along_openings(0u, 0.5 * HOUSE_WIDTH, margin, place, pixel),
        along_openings(2u, HOUSE_WIDTH, margin, place, pixel),
        along_openings(3u, HOUSE_WIDTH, margin, place, pixel),
    );
    let upwards = vec3f(
        up_openings(0u, margin, place, pixel) + up_openings(1u, margin, place, pixel),
        up_openings(2u, margin, place, pixel),
        up_openings(3u, margin, place, pixel),
    );
    return along * upwards;
}

// Colour, and the share of the pixel that is covered.
fn front(place: vec2f, pixel: vec2f) -> vec4f {
    let house = houses(place, pixel);
    let openings = openings_cover(0.0, place, pixel);
    let frames = dot(openings_cover(FRAME_WIDTH, place, pixel), vec3f(1.0));
    let stone = band_cover(place.y, COURSE_FROM, COURSE_TO, pixel.y) + house.z + frames;
    var colour = mix(frame.backdrop[6].rgb * house.x, frame.backdrop[7].rgb, min(stone, 1.0));
    colour = mix(colour, frame.backdrop[8].rgb, openings.x);
    colour = mix(colour, frame.backdrop[9].rgb, openings.y);
    return vec4f(mix(colour, frame.backdrop[10].rgb, openings.z), house.y);
}
