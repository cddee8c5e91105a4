//! Wheels in scene files.

use std::f64::consts::TAU;

use glam::DVec3;
use relativity_core::Turning;
use relativity_render::{Body, Emission, Material, Paint, Pattern, Shape, Spin};

use super::error;
use crate::scene::Scene;

/// Returns a wheel of four spokes whose hub is at (1, 3, 2), with the `rest` of its table.
fn wheel(rest: &str) -> String {
    format!(
        "name = \"x\"\n[[wheel]]\nhub = [1, 3, 2]\nradius = 0.5\ntyre = 0.03\nrim = 0.01\naxle = 0.2\nhub_radius = 0.05\n\
         spokes = 4\nspoke_radius = 0.005\n{rest}"
    )
}

fn scene(rest: &str) -> Scene {
    Scene::parse(&wheel(rest), "balls.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn ends(body: &Body) -> [DVec3; 2] {
    let Shape::Tube { from, to, .. } = body.shape else { panic!("{body:?} is no tube") };
    [from, to].map(DVec3::from)
}

/// Start and end of some spokes of the paper's cyclist: of the drawing from which its wheels were first
/// written down, to three decimals.
const SPOKES: [(&str, [f64; 3], [f64; 3]); 6] = [
    ("front wheel's spoke 1", [-0.505, 2.948, 1.963], [-0.096, 3.0, 2.098]),
    ("front wheel's spoke 6", [-0.559, 3.052, 1.975], [-0.869, 3.0, 2.274]),
    ("front wheel's spoke 14", [-0.505, 3.052, 2.037], [-0.096, 3.0, 1.902]),
    ("rear wheel's spoke 1", [-2.091, 2.934, 1.961], [-1.667, 3.0, 2.039]),
    ("rear wheel's spoke 4", [-2.144, 3.066, 2.016], [-2.046, 3.0, 2.436]),
    ("rear wheel's spoke 13", [-2.127, 2.934, 1.964], [-1.801, 3.0, 1.682]),
];

#[test]
fn the_cyclists_wheels_are_those_of_the_drawing() {
    let cyclist = Scene::preset("cyclist").expect("a preset");
    for (name, from, to) in SPOKES {
        let body = cyclist.names.iter().position(|its| its == name).expect("there is such a spoke");
        let found = ends(&cyclist.bodies[body]);
        let off = (found[0] - DVec3::from(from)).abs().max((found[1] - DVec3::from(to)).abs());
        assert!(off.max_element() <= 0.5e-3, "{name}: {off}");
    }
    assert_eq!(cyclist.names[..4], ["front tyre", "front rim", "front hub", "front wheel's spoke 1"]);
    assert_eq!([&cyclist.names[17], &cyclist.names[34]], ["rear tyre", "top tube"]);
    let tyre = Shape::Ring {
        centre: [-0.525, 3.0, 2.0],
        axis: [0.0, 1.0, 0.0],
        radius: 0.525 - 0.032,
        tube_radius: 0.032,
    };
    assert_eq!(cyclist.bodies[0], Body::new(tyre, 700.0));
    assert!(cyclist.bodies.iter().all(|body| body.spin.is_none()), "the paper's bicycle slides");
}

#[test]
fn a_tyre_may_have_paint_of_its_own() {
    let scene = scene("material = \"white_paint\"\nbrightness = 0.5\ntyre_paint = \"#000000\"");
    let [tyre, others @ ..] = &scene.bodies[..] else { panic!("it has a tyre") };
    assert_eq!((tyre.emission, tyre.brightness), (Emission::Painted(Paint::Smooth([0.0; 3])), 1.0));
    let white = Material::named("white_paint").expect("it was measured");
    let white = (Emission::Painted(Paint::Measured(white)), 0.5);
    assert!(others.iter().all(|body| (body.emission, body.brightness) == white));
}

#[test]
fn a_wheel_is_tyre_rim_hub_spokes_and_valve() {
    let scene = scene("name = \"left wheel\"\nvalve = true\nwavelength_nm = 600");
    let names = [
        "tyre",
        "rim",
        "hub",
        "wheel's spoke 1",
        "wheel's spoke 2",
        "wheel's spoke 3",
        "wheel's spoke 4",
        "valve",
    ];
    assert_eq!(scene.names, names.map(|name| format!("left {name}")));
    let radii = scene.bodies[..2].iter().map(|body| match body.shape {
        Shape::Ring { radius, tube_radius, .. } => radius + tube_radius,
        _ => panic!("a ring"),
    });
    // The rim lies against the tyre, whose tube is 0.06 thick.
    assert!(radii.zip([0.5, 0.44]).all(|(found, expected)| (found - expected).abs() < 1e-15));
    assert_eq!(
        scene.bodies[2].shape,
        Shape::Tube { from: [1.0, 2.9, 2.0], to: [1.0, 3.1, 2.0], radius: 0.05 }
    );
    let [from, to] = ends(&scene.bodies[7]);
    assert!(from.distance(DVec3::new(1.43, 3.0, 2.0)) < 1e-15 && to.x < from.x && to.z == 2.0, "{from} {to}");
    assert!(scene.bodies.iter().all(|body| body.emission == Emission::Wavelength(600.0)));
}

#[test]
fn spokes_are_even_and_cross_in_turn() {
    let scene = scene("flanges = 0.1\ncrossing = 60\nangle = 10");
    let hub = DVec3::new(1.0, 3.0, 2.0);
    let off = |place: DVec3| place - hub;
    for (number, body) in (0..4).zip(&scene.bodies[3..]) {
        let [from, to] = ends(body).map(off);
        let angle = |v: DVec3| v.z.atan2(v.x).to_degrees();
        let side = if number % 2 == 0 { -1.0 } else { 1.0 };
        let ahead = (angle(from) - angle(to) + 540.0).rem_euclid(360.0) - 180.0;
        assert!((ahead - side * 60.0).abs() < 1e-12, "{number}: {ahead}");
        let turned = (angle(to) - 10.0 - 90.0 * f64::from(number) + 540.0).rem_euclid(360.0) - 180.0;
        assert!(turned.abs() < 1e-12, "{number}: {turned}");
        assert!((from.y - side * 0.05).abs() < 1e-15 && to.y == 0.0);
        // The tip is under the surface of the rim, whose middle is at 0.43.
        assert!((to.length() - 0.425).abs() < 1e-15);
    }
}

#[test]
fn a_wheel_rolls_or_turns_about_its_hub_as_it_says() {
    let turning = |rest: &str| {
        let scene = scene(rest);
        let spin = scene.bodies[0].spin;
        assert!(scene.bodies.iter().all(|body| body.spin == spin), "all of it turns alike");
        spin
    };
    let spin = Spin { hub: [1.0, 3.0, 2.0], radius: 0.5, turning: Turning::Rolling };
    assert_eq!(turning(""), None);
    assert_eq!(turning("rolls = false"), None);
    assert_eq!(turning("rolls = true"), Some(spin));
    assert_eq!(turning("rim_speed = -0.5"), Some(Spin { turning: Turning::RimSpeed(-0.5), ..spin }));
    let rolling = scene("rolls = true\nvalve = true\ncrossing = 40\nflanges = 0.1");
    for (body, name) in rolling.bodies.iter().zip(&rolling.names) {
        let is_round = ["tyre", "rim", "hub"].contains(&&name[..]);
        assert_eq!(body.shape.is_round_about(&spin), is_round, "{name}");
    }
}

#[test]
fn a_tread_closes_around_the_tyre() {
    for spacing in [0.03, 0.1, 0.37, 5.0] {
        let Pattern::Stripes { step } = scene(&format!("tread = {spacing}")).bodies[0].pattern else {
            panic!("stripes")
        };
        let pairs = TAU * 0.47 / (2.0 * step);
        assert!((pairs - pairs.round()).abs() < 1e-12 && pairs > 0.5, "{pairs}");
        assert!(spacing > 1.0 || (pairs - TAU * 0.47 / (2.0 * spacing)).abs() <= 0.5, "{pairs}");
    }
    assert!(scene("").bodies.iter().all(|body| body.pattern == Pattern::Plain));
}

#[test]
fn an_include_says_how_its_wheels_turn() {
    let text = "name = \"x\"\n[[group]]\nname = \"a\"\n[[group.include]]\nscene = \"cyclist\"\noffset = [0, 1, -4]\n\
                [group.include.wheels]\nrolls = true\ntread = 0.1\nvalve = true\n[[group.include]]\nscene = \"cyclist\"";
    let scene = Scene::parse(text, "x").unwrap_or_else(|error| panic!("{error}"));
    let cyclist = Scene::preset("cyclist").expect("a preset");
    let (rolling, sliding) = scene.bodies.split_at(cyclist.bodies.len() + 2);
    assert_eq!(sliding, cyclist.bodies);
    let front = Spin { hub: [-0.525, 4.0, -2.0], radius: 0.525, turning: Turning::Rolling };
    assert_eq!(rolling[0].spin, Some(front));
    assert_eq!(scene.names[17], "front valve");
    assert_eq!(scene.names[35], "rear valve");
    assert_eq!(rolling.iter().filter(|body| body.spin.is_some()).count(), 36);
    let still = text.replace("rolls = true\ntread = 0.1\nvalve = true", "rolls = false");
    let still = Scene::parse(&still, "x").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(still.bodies[..cyclist.bodies.len()], {
        cyclist.bodies.iter().map(|body| body.clone().moved([0.0, 1.0, -4.0])).collect::<Vec<_>>()
    });
    // What includes it has the last word.
    let street = "name = \"x\"\n[[include]]\nscene = \"street\"\n[include.wheels]\nrim_speed = 0.25";
    let street = Scene::parse(street, "x").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(street.bodies[0].spin.map(|spin| spin.turning), Some(Turning::RimSpeed(0.25)));
    assert_eq!(street.names[17], "front valve");
}

#[test]
fn a_point_turns_with_the_body_that_it_is_on() {
    let street = Scene::preset("street").expect("a preset");
    let front = street.bodies[0].spin;
    assert!(front.is_some());
    let name = |place: [f64; 3]| street.body_at(place).map(|body| street.name_of(body));
    // The front of the tyre, the same rounded, and its side; the hub's end, which stays where it is; a helmet
    // does not turn.
    for place in [[0.0, 4.0, -1.975], [0.0004, 4.0004, -1.9754], [-0.032, 3.968, -1.975]] {
        assert_eq!((name(place), street.track(Some(place)).spin), (Some("front tyre"), front));
    }
    assert_eq!((street.tracked_body(), street.track(None).spin), (Some(2), None));
    let bodies = || street.groups[0].bodies();
    let saddle = bodies().find(|&body| street.name_of(body) == "saddle nose").expect("it has one");
    assert_eq!(street.track_on(saddle).map(|track| track.spin), Some(None));
    // Near the tyre is not on it; what lies in a tube is on it.
    assert_eq!((name([0.01, 4.0, -1.975]), name([-0.525, 4.0, -1.96])), (None, Some("front hub")));
}

#[test]
fn what_is_wrong_with_a_wheel_is_said() {
    for (rest, problem) in [
        (
            "rim_speed = 1",
            "11: rim_speed = 1 must be between -1 and 1, the speed of light (above 0 it turns as if rolling to +x)",
        ),
        (
            "rolls = true\nrim_speed = 0.5",
            "12: rim_speed = 0.5 must be left out where rolls = true, which sets it",
        ),
        ("rolls = 1", "11: rolls = 1 must be true or false"),
        ("valve = \"yes\"", "11: valve = \"yes\" must be true or false"),
        ("tread = 0", "11: tread = 0 must be above 0"),
        (
            "flange_radius = 0.43",
            "11: flange_radius = 0.43 must be so small that there is room for spokes out to the rim",
        ),
        ("rim_radius = 0.495", "11: rim_radius = 0.495 must be so small that the rim lies inside `radius`"),
        ("crossing = nan", "11: crossing = nan must lie between -1e6 and 1e6"),
        (
            "light = \"white\"\nwavelength_nm = 5",
            "11: light = \"white\" must be left out where there is `wavelength_nm`: an object has one light",
        ),
        (
            "spoke = 3",
            "11: unknown key `spoke` (did you mean `spokes`?): a wheel has name, hub, radius, tyre, rim, rim_radius, axle, hub_radius, flange_radius, \
             flanges, spokes, spoke_radius, crossing, angle, rolls, rim_speed, tread, valve, tyre_paint, wavelength_nm, light, \
             material, paint, glow_k, brightness",
        ),
    ] {
        assert_eq!(error(&format!("{}\n", wheel(rest))), format!("balls.toml:{problem}"));
    }
    for (old, new, problem) in [
        (
            "tyre = 0.03",
            "tyre = 0.2",
            "5: tyre = 0.2 must be below a quarter of `radius`: it is the radius of the tyre's tube",
        ),
        (
            "rim = 0.01",
            "rim = 0.3",
            "6: rim = 0.3 must be smaller: it is the radius of the rim's tube, which lies inside the tyre",
        ),
        (
            "hub_radius = 0.05",
            "hub_radius = 0.6",
            "8: hub_radius = 0.6 must be so small that there is room for spokes out to the rim",
        ),
        ("spokes = 4", "spokes = 0", "9: spokes = 0 must be a whole number between 1 and 1000"),
        ("spokes = 4\n", "", "2: a wheel needs `spokes`"),
        ("hub = [1, 3, 2]\n", "", "2: a wheel needs `hub`"),
    ] {
        assert_eq!(error(&wheel("").replace(old, new)), format!("balls.toml:{problem}"));
    }
    let include = |rest: &str| format!("name = \"x\"\n[[include]]\nscene = \"cyclist\"\n{rest}");
    assert_eq!(
        error(&include("[include.wheels]\nspokes = 3")),
        "balls.toml:5: unknown key `spokes`: `wheels` of an include has rolls, rim_speed, tread, valve"
    );
    assert_eq!(
        error(&include("wheels = 3")),
        "balls.toml:4: wheels = 3 must be a table: keys and values, headed by its name in brackets"
    );
}

#[test]
fn a_mangled_wheel_is_a_scene_or_one_line() {
    let text =
        wheel("flanges = 0.1\ncrossing = 60\nrim_radius = 0.42\nrim_speed = 0.5\ntread = 0.1\nvalve = true");
    for at in 0..text.len() {
        for replacement in ["", "[", "=", ".", "-", "9", "\n"] {
            let mangled = format!("{}{replacement}{}", &text[..at], &text[at + 1..]);
            match Scene::parse(&mangled, "balls.toml") {
                Ok(scene) => assert!(scene.tracked.iter().all(|x| x.is_finite()), "{mangled}"),
                Err(error) => {
                    let line = error.to_string();
                    assert!(line.starts_with("balls.toml:") && !line.contains('\n'), "{line}");
                }
            }
        }
    }
}
