//! Scene files, right and wrong.

mod names;
mod wheels;

use relativity_render::{Body, Emission, Material, Motion, Paint, Pattern, Shape, Velocity};

use super::{PRESETS, Scene, SceneError};

/// Numbers between 0 and 1, always the same: the generator of Knuth's MMIX.
pub(super) fn random() -> impl FnMut() -> f64 {
    let mut state = 1_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1 << 31)
    }
}

const EXAMPLE: &str = r#"
name = "Two balls"

[[object]]
shape = "sphere"
centre = [0.0, 3.0, 2.0]
radius = 0.5
wavelength_nm = 550

[[object]]
shape = "tube"
from = [-1, 3, 0.5]
to = [1, 3, 0.5]
radius = 0.1

[[object]]
shape = "ring"
centre = [0, 4, 0]
axis = [0, 3, 4]
radius = 0.5
tube_radius = 0.125
"#;

fn error(text: &str) -> String {
    Scene::parse(text, "balls.toml").expect_err("the file is wrong").to_string()
}

/// The error of a file whose only object, from line 2 on, is `object`.
fn object_error(object: &str) -> String {
    error(&format!("name = \"x\"\n[[object]]\n{object}\n"))
}

#[test]
fn objects_keep_their_order_and_what_the_file_says() {
    let scene = Scene::parse(EXAMPLE, "balls.toml").expect("the example is right");
    assert_eq!(scene.name, "Two balls");
    assert_eq!(scene.ground_z, None);
    let sphere = Shape::Sphere { centre: [0.0, 3.0, 2.0], radius: 0.5 };
    let tube = Shape::Tube { from: [-1.0, 3.0, 0.5], to: [1.0, 3.0, 0.5], radius: 0.1 };
    let ring =
        Shape::Ring { centre: [0.0, 4.0, 0.0], axis: [0.0, 0.6, 0.8], radius: 0.5, tube_radius: 0.125 };
    let expected = [(sphere, 550.0), (tube, 700.0), (ring, 700.0)];
    let expected = expected.map(|(shape, rest_wavelength_nm)| Body::new(shape, rest_wavelength_nm));
    assert_eq!(scene.bodies, expected);
}

#[test]
fn the_forward_most_point_is_tracked_unless_the_file_names_another() {
    let forward_most = Scene::parse(EXAMPLE, "x").expect("right").tracked;
    assert_eq!(forward_most, [1.1, 3.0, 0.5]);
    let chosen = format!("tracked = [1, 2, 3]\n{EXAMPLE}");
    assert_eq!(Scene::parse(&chosen, "x").expect("right").tracked, [1.0, 2.0, 3.0]);
}

#[test]
fn a_tilted_ring_is_forward_most_where_its_tube_faces_forward() {
    let ring = "centre = [0, 0, 0]\naxis = [3, 4, 0]\nradius = 1\ntube_radius = 0.25";
    let scene =
        Scene::parse(&format!("name = \"x\"\n[[object]]\nshape = \"ring\"\n{ring}"), "x").expect("right");
    let expected = glam::DVec3::new(0.8 + 0.25, -0.6, 0.0);
    assert!(expected.distance(scene.tracked.into()) < 1e-15, "{:?}", scene.tracked);
}

#[test]
fn a_ring_that_faces_forward_is_tracked_on_its_tube() {
    let ring = "centre = [0, 0, 0]\naxis = [1, 0, 0]\nradius = 1\ntube_radius = 0.25";
    let scene =
        Scene::parse(&format!("name = \"x\"\n[[object]]\nshape = \"ring\"\n{ring}"), "x").expect("right");
    let [x, y, z] = scene.tracked;
    assert_eq!((x, y.hypot(z)), (0.25, 1.0));
}

#[test]
fn an_include_moves_a_preset_and_comes_before_the_objects() {
    let text = "name = \"x\"\n[[object]]\nshape = \"sphere\"\ncentre = [9, 0, 0]\nradius = 1\n\
                [[include]]\nscene = \"cyclist\"\noffset = [1, 2, -3]\n[[include]]\nscene = \"two-balls\"";
    let scene = Scene::parse(text, "x").expect("right");
    let cyclist = Scene::preset("cyclist").expect("a preset");
    let balls = Scene::preset("two-balls").expect("a preset");
    let [Shape::Ring { centre: there, .. }, Shape::Ring { centre: here, .. }] =
        [&scene, &cyclist].map(|scene| scene.bodies[0].shape)
    else {
        panic!("the tyre comes first")
    };
    assert_eq!(there, [here[0] + 1.0, here[1] + 2.0, here[2] - 3.0]);
    let (cyclist_count, balls_count) = (cyclist.bodies.len(), balls.bodies.len());
    assert_eq!(scene.bodies[cyclist_count..cyclist_count + balls_count], balls.bodies);
    assert_eq!(scene.bodies.len(), cyclist_count + balls_count + 1);
}

#[test]
fn bodies_are_called_what_their_file_says_else_by_shape_and_number() {
    let ball = "shape = \"sphere\"\ncentre = [0, 3, 2]\nradius = 1\n";
    let text = format!(
        "name = \"x\"\n[[include]]\nscene = \"cyclist\"\n[[object]]\n{ball}\
         [[group]]\nname = \"moon\"\n[[group.object]]\n{ball}name = \"full moon\""
    );
    let scene = Scene::parse(&text, "x").expect("right");
    let ball = Scene::preset("cyclist").expect("a preset").bodies.len();
    assert_eq!(scene.name_of(0), "front tyre");
    assert_eq!(scene.name_of(ball), format!("sphere {ball}"));
    assert_eq!(scene.name_of(ball + 1), "full moon");
    assert_eq!(scene.tracked_body(), Some(ball), "the forward-most point is the ball's");
    let named = text.replace("full moon", "new moon");
    assert_eq!(Scene::parse(&named, "x").expect("right").fingerprint(), scene.fingerprint());
    assert_eq!(Scene::preset("cyclist").expect("a preset").tracked_body(), Some(0));
}

#[test]
fn an_object_is_repeated_a_step_further_each_time() {
    let post = "shape = \"tube\"\nfrom = [0, 3, 0]\nto = [0, 3, 2]\nradius = 0.1";
    let text = format!("name = \"x\"\n[[object]]\n{post}\nname = \"post\"\nrepeat = 3\nstep = [8, 0, -1]");
    let scene = Scene::parse(&text, "x").expect("right");
    assert_eq!(scene.names, ["post 1", "post 2", "post 3"]);
    let last = Shape::Tube { from: [16.0, 3.0, -2.0], to: [16.0, 3.0, 0.0], radius: 0.1 };
    assert_eq!(scene.bodies[2].shape, last);
    for count in ["0", "1001", "2.0", "-3"] {
        assert_eq!(
            object_error(&format!("{post}\nrepeat = {count}")),
            format!("balls.toml:7: repeat = {count} must be a whole number between 1 and 1000")
        );
    }
}

#[test]
fn a_street_has_kerbs_and_fronts_one_behind_the_other() {
    let street = |parts: &str| format!("street = {parts}\n{EXAMPLE}");
    assert_eq!(Scene::parse(&street("[2, 9, 13]"), "x").expect("right").street, Some([2.0, 9.0, 13.0]));
    assert_eq!(
        error(&street("[2, 2, 13]")),
        "balls.toml:1: street = [2, 2, 13] must be the y of the near kerb, then of the far one, then of the house fronts"
    );
}

#[test]
fn without_surroundings_only_what_moves_is_left() {
    let ball = "[[group.object]]\nshape = \"sphere\"\ncentre = [0, 3, 2]\nradius = 1\n";
    let group = |name: &str, beta: &str| format!("[[group]]\nname = \"{name}\"\nbeta = {beta}\n{ball}");
    let [street, oncoming] = [group("street", "0"), group("oncoming", "-0.6")];
    let all = Scene::parse(&format!("{EXAMPLE}{street}{oncoming}"), "x").expect("right");
    let moving = Scene::parse(&format!("{EXAMPLE}{oncoming}"), "x").expect("right");
    assert_eq!(all.without_surroundings().fingerprint(), moving.fingerprint());
    assert_eq!(moving.clone().without_surroundings(), moving);
}

#[test]
fn groups_have_motions_of_their_own() {
    let ball = "[[group.object]]\nshape = \"sphere\"\ncentre = [0, 3, 2]\nradius = 1\n";
    let text = format!(
        "{EXAMPLE}[[group]]\nname = \"street\"\nbeta = 0\n{ball}{ball}[[group]]\nname = \"oncoming\"\nbeta = -0.6\n{ball}"
    );
    let scene = Scene::parse(&text, "x").expect("right");
    let found: Vec<_> =
        scene.groups.iter().map(|group| (&group.name[..], group.motion, group.bodies())).collect();
    let oncoming = Velocity::from_beta(-0.6).expect("a speed");
    let expected = [
        ("Two balls", Motion::Scene, 0..3),
        ("street", Motion::Own(Velocity::REST), 3..5),
        ("oncoming", Motion::Own(oncoming), 5..6),
    ];
    assert_eq!(found, expected);
    assert_eq!(scene.prepared().motion_of(5), Motion::Own(oncoming));
}

#[test]
fn a_scene_may_be_all_groups() {
    let group = "[[group]]\nname = \"b\"\n[[group.include]]\nscene = \"two-balls\"\n";
    let scene = Scene::parse(&format!("name = \"x\"\n[[group]]\nname = \"a\"\n{group}"), "x").expect("right");
    assert_eq!(scene.groups.len(), 1);
    assert_eq!((&scene.groups[0].name[..], scene.groups[0].bodies()), ("b", 0..scene.bodies.len()));
}

#[test]
fn a_group_moves_slower_than_light() {
    for beta in ["1", "-1.0", "2"] {
        assert_eq!(
            error(&format!("name = \"x\"\n[[group]]\nname = \"a\"\nbeta = {beta}\n")),
            format!(
                "balls.toml:4: beta = {beta} must lie between -1 and 1 (0 rests on the ground, below 0 moves towards -x)"
            )
        );
    }
    assert_eq!(error("name = \"x\"\n[[group]]\nbeta = 0\n"), "balls.toml:2: a group needs `name`");
}

#[test]
fn presets_are_found_by_name_only() {
    assert_eq!(Scene::default(), Scene::preset(PRESETS[0]).expect("a preset"));
    assert!(PRESETS.iter().all(|name| Scene::open(name).is_ok()));
    assert_eq!(Scene::preset("cyclist.toml"), None);
    assert_eq!(
        Scene::open("cycle").expect_err("no such scene").to_string(),
        "no scene is called `cycle`: there are street, cyclist, cube, globe, train, wheel, rods, twins, lattice, two-balls, post-office, tunnel, tram, mr-tompkins, town, town-cyclist; \
         for a file, give a name ending in .toml"
    );
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let error = Scene::open("no/such.toml").expect_err("there is no such file");
    assert!(matches!(error, SceneError::Read { .. }));
    assert!(error.to_string().starts_with("no/such.toml: cannot read this scene file: "), "{error}");
}

#[test]
fn a_syntax_error_names_line_and_column() {
    let error = error("name = \"x\"\nground_z = = 1\n");
    assert!(error.starts_with("balls.toml:2: column 12: ") && !error.contains('\n'), "{error}");
}

#[test]
fn an_unknown_key_is_told_the_keys_there_are() {
    assert_eq!(
        error("name = \"x\"\n\ngroud_z = 1\n"),
        "balls.toml:3: unknown key `groud_z` (did you mean `ground_z`?): a scene has name, rider, metres, tracked, ground_z, street, sunlit, include, wheel, model, object, group"
    );
    assert_eq!(
        object_error("shape = \"sphere\"\ncentre = [0, 3, 2]\nradus = 1"),
        "balls.toml:5: unknown key `radus` (did you mean `radius`?): a sphere has shape, centre, radius, wavelength_nm, light, material, paint, glow_k, brightness, name, pattern, spacing, repeat, step"
    );
    assert_eq!(
        object_error("shape = \"tube\"\ncentre = [0, 3, 2]"),
        "balls.toml:4: unknown key `centre`: a tube has shape, from, to, radius, wavelength_nm, light, material, paint, glow_k, brightness, name, pattern, spacing, repeat, step"
    );
    assert_eq!(
        error("name = \"x\"\n[[include]]\nscene = \"cyclist\"\nmove = [0, 0, 1]"),
        "balls.toml:4: unknown key `move`: an include has scene, offset, wheels"
    );
}

#[test]
fn a_missing_key_is_reported_at_its_table() {
    assert_eq!(error("\n\nground_z = 1\n"), "balls.toml:1: a scene needs `name`");
    assert_eq!(object_error("radius = 1"), "balls.toml:2: an object needs `shape`");
    assert_eq!(object_error("shape = \"sphere\"\nradius = 1"), "balls.toml:2: a sphere needs `centre`");
    assert_eq!(
        object_error("shape = \"ring\"\ncentre = [0, 0, 0]\naxis = [0, 1, 0]\nradius = 1"),
        "balls.toml:2: a ring needs `tube_radius`"
    );
}

#[test]
fn a_value_of_the_wrong_type_is_quoted() {
    assert_eq!(error("name = 3\n"), "balls.toml:1: name = 3 must be a text in double quotes");
    assert_eq!(
        object_error("shape = \"sphere\"\ncentre = [0, 3]\nradius = 1"),
        "balls.toml:4: centre = [0, 3] must be three numbers [x, y, z]"
    );
    assert_eq!(
        object_error("shape = \"sphere\"\ncentre = [0,\n  \"3\", 2]\nradius = 1"),
        "balls.toml:5: centre = \"3\" must be three numbers [x, y, z]"
    );
    assert_eq!(
        object_error("shape = \"sphere\"\ncentre = [0, 3, 2]\nradius = true"),
        "balls.toml:5: radius = true must be a number"
    );
    assert_eq!(
        error("name = \"x\"\n[object]\nshape = \"sphere\"\n"),
        "balls.toml:2: object = [object] must be tables, each headed by its name in double brackets"
    );
}

#[test]
fn a_coordinate_must_be_finite_and_within_reach() {
    for coordinate in ["nan", "inf", "-inf", "1e7", "-1_000_001", "0xfffffffff", "9e999"] {
        assert_eq!(
            object_error(&format!("shape = \"sphere\"\ncentre = [0, {coordinate}, 2]\nradius = 1")),
            format!("balls.toml:4: centre = {coordinate} must lie between -1e6 and 1e6")
        );
    }
    assert_eq!(
        error("name = \"x\"\nground_z = nan"),
        "balls.toml:2: ground_z = nan must lie between -1e6 and 1e6"
    );
}

#[test]
fn a_scene_may_say_how_long_its_unit_is() {
    let ball = "[[object]]\nshape = \"sphere\"\ncentre = [0, 3, 2]\nradius = 1";
    let metres = |line: &str| Scene::parse(&format!("name = \"x\"\n{line}\n{ball}"), "balls.toml");
    assert_eq!(metres("metres = 0.65").map(|scene| scene.metres).ok(), Some(Some(0.65)));
    assert_eq!(metres("").map(|scene| scene.metres).ok(), Some(None));
    for (line, problem) in [
        ("metres = 0", "must be above 0"),
        ("metres = -1", "must be above 0"),
        ("metres = nan", "must lie between 1e-6 and 1e6"),
        ("metres = inf", "must lie between 1e-6 and 1e6"),
        ("metres = 1e7", "must lie between 1e-6 and 1e6"),
        ("metres = \"0.65\"", "must be a number"),
    ] {
        assert_eq!(error(&format!("name = \"x\"\n{line}")), format!("balls.toml:2: {line} {problem}"));
    }
}

#[test]
fn an_object_may_carry_a_pattern_with_a_spacing() {
    let pattern = |shape: &str, pattern: &str| {
        let text = format!("name = \"x\"\n[[object]]\ncentre = [0, 3, 2]\n{shape}\n{pattern}");
        Scene::parse(&text, "x").unwrap_or_else(|error| panic!("{error}")).bodies[0].pattern
    };
    let (ball, cuboid) = ("shape = \"sphere\"\nradius = 1", "shape = \"box\"\nsize = [1, 1, 1]");
    assert_eq!(pattern(ball, ""), Pattern::Plain);
    assert_eq!(pattern(ball, "pattern = \"graticule\""), Pattern::Graticule { step_degrees: 15.0 });
    assert_eq!(
        pattern(ball, "pattern = \"graticule\"\nspacing = 22.5"),
        Pattern::Graticule { step_degrees: 22.5 }
    );
    assert_eq!(pattern(ball, "pattern = \"chequer\""), Pattern::Chequer { step: 0.25 });
    assert_eq!(pattern(cuboid, "pattern = \"stripes\"\nspacing = 0.1"), Pattern::Stripes { step: 0.1 });
    assert_eq!(pattern(cuboid, "pattern = \"faces\""), Pattern::Faces);
}

#[test]
fn a_pattern_must_fit_its_shape_and_close_around_it() {
    let ball =
        |rest: &str| object_error(&format!("shape = \"sphere\"\ncentre = [0, 3, 2]\nradius = 1\n{rest}"));
    let cuboid =
        |rest: &str| object_error(&format!("shape = \"box\"\ncentre = [0, 3, 2]\nsize = [1, 1, 1]\n{rest}"));
    assert_eq!(
        ball("pattern = \"faces\""),
        "balls.toml:6: pattern = \"faces\" must be on a box: only that has faces"
    );
    assert_eq!(
        ball("pattern = \"dots\""),
        "balls.toml:6: pattern = \"dots\" must be \"faces\", \"graticule\", \"chequer\" or \"stripes\""
    );
    assert_eq!(
        ball("pattern = \"graticule\"\nspacing = 7"),
        "balls.toml:7: spacing = 7 must be a divisor of 90: degrees from line to line, such as 10, 15 or 30"
    );
    assert_eq!(ball("spacing = 1"), "balls.toml:6: spacing = 1 must be left out where there is no `pattern`");
    assert_eq!(
        cuboid("pattern = \"faces\"\nspacing = 1"),
        "balls.toml:7: spacing = 1 must be left out where pattern = \"faces\", which has none"
    );
    assert_eq!(
        cuboid("pattern = \"graticule\""),
        "balls.toml:6: pattern = \"graticule\" must be \"faces\", \"chequer\" or \"stripes\" on a box, which is not round"
    );
}

#[test]
fn a_box_has_full_lengths_and_may_be_turned() {
    let half_and_x = |rest: &str| {
        let text = format!("name = \"x\"\n[[object]]\nshape = \"box\"\ncentre = [1, 2, 3]\n{rest}");
        let scene = Scene::parse(&text, "x").unwrap_or_else(|error| panic!("{error}"));
        let Shape::Box { centre, half, turn } = scene.bodies[0].shape else { panic!("a box") };
        assert_eq!(centre, [1.0, 2.0, 3.0]);
        (half, glam::DQuat::from_array(turn) * glam::DVec3::X)
    };
    let size = "size = [2, 4, 6]";
    assert_eq!(half_and_x(size), ([1.0, 2.0, 3.0], glam::DVec3::X));
    // Counter-clockwise as seen from above, or from where the axis points.
    let turned = |rest: &str| half_and_x(&format!("{size}\n{rest}")).1;
    assert!(turned("angle = 90").distance(glam::DVec3::Y) < 1e-15);
    assert!(turned("angle = 90\naxis = [0, 3, 0]").distance(glam::DVec3::NEG_Z) < 1e-15);
}

#[test]
fn what_is_wrong_with_a_box_or_a_cylinder_is_said() {
    let cuboid = |rest: &str| object_error(&format!("shape = \"box\"\ncentre = [0, 3, 2]\n{rest}"));
    assert_eq!(cuboid("angle = 5"), "balls.toml:2: a box needs `size`");
    assert_eq!(cuboid("size = 2"), "balls.toml:5: size = 2 must be three sizes [x, y, z]");
    assert_eq!(cuboid("size = [1, 0, 1]"), "balls.toml:5: size = 0 must be above 0");
    assert_eq!(
        cuboid("size = [1, 1, 1]\naxis = [0, 0, 1]"),
        "balls.toml:6: axis = [0, 0, 1] needs `angle`, by how many degrees the box is turned about it"
    );
    assert_eq!(
        cuboid("size = [1, 1, 1]\naxis = [0, 0, 0]\nangle = 5"),
        "balls.toml:6: axis = [0, 0, 0] must have a direction, such as [0, 1, 0]"
    );
    assert_eq!(
        object_error("shape = \"cylinder\"\nfrom = [0, 3, 2]\nto = [0, 3, 2]\nradius = 1"),
        "balls.toml:5: to = [0, 3, 2] must differ from `from`, the middle of the other end"
    );
}

#[test]
fn flat_faces_are_tracked_in_their_middle_and_corners_where_they_stand_out() {
    let tracked = |object: &str| {
        let text = format!("name = \"x\"\n[[object]]\n{object}");
        Scene::parse(&text, "x").unwrap_or_else(|error| panic!("{error}")).tracked
    };
    let cuboid = "shape = \"box\"\ncentre = [0, 3, 0]\nsize = [2, 2, 2]\n";
    assert_eq!(tracked(cuboid), [1.0, 3.0, 0.0]);
    let [x, y, z] = tracked(&format!("{cuboid}angle = 45"));
    assert!((x - 2f64.sqrt()).abs() < 1e-15 && (y - 3.0).abs() < 1e-15 && z == 0.0, "{x}, {y}, {z}");
    let cylinder = "shape = \"cylinder\"\nradius = 0.5\nfrom = [0, 3, 0]\n";
    assert_eq!(tracked(&format!("{cylinder}to = [2, 3, 0]")), [2.0, 3.0, 0.0]);
    assert_eq!(tracked(&format!("{cylinder}to = [0, 5, 0]")), [0.5, 4.0, 0.0]);
}

#[test]
fn a_size_must_be_positive_and_drawable() {
    let sphere = |size: &str| object_error(&format!("shape = \"sphere\"\ncentre = [0, 3, 2]\n{size}"));
    assert_eq!(sphere("radius = -1"), "balls.toml:5: radius = -1 must be above 0");
    assert_eq!(sphere("radius = 0.0"), "balls.toml:5: radius = 0.0 must be above 0");
    assert_eq!(sphere("radius = 1e-9"), "balls.toml:5: radius = 1e-9 must lie between 1e-6 and 1e6");
    assert_eq!(sphere("radius = nan"), "balls.toml:5: radius = nan must lie between 1e-6 and 1e6");
    assert_eq!(
        sphere("radius = 1\nwavelength_nm = -700"),
        "balls.toml:6: wavelength_nm = -700 must be above 0"
    );
}

#[test]
fn an_object_has_one_light_and_may_be_dim() {
    let ball = |light: &str| {
        let text =
            format!("{EXAMPLE}[[object]]\nshape = \"sphere\"\ncentre = [9, 0, 0]\nradius = 1\n{light}");
        let scene = Scene::parse(&text, "balls.toml").map_err(|error| error.to_string())?;
        let body = scene.bodies.last().expect("the ball");
        Ok::<_, String>((body.emission, body.brightness))
    };
    assert_eq!(ball(""), Ok((Emission::Wavelength(700.0), 1.0)));
    assert_eq!(ball("light = \"white\"\nbrightness = 0.25"), Ok((Emission::WHITE, 0.25)));
    assert_eq!(ball("wavelength_nm = 600\nbrightness = 1"), Ok((Emission::Wavelength(600.0), 1.0)));
    assert_eq!(ball("glow_k = 2700"), Ok((Emission::Glowing(2700.0), 1.0)));
    let bark = Material::named("bark").expect("it was measured");
    assert_eq!(ball("material = \"bark\""), Ok((Emission::Painted(Paint::Measured(bark)), 1.0)));
    // IEC 61966-2-1: 188 of 255 is 0.5029 in linear light.
    let (paint, _) = ball("paint = \"#FF00bc\"").expect("it is a colour");
    let Emission::Painted(Paint::Smooth([red, green, blue])) = paint else { panic!("{paint:?}") };
    assert_eq!([red, green], [1.0, 0.0]);
    assert!((blue - 0.5029).abs() < 5e-5, "{blue}");
    for (light, problem) in [
        ("light = \"red\"", "light = \"red\" must be \"white\", or left out for light of one wavelength"),
        (
            "wavelength_nm = 5\nlight = \"white\"",
            "light = \"white\" must be left out where there is `wavelength_nm`: an object has one light",
        ),
        (
            "material = \"leavs\"",
            "material = \"leavs\" must be a measured one: the nearest are leaves, glass, bark",
        ),
        (
            "paint = \"#b3202a\"\nmaterial = \"leaves\"",
            "paint = \"#b3202a\" must be left out where there is `material`: an object has one light",
        ),
        ("paint = \"red\"", "paint = \"red\" must be a colour in sRGB, such as \"#b3202a\""),
        ("paint = \"#+3202a\"", "paint = \"#+3202a\" must be a colour in sRGB, such as \"#b3202a\""),
        ("paint = \"#b3202ä\"", "paint = \"#b3202ä\" must be a colour in sRGB, such as \"#b3202a\""),
        ("glow_k = 0", "glow_k = 0 must be above 0"),
        ("brightness = 0", "brightness = 0 must be above 0 and at most 1"),
        ("brightness = 1.5", "brightness = 1.5 must be above 0 and at most 1"),
        ("brightness = nan", "brightness = nan must lie between -1e6 and 1e6"),
    ] {
        let error = ball(light).expect_err(problem);
        assert!(error.ends_with(problem), "{error}");
    }
}

#[test]
fn a_ring_must_have_a_hole_and_an_axis() {
    let ring = |rest: &str| object_error(&format!("shape = \"ring\"\ncentre = [0, 3, 2]\n{rest}"));
    assert_eq!(
        ring("axis = [0, 1, 0]\nradius = 0.5\ntube_radius = 0.5"),
        "balls.toml:7: tube_radius = 0.5 must be below radius = 0.5"
    );
    assert_eq!(
        ring("axis = [0, 0.0, 0]\nradius = 0.5\ntube_radius = 0.1"),
        "balls.toml:5: axis = [0, 0.0, 0] must have a direction, such as [0, 1, 0]"
    );
}

#[test]
fn a_tube_must_have_a_length() {
    assert_eq!(
        object_error("shape = \"tube\"\nfrom = [0, 3, 2]\nto = [0, 3, 2]\nradius = 1"),
        "balls.toml:5: to = [0, 3, 2] must differ from `from`: for a ball write shape = \"sphere\""
    );
}

#[test]
fn shapes_and_scenes_are_known_by_name() {
    let refused = object_error("shape = \"cube\"");
    assert!(
        refused.starts_with("balls.toml:3: shape = \"cube\" must be \"sphere\", \"tube\", ")
            && refused.contains(" or \""),
        "{refused}"
    );
    assert_eq!(
        error("name = \"x\"\n[[include]]\nscene = \"cyclists\""),
        "balls.toml:3: scene = \"cyclists\" must be one of street, cyclist, cube, globe, train, wheel, rods, twins, lattice, two-balls, post-office, tunnel, tram, mr-tompkins, town, town-cyclist"
    );
}

#[test]
fn a_scene_is_never_empty() {
    assert_eq!(
        error("name = \"x\"\n"),
        "balls.toml:1: a scene needs at least one [[object]], [[model]], [[include]] or [[group]] with one"
    );
}

#[test]
fn a_centre_may_be_written_center_but_not_both() {
    let ball = |centre: &str| format!("name = \"x\"\n[[object]]\nshape = \"sphere\"\nradius = 1\n{centre}");
    let scene = |centre: &str| Scene::parse(&ball(centre), "x").expect("right");
    assert_eq!(scene("center = [0, 3, 2]"), scene("centre = [0, 3, 2]"));
    let both = "centre = [0, 3, 2]\ncenter = [0, 3, 3]";
    assert!(error(&ball(both)).starts_with("balls.toml:6: unknown key `center`"), "{}", error(&ball(both)));
    assert!(error(&ball("center = 3")).contains("centre = 3 must be"), "{}", error(&ball("center = 3")));
}

#[test]
fn an_axis_of_any_length_becomes_a_unit_vector() {
    for length in [1e-300, 1e-9, 1.0, 1e6] {
        let ring = format!("centre = [0, 0, 0]\naxis = [0, 0, -{length:e}]\nradius = 1\ntube_radius = 0.25");
        let text = format!("name = \"x\"\n[[object]]\nshape = \"ring\"\n{ring}");
        let Shape::Ring { axis, .. } = Scene::parse(&text, "x").expect("right").bodies[0].shape else {
            panic!("a ring")
        };
        assert_eq!(axis, [0.0, 0.0, -1.0]);
    }
}

#[test]
fn a_mangled_file_gives_a_scene_or_one_line() {
    for at in 0..EXAMPLE.len() {
        for replacement in ["", "\"", "[", "]", "=", ".", "-", "9", "\n", "\u{e9}"] {
            let mangled = format!("{}{replacement}{}", &EXAMPLE[..at], &EXAMPLE[at + 1..]);
            let Err(error) = Scene::parse(&mangled, "balls.toml") else { continue };
            let line = error.to_string();
            assert!(line.starts_with("balls.toml:") && !line.contains('\n'), "{line}");
        }
    }
}

#[test]
fn the_examples_in_the_description_of_the_format_load() {
    let description = include_str!("../../assets/scenes/README.md");
    let examples = description.split("```toml\n").skip(1).filter_map(|rest| rest.split_once("```"));
    let whole = examples.map(|(example, _)| example).filter(|example| example.starts_with("name = "));
    let scenes: Vec<Scene> = whole
        .map(|example| Scene::parse(example, "README.md").unwrap_or_else(|error| panic!("{error}")))
        .collect();
    let found: Vec<_> = scenes.iter().map(|scene| (scene.bodies.len(), scene.ground_z)).collect();
    assert_eq!(found, [(5, Some(-2.5)), (18, Some(-2.5))]);
}

#[test]
fn wheels_are_changed_only_where_there_are_any() {
    const WITH_WHEELS: [&str; 6] = ["street", "cyclist", "wheel", "tram", "mr-tompkins", "town-cyclist"];
    let text = |scene: &str| {
        format!("name = \"x\"\n[[include]]\nscene = \"{scene}\"\n[include.wheels]\nrolls = true")
    };
    for preset in PRESETS {
        let read = Scene::parse(&text(preset), "x.toml");
        match read {
            Ok(_) => assert!(WITH_WHEELS.contains(&preset), "{preset}"),
            Err(error) => assert_eq!(
                error.to_string(),
                format!(
                    "x.toml:4: `wheels`: the scene {preset} has none that could be changed; leave this out, or \
                     include cyclist, mr-tompkins, wheel or tram"
                )
            ),
        }
    }
}

#[test]
fn names_bodies_and_groups_have_limits() {
    let long = "n".repeat(1_000_000);
    let ball = "[[object]]\nshape = \"sphere\"\ncentre = [0, 3, 2]\nradius = 1\n";
    let start = |line: u32, key: &str| format!("balls.toml:{line}: {key} = \"nnnnn");
    let end = "… must have at most 100 letters";
    for (text, start) in [
        (format!("name = \"{long}\"\n{ball}"), start(1, "name")),
        (format!("name = \"x\"\nrider = \"{long}\"\n{ball}"), start(2, "rider")),
        (format!("name = \"x\"\n{ball}name = \"{long}\"\nrepeat = 1000\n"), start(6, "name")),
        (format!("name = \"x\"\n{ball}[[group]]\nname = \"{long}\"\n"), start(7, "name")),
    ] {
        let error = error(&text);
        assert!(error.starts_with(&start) && error.ends_with(end) && error.len() < 200, "{error}");
    }
    let groups = format!("name = \"x\"\n{ball}{}", "[[group]]\nname = \"g\"\n".repeat(5000));
    let told = error(&groups);
    assert_eq!(told, "balls.toml:406: a scene has at most 200 groups, and this one has 5000");
    let bodies = format!("name = \"x\"\n{}", format!("{ball}repeat = 1000\n").repeat(1001));
    let told = error(&bodies);
    assert_eq!(told, "balls.toml:5002: a scene has at most 1000000 bodies, and here there are more");
    let wheel = |i: u32| {
        let sizes = "radius = 1\ntyre = 0.1\nrim = 0.1\naxle = 0.3\nhub_radius = 0.1\nspokes = 60\nspoke_radius = 0.02\n";
        format!("[[wheel]]\nname = \"{i}\"\nhub = [{i}, 4, 0]\n{sizes}rolls = true\n")
    };
    let wheels = |count| format!("name = \"x\"\n{}", (0..count).map(wheel).collect::<String>());
    let told = error(&wheels(900));
    assert!(told.ends_with("a scene has at most 50000 bodies that turn, and here there are more"), "{told}");
}

#[test]
fn what_is_nested_without_end_is_refused() {
    for value in ["[".repeat(100_000), "{a=".repeat(100_000), "[[{a=[".repeat(50_000)] {
        let error = error(&format!("name = \"x\"\nstreet = {value}"));
        assert!(error.starts_with("balls.toml:2: ") && error.len() < 300, "{error}");
    }
    let error = error(&format!("{}b = 1", "a.".repeat(100_000)));
    assert!(error.starts_with("balls.toml:1: ") && error.len() < 300, "{error}");
}

#[test]
fn errors_quote_little_of_a_file() {
    let long = "k".repeat(1_000_000);
    for text in [
        format!("{long} = 1\n"),
        format!("name = \"x\"\nname = \"{long}\"\n"),
        format!("name = [{long}]\n"),
        format!("name = \"x\"\nstreet = \"{long}\"\n"),
        format!("name = \"x\"\n\"{long}\" = 1\n\"{long}\" = 2\n"),
        format!("{long} = 0,5\n"),
        format!("name = 0,{}\n", "5".repeat(1_000_000)),
        format!("name = \"x\"\n[[include]]\nscene = \"{}\"\n", "k".repeat(99)),
    ] {
        let error = error(&text);
        assert!(error.len() < 400 && !error.contains('\n'), "{} letters: {error:.300}", error.len());
    }
    let unknown = Scene::open(&long).expect_err("there is none").to_string();
    assert!(unknown.len() < 400, "{unknown:.300}");
}

/// Whoever rides has a bicycle below, which nobody can follow, and all else keeps its number.
#[test]
fn the_own_bicycle_comes_last() {
    let street = Scene::preset("street").expect("a preset");
    let count = street.bodies.len();
    let riding = street.clone().with_own_bicycle();
    assert_eq!(riding.names[..count], street.names);
    assert!(
        riding.bodies.len() > count + 10 && riding.bodies[count..].iter().any(|body| body.spin.is_some())
    );
    assert!((count..riding.bodies.len()).all(|body| riding.track_on(body).is_none()));
    assert_eq!(riding.passing().count(), street.groups.len());
    // No name of the two is the same.
    assert_eq!(riding.body_names().len(), street.body_names().len() + riding.bodies.len() - count);
}
