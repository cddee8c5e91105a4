//! Houses side by side: fronts with windows in reveals, doors and shutters, stepped gables, and roofs of
//! tiles.

use super::objects::{Objects, Place};

/// Depth of a house, from its front.
const DEPTH: f64 = 9.0;
/// Overhang of the eaves, and thickness of a roof.
const EAVES: f64 = 0.6;
const ROOF: f64 = 0.22;
/// Half the width of a window or door, and how deep they lie in the wall.
const HALF: f64 = 0.75;
const REVEAL: f64 = 0.26;
/// Share of the light under the eaves.
const SHADE: f64 = 0.55;
/// By how much the wall between windows lies behind the piers.
const STEP: f64 = 0.03;
/// Heights of the windows of the floors.
const FLOORS: [[f64; 2]; 3] = [[1.45, 3.75], [5.9, 8.2], [10.3, 12.2]];

/// A house: its measures and the materials of its parts.
#[derive(Clone, Copy)]
pub struct House {
    pub width: f64,
    /// Floors with windows, at most three, and windows in each.
    pub floors: usize,
    pub columns: usize,
    /// The column of the door.
    pub door: usize,
    /// Height of the ridge above the eaves.
    pub rise: f64,
    pub wall: &'static str,
    pub trim: &'static str,
    pub shutters: Option<&'static str>,
    pub door_paint: &'static str,
    pub roof: &'static str,
    /// Number of dormers.
    pub dormers: usize,
}

/// A row of houses along x, whose front stands at `front`, facing the street on the side of lower y, or
/// else of higher y.
pub struct Row<'a> {
    pub objects: &'a mut Objects,
    pub front: f64,
    pub is_far: bool,
}

impl House {
    /// Returns the height of the eaves.
    pub const fn eaves(&self) -> f64 {
        FLOORS[self.floors - 1][1] + 1.2
    }

    /// Returns the middle of a column.
    fn column(&self, number: usize) -> f64 {
        self.width * (number as f64 + 0.5) / self.columns as f64
    }
}

impl Row<'_> {
    /// Adds these houses from `x` on, and returns where they end.
    pub fn houses(&mut self, x: f64, houses: &[House]) -> f64 {
        houses.iter().fold(x, |x, house| {
            self.house(x, house);
            x + house.width
        })
    }

    /// Adds a box between two corners: along, behind the front, and up.
    pub fn block(&mut self, material: &str, low: Place, high: Place) {
        let at = |[x, behind, z]: Place| [x, self.across(behind), z];
        self.objects.block(material, at(low), at(high));
    }

    /// Adds a box in the shade.
    fn shade(&mut self, lit: f64, material: &str, low: Place, high: Place) {
        let before = std::mem::replace(&mut self.objects.lit, lit);
        self.block(material, low, high);
        self.objects.lit = before;
    }

    fn across(&self, behind: f64) -> f64 {
        if self.is_far { self.front + behind } else { self.front - behind }
    }

    fn house(&mut self, x: f64, house: &House) {
        let (end, eaves) = (x + house.width, house.eaves());
        self.front(x, house);
        self.objects.part = "wall";
        // The room behind the windows, and the wall up to the roof.
        self.block("window", [x + 0.01, REVEAL, 0.0], [end - 0.01, REVEAL + 0.1, eaves - 0.1]);
        self.block(house.wall, [x, 0.7, 0.0], [end, DEPTH, eaves]);
        self.block("stone", [x, -0.08, 0.0], [end, 0.0, 0.45]);
        self.block(house.trim, [x, -0.1, 4.7], [end, 0.0, 4.9]);
        self.block(house.trim, [x, -0.22, eaves - 0.42], [end, 0.0, eaves - 0.12]);
        self.block("zinc", [end - 0.14, -0.16, 0.2], [end, -0.02, eaves - 0.2]);
        self.roof([x, end], eaves, house);
        for number in 0..house.dormers {
            let middle = x + house.width * (number as f64 + 0.5) / house.dormers as f64;
            self.dormer(middle, eaves, house);
        }
    }

    /// Adds the wall of the front: piers beside the windows, and a little behind these the wall below and
    /// above each window.
    fn front(&mut self, x: f64, house: &House) {
        let eaves = house.eaves();
        let mut from = x;
        self.objects.part = "wall";
        for column in 0..house.columns {
            let middle = x + house.column(column);
            self.objects.part = "wall";
            self.block(house.wall, [from, 0.0, 0.0], [middle - HALF, 0.7, eaves]);
            from = middle + HALF;
            let mut low = 0.0;
            for (floor, &[bottom, top]) in FLOORS[..house.floors].iter().enumerate() {
                if floor == 0 && column == house.door {
                    self.door(middle, house);
                } else {
                    self.objects.part = "wall";
                    self.block(house.wall, [middle - HALF, STEP, low], [from, 0.7, bottom]);
                    self.window(middle, [bottom, top], house);
                }
                low = top;
            }
            self.objects.part = "wall";
            self.block(house.wall, [middle - HALF, STEP, low], [from, 0.7, eaves]);
        }
        self.block(house.wall, [from, 0.0, 0.0], [x + house.width, 0.7, eaves]);
    }

    fn window(&mut self, middle: f64, [low, high]: [f64; 2], house: &House) {
        let [from, to] = [middle - HALF, middle + HALF];
        let bars = REVEAL - 0.06;
        self.objects.part = "window";
        self.block("white_paint", [middle - 0.05, bars, low], [middle + 0.05, REVEAL, high]);
        let cross = low + 0.64 * (high - low);
        self.block("white_paint", [from, bars, cross], [to, REVEAL, cross + 0.09]);
        self.block(house.trim, [from - 0.14, -0.16, low - 0.14], [to + 0.14, 0.02, low]);
        let Some(shutters) = house.shutters else {
            self.block(house.trim, [from - 0.16, -0.09, high], [to + 0.16, 0.02, high + 0.32]);
            return;
        };
        self.objects.part = "shutter";
        for [from, to] in [[from - 0.74, from - 0.03], [to + 0.03, to + 0.74]] {
            self.block(shutters, [from, -0.1, low], [to, -0.02, high]);
        }
    }

    fn door(&mut self, middle: f64, house: &House) {
        let ([from, to], top) = ([middle - HALF, middle + HALF], FLOORS[0][1]);
        self.objects.part = "door";
        self.block(house.door_paint, [from, REVEAL - 0.08, 0.0], [to, REVEAL, top - 0.7]);
        self.block("white_paint", [from, REVEAL - 0.1, top - 0.75], [to, REVEAL, top - 0.65]);
        self.block("stone", [from - 0.25, -0.55, 0.0], [to + 0.25, 0.1, 0.16]);
        for [from, to] in [[from - 0.24, from + 0.02], [to - 0.02, to + 0.24]] {
            self.block(house.trim, [from, -0.1, 0.0], [to, 0.05, top + 0.2]);
        }
        self.block(house.trim, [from - 0.36, -0.28, top + 0.2], [to + 0.36, 0.05, top + 0.42]);
    }

    /// Adds both slopes of a roof, the stepped wall at its beginning, the gutter and a chimney.
    fn roof(&mut self, [from, to]: [f64; 2], eaves: f64, house: &House) {
        let half = 0.5 * DEPTH;
        self.objects.part = "roof";
        let slope = house.rise / half;
        let [x, width] = [0.5 * (from + to), to - from];
        for (low, high) in [(-EAVES, half), (DEPTH + EAVES, half)] {
            let [bottom, top] = [eaves - slope * EAVES, eaves + house.rise];
            let length = (high - low).hypot(top - bottom);
            let centre = [x, self.across(0.5 * (low + high)), 0.5 * (bottom + top)];
            let rises = (top - bottom).atan2(self.across(high) - self.across(low));
            self.objects.turned_block(house.roof, centre, [width, length, ROOF], rises.to_degrees());
        }
        let gutter = eaves - slope * EAVES;
        self.block("zinc", [from, -EAVES - 0.14, gutter - 0.14], [to, -EAVES + 0.04, gutter + 0.04]);
        // The shadow that the eaves throw on the front.
        let soffit = [[from, -EAVES, gutter - 0.06], [to, 0.1, gutter + 0.02]];
        self.shade(SHADE, "weathered_wood", soffit[0], soffit[1]);
        self.shade(
            SHADE,
            house.wall,
            [from, -0.015, FLOORS[house.floors - 1][1] + 0.35],
            [to, 0.1, eaves - 0.4],
        );
        self.objects.part = "fire wall";
        // The fire wall between two roofs rises in steps.
        for step in 0..4 {
            let reach = half * (1.0 - f64::from(step) / 4.0);
            let top = eaves + house.rise * f64::from(step + 1) / 4.0 + 0.35;
            self.block(house.wall, [from - 0.2, half - reach, eaves - 0.6], [from + 0.2, half + reach, top]);
            let cap =
                [[from - 0.28, half - reach - 0.06, top], [from + 0.28, half + reach + 0.06, top + 0.1]];
            self.block("stone", cap[0], cap[1]);
        }
        self.objects.part = "chimney";
        let [chimney, ridge] = [from + 1.4, eaves + house.rise];
        self.block(
            "brick_paving",
            [chimney - 0.5, half - 0.4, eaves],
            [chimney + 0.5, half + 0.4, ridge + 1.3],
        );
        self.block(
            "stone",
            [chimney - 0.6, half - 0.5, ridge + 1.3],
            [chimney + 0.6, half + 0.5, ridge + 1.5],
        );
        for side in [-0.25, 0.25] {
            let at = |z: f64| [chimney + side, self.across(half), z];
            let ends = [at(ridge + 1.4), at(ridge + 2.0)];
            self.objects.cylinder("clay_tile", ends[0], ends[1], 0.15);
        }
    }

    fn dormer(&mut self, middle: f64, eaves: f64, house: &House) {
        let ([from, to], low) = ([middle - 0.95, middle + 0.95], eaves + 0.9);
        let high = low + 1.7;
        self.objects.part = "dormer";
        self.block(house.wall, [from, 0.6, low - 0.7], [to, 4.0, high]);
        self.block("window", [from + 0.3, 0.55, low - 0.1], [to - 0.3, 0.7, high - 0.2]);
        self.block("white_paint", [middle - 0.05, 0.5, low - 0.1], [middle + 0.05, 0.6, high - 0.2]);
        self.block(house.trim, [from + 0.15, 0.48, low - 0.24], [to - 0.15, 0.7, low - 0.1]);
        let slab = |across: f64| [middle, across, high + 0.2];
        let centre = slab(self.across(2.2));
        let tilt = if self.is_far { 6.0 } else { -6.0 };
        self.objects.turned_block(house.roof, centre, [2.4, 4.0, 0.16], tilt);
    }
}
