//! Wheels of models: named parts that roll.

use relativity_core::Turning;
use relativity_render::{Shape, Spin};
use serde_json::json;

use super::{gltf, read};
use crate::scene::Scene;

/// A prism of this many sides about an axle along y, with the numbers of its corners counted from this one.
fn prism([x, y, z]: [f64; 3], radius: f64, sides: u32, first: u32) -> String {
    let corner = |i: u32| {
        let (sine, cosine) = (std::f64::consts::TAU * f64::from(i / 2) / f64::from(sides)).sin_cos();
        let side = if i.is_multiple_of(2) { -0.1 } else { 0.1 };
        format!("v {} {} {}\n", x + radius * cosine, y + side, z + radius * sine)
    };
    let face = |i: u32| {
        let [a, b] = [2 * i, 2 * ((i + 1) % sides)].map(|corner| first + corner);
        format!("f {a} {} {} {b}\n", a + 1, b + 1)
    };
    (0..2 * sides).map(corner).chain((0..sides).map(face)).collect()
}

/// A plate with two wheels, one of 7 sides in two pieces.
fn cart() -> String {
    let plate = "o body\nv 0 0 1\nv 4 0 1\nv 4 1 1\nv 0 1 1\nf 1 2 3 4\n";
    let front = prism([3.0, 0.5, 0.5], 0.5, 7, 5);
    let rear = prism([1.0, 0.5, 0.4], 0.4, 16, 19);
    let (one, other) = front.split_at(front.rfind("\nf").expect("faces") + 1);
    format!("{plate}o front wheel\n{one}g rear wheel\n{rear}o front wheel\n{other}")
}

fn spins(scene: &Scene) -> Vec<Option<Spin>> {
    scene.bodies.iter().map(|body| body.spin).collect()
}

const WHEELS: &str = "path = \"a.obj\"\nup = \"z\"\nwheels = [\"rear wheel\", \"front wheel\"]";

fn with(table: &str) -> Result<Scene, String> {
    read(table, &[("a.obj", cart().as_bytes())])
}

#[test]
fn a_named_part_of_an_obj_rolls_about_the_middle_of_the_circle_around_it() {
    let scene = with(&format!("{WHEELS}\nscale = 2\nplace = [1, 0, 3]")).expect("it is right");
    assert_eq!(scene.names, ["a", "rear wheel", "front wheel"]);
    let counts: Vec<_> =
        scene.bodies.iter().map(|body| body.triangles.as_ref().expect("a model").count()).collect();
    assert_eq!(counts, [2, 32, 14]);
    let [None, Some(rear), Some(front)] = spins(&scene)[..] else { panic!("two of them roll") };
    for (spin, hub, radius) in [(rear, [3.0, 1.0, 3.8], 0.8), (front, [7.0, 1.0, 4.0], 1.0)] {
        assert!(spin.hub.iter().zip(hub).all(|(a, b)| (a - b).abs() < 1e-6), "{spin:?}");
        assert!((spin.radius - radius).abs() < 1e-6 && spin.turning == Turning::Rolling, "{spin:?}");
    }
    // No corner is farther off than the radius, or it would be faster than the rim.
    let unmoved = with(&format!("{WHEELS}\nscale = 2")).expect("it is right");
    for body in &unmoved.bodies[1..] {
        let (spin, triangles) = (body.spin.expect("it rolls"), body.triangles.as_ref().expect("a model"));
        let off = |corner: glam::DVec3| {
            let place = triangles.middle() + corner;
            (place.x - spin.hub[0]).hypot(place.z - spin.hub[2])
        };
        assert!(triangles.corners().map(off).all(|off| off <= spin.radius * (1.0 + 1e-15)));
        let Shape::Cylinder { radius, .. } = body.outline() else {
            panic!("it has the outline of a cylinder")
        };
        assert_eq!(radius.to_bits(), spin.radius.to_bits());
    }
    let still = with(&format!("{WHEELS}\nrolls = false")).expect("it is right");
    assert_eq!((still.bodies.len(), spins(&still)), (3, vec![None; 3]));
    let spinning = with(&format!("{WHEELS}\nrim_speed = -0.5")).expect("it is right");
    assert!(spins(&spinning)[1].is_some_and(|spin| spin.turning == Turning::RimSpeed(-0.5)));
    assert_ne!(still.fingerprint(), spinning.fingerprint());
    let whole = with("path = \"a.obj\"").expect("it is right");
    assert_eq!(whole.bodies.len(), 1);
    // Nothing is left of it.
    let all = WHEELS.replace('[', "[\"body\", ");
    assert_eq!(with(&all).expect("it is right").names, ["body", "rear wheel", "front wheel"]);
}

#[test]
fn a_node_of_a_gltf_rolls_with_all_that_is_in_it() {
    let mut document = gltf();
    document["nodes"] = json!([
        { "name": "car", "mesh": 0, "children": [1, 3] },
        { "name": "wheel", "children": [2] },
        { "mesh": 0, "scale": [2, 1, 1] },
        { "mesh": 0, "name": "seat" }
    ]);
    let scene = |name: &str| {
        let table = format!("path = \"a.gltf\"\nwheels = [\"{name}\"]");
        read(&table, &[("a.gltf", document.to_string().as_bytes())])
    };
    let found = scene("wheel").expect("it is right");
    assert_eq!(found.names, ["a", "wheel"]);
    let count = |body: usize| found.bodies[body].triangles.as_ref().expect("a model").count();
    assert_eq!((count(0), count(1)), (8, 4));
    assert_eq!(scene("car").expect("it is right").names, ["car"]);
    assert_eq!(
        scene("whel").expect_err("it is wrong"),
        "./a.toml:4: wheels = [\"whel\"]: no part is called `whel`: the nearest are wheel, car, seat"
    );
}

#[test]
fn what_is_wrong_with_wheels_is_said_in_one_line() {
    let wrong = |rest: &str| with(&format!("path = \"a.obj\"\n{rest}")).expect_err("it is wrong");
    let nothing = "o nothing\ng nothing\n";
    let empty = format!("{nothing}{}", cart());
    let empty = read("path = \"a.obj\"\nwheels = [\"nothing\"]", &[("a.obj", empty.as_bytes())]);
    let unnamed = read("path = \"a.gltf\"\nwheels = [\"a\"]", &[("a.gltf", gltf().to_string().as_bytes())]);
    let texts = [
        (
            wrong("wheels = [\"front whel\"]"),
            "wheels = [\"front whel\"]: no part is called `front whel`: the nearest are front wheel, rear wheel, body",
        ),
        (
            wrong("wheels = [\"body\", \"body\"]"),
            "wheels = [\"body\", \"body\"]: `body` and `body` have triangles in common",
        ),
        (wrong("wheels = \"body\""), "wheels = \"body\" must be names in double quotes, in brackets"),
        (wrong("wheels = [1]"), "wheels = 1 must be names in double quotes, in brackets"),
        (wrong("wheels = []\nrolls = true"), "rolls = true must be left out where there are no `wheels`"),
        (wrong("rim_speed = 0.5"), "rim_speed = 0.5 must be left out where there are no `wheels`"),
        (
            unnamed.expect_err("it is wrong"),
            "wheels = [\"a\"]: no part is called `a`: the model has no named parts",
        ),
        (
            empty.expect_err("it is wrong"),
            "wheels = [\"nothing\"]: no part is called `nothing`: the nearest are body, front wheel, rear wheel",
        ),
    ];
    for (found, expected) in texts {
        let (place, reason) = found.split_once(": ").expect("a place");
        assert!(place.starts_with("./a.toml:"), "{found}");
        assert_eq!(reason, expected);
    }
}
