//! A street of a small town, and Mr Tompkins on his bicycle, of boxes, balls and tubes: `town.toml` and
//! `mr-tompkins.toml` in `assets/scenes`.
//!
//! A unit is that of the scenes, 0.65 m; x runs along the street, z up from the ground. A block of the street
//! is 60 long. `cargo run --example town` writes the files.

mod ground;
mod houses;
mod landmarks;
mod objects;
mod people;
mod tompkins;
mod trees;

use std::error::Error;
use std::fs;

use self::ground::FRONTS;
use self::houses::{House, Row};
use self::objects::Objects;
use self::people::{Person, person};
use self::trees::{hedge, lobes, shade, tree};

/// Length of a block, where the first begins, and their number.
const BLOCK: f64 = 60.0;
const BEGIN: f64 = -90.0;
const BLOCKS: usize = 5;
/// Height of the ground.
const GROUND: f64 = -2.5;
/// From each tree to the next of its kind.
const TREES: f64 = 30.0;
/// Where the first tree on each side stands, and whether it is a broad one.
const FIRST_TREES: [([f64; 2], bool); 4] =
    [([5.0, 0.7], true), ([12.5, 10.6], true), ([20.0, 0.7], false), ([27.5, 10.6], false)];

/// The beginning of the file.
const HEAD: &str = r#"# A street of a small town, about 200 m long, from the station to the post office. All of it rests. One unit is
# 0.65 m, as on Gamow's street. The sun stands 33 degrees high. `cargo run --example town` writes this file.

name = "A street of a small town"
rider = "street"
metres = 0.65
ground_z = -2.5
street = [2.0, 9.0, 10000.0]      # near kerb, far kerb; house fronts stand at y = 13, and none are painted
sunlit = true
tracked = [-18.49, 8.88, 3.6]     # leaves of a tree, on the side of the street

[[group]]
name = "street"
beta = 0
"#;

/// A house that others are like.
const PLAIN: House = House {
    width: 10.0,
    floors: 2,
    columns: 3,
    door: 1,
    rise: 4.2,
    wall: "cream plaster",
    trim: "white_paint",
    shutters: Some("shutter green"),
    door_paint: "door brown",
    roof: "clay_tile",
    dormers: 0,
};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes");
    for (name, text) in files() {
        fs::write(format!("{folder}/{name}"), text)?;
    }
    Ok(())
}

/// Returns the names and the contents of the files.
#[must_use]
pub fn files() -> [(&'static str, String); 2] {
    [("town.toml", town()), ("mr-tompkins.toml", tompkins::text())]
}

/// Returns the contents of `town.toml`.
fn town() -> String {
    let mut objects = Objects::new("group.object", GROUND);
    let objects = &mut objects;
    let length = BLOCK * BLOCKS as f64;
    objects.stand([BEGIN, 0.0], 1, 0.0);
    landmarks::station(objects);
    ground::kerbs(objects, [0.0, length]);
    objects.stand([BEGIN + BLOCK, 0.0], BLOCKS - 2, BLOCK);
    far(objects);
    objects.stand([BEGIN + length - BLOCK, 0.0], 1, 0.0);
    landmarks::post_office(objects);
    objects.stand([BEGIN + length + 20.0, 5.5], 1, 0.0);
    landmarks::church(objects);
    objects.stand([BEGIN, 0.0], BLOCKS, BLOCK);
    near(objects);
    let trees = (length / TREES) as usize;
    for (number, ([x, y], is_broad)) in FIRST_TREES.into_iter().enumerate() {
        objects.stand([BEGIN + x, y], trees, TREES);
        let lobes = lobes(is_broad, 7 + number as u64);
        tree(objects, &lobes);
        ground::post(objects, 0.2, 4.5);
        shade(&lobes).for_each(|(middle, radius)| ground::disc(objects, middle, radius));
    }
    for [x, y] in [[12.5, 1.5], [5.0, 9.6]] {
        objects.stand([BEGIN + x, y], trees, TREES);
        landmarks::lamp(objects);
        ground::post(objects, 0.07, 6.0);
    }
    objects.stand([BEGIN + 22.5, 11.9], trees, TREES);
    landmarks::bench(objects);
    objects.stand([BEGIN + 18.0, 9.9], BLOCKS, BLOCK);
    landmarks::post_box(objects);
    people(objects);
    HEAD.to_owned() + &objects.text
}

/// Adds the passers-by of each second block.
fn people(objects: &mut Objects) {
    objects.stand([BEGIN, 0.0], BLOCKS.div_ceil(2), 2.0 * BLOCK);
    objects.part = "passer-by";
    let man = Person {
        at: [68.0, 11.6],
        facing: 1.0,
        height: 2.7,
        coat: "navy cloth",
        trousers: Some("grey cloth"),
        has_hat: true,
    };
    let woman = Person { coat: "wine cloth", trousers: None, height: 2.5, has_hat: false, ..man };
    person(objects, &man);
    person(objects, &Person { at: [69.2, 11.9], ..woman });
    person(objects, &Person { at: [106.0, 12.0], facing: -1.0, coat: "green cloth", has_hat: false, ..man });
    person(objects, &Person { at: [84.0, -0.6], facing: -1.0, coat: "green cloth", ..woman });
    person(objects, &Person { at: [40.0, -0.4], coat: "grey cloth", trousers: Some("navy cloth"), ..man });
    person(objects, &Person { at: [22.0, 11.4], facing: -1.0, coat: "brown leather", ..woman });
}

/// Adds the houses of a block on the far side of the road.
fn far(objects: &mut Objects) {
    let houses = [
        House { width: 11.0, dormers: 2, ..PLAIN },
        House {
            width: 9.0,
            floors: 3,
            door: 0,
            wall: "brick_paving",
            shutters: None,
            door_paint: "shutter green",
            ..PLAIN
        },
        House { width: 12.5, columns: 4, door: 2, wall: "ochre plaster", rise: 4.8, ..PLAIN },
        House {
            width: 8.0,
            columns: 2,
            door: 0,
            wall: "white_paint",
            trim: "stone",
            shutters: Some("shutter blue"),
            door_paint: "shutter blue",
            roof: "concrete_roof_tile",
            ..PLAIN
        },
        House {
            width: 10.5,
            floors: 3,
            wall: "rose plaster",
            rise: 3.6,
            door: 2,
            door_paint: "door red",
            ..PLAIN
        },
        House { width: 9.0, wall: "brick_paving", shutters: None, dormers: 1, door: 2, ..PLAIN },
    ];
    Row { objects, front: FRONTS[1], is_far: true }.houses(0.0, &houses);
}

/// The houses of a block on the near side, on both sides of a garden.
fn near_houses() -> [Vec<House>; 2] {
    let before = vec![
        House { width: 10.0, wall: "ochre plaster", door: 0, dormers: 1, ..PLAIN },
        House { width: 9.0, wall: "brick_paving", shutters: None, door_paint: "shutter blue", ..PLAIN },
        House { width: 10.0, floors: 3, door: 2, rise: 3.6, ..PLAIN },
    ];
    let after = vec![
        House { width: 11.0, wall: "rose plaster", rise: 4.8, ..PLAIN },
        House { width: 9.0, wall: "grey plaster", trim: "stone", door: 2, door_paint: "door red", ..PLAIN },
    ];
    [before, after]
}

/// Adds these, and their shadows on the pavement.
fn near(objects: &mut Objects) {
    let [before, after] = near_houses();
    let width = |houses: &[House]| houses.iter().map(|house| house.width).sum::<f64>();
    let [garden, end] = [width(&before), BLOCK - width(&after)];
    let mut row = Row { objects, front: FRONTS[0], is_far: false };
    row.houses(0.0, &before);
    row.houses(end, &after);
    for (houses, mut x) in [before, after].iter().zip([0.0, end]) {
        for house in houses {
            ground::wall(objects, [x, x + house.width], FRONTS[0], house.eaves() + 0.6);
            x += house.width;
        }
    }
    hedge(objects, [garden + 0.2, -3.0], [end - 0.2, -2.2], 2.2, 3);
}
