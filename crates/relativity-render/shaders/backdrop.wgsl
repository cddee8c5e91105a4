// The last pass: sky and resting ground, the bodies over them, and the sRGB curve.
//
// Repeats `backdrop.rs`, which says what each line is for.

// Whether there is a ground grid.
override GROUND: bool = true;
override HAZE_DISTANCE: f32;
override LINE_HALF_WIDTH: f32;
override AXIS_HALF_WIDTH: f32;

// Linear light, premultiplied by coverage.
@group(1) @binding(0) var bodies: texture_2d<f32>;

@vertex
fn screen(@builtin(vertex_index) vertex: u32) -> @builtin(position) vec4f {
    let corner = vec2f(f32(vertex & 1u), f32(vertex >> 1u)) * 4.0 - 1.0;
    return vec4f(corner, 0.5, 1.0);
}

fn line(off_line: vec2f, half_width: f32, footprint: vec2f) -> vec2f {
    let drawn = max(vec2f(half_width), 0.5 * footprint);
    let edge = (drawn - abs(off_line)) / footprint + 0.5;
    return clamp(edge, vec2f(0.0), vec2f(1.0)) * (half_width / drawn);
}

fn ground_colour(sight: vec3f, distance: f32) -> vec3f {
    let foot = frame.ground.xy + sight.xy * distance;
    let steepness = sight.xy / sight.z;
    let footprint = distance / frame.ground.w * sqrt(1.0 + steepness * steepness);
    let fade = max(1.0 - 2.0 * footprint, vec2f(0.0));
    let grid = line(foot - round(foot), LINE_HALF_WIDTH, footprint) * fade;
    let axes = line(foot, AXIS_HALF_WIDTH, footprint);
    let painted = mix(frame.backdrop[2].rgb, frame.backdrop[3].rgb, max(grid.x, grid.y));
    let marked = mix(painted, frame.backdrop[4].rgb, max(axes.x, axes.y));
    return mix(marked, frame.backdrop[0].rgb, distance / (distance + HAZE_DISTANCE));
}

fn behind(pixel: vec2f) -> vec3f {
    let sight = line_of_sight(pixel).xyz;
    if GROUND {
        // The horizon itself counts as 1e9 away.
        let distance = frame.ground.z / select(sight.z, 1e-9, abs(sight.z) < 1e-9);
        if distance > 0.0 {
            return ground_colour(sight, distance);
        }
    }
    let height = abs(sight.z);
    return mix(frame.backdrop[0].rgb, frame.backdrop[1].rgb, height * (2.0 - height));
}

// The sRGB curve, fitted in square roots: within 0.1 of 255 levels, and cheaper than a power.
fn srgb_encoded(linear: vec3f) -> vec3f {
    let root = sqrt(linear);
    let curved = 0.8337236 * root + 0.2981398 * sqrt(root) - 0.0553132 * linear - 0.0769116;
    return select(curved, 12.92 * linear, linear <= vec3f(0.0031308));
}

@fragment
fn composite(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let front = textureLoad(bodies, vec2i(position.xy), 0);
    var linear = front.rgb;
    if front.a < 1.0 {
        linear += (1.0 - front.a) * behind(position.xy);
    }
    return vec4f(srgb_encoded(linear), 1.0);
}
