//! Objects of a scene file: boxes, balls, tubes and cylinders of named materials.

use std::collections::BTreeMap;
use std::fmt::Write as _;

/// A place: x along the street, y across it, z up from the ground.
pub type Place = [f64; 3];

/// How far what stands on the ground reaches into it: a box that only touches it would have a shadow there.
const SUNK: f64 = 0.5;

/// The light of objects by the names of their materials: measured ones, and smooth paint in sRGB.
const PAINTS: [(&str, &str); 27] = [
    ("cream plaster", "#d8caa4"),
    ("ochre plaster", "#cda25a"),
    ("rose plaster", "#c89a86"),
    ("grey plaster", "#b4b3aa"),
    ("stone", "#ada594"),
    // That of the street of the program.
    ("road", "#8f9296"),
    ("window", "#343d47"),
    ("shutter green", "#2f6a43"),
    ("shutter blue", "#3f5f86"),
    ("door red", "#8e2f2a"),
    ("door brown", "#5f4632"),
    ("zinc", "#7f8488"),
    ("iron", "#2b2d30"),
    ("clock face", "#ece9dc"),
    ("slot", "#1a1414"),
    ("skin", "#dcab8c"),
    ("hair", "#4a3526"),
    ("hat", "#2b2622"),
    ("hat band", "#14110f"),
    ("navy cloth", "#2f3f5c"),
    ("grey cloth", "#63646a"),
    ("green cloth", "#4f6247"),
    ("wine cloth", "#7a2e3a"),
    ("linen", "#e9e6dc"),
    ("black leather", "#211e1d"),
    ("brown leather", "#6b4528"),
    ("chrome", "#b9bdc2"),
];

/// Text of objects that stand `repeat` times, a step from each to the next.
pub struct Objects {
    pub text: String,
    /// What the following is part of, and is named by with a number; nothing has names of its own.
    pub part: &'static str,
    /// Number of the objects of each part so far.
    counts: BTreeMap<&'static str, usize>,
    /// Heading of a table.
    table: &'static str,
    /// Height of what is at z = 0.
    ground: f64,
    /// Place of the origin of what follows.
    pub at: [f64; 2],
    /// How often it stands there, and how far apart along x.
    pub repeat: (usize, f64),
    /// Share of the light that reaches what follows; less than 1 in the shade.
    pub lit: f64,
}

impl Objects {
    /// Returns none yet, of a table with this heading; what is at z = 0 will be at the height `ground`.
    pub const fn new(table: &'static str, ground: f64) -> Self {
        Self {
            text: String::new(),
            part: "",
            counts: BTreeMap::new(),
            table,
            ground,
            at: [0.0; 2],
            repeat: (1, 0.0),
            lit: 1.0,
        }
    }

    /// Begins what stands so often from `at` on.
    pub fn stand(&mut self, at: [f64; 2], count: usize, step: f64) {
        (self.at, self.repeat) = (at, (count, step));
    }

    /// Adds a box between two corners; what begins at the ground reaches into it.
    pub fn block(&mut self, material: &str, low: Place, high: Place) {
        let bottom = if low[2] == 0.0 { -SUNK } else { low[2] };
        let low = [low[0], low[1], bottom];
        let centre = [0, 1, 2].map(|axis| 0.5 * (low[axis] + high[axis]));
        let size = [0, 1, 2].map(|axis| (high[axis] - low[axis]).abs());
        self.turned_block(material, centre, size, 0.0);
    }

    /// Adds a box that is turned about the x axis, degrees counter-clockwise as seen from there.
    pub fn turned_block(&mut self, material: &str, centre: Place, size: Place, angle: f64) {
        self.object("box", material);
        self.place("centre", centre);
        let _ = writeln!(self.text, "size = {}", list(size));
        if angle != 0.0 {
            let _ = writeln!(self.text, "axis = [1.0, 0.0, 0.0]\nangle = {angle:.2}");
        }
    }

    /// Adds what `add` adds, which so much of the light reaches.
    pub fn shaded(&mut self, lit: f64, add: impl FnOnce(&mut Self)) {
        let before = self.lit;
        self.lit *= lit;
        add(self);
        self.lit = before;
    }

    /// Adds a ball.
    pub fn ball(&mut self, material: &str, centre: Place, radius: f64) {
        self.object("sphere", material);
        self.place("centre", centre);
        let _ = writeln!(self.text, "radius = {}", number(radius));
    }

    /// Adds a tube with rounded ends.
    pub fn tube(&mut self, material: &str, from: Place, to: Place, radius: f64) {
        self.long("tube", material, from, to, radius);
    }

    /// Adds a cylinder with flat ends.
    pub fn cylinder(&mut self, material: &str, from: Place, to: Place, radius: f64) {
        self.long("cylinder", material, from, to, radius);
    }

    /// Gives the last object a name.
    pub fn named(&mut self, name: &str) {
        let _ = writeln!(self.text, "name = \"{name}\"");
    }

    /// Adds a ring.
    pub fn ring(&mut self, material: &str, centre: Place, axis: Place, [radius, tube]: [f64; 2]) {
        self.object("ring", material);
        self.place("centre", centre);
        let axis = list(axis);
        let (radius, tube) = (number(radius), number(tube));
        let _ = writeln!(self.text, "axis = {axis}\nradius = {radius}\ntube_radius = {tube}");
    }

    fn long(&mut self, shape: &str, material: &str, from: Place, to: Place, radius: f64) {
        self.object(shape, material);
        self.place("from", from);
        self.place("to", to);
        let _ = writeln!(self.text, "radius = {}", number(radius));
    }

    fn object(&mut self, shape: &str, material: &str) {
        let _ = writeln!(self.text, "\n[[{}]]\nshape = \"{shape}\"", self.table);
        let _ = match PAINTS.iter().find(|(name, _)| *name == material) {
            Some((_, paint)) => writeln!(self.text, "paint = \"{paint}\""),
            None if material == "lamp" => writeln!(self.text, "glow_k = 2700"),
            None => writeln!(self.text, "material = \"{material}\""),
        };
        if !self.part.is_empty() {
            let count = self.counts.entry(self.part).or_default();
            *count += 1;
            let _ = writeln!(self.text, "name = \"{} {count}\"", self.part);
        }
        if self.lit < 1.0 {
            let _ = writeln!(self.text, "brightness = {}", number(self.lit));
        }
        let (count, step) = self.repeat;
        if count > 1 {
            let _ = writeln!(self.text, "repeat = {count}\nstep = {}", list([step, 0.0, 0.0]));
        }
    }

    fn place(&mut self, key: &str, [x, y, z]: Place) {
        let place = list([x + self.at[0], y + self.at[1], z + self.ground]);
        let _ = writeln!(self.text, "{key} = {place}");
    }
}

/// Writes a number to three decimals, and no more of these than it takes.
fn number(value: f64) -> String {
    let rounded = (1e3 * value).round() / 1e3;
    // Without the sign of -0.
    format!("{:?}", rounded + 0.0)
}

fn list(place: Place) -> String {
    format!("[{}]", place.map(number).join(", "))
}

/// Numbers that look like chance, the same ones each time: a linear congruential generator (D. E. Knuth).
pub struct Chance(u64);

impl Chance {
    /// Begins with this seed.
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns the next one between these.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 40) as f64 / (1_u64 << 24) as f64)
    }
}
