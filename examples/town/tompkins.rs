//! Mr Tompkins on his bicycle, `mr-tompkins.toml`: a thin bank clerk with a moustache and a bowler hat. The
//! bicycle has the measures of the paper's, and a handlebar at which one sits upright.

use super::objects::{Objects, Place};
use super::people::head;

/// The plane of the bicycle.
const Y: f64 = 3.0;
/// The beginning of the file.
const HEAD: &str = r##"# Mr Tompkins in paint, on a red bicycle: a bank clerk, whom G. Gamow had ride through a city in which light is slow (1938).
# The bicycle has the measures of the paper's cyclist, and stands where that does. `cargo run --example town` writes this file.

name = "Mr Tompkins"
rider = "bicycle"
metres = 0.65
tracked = [0.0, 3.0, 2.0]    # the forward-most point of the front tyre
ground_z = -2.5

[[wheel]]
name = "front wheel"
hub = [-0.525, 3.0, 2.0]
radius = 0.525
tyre = 0.034
rim = 0.016
rim_radius = 0.447
axle = 0.15
hub_radius = 0.03
flange_radius = 0.042
flanges = 0.104
spokes = 14
spoke_radius = 0.007
crossing = 75
paint = "#c6cacf"
tyre_paint = "#1d1d1f"

[[wheel]]
name = "rear wheel"
hub = [-2.105, 3.0, 2.0]
radius = 0.525
tyre = 0.034
rim = 0.016
rim_radius = 0.447
axle = 0.19
hub_radius = 0.03
flange_radius = 0.042
flanges = 0.132
spokes = 14
spoke_radius = 0.007
crossing = 75
angle = 5.14
paint = "#c6cacf"
tyre_paint = "#1d1d1f"
"##;

/// The parts so far, and how each is added: in the plane of the bicycle, or on one side of it.
struct Parts {
    objects: Objects,
    name: &'static str,
    side: f64,
}

impl Parts {
    /// Adds a tube between places along, aside (to the left in the middle, else outwards) and up.
    fn tube(&mut self, name: &str, material: &str, from: Place, to: Place, radius: f64) {
        let [from, to] = [from, to].map(|[x, aside, z]| [x, Y + self.side * aside, z]);
        self.objects.tube(material, from, to, radius);
        let name = [self.name, name].concat();
        self.objects.named(&name);
    }

    /// Adds a ball.
    fn ball(&mut self, name: &str, material: &str, [x, aside, z]: Place, radius: f64) {
        self.objects.ball(material, [x, Y + self.side * aside, z], radius);
        let name = [self.name, name].concat();
        self.objects.named(&name);
    }

    /// Adds what is on both sides.
    fn both(&mut self, add: impl Fn(&mut Self)) {
        for (name, side) in [("right ", -1.0), ("left ", 1.0)] {
            (self.name, self.side) = (name, side);
            add(self);
        }
        (self.name, self.side) = ("", 1.0);
    }
}

/// Returns the contents of the file.
pub fn text() -> String {
    let mut parts = Parts { objects: Objects::new("object", 0.0), name: "", side: 1.0 };
    frame(&mut parts);
    handlebar(&mut parts);
    drive(&mut parts);
    legs(&mut parts);
    trunk(&mut parts);
    parts.both(arm);
    head(&mut parts.objects, [-1.41, Y, 4.03], 1.0, [true, true]);
    HEAD.to_owned() + &parts.objects.text
}

fn frame(parts: &mut Parts) {
    let red = "bicycle red";
    let crank = [-1.454, 0.0, 1.892];
    parts.tube("top tube", red, [-1.697, 0.0, 2.686], [-0.843, 0.0, 2.753], 0.026);
    parts.tube("down tube", red, crank, [-0.802, 0.0, 2.625], 0.03);
    parts.tube("seat tube", red, crank, [-1.711, 0.0, 2.734], 0.028);
    parts.tube("head tube", red, [-0.788, 0.0, 2.582], [-0.857, 0.0, 2.796], 0.036);
    parts.both(|parts| {
        parts.tube("chain stay", red, [-1.454, 0.055, 1.892], [-2.105, 0.1, 2.0], 0.018);
        parts.tube("seat stay", red, [-1.697, 0.028, 2.686], [-2.105, 0.1, 2.0], 0.015);
        parts.tube("fork blade", red, [-0.777, 0.062, 2.549], [-0.641, 0.074, 2.131], 0.021);
        parts.tube("fork tip", red, [-0.641, 0.074, 2.131], [-0.525, 0.08, 2.0], 0.018);
        parts.tube("half of the fork crown", red, [-0.777, 0.0, 2.549], [-0.777, 0.062, 2.549], 0.028);
        parts.tube("half of the saddle", "brown leather", [-1.7, 0.012, 2.9], [-1.95, 0.075, 2.93], 0.04);
    });
    parts.tube("seat post", "chrome", [-1.688, 0.0, 2.657], [-1.76, 0.0, 2.861], 0.02);
    parts.tube("saddle nose", "brown leather", [-1.52, 0.0, 2.89], [-1.78, 0.0, 2.906], 0.032);
}

fn handlebar(parts: &mut Parts) {
    parts.tube("stem", "chrome", [-0.857, 0.0, 2.796], [-0.9, 0.0, 3.0], 0.021);
    parts.both(|parts| {
        parts.tube("half of the handlebar", "chrome", [-0.9, 0.0, 3.0], [-0.82, 0.24, 3.06], 0.018);
        parts.tube("bend of the handlebar", "chrome", [-0.82, 0.24, 3.06], [-0.9, 0.32, 3.08], 0.018);
        parts.tube("end of the handlebar", "chrome", [-0.9, 0.32, 3.08], [-1.06, 0.34, 3.06], 0.018);
        parts.tube("grip", "black leather", [-0.98, 0.33, 3.07], [-1.12, 0.345, 3.052], 0.028);
    });
    parts.tube("bracket of the lamp", "chrome", [-0.87, 0.0, 2.86], [-0.72, 0.0, 2.84], 0.014);
    parts.tube("housing of the lamp", "black leather", [-0.72, 0.0, 2.84], [-0.68, 0.0, 2.84], 0.055);
    parts.ball("lamp", "lamp", [-0.655, 0.0, 2.84], 0.048);
    parts.ball("bell", "chrome", [-0.85, 0.12, 3.075], 0.04);
}

fn drive(parts: &mut Parts) {
    let ring = |parts: &mut Parts, name: &str, [x, z]: [f64; 2], radius: f64| {
        parts.objects.ring("chrome", [x, Y - 0.085, z], [0.0, 1.0, 0.0], [radius, 0.013]);
        parts.objects.named(name);
    };
    ring(parts, "chain ring", [-1.454, 1.892], 0.135);
    ring(parts, "sprocket", [-2.105, 2.0], 0.055);
    let dark = "iron";
    parts.tube("upper run of the chain", dark, [-2.103, -0.085, 2.055], [-1.448, -0.085, 2.027], 0.009);
    parts.tube("lower run of the chain", dark, [-2.121, -0.085, 1.947], [-1.492, -0.085, 1.763], 0.009);
    parts.tube("bottom bracket", "chrome", [-1.454, -0.115, 1.892], [-1.454, 0.115, 1.892], 0.034);
    parts.tube("rear arm of the spider", "chrome", [-1.454, -0.085, 1.892], [-1.58, -0.085, 1.858], 0.01);
    parts.tube("front arm of the spider", "chrome", [-1.454, -0.085, 1.892], [-1.362, -0.085, 1.8], 0.01);
    parts.tube("right crank", "chrome", [-1.454, -0.115, 1.892], [-1.387, -0.115, 2.143], 0.018);
    parts.tube("right pedal", dark, [-1.387, -0.13, 2.143], [-1.387, -0.27, 2.143], 0.022);
    parts.tube("left crank", "chrome", [-1.454, 0.115, 1.892], [-1.521, 0.115, 1.641], 0.018);
    parts.tube("left pedal", dark, [-1.521, 0.13, 1.641], [-1.521, 0.27, 1.641], 0.022);
}

/// Adds the legs: hip, knee, ankle, heel and toe of each.
fn legs(parts: &mut Parts) {
    let right =
        [[-1.7, 0.11, 3.03], [-1.1, 0.17, 2.79], [-1.53, 0.2, 2.375], [-1.6, 0.2, 2.235], [-1.3, 0.2, 2.195]];
    let left = [
        [-1.7, 0.11, 3.01],
        [-1.35, 0.17, 2.47],
        [-1.63, 0.2, 1.92],
        [-1.71, 0.2, 1.785],
        [-1.44, 0.2, 1.665],
    ];
    for (name, side, [hip, knee, ankle, heel, toe]) in [("right ", -1.0, right), ("left ", 1.0, left)] {
        (parts.name, parts.side) = (name, side);
        let share = |from: Place, to: Place, share: f64| {
            std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]))
        };
        let cloth = "grey cloth";
        parts.tube("upper thigh", cloth, hip, share(hip, knee, 0.6), 0.118);
        parts.tube("lower thigh", cloth, share(hip, knee, 0.4), knee, 0.096);
        let calf = share(knee, ankle, 0.4);
        parts.tube("calf", cloth, knee, calf, 0.083);
        parts.tube("shin", cloth, calf, share(knee, ankle, 0.86), 0.068);
        parts.tube("sock", "linen", share(knee, ankle, 0.8), ankle, 0.044);
        parts.tube("heel", "black leather", ankle, heel, 0.05);
        parts.tube("sole", "black leather", heel, toe, 0.05);
        parts.tube("instep", "black leather", ankle, share(heel, toe, 0.75), 0.045);
    }
    (parts.name, parts.side) = ("", 1.0);
}

fn trunk(parts: &mut Parts) {
    let coat = "navy cloth";
    parts.both(|parts| {
        parts.tube("half of the hips", coat, [-1.72, 0.0, 3.05], [-1.715, 0.09, 3.06], 0.145);
        parts.tube("side of the waist", coat, [-1.705, 0.06, 3.06], [-1.63, 0.08, 3.4], 0.128);
        parts.tube("side of the chest", coat, [-1.63, 0.08, 3.4], [-1.53, 0.11, 3.66], 0.135);
        parts.tube("shoulder", coat, [-1.5, 0.0, 3.74], [-1.5, 0.2, 3.735], 0.085);
        // The tails of the coat blow behind the saddle.
        parts.tube("top of the coat's tail", coat, [-1.77, 0.07, 3.04], [-1.9, 0.11, 2.9], 0.1);
        parts.tube("coat's tail", coat, [-1.88, 0.1, 2.92], [-2.05, 0.14, 2.8], 0.065);
        parts.tube("lapel", coat, [-1.395, 0.045, 3.46], [-1.4, 0.1, 3.72], 0.03);
        parts.tube("half of the collar", "linen", [-1.445, 0.0, 3.815], [-1.465, 0.07, 3.83], 0.034);
    });
    parts.tube("belly", coat, [-1.66, 0.0, 3.08], [-1.55, 0.0, 3.42], 0.15);
    parts.tube("chest", coat, [-1.55, 0.0, 3.42], [-1.5, 0.0, 3.66], 0.14);
    parts.tube("shirt", "linen", [-1.425, 0.0, 3.5], [-1.425, 0.0, 3.76], 0.062);
    parts.tube("tie", "wine cloth", [-1.37, 0.0, 3.5], [-1.378, 0.0, 3.77], 0.02);
    parts.ball("knot of the tie", "wine cloth", [-1.38, 0.0, 3.785], 0.03);
    parts.tube("neck", "skin", [-1.48, 0.0, 3.76], [-1.43, 0.0, 3.95], 0.07);
}

fn arm(parts: &mut Parts) {
    let [shoulder, elbow, wrist] = [[-1.5, 0.235, 3.72], [-1.395, 0.36, 3.31], [-1.1, 0.35, 3.13]];
    let coat = "navy cloth";
    parts.ball("shoulder's end", coat, shoulder, 0.088);
    parts.tube("upper arm", coat, shoulder, elbow, 0.07);
    parts.tube("forearm", coat, elbow, [-1.15, 0.352, 3.16], 0.06);
    parts.tube("cuff", "linen", [-1.15, 0.352, 3.16], wrist, 0.05);
    parts.tube("hand", "skin", wrist, [-1.03, 0.338, 3.09], 0.048);
    parts.tube("fingers", "skin", [-1.02, 0.36, 3.06], [-1.02, 0.315, 3.045], 0.032);
    parts.tube("thumb", "skin", [-1.06, 0.31, 3.1], [-0.99, 0.305, 3.09], 0.02);
}
