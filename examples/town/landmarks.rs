//! The station, the post office, the church at the end of the street, and what stands on the pavement.

use super::houses::{House, Row};
use super::objects::{Objects, Place};
use super::trees::hedge;
use super::{BLOCK, FRONTS, PLAIN};

/// Adds a block of the far side with the station, and hedges beside it.
pub fn station(objects: &mut Objects) {
    let hall =
        House { width: 26.0, columns: 7, door: 3, rise: 5.0, wall: "brick_paving", shutters: None, ..PLAIN };
    let wing = House { width: 8.0, columns: 2, door: 0, ..hall };
    let mut row = Row { objects, front: FRONTS[1], is_far: true };
    let end = row.houses(9.0, &[wing, hall, wing]);
    let middle = 9.0 + 8.0 + 13.0;
    gable(&mut row, middle, hall.eaves(), hall.wall);
    clock(objects, "station clock", [middle, FRONTS[1] - 0.3, hall.eaves() + 1.6]);
    canopy(objects, [middle - 6.0, middle + 6.0]);
    hedge(objects, [0.3, 13.0], [8.6, 13.9], 2.0, 21);
    hedge(objects, [end + 0.4, 13.0], [BLOCK - 0.4, 13.9], 2.0, 22);
}

/// Adds a block of the far side with the post office among houses.
pub fn post_office(objects: &mut Objects) {
    let office = House {
        width: 18.0,
        columns: 5,
        door: 2,
        floors: 3,
        rise: 3.4,
        wall: "ochre plaster",
        shutters: None,
        trim: "stone",
        door_paint: "door red",
        ..PLAIN
    };
    let mut row = Row { objects, front: FRONTS[1], is_far: true };
    let houses = [
        House { width: 11.0, wall: "brick_paving", shutters: None, dormers: 2, ..PLAIN },
        House { width: 10.0, ..PLAIN },
        office,
        House { width: 11.0, wall: "rose plaster", ..PLAIN },
        House { width: 10.0, wall: "white_paint", door: 0, trim: "stone", dormers: 1, ..PLAIN },
    ];
    row.houses(0.0, &houses);
    let middle = 21.0 + 9.0;
    gable(&mut row, middle, office.eaves(), office.wall);
    row.objects.part = "sign";
    row.block("post red", [middle - 3.2, -0.3, 4.3], [middle + 3.2, -0.05, 5.3]);
    row.block("white_paint", [middle - 2.9, -0.34, 4.52], [middle + 2.9, -0.3, 5.08]);
    clock(objects, "post office clock", [middle, FRONTS[1] - 0.3, office.eaves() + 1.6]);
}

/// Adds a stepped gable above the eaves.
fn gable(row: &mut Row<'_>, middle: f64, eaves: f64, wall: &str) {
    row.objects.part = "gable";
    for step in 0..4 {
        let (half, low) = (4.0 - 0.9 * f64::from(step), eaves - 0.4 + f64::from(step));
        row.block(wall, [middle - half, -0.25, low], [middle + half, 0.6, low + 1.0]);
        row.block("stone", [middle - half - 0.1, -0.35, low + 0.9], [middle + half + 0.1, 0.7, low + 1.02]);
    }
}

/// Adds a clock that faces lower y: half past five.
fn clock(objects: &mut Objects, name: &'static str, [x, y, z]: Place) {
    objects.part = name;
    objects.cylinder("iron", [x, y, z], [x, y + 0.1, z], 1.15);
    objects.cylinder("clock face", [x, y - 0.02, z], [x, y + 0.1, z], 1.03);
    let mut hand = |turn: f64, from: f64, to: f64, radius: f64| {
        let (sine, cosine) = turn.to_radians().sin_cos();
        let at = |along: f64| [x + sine * along, y - 0.03, z + cosine * along];
        objects.tube("iron", at(from), at(to), radius);
    };
    hand(165.0, -0.1, 0.55, 0.055);
    hand(180.0, -0.1, 0.85, 0.04);
    (0..12).for_each(|hour| hand(30.0 * f64::from(hour), 0.88, 0.95, 0.025));
}

/// Adds the roof over the door of the station, on four posts.
fn canopy(objects: &mut Objects, [from, to]: [f64; 2]) {
    let [wall, edge] = [FRONTS[1], FRONTS[1] - 2.4];
    objects.part = "canopy";
    let (middle, tilt) = ([0.5 * (from + to), 0.5 * (wall + edge), 4.45], 14.0);
    objects.turned_block("zinc", middle, [to - from, 2.55, 0.1], tilt);
    objects.block("shutter green", [from, edge - 0.08, 3.85], [to, edge, 4.2]);
    for number in 0..4 {
        let x = from + 0.3 + (to - from - 0.6) * f64::from(number) / 3.0;
        objects.cylinder("shutter green", [x, edge + 0.2, -0.3], [x, edge + 0.2, 4.2], 0.1);
    }
}

/// Adds a church, which stands across the end of the street.
pub fn church(objects: &mut Objects) {
    objects.part = "church";
    objects.block("stone", [-3.2, -3.2, 0.0], [3.2, 3.2, 22.0]);
    objects.block("stone", [-3.5, -3.5, 21.6], [3.5, 3.5, 22.2]);
    // The spire: ever narrower cylinders.
    for step in 0..16 {
        let step = f64::from(step);
        let z = 22.0 + step;
        objects.cylinder("concrete_roof_tile", [0.0, 0.0, z], [0.0, 0.0, z + 1.1], 3.2 - 0.2 * step);
    }
    for z in [6.0, 17.0] {
        objects.block("window", [-3.25, -0.8, z], [-3.0, 0.8, z + 3.2]);
    }
    objects.cylinder("clock face", [-3.4, 0.0, 13.0], [-3.0, 0.0, 13.0], 1.6);
    objects.block("iron", [-3.45, -0.08, 12.8], [-3.4, 0.08, 14.3]);
    for half in [-1.0, 1.0] {
        objects.block("cream plaster", [2.0, half * 3.2, 0.0], [14.0, half * 30.0, 12.0]);
        let centre = [5.0, half * 17.0, 14.6];
        objects.block("clay_tile", [centre[0] - 3.4, half * 3.2, 12.0], [14.0, half * 30.6, 13.6]);
        objects.block("clay_tile", [centre[0] - 1.4, half * 3.2, 13.6], [13.0, half * 30.2, 15.4]);
        for number in 0..5 {
            let y = half * (6.5 + 5.0 * f64::from(number));
            objects.block("window", [1.9, y - 0.9, 3.5], [2.1, y + 0.9, 9.0]);
        }
    }
}

/// Adds a bench at the origin that looks towards lower y.
pub fn bench(objects: &mut Objects) {
    objects.part = "bench";
    for row in 0..3 {
        let across = -0.5 + 0.22 * f64::from(row);
        objects.block("weathered_wood", [-1.3, across, 0.66], [1.3, across + 0.17, 0.72]);
    }
    for row in 0..2 {
        let low = 0.9 + 0.28 * f64::from(row);
        objects.block("weathered_wood", [-1.3, 0.16, low], [1.3, 0.22, low + 0.2]);
    }
    for side in [-1.0, 1.0] {
        objects.block("iron", [side - 0.05, -0.45, 0.0], [side + 0.05, -0.37, 0.66]);
        objects.block("iron", [side - 0.05, 0.12, 0.0], [side + 0.05, 0.2, 1.38]);
    }
}

/// Adds a lamp post at the origin.
pub fn lamp(objects: &mut Objects) {
    let height = 6.0;
    objects.part = "street lamp";
    objects.tube("iron", [0.0, 0.0, -0.2], [0.0, 0.0, height], 0.07);
    objects.tube("iron", [0.0, 0.0, -0.2], [0.0, 0.0, 0.9], 0.12);
    objects.ball("lamp", [0.0, 0.0, height + 0.24], 0.24);
    objects.cylinder("iron", [0.0, 0.0, height + 0.42], [0.0, 0.0, height + 0.5], 0.16);
}

/// Adds a post box at the origin.
pub fn post_box(objects: &mut Objects) {
    objects.part = "post box";
    objects.cylinder("iron", [0.0, 0.0, -0.2], [0.0, 0.0, 0.25], 0.42);
    objects.cylinder("post red", [0.0, 0.0, 0.25], [0.0, 0.0, 2.05], 0.38);
    objects.cylinder("post red", [0.0, 0.0, 2.05], [0.0, 0.0, 2.15], 0.46);
    objects.ball("post red", [0.0, 0.0, 1.98], 0.38);
    objects.block("slot", [-0.2, -0.385, 1.72], [0.2, 0.385, 1.8]);
    objects.block("clock face", [-0.14, -0.39, 1.15], [0.14, 0.0, 1.5]);
}
