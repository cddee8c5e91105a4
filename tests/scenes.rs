//! The scene files that ship with the program, checked geometrically.

use gamow::scene::{PRESETS, Scene};
use glam::DVec3;
use relativity_render::{Body, Material, Shape};

use crate::support::signed_distance;

#[test]
fn every_scene_file_is_a_preset_and_loads_as_one() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes");
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).expect("the folder exists") {
        let path = entry.expect("it can be listed").path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let name = path.file_stem().expect("it has a name").to_string_lossy().into_owned();
        let loaded = Scene::load(&path).unwrap_or_else(|error| panic!("{error}"));
        // A preset reports on no models.
        let loaded = Scene { models: Vec::new(), ..loaded };
        assert_eq!(Some(loaded), Scene::preset(&name), "{name}");
        names.push(name);
    }
    names.sort();
    let mut presets = PRESETS;
    presets.sort_unstable();
    assert_eq!(names, presets);
}

fn cyclist() -> Scene {
    Scene::preset("cyclist").expect("it is a preset")
}

#[test]
fn the_cyclists_tracked_point_is_the_papers_at_the_front_of_the_front_tyre() {
    let cyclist = cyclist();
    assert_eq!(cyclist.tracked, [0.0, 3.0, 2.0]);
    let Shape::Ring { centre, axis, .. } = cyclist.bodies[0].shape else { panic!("the tyre comes first") };
    assert_eq!((centre[1], centre[2], axis), (3.0, 2.0, [0.0, 1.0, 0.0]));
    assert!(signed_distance(&cyclist.bodies[0].shape, cyclist.tracked.into()).abs() < 1e-12);
}

#[test]
fn no_other_part_of_the_cyclist_reaches_as_far_forward() {
    for (number, body) in cyclist().bodies.iter().enumerate().skip(1) {
        let front = largest_x(&body.shape);
        assert!(front < -0.01, "body {number} reaches x = {front}");
    }
}

const NO_FLAT_FACES: &str = "the cyclist has none with flat faces";

/// Largest x on a shape.
fn largest_x(shape: &Shape) -> f64 {
    match *shape {
        Shape::Sphere { centre, radius } => centre[0] + radius,
        Shape::Tube { from, to, radius } => from[0].max(to[0]) + radius,
        Shape::Ring { centre, axis, radius, tube_radius } => {
            centre[0] + radius * (1.0 - axis[0] * axis[0]).sqrt() + tube_radius
        }
        _ => unreachable!("{NO_FLAT_FACES}"),
    }
}

#[test]
fn the_wheels_of_the_street_scene_stand_on_the_ground() {
    let street = Scene::preset("street").expect("it is a preset");
    let ground = street.ground_z.expect("a street has ground");
    let tyres: Vec<f64> = street.bodies.iter().filter_map(|body| lowest_z_of_tyre(&body.shape)).collect();
    assert_eq!(tyres.len(), 2);
    assert!(tyres.iter().all(|lowest| (lowest - ground).abs() < 1e-9), "{tyres:?}");
}

/// Lowest point of a ring as large as a tyre.
fn lowest_z_of_tyre(shape: &Shape) -> Option<f64> {
    match *shape {
        Shape::Ring { centre, radius, tube_radius, .. } if radius > 0.47 => {
            Some(centre[2] - radius - tube_radius)
        }
        _ => None,
    }
}

#[test]
fn every_preset_tracks_a_point_on_one_of_its_bodies() {
    for name in PRESETS {
        let scene = Scene::preset(name).expect("it is a preset");
        let distances =
            scene.bodies.iter().map(|body| signed_distance(&body.shape, scene.tracked.into()).abs());
        assert!(distances.fold(f64::INFINITY, f64::min) < 1e-12, "{name}");
    }
}

#[test]
fn the_cyclist_is_one_piece() {
    // Bodies that touch form one piece: nothing hangs in the air.
    let bodies = cyclist().bodies;
    let mut reached = vec![false; bodies.len()];
    let mut to_visit = vec![0];
    while let Some(number) = to_visit.pop() {
        if std::mem::replace(&mut reached[number], true) {
            continue;
        }
        to_visit
            .extend((0..bodies.len()).filter(|&other| touch(&bodies[number].shape, &bodies[other].shape)));
    }
    assert_eq!(reached.iter().position(|reached| !reached), None);
}

/// Whether two shapes overlap, or come within a hundredth of each other.
fn touch(a: &Shape, b: &Shape) -> bool {
    skeleton(a).any(|point| signed_distance(b, point) < tube_radius(a) + 0.01)
}

/// Points along the curve in the middle of a shape.
fn skeleton(shape: &Shape) -> Box<dyn Iterator<Item = DVec3>> {
    let steps = (0..=200).map(|step| f64::from(step) / 200.0);
    match *shape {
        Shape::Sphere { centre, .. } => Box::new(std::iter::once(centre.into())),
        Shape::Tube { from, to, .. } => Box::new(steps.map(move |s| DVec3::from(from).lerp(to.into(), s))),
        Shape::Ring { centre, axis, radius, .. } => {
            let (u, v) = DVec3::from(axis).any_orthonormal_pair();
            let turns = steps.map(|s| (std::f64::consts::TAU * s).sin_cos());
            Box::new(turns.map(move |(sin, cos)| DVec3::from(centre) + radius * (cos * u + sin * v)))
        }
        _ => unreachable!("{NO_FLAT_FACES}"),
    }
}

/// How far a shape reaches from its skeleton.
fn tube_radius(shape: &Shape) -> f64 {
    match *shape {
        Shape::Sphere { radius, .. } | Shape::Tube { radius, .. } => radius,
        Shape::Ring { tube_radius, .. } => tube_radius,
        _ => unreachable!("{NO_FLAT_FACES}"),
    }
}

#[test]
fn every_body_of_a_preset_has_a_name_of_its_own() {
    for preset in PRESETS {
        let scene = Scene::preset(preset).expect("it is a preset");
        let unnamed = |name: &&String| {
            let shapes = ["sphere ", "tube ", "ring ", "box ", "cylinder "];
            shapes.into_iter().any(|shape| name.starts_with(shape))
        };
        assert_eq!(scene.names.iter().find(unnamed), None, "{preset}");
        let mut names = scene.names.clone();
        names.sort();
        let twice = names.windows(2).find(|pair| pair[0] == pair[1]);
        assert_eq!(twice, None, "{preset}");
    }
}

#[path = "../examples/tram.rs"]
#[allow(dead_code, reason = "as an example it has a main function")]
#[allow(clippy::allow_attributes, reason = "an expectation would fail in the example itself")]
mod tram;

/// The tram of the program equals what its example writes, and in its scene it stands upright on wheels that
/// roll on the ground.
#[test]
fn the_tram_is_what_its_example_writes() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes");
    let written = |name: &str| std::fs::read(format!("{folder}/{name}")).expect("it is there");
    assert!(written("tram.obj") == tram::text().into_bytes(), "run `cargo run --example tram`");
    assert!(written("tram.mtl") == tram::MATERIALS.as_bytes(), "run `cargo run --example tram`");
    let mut picture =
        png::Decoder::new(std::io::Cursor::new(written("tram.png"))).read_info().expect("it is a PNG");
    let (size, levels) = tram::board();
    let mut found = vec![0; levels.len()];
    let read = picture.next_frame(&mut found).expect("it is as large");
    assert!(([read.width, read.height], &found) == (size, &levels), "run `cargo run --example tram`");
    let scene = Scene::load(format!("{folder}/tram.toml").as_ref()).unwrap_or_else(|error| panic!("{error}"));
    let [body, wheels @ ..] = &scene.bodies[..] else { panic!("it has bodies") };
    let count = |body: &relativity_render::Body| body.triangles.as_ref().expect("a model").count();
    assert_eq!((count(body), wheels.iter().map(count).collect::<Vec<_>>()), (726, vec![72; 8]));
    for spin in wheels.iter().map(|wheel| wheel.spin.expect("it rolls")) {
        let low = spin.hub[2] - spin.radius;
        // The file has three decimals.
        assert!((low - scene.ground_z.expect("a ground")).abs() < 1e-3, "{low}");
        assert!((spin.radius - 0.4).abs() < 1e-3, "{spin:?}");
    }
    assert!(body.shape.distance(scene.tracked.into()).abs() < 1e-9);
}

/// The description of scene files names every measured material.
#[test]
fn every_material_is_described() {
    let description = include_str!("../assets/scenes/README.md");
    let missing =
        Material::ALL.into_iter().find(|material| !description.contains(&format!("`{}`", material.name())));
    assert_eq!(missing, None);
}

#[path = "../examples/town/main.rs"]
#[allow(dead_code, reason = "as an example it has a main function")]
#[allow(clippy::allow_attributes, reason = "an expectation would fail in the example itself")]
mod town;

/// The town and its cyclist equal what their example writes; nothing in the town touches the ground, since
/// that would have a shadow there.
#[test]
fn the_town_is_what_its_example_writes() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/scenes");
    for (name, text) in town::files() {
        let written = std::fs::read_to_string(format!("{folder}/{name}")).expect("it is there");
        assert!(written == text, "{name}: run `cargo run --example town`");
    }
    let scene = Scene::preset("town").expect("a preset");
    let ground = scene.ground_z.expect("a ground");
    let low = |body: &Body| match body.shape {
        Shape::Box { centre, half, .. } => centre[2] - half[2],
        Shape::Sphere { centre, radius } => centre[2] - radius,
        _ => f64::INFINITY,
    };
    let touching = scene.bodies.iter().find(|body| (low(body) - ground).abs() < 0.02);
    assert_eq!(touching, None);
}
