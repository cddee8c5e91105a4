// Sky and resting ground behind the bodies: what motion is seen against.

// Whether the sky is a gradient (else plain).
override SKY: bool = true;
// Whether there is a ground grid.
override GROUND: bool = true;
// Whether it is drawn for a light window.
override LIGHT: bool = false;

struct Backdrop {
    @location(0) colour: vec4f,
    @builtin(frag_depth) depth: f32,
}

@vertex
fn screen(@builtin(vertex_index) vertex: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(vertex & 1u), f32(vertex >> 1u)) * 4.0 - 1.0;
    return vec4f(corner, 0.5, 1.0);
}

// Linear sRGB.
fn palette(dark: vec3f, light: vec3f) -> vec3f {
    return select(dark, light, LIGHT);
}

fn sky_colour(elevation: f32) -> vec3f {
    let zenith = palette(vec3f(0.0052, 0.0072, 0.0150), vec3f(0.50, 0.63, 0.80));
    let horizon = palette(vec3f(0.0240, 0.0300, 0.0470), vec3f(0.83, 0.87, 0.91));
    if !SKY {
        return palette(vec3f(0.0060, 0.0070, 0.0100), vec3f(0.88, 0.89, 0.91));
    }
    let nearness = 1.0 - min(abs(elevation) * 1.4, 1.0);
    return mix(zenith, horizon, nearness * nearness);
}

// Share of a pixel covered by the lines of a grid, along one coordinate.
fn line_cover(coordinate: f32, spacing: f32, half_width: f32, pixel: f32) -> f32 {
    let from_line = abs(fract(coordinate / spacing + 0.5) - 0.5) * spacing;
    let half = max(half_width, 0.5 * pixel);
    let cover = clamp((half - from_line) / max(pixel, 1e-6) + 0.5, 0.0, 1.0);
    // A line thinner than a pixel is faded rather than broken up; a grid finer than pixels is left out.
    return cover * (half_width / half) * clamp(2.0 - 4.0 * pixel / spacing, 0.0, 1.0);
}

fn axis_cover(coordinate: f32, half_width: f32, pixel: f32) -> f32 {
    let half = max(half_width, 0.5 * pixel);
    return clamp((half - abs(coordinate)) / max(pixel, 1e-6) + 0.5, 0.0, 1.0) * (half_width / half);
}

fn ground_colour(sky: vec3f, place: vec2f, pixel: vec2f, distance: f32) -> vec3f {
    let earth = palette(vec3f(0.0085, 0.0100, 0.0135), vec3f(0.66, 0.69, 0.72));
    let ink = palette(vec3f(0.085, 0.105, 0.140), vec3f(0.26, 0.31, 0.38));
    let fine = max(line_cover(place.x, 1.0, 0.012, pixel.x), line_cover(place.y, 1.0, 0.012, pixel.y));
    let axes = max(axis_cover(place.x, 0.03, pixel.x), axis_cover(place.y, 0.03, pixel.y));
    let painted = mix(mix(earth, ink, 0.55 * fine), ink * 1.5, axes);
    let haze = 1.0 / (1.0 + distance * distance * 0.0025);
    return mix(sky, painted, haze);
}

@fragment
fn backdrop(@builtin(position) position: vec4f) -> Backdrop {
    let sight = line_of_sight(position.xy);
    let sky = sky_colour(sight.n.z);
    if !GROUND {
        return Backdrop(vec4f(sky, 1.0), 0.0);
    }
    // Above the eye the ground would hide everything: then it is left out.
    let below = sight.n.z * frame.ground.z > 0.0 && frame.ground.z < 0.0;
    if !below {
        return Backdrop(vec4f(sky, 1.0), 0.0);
    }
    let distance = frame.ground.z / sight.n.z;
    let place = frame.ground.xy + sight.n.xy * distance;
    // How far the place moves from pixel to pixel.
    let across = distance * (sight.along_u.xy - sight.n.xy * (sight.along_u.z / sight.n.z));
    let down = distance * (sight.along_v.xy - sight.n.xy * (sight.along_v.z / sight.n.z));
    let pixel = sqrt(across * across + down * down);
    return Backdrop(vec4f(ground_colour(sky, place, pixel, distance), 1.0), depth(distance));
}
