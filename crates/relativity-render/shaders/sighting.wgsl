// Where a point at rest in a group is seen, and where in a conformal picture that is.

struct Sighting {
    position: vec3f,
    doppler: f32,
}

// Beyond this apparent distance everything is drawn there.
const FAR = 1e30;

// What is seen of a point at rest at `c` from the camera's event: with S = c_x/gamma and q = hypot(S,
// rho/gamma), R = gamma^2 (q - beta S) and X = S - beta R; for S > 0 as quotients of what does not cancel. No
// product of these overflows at any gamma, as |c|^2 would.
fn sighting(c: vec3f) -> Sighting {
    let beta = frame.speed.x;
    let gamma = frame.speed.w;
    let s = c.x * frame.speed.z;
    let rho = sqrt(c.y * c.y + c.z * c.z);
    let across = rho * frame.speed.z;
    let q = max(sqrt(s * s + across * across), 1e-30);
    var distance = gamma * min(gamma * (q - beta * s), FAR * frame.speed.z);
    var x = s - beta * distance;
    if s > 0.0 {
        distance = (s * s + rho * rho) / (q + beta * s);
        x = (s - beta * rho) * (s + beta * rho) / (s + beta * q);
    }
    return Sighting(vec3f(x, c.yz), distance * frame.speed.z / q);
}

// Coordinates in a conformal picture, radians from its middle row and where the baseline is abreast.
struct Coordinates {
    u: f32,
    v: f32,
    // Whether it is on the far side of the baseline from the middle of the picture.
    is_behind: bool,
}

fn coordinates_of(position: vec3f) -> Coordinates {
    let largest = max(max(abs(position.x), abs(position.y)), max(abs(position.z), 1e-30));
    let scaled = position / largest;
    let aside = dot(scaled, frame.clip_right.xyz);
    let off = vec2f(dot(scaled, frame.forward.xyz), dot(scaled, frame.clip_up.xyz));
    let rho = max(length(off), 1e-30);
    let u = sign_of(aside) * log((abs(aside) + sqrt(aside * aside + rho * rho)) / rho);
    return Coordinates(u, angle_of(off), off.x < 0.0);
}

// The angle from the first axis to `place`, radians from -pi to pi. WGSL leaves 12 bits of `atan2` to whoever
// computes it; this is the series of the arctangent of a quarter of it.
fn angle_of(place: vec2f) -> f32 {
    let half = place.y / max(length(place) + abs(place.x), 1e-30);
    let quarter = half / (1.0 + sqrt(1.0 + half * half));
    let square = -quarter * quarter;
    var series = 1.0 / 15.0;
    for (var odd = 13.0; odd > 0.0; odd -= 2.0) {
        series = series * square + 1.0 / odd;
    }
    let angle = 4.0 * quarter * series;
    return select(angle, sign_of(place.y) * 3.14159265 - angle, place.x < 0.0);
}
