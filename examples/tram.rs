//! A tram of 1,302 triangles with eight named wheels and a board on its roof, as Wavefront OBJ with colours
//! and a texture: `tram.obj`, `tram.mtl` and `tram.png` in `assets/scenes`.
//!
//! `cargo run --example tram` writes them.

use std::error::Error;
use std::f64::consts::PI;
use std::fmt::Write as _;
use std::fs::{self, File};

type Colour = [f64; 3];

const RED: Colour = [0.72, 0.13, 0.1];
const CREAM: Colour = [0.94, 0.89, 0.74];
const GLASS: Colour = [0.24, 0.33, 0.42];
const GREY: Colour = [0.45, 0.46, 0.48];
const DARK: Colour = [0.16, 0.16, 0.18];
const LAMP: Colour = [1.0, 0.95, 0.6];

/// Half the length of the tram, and half its width.
const HALF: [f64; 2] = [5.0, 1.1];
/// Places of the axles.
const AXLES: [f64; 4] = [-3.4, -2.0, 2.0, 3.4];
/// Number of sides of what is round.
const SIDES: usize = 16;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes");
    fs::write(format!("{folder}/tram.obj"), text())?;
    fs::write(format!("{folder}/tram.mtl"), MATERIALS)?;
    let ([width, height], levels) = board();
    let mut picture = png::Encoder::new(File::create(format!("{folder}/tram.png"))?, width, height);
    picture.set_color(png::ColorType::Grayscale);
    picture.write_header()?.write_image_data(&levels)?;
    Ok(())
}

/// The materials of the model: paint, and the board.
pub const MATERIALS: &str = "newmtl paint\nKd 1 1 1\nnewmtl board\nKd 1 1 1\nmap_Kd tram.png\n";

/// The words on the board.
const WORDS: &str = "STATION - POST OFFICE";
/// Texels of each square of a letter, and squares around the words.
const SQUARE: u32 = 4;
const MARGIN: u32 = 2;

/// The letters, rows of five squares from the top, the leftmost square 16.
const fn letter(letter: char) -> [u8; 7] {
    match letter {
        'A' => [14, 17, 17, 31, 17, 17, 17],
        'C' => [14, 17, 16, 16, 16, 17, 14],
        'E' => [31, 16, 16, 30, 16, 16, 31],
        'F' => [31, 16, 16, 30, 16, 16, 16],
        'I' => [14, 4, 4, 4, 4, 4, 14],
        'N' => [17, 25, 21, 19, 17, 17, 17],
        'O' => [14, 17, 17, 17, 17, 17, 14],
        'P' => [30, 17, 17, 30, 16, 16, 16],
        'S' => [15, 16, 16, 14, 1, 1, 30],
        'T' => [31, 4, 4, 4, 4, 4, 4],
        '-' => [0, 0, 0, 31, 0, 0, 0],
        _ => [0; 7],
    }
}

/// Returns the board's picture: its width and height, and the grey level of each texel, in rows from the top.
#[must_use]
pub fn board() -> ([u32; 2], Vec<u8>) {
    let size = [(6 * WORDS.len() as u32 - 1 + 2 * MARGIN) * SQUARE, (7 + 2 * MARGIN) * SQUARE];
    let is_dark = |texel: u32| {
        let place = [texel % size[0], texel / size[0]].map(|texel| (texel / SQUARE).checked_sub(MARGIN));
        let [Some(column), Some(row)] = place else { return false };
        let letter = WORDS.chars().nth(column as usize / 6).map_or([0; 7], letter);
        column % 6 < 5 && letter.get(row as usize).is_some_and(|row| row >> (4 - column % 6) & 1 == 1)
    };
    (size, (0..size[0] * size[1]).map(|texel| if is_dark(texel) { 24 } else { 236 }).collect())
}

/// Returns the contents of `tram.obj`.
#[must_use]
pub fn text() -> String {
    // The corners of the board's picture.
    let head = "mtllib tram.mtl\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl paint\n";
    let mut tram = Mesh { text: head.to_owned(), corners: 0 };
    let [length, width] = HALF;
    tram.part("car");
    tram.block([-length, -width, 0.5], [length, width, 1.6], RED);
    tram.block([-length, -width, 1.6], [length, width, 2.9], CREAM);
    tram.block([-length - 0.02, -width - 0.02, 1.52], [length + 0.02, width + 0.02, 1.62], CREAM);
    tram.roof(2.9, 0.45);
    for side in [-1.0, 1.0] {
        for window in 0..6 {
            let from = -4.1 + 1.4 * f64::from(window);
            let y = side * width;
            let is_door = window == 1 || window == 4;
            tram.block(
                [from, y - 0.01, if is_door { 0.6 } else { 1.75 }],
                [from + 1.2, y + 0.01, 2.7],
                GLASS,
            );
        }
    }
    for end in [-length, length] {
        tram.block([end - 0.01, -0.85, 1.75], [end + 0.01, 0.85, 2.7], GLASS);
        tram.prism([end, 0.0, 1.1], [0.06, 0.0, 0.0], 0.18, LAMP);
        tram.block([end - 0.2, -0.7, 0.3], [end + 0.2, 0.7, 0.5], DARK);
    }
    for axle in AXLES {
        tram.prism([axle, 0.0, 0.4], [0.0, 0.75, 0.0], 0.06, GREY);
    }
    tram.block([-0.6, -0.5, 3.3], [0.6, 0.5, 3.42], GREY);
    tram.bar([-0.5, 0.4, 3.4], [0.6, 0.4, 4.1]);
    tram.bar([-0.5, -0.4, 3.4], [0.6, -0.4, 4.1]);
    tram.bar([0.6, -0.8, 4.1], [0.6, 0.8, 4.1]);
    for side in [-1.0, 1.0] {
        tram.board(side);
    }
    for (number, axle) in (1..).zip(AXLES) {
        for (name, side) in [("right", -0.75), ("left", 0.75)] {
            tram.part(&format!("{name} wheel {number}"));
            tram.prism([axle, side, 0.4], [0.0, 0.08, 0.0], 0.4, DARK);
            // So that its turning can be seen.
            tram.block([axle - 0.3, side - 0.085, 0.35], [axle + 0.3, side + 0.085, 0.45], CREAM);
        }
    }
    tram.text
}

/// The corners and faces so far.
struct Mesh {
    text: String,
    corners: usize,
}

impl Mesh {
    /// Names the faces that follow.
    fn part(&mut self, name: &str) {
        let _ = writeln!(self.text, "o {name}");
    }

    /// A face with these corners, counter-clockwise from outside.
    fn face(&mut self, corners: &[[f64; 3]], [red, green, blue]: Colour) {
        for [x, y, z] in corners {
            let _ = writeln!(self.text, "v {x:.3} {y:.3} {z:.3} {red} {green} {blue}");
        }
        let numbers = (self.corners + 1..=self.corners + corners.len()).map(|number| format!(" {number}"));
        let _ = writeln!(self.text, "f{}", numbers.collect::<String>());
        self.corners += corners.len();
    }

    /// A board on an edge of the roof, whose words are read from that side.
    fn board(&mut self, side: f64) {
        let (half, [low, high]) = (2.6, [3.05, 3.49]);
        let depth = [1.0, 1.04].map(|y| side * y);
        self.block([-half, depth[0].min(depth[1]), low], [half, depth[0].max(depth[1]), high], DARK);
        // From there the words begin on the left.
        let [left, right, y] = [side * half, -side * half, side * 1.045];
        self.text.push_str("usemtl board\n");
        for [x, z] in [[left, low], [right, low], [right, high], [left, high]] {
            let _ = writeln!(self.text, "v {x:.3} {y:.3} {z:.3} 1 1 1");
        }
        let numbers = (1..=4).map(|i| format!(" {}/{i}", self.corners + i));
        let _ = writeln!(self.text, "f{}", numbers.collect::<String>());
        self.text.push_str("usemtl paint\n");
        self.corners += 4;
    }

    /// A block between two corners.
    fn block(&mut self, low: [f64; 3], high: [f64; 3], colour: Colour) {
        let corner =
            |i: usize| std::array::from_fn(|axis| if i >> axis & 1 == 0 { low[axis] } else { high[axis] });
        for face in [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]] {
            self.face(&face.map(corner), colour);
        }
    }

    /// A prism about an axis along x or y, this far to both sides of `middle`.
    fn prism(&mut self, middle: [f64; 3], half: [f64; 3], radius: f64, colour: Colour) {
        let rim = |side: f64, i: usize| {
            let (sine, cosine) = (2.0 * PI * i as f64 / SIDES as f64).sin_cos();
            let across = if half[0] > 0.0 { [0.0, cosine, sine] } else { [sine, 0.0, cosine] };
            std::array::from_fn(|axis| middle[axis] + side * half[axis] + radius * across[axis])
        };
        let ring = |side: f64| (0..SIDES).map(|i| rim(side, i)).collect::<Vec<_>>();
        self.face(&ring(1.0), colour);
        self.face(&ring(-1.0).into_iter().rev().collect::<Vec<_>>(), colour);
        for i in 0..SIDES {
            self.face(&[rim(-1.0, i), rim(-1.0, i + 1), rim(1.0, i + 1), rim(1.0, i)], colour);
        }
    }

    /// A rounded roof from this height on.
    fn roof(&mut self, from: f64, height: f64) {
        let [length, width] = HALF;
        let edge = |x: f64, i: usize| {
            let (sine, cosine) = (PI * i as f64 / SIDES as f64).sin_cos();
            [x, width * cosine, from + height * sine]
        };
        let ring = |x: f64| (0..=SIDES).map(|i| edge(x, i)).collect::<Vec<_>>();
        self.face(&ring(length), GREY);
        self.face(&ring(-length).into_iter().rev().collect::<Vec<_>>(), GREY);
        for i in 0..SIDES {
            self.face(&[edge(-length, i), edge(length, i), edge(length, i + 1), edge(-length, i + 1)], GREY);
        }
    }

    /// Adds a thin bar between two places.
    fn bar(&mut self, from: [f64; 3], to: [f64; 3]) {
        let off = 0.03;
        let around = |[x, y, z]: [f64; 3]| {
            let is_across = from[0] == to[0];
            let aside = if is_across { [off, 0.0] } else { [0.0, off] };
            [
                [x - aside[0], y - aside[1], z - off],
                [x + aside[0], y + aside[1], z - off],
                [x + aside[0], y + aside[1], z + off],
                [x - aside[0], y - aside[1], z + off],
            ]
        };
        let (first, last) = (around(from), around(to));
        for i in 0..4 {
            let next = (i + 1) % 4;
            self.face(&[first[i], first[next], last[next], last[i]], DARK);
        }
        self.face(&first, DARK);
        self.face(&last, DARK);
    }
}
