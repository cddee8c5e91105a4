//! Models that are opened by themselves: they ride on Gamow's street.

use super::{MTL, OBJ, folder_of, placed, triangles};
use crate::scene::{Scene, scene_text};

/// A box of this size as OBJ, with its corner at (1, 2, 3).
fn block([x, y, z]: [f64; 3]) -> String {
    let corner = |i: u32| {
        let side = |bit: u32, length: f64| if i & bit == 0 { 0.0 } else { length };
        format!("v {} {} {}\n", 1.0 + side(1, x), 2.0 + side(2, y), 3.0 + side(4, z))
    };
    let corners: String = (0..8).map(corner).collect();
    format!("{corners}f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n")
}

fn ridden(text: &str) -> Result<Scene, String> {
    let (folder, path) = folder_of("", &[("my bike.obj", text.as_bytes())]);
    let around = format!("{}", folder.path().display());
    let scene = Scene::load(&path.with_file_name("my bike.obj"));
    scene.map_err(|error| error.to_string().replace(&around, "."))
}

#[test]
fn a_model_rides_in_place_of_the_cyclist() {
    let street = Scene::preset("street").expect("a preset");
    // Size in the file, and half of it on the street: height, length along the street, and half the width
    // across.
    for (size, half) in [
        ([1.0, 2.0, 0.5], [0.25 * 1.275, 0.5 * 1.275, 1.275]),
        ([4.0, 2.0, 1.0], [2.55, 0.6375, 1.275]),
        ([1.0, 2.0, 4.0], [2.55, 0.6375, 1.275]),
        ([16.0, 0.2, 8.0], [8.0, 4.0, 0.1]),
    ] {
        let scene = ridden(&block(size)).expect("it is right");
        assert_eq!(scene.names[0], "my bike");
        assert_eq!(scene.street, street.street);
        assert_eq!(scene.groups[1].count, street.groups[1].count);
        assert_eq!(triangles(&scene).count(), 12);
        let ([x, y, z], found) = placed(&scene);
        assert!(found.iter().zip(half).all(|(a, b)| (a - b).abs() < 1e-5), "{size:?}: {found:?}");
        let near = (y - half[1]) - 2.2;
        assert!((x + half[0]).abs() < 1e-5 && (z - half[2] + 2.5).abs() < 1e-5, "{size:?}: {x} {z}");
        assert!(near.abs() < 1e-5 || near > 0.0 && (y - 4.0).abs() < 1e-5, "{size:?}: {y}");
    }
}

#[test]
fn its_scene_can_be_saved_beside_it_or_above() {
    let files: [(&str, &[u8]); 2] = [("models/a.obj", OBJ.as_bytes()), ("models/paint.mtl", MTL.as_bytes())];
    let (folder, path) = folder_of("", &files);
    let model = folder.path().join("models/a.obj");
    let direct = Scene::load(&model).expect("it is right");
    for place in [path.clone(), folder.path().join("models/b.toml")] {
        let around = place.parent().expect("a folder");
        std::fs::write(&place, scene_text(&model, around).expect("it is there")).expect("it is written");
        assert_eq!(Scene::load(&place).expect("it is right").fingerprint(), direct.fingerprint());
    }
    let elsewhere = tempfile::tempdir().expect("a folder");
    let refused = scene_text(&model, elsewhere.path()).expect_err("it is elsewhere");
    assert!(refused.ends_with("a.obj must lie in the folder of the scene file, or in a folder there"));
}

#[test]
fn what_is_wrong_with_it_is_said_in_one_line() {
    for (text, expected) in [
        ("v 0 0 x", "./my bike.obj: line 1 of it: x is not a number"),
        ("v 0 0 0", "./my bike.obj: the model has no triangle with an area"),
        ("v 0 0 0\nf 1 1 1", "./my bike.obj: the model has no triangle with an area"),
        (
            "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3",
            "./my bike.obj: corner 0 of the model is at [NaN, NaN, NaN], and coordinates must lie between -1e6 and 1e6",
        ),
        ("mtllib b.mtl", "./my bike.obj: the model has no triangle with an area"),
    ] {
        assert_eq!(ridden(text).expect_err("it is wrong"), expected);
    }
    let missing =
        Scene::load(std::path::Path::new("nowhere/a.glb")).expect_err("it is not there").to_string();
    assert!(missing.starts_with("nowhere/a.glb: cannot read nowhere/a.glb: "), "{missing}");
}
