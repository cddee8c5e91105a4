// The last pass: sky and resting ground, the bodies over them, and the sRGB curve.
//
// Repeats `street/backdrop.rs`, which says what each line is for and gives these.

// Whether this draws where the ground can be seen, with a road on it, and where house fronts can: of what
// lies behind, each tile of the picture is drawn by one pipeline, with no more than what it shows.
override GROUND: bool;
override ROAD: bool;
override FRONTS: bool;
// Geometry that shows the street: 0 as seen, 1 contracted only, 2 at rest with the camera.
override STREET_GEOMETRY: u32;
// Row of the tables that has what its motion does to colours; 0 where they stay as painted.
override STREET_ROW: i32;
// Whether the street moves past the camera otherwise than along x.
override OBLIQUE_STREET: bool;
override TILE_COLUMNS: u32;
override TILE_ROWS: u32;
override LEAST_TOWARDS_FRONTS: f32;
override KERB_WIDTH: f32;
override LANE_HALF_WIDTH: f32;
override DASH_LENGTH: f32;
override DASH_PERIOD: f32;
override LINE_HALF_WIDTH: f32;
override AXIS_HALF_WIDTH: f32;
override GRID_FADE_START: f32;
override GRID_FADE_RATE: f32;
override HAZE: f32;
override SKY_RISE: f32;
// The brightest value that a screen tells from 1.
override BRIGHTEST: f32;
override CONTACT_DARKEST: f32;
override CONTACT_FARTHEST: f32;

// Linear light, premultiplied by coverage.
@group(1) @binding(0) var bodies: texture_2d<f32>;

// A tile of the picture; without a size where another pipeline draws it.
@vertex
fn tile(@builtin(vertex_index) vertex: u32, @builtin(instance_index) index: u32) -> @builtin(position) vec4f {
    let number = vec2u(index % TILE_COLUMNS, index / TILE_COLUMNS);
    let place = tile_corner(number + select(vec2u(0u), vec2u(1u), shows(number)) * vec2u(vertex & 1u, vertex >> 1u));
    return vec4f(place, 0.5, 1.0);
}

// In clip coordinates.
fn tile_corner(number: vec2u) -> vec2f {
    return vec2f(number) / vec2f(f32(TILE_COLUMNS), f32(TILE_ROWS)) * 2.0 - 1.0;
}

// Whether this pipeline draws the tile.
fn shows(number: vec2u) -> bool {
    // The plane of the ground is a bowl to whoever does not move along it.
    if OBLIQUE_STREET {
        // Without branches, see `tests/shaders.rs`.
        let has_fronts = all(vec2<bool>(frame.road.z > 0.0, frame.road.x < frame.road.y));
        return all(vec2<bool>(GROUND == (frame.ground.z > NO_GROUND), FRONTS == has_fronts));
    }
    let low = tile_corner(number);
    let high = tile_corner(number + 1u);
    let corners = array(
        line_near(low, vec2f(-1.0, 1.0)),
        line_near(vec2f(high.x, low.y), vec2f(1.0, 1.0)),
        line_near(vec2f(low.x, high.y), vec2f(-1.0, -1.0)),
        line_near(high, vec2f(1.0, -1.0)),
    );
    // Of planes through the aperture: how far the corners are in front of the fronts' plane, above their
    // foot, and below the highest and the lowest of the roofs. A tile is on one side of a plane if all of its
    // corners are; in a conformal picture, whose rows may bulge between the corners, by the square of a
    // tile's height.
    let rows = select(0.0, 2.0 / (f32(TILE_ROWS) * frame.clip_up.w) + 4.0 * frame.base.w, CONFORMAL);
    let bulge = rows * rows;
    let ground = frame.ground.z;
    let towards = vec4f(corners[0].y, corners[1].y, corners[2].y, corners[3].y);
    let rise = vec4f(corners[0].z, corners[1].z, corners[2].z, corners[3].z);
    let height = rise * frame.road.z;
    let above = height - ground * towards;
    let room = bulge * (frame.road.z + abs(ground) + frame.houses[0].x);
    let is_beside = all(towards <= vec4f(-bulge)) || all(above < vec4f(-room))
        || all(above > frame.houses[0].x * towards + room);
    let has_fronts = !is_beside && frame.road.z > 0.0;
    let is_covered = has_fronts && all(towards > vec4f(0.01 + bulge)) && all(above > vec4f(room))
        && all(above < frame.houses[1].x * towards - room);
    let has_ground = any(rise < vec4f(bulge)) && !is_covered && ground > NO_GROUND;
    return has_ground == GROUND && has_fronts == FRONTS;
}

// Heights below this stand for no ground.
const NO_GROUND = -1e38;

// The line of sight (unnormalised) two pixels to the right and down, or against that, of a place in clip
// coordinates.
fn line_near(place: vec2f, outwards: vec2f) -> vec3f {
    if CONFORMAL {
        let off = 2.0 * frame.base.w * outwards;
        let middle = vec2f(frame.forward.w + place.x / frame.clip_right.w, place.y / frame.clip_up.w);
        let half = arcs(0.5 * (middle + vec2f(off.x, -off.y)));
        let sines = 2.0 * half.sines * (1.0 + half.versines);
        let cosine = 1.0 - 2.0 * half.sines.y * half.sines.y;
        return frame.clip_right.xyz * sines.x + frame.forward.xyz * cosine + frame.clip_up.xyz * sines.y;
    }
    // In a sheared picture `clip_right` is not across `forward`, and that is not in the middle.
    let along = dot(frame.clip_right.xyz, frame.forward.xyz);
    let across = frame.clip_right.xyz - frame.forward.xyz * along;
    let right = across / dot(across, across);
    let up = frame.clip_up.xyz / dot(frame.clip_up.xyz, frame.clip_up.xyz);
    return frame.forward.xyz + right * (place.x - along) + up * place.y
        + 2.0 * (frame.right.xyz * outwards.x + frame.down.xyz * outwards.y);
}

fn line_cover(off_line: vec2f, half_width: f32, pixel: vec2f) -> vec2f {
    let half = max(vec2f(half_width), 0.5 * pixel);
    let cover = clamp((half - abs(off_line)) / max(pixel, vec2f(1e-6)) + 0.5, vec2f(0.0), vec2f(1.0));
    return cover * (half_width / half);
}

// How the place where a line of sight meets the ground moves to the next pixel. A multiple of the line of
// sight in its `step` does not move it.
fn shift(line: Line, step: vec3f, distance: f32) -> vec2f {
    return (step.xy - line.n.xy * (step.z / line.n.z)) * (line.scale * distance);
}

// A line of sight on the ground: see `street/sight.rs`.
struct Line {
    // Unit vector.
    n: vec3f,
    // By which steps to the next pixels are multiplied.
    scale: f32,
    // The part of a distance by which haze counts.
    haze_share: f32,
    // Doppler factor.
    doppler: f32,
    // Steps to the pixels on the right and below, up to multiples of the line.
    right: vec3f,
    down: vec3f,
}

fn line_on_ground(sight: vec4f) -> Line {
    let right = step_right_but_along();
    let down = step_down(sight.xyz);
    if STREET_GEOMETRY == AT_REST {
        return Line(sight.xyz, sight.w, 1.0, 1.0, right, down);
    }
    if OBLIQUE_STREET {
        return line_on_oblique_ground(sight, right, down);
    }
    let seen = passage(sight.xyz, STREET_GEOMETRY, frame.street_speed, frame.street_motion.x);
    let scale = sight.w * seen.ground_per_rest;
    let haze_share = min(seen.ground_per_rest, 1.0);
    let steps = array(step_on_ground(sight.xyz, right), step_on_ground(sight.xyz, down));
    return Line(seen.direction, scale, haze_share, seen.doppler, steps[0], steps[1]);
}

// The same where the street moves otherwise than along x: through the axes along its motion.
fn line_on_oblique_ground(sight: vec4f, right: vec3f, down: vec3f) -> Line {
    let n = frame.to_street * sight.xyz;
    let seen = passage(n, STREET_GEOMETRY, frame.street_speed, 1.0);
    return Line(
        frame.street_axes * seen.direction,
        sight.w * seen.ground_per_rest,
        min(seen.ground_per_rest, 1.0),
        seen.doppler,
        frame.street_axes * step_on_ground(n, frame.to_street * right),
        frame.street_axes * step_on_ground(n, frame.to_street * down),
    );
}

const AT_REST = 2u;

// What a `step` of the line of sight `n` of the camera is on the ground, whose line is (Gamma (n_x + V |n|),
// n_y, n_z).
fn step_on_ground(n: vec3f, step: vec3f) -> vec3f {
    let lag = select(0.0, frame.street_motion.x * frame.street_speed.x * dot(n, step), STREET_GEOMETRY == 0u);
    return vec3f(frame.street_speed.w * (step.x + lag), step.yz);
}

fn marks_cover(foot: vec2f, pixel: vec2f) -> f32 {
    let near = frame.road.x;
    let far = frame.road.y;
    let middle = 0.5 * (near + far);
    let kerbs = band_cover(foot.y, near - KERB_WIDTH, near, pixel.y) + band_cover(foot.y, far, far + KERB_WIDTH, pixel.y);
    let lane = band_cover(foot.y, middle - LANE_HALF_WIDTH, middle + LANE_HALF_WIDTH, pixel.y);
    return kerbs + lane * repeated_cover(foot.x, DASH_LENGTH, DASH_PERIOD, pixel.x);
}

// Share of a road's light that the shadows of what touches it leave at `foot` from the camera: see
// `street/contact.rs`.
fn left_by_contacts(foot: vec2f, pixel: vec2f) -> f32 {
    var left = 1.0;
    let from_middle = vec3f(foot, frame.ground.z) + frame.contact_eye.xyz;
    let distance = sqrt(dot(from_middle, from_middle));
    // Of the pixel, too: a software GPU compiles anew for each number of rounds that only the frame decides.
    let count = select(0u, u32(frame.contact_eye.w), distance <= CONTACT_FARTHEST);
    for (var i = 0u; i < count; i++) {
        let place = frame.contacts[2 * i];
        let size = frame.contacts[2 * i + 1];
        let off = foot - place.xy;
        let wide = size.y + pixel.y * pixel.y;
        if off.y * off.y < wide {
            let mean = (2.0 * from_middle.xy - off) / (distance + place.z);
            let stretch = vec2f(size.z + place.w * mean.x, place.w * mean.y);
            let along = dot(stretch, off);
            let blur = stretch * pixel;
            let long = size.x + dot(blur, blur);
            let inside = max(1.0 - along * along / long - off.y * off.y / wide, 0.0);
            left *= 1.0 - CONTACT_DARKEST * sqrt(size.x / long * (size.y / wide)) * inside * inside;
        }
    }
    return left;
}

fn seen_through_haze(line: Line, distance: f32) -> f32 {
    let near = distance * line.haze_share;
    return 1.0 / (1.0 + HAZE * near * near);
}

fn ground_colour(sky: vec4f, line: Line, distance: f32) -> vec4f {
    let from_camera = line.n.xy * distance;
    let foot = frame.ground.xy + from_camera;
    let right = shift(line, line.right, distance);
    let down = shift(line, line.down, distance);
    let pixel = sqrt(right * right + down * down);
    let fade = clamp(GRID_FADE_START - GRID_FADE_RATE * pixel, vec2f(0.0), vec2f(1.0));
    let grid = line_cover(foot - round(foot), LINE_HALF_WIDTH, pixel) * fade;
    let gridded = mix(frame.backdrop[2].rgb, frame.backdrop[3].rgb, max(grid.x, grid.y));
    var painted: vec3f;
    if ROAD {
        let surface = mix(gridded, frame.backdrop[5].rgb, band_cover(foot.y, frame.road.x, frame.road.y, pixel.y));
        painted = mix(surface, frame.backdrop[4].rgb, marks_cover(foot, pixel)) * left_by_contacts(from_camera, pixel);
    } else {
        let axes = line_cover(foot, AXIS_HALF_WIDTH, pixel);
        painted = mix(gridded, frame.backdrop[4].rgb, max(axes.x, axes.y));
    }
    return mix(sky, vec4f(painted, 0.0), seen_through_haze(line, distance));
}

// How the place where it meets house fronts moves.
fn shift_on_fronts(line: Line, step: vec3f, distance: f32) -> vec2f {
    return (step.xz - line.n.xz * (step.y / line.n.y)) * (line.scale * distance);
}

fn with_fronts(without: vec4f, sky: vec4f, line: Line) -> vec4f {
    let distance = frame.road.z / line.n.y;
    let place = vec2f(frame.ground.x, -frame.ground.z) + line.n.xz * distance;
    let right = shift_on_fronts(line, line.right, distance);
    let down = shift_on_fronts(line, line.down, distance);
    let seen = front(place, sqrt(right * right + down * down));
    return mix(without, mix(sky, vec4f(seen.rgb, 0.0), seen_through_haze(line, distance)), seen.a);
}

// The light that a screen shows as `colour`, with the sky's share in it: up to the brightest level that it
// tells from 1.
fn unshouldered(colour: vec4f) -> vec4f {
    let largest = max(colour.r, max(colour.g, colour.b));
    if largest <= KNEE {
        return colour;
    }
    let left = (1.0 - min(largest, BRIGHTEST)) / (1.0 - KNEE);
    return colour * ((KNEE + (1.0 - KNEE) * (1.0 / left - 1.0)) / largest);
}

// What is received of paint on the street and of the sky, see `light/street_light.rs`.
fn received_from_street(painted: vec4f, doppler: f32) -> vec3f {
    let octaves = log2(doppler);
    let paint = unshouldered(painted);
    var seen: vec4f;
    if STREET_ROW == FIRST_SUNLIT {
        let place = SUNLIT_AT_REST + SUNLIT_PER_OCTAVE * (octaves * frame.street_light.x);
        seen = sunlit(FIRST_SUNLIT, paint.rgb, place) + vec4f(paint.w * looked_up(SKY_ROW, place).rgb, 0.0);
    } else {
        let tint = looked_up(FALSE_ROW, MAP_MIDDLE + MAP_PER_OCTAVE * (octaves * frame.street_light.x));
        seen = vec4f(paint.rgb * tint.rgb, tint.a);
    }
    let power = frame.street_light.y * seen.a + frame.street_light.z * octaves + frame.street_light.w;
    let light = on_screen(seen.rgb * power_of_two(power));
    let largest = max(light.r, max(light.g, light.b));
    return light * (shoulder(largest) / max(largest, 1e-30));
}

fn behind(pixel: vec2f) -> vec3f {
    let line = line_on_ground(line_of_sight(pixel));
    let nearness = 1.0 - min(SKY_RISE * abs(line.n.z), 1.0);
    // Linear sRGB at rest, and the share of the sky's own light in it.
    let sky = mix(frame.backdrop[1], frame.backdrop[0], nearness * nearness);
    var colour = sky;
    if GROUND && line.n.z < -1e-6 {
        colour = ground_colour(sky, line, frame.ground.z / line.n.z);
    }
    if FRONTS && line.n.y > LEAST_TOWARDS_FRONTS {
        colour = with_fronts(colour, sky, line);
    }
    if STREET_ROW != 0 {
        return received_from_street(colour, line.doppler);
    }
    return colour.rgb;
}

@fragment
fn composite(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let first = vec2u(position.xy) * ACROSS;
    var front = vec4f(0.0);
    for (var i = 0u; i < ACROSS * ACROSS; i++) {
        front += textureLoad(bodies, first + vec2u(i % ACROSS, i / ACROSS), 0);
    }
    front /= f32(ACROSS * ACROSS);
    var linear = front.rgb;
    if front.a < 1.0 {
        linear += (1.0 - front.a) * behind(position.xy);
    }
    return vec4f(srgb_encoded(linear), 1.0);
}
