//! Settings survive every file they are in, to the last digit; and an invalid one gives an error of one line.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::f64::consts::FRAC_PI_2;
use std::ops::RangeInclusive;
use std::path::Path;

use clap::ValueEnum as _;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use relativity_core::Leg;
use relativity_render::{Appearance, Gaze, HitImage, Picture as Pixels, PreparedScene};

use super::*;
use crate::files::exr::{self, Measurements};
use crate::files::png;
use crate::files::provenance::Provenance;
use crate::flags::choices::{
    AZIMUTH, Compare, ELEVATION, GazeChoice, Layout, PARALLAX_DISTANCE, ProjectionChoice, Size, Swapped,
    ZeroParallax,
};
use crate::flags::words::Shell;
use crate::flags::{
    BUDGET_MS, ERROR_PX, EXPONENT, EXPOSURE_EV, Exposure, FIELD_OF_VIEW, FieldOfView, Followed,
    FollowedPoint, Goal, HEAD_DEGREES, IntensityExponent, MAX_TIME, PLACE, RideLegs, SCREEN_CM, ScreenWidth,
    Share, SpeedParameter, SpeedSetting, StreetVelocity, TEMPERATURE_K, TimeRange,
};

/// Any number within `range`, of any magnitude.
fn number(range: RangeInclusive<f64>) -> impl Strategy<Value = f64> {
    let (low, high) = range.clone().into_inner();
    let any = (any_number(), range.clone())
        .prop_map(move |(any, inside)| if range.contains(&any) { any } else { inside });
    prop_oneof![8 => any, 1 => Just(low), 1 => Just(high)]
}

fn any_number() -> impl Strategy<Value = f64> {
    any::<f64>()
}

fn motion() -> impl Strategy<Value = MotionSettings> {
    let speed = prop_oneof![
        (0.0..1.0).prop_map(|value| (SpeedParameter::Beta, value)),
        (0.0..30.0).prop_map(|power| (SpeedParameter::Gamma, 10f64.powf(power))),
        (0.0..69.0).prop_map(|value| (SpeedParameter::Rapidity, value)),
    ];
    let length = || number(-MAX_LENGTH..=MAX_LENGTH);
    let angle = || number(HEAD_DEGREES);
    (speed, number(0.0..=MAX_LENGTH), [angle(), angle()], [length(), length()]).prop_map(
        |((parameter, value), d, [roll, turn], [depth_shift, height_shift])| {
            let speed = SpeedSetting::new(parameter, value).expect("in range");
            MotionSettings { speed, d, roll, turn, depth_shift, height_shift }
        },
    )
}

fn riding() -> impl Strategy<Value = Riding> {
    let leg = (0.0..=2.0, -1.0..=1.0)
        .prop_map(|(duration, along)| Leg { duration, acceleration: [along, 0.0, 0.0] });
    let legs = proptest::option::of(proptest::collection::vec(leg, 0..5));
    let ride = legs.prop_map(|legs| {
        legs.map_or_else(RideLegs::default, |legs| RideLegs::from_legs(legs).expect("slow"))
    });
    let speed = (choice_of_speed(), -1.0..=1.0).prop_map(|(parameter, share)| {
        let value = if parameter == SpeedParameter::Gamma { (2.0 + share) * 1.5 } else { 0.999 * share };
        StreetVelocity::new(parameter, value).expect("in range")
    });
    let heading = (number(-360.0..=360.0), number(-90.0..=90.0));
    (ride, speed, number(-MAX_LENGTH..=MAX_LENGTH), heading, number(PUSH)).prop_map(
        |(ride, ride_speed, ride_from, (ride_azimuth, ride_elevation), push)| Riding {
            ride,
            ride_speed,
            ride_from,
            ride_azimuth,
            ride_elevation,
            push,
            ..Riding::default()
        },
    )
}

fn choice_of_speed() -> impl Strategy<Value = SpeedParameter> {
    proptest::sample::select(SpeedParameter::ALL.to_vec())
}

fn look() -> impl Strategy<Value = LookSettings> {
    let fixed = (number(AZIMUTH), number(ELEVATION))
        .prop_map(|(azimuth, elevation)| GazeChoice::Fixed([azimuth, elevation]));
    let followed = proptest::sample::select(vec![GazeChoice::Whole, GazeChoice::Point, GazeChoice::Ahead]);
    let gaze = prop_oneof![followed, fixed];
    let fov = proptest::option::of(number(FIELD_OF_VIEW)).prop_map(FieldOfView);
    let distance = number(PARALLAX_DISTANCE).prop_map(ZeroParallax::Distance);
    let zero_parallax = prop_oneof![Just(ZeroParallax::Point), Just(ZeroParallax::Infinity), distance];
    (gaze, fov, zero_parallax).prop_map(|(gaze, fov, zero_parallax)| LookSettings {
        gaze,
        fov,
        zero_parallax,
        ..LookSettings::default()
    })
}

fn light() -> impl Strategy<Value = LightSettings> {
    let exponent = prop_oneof![Just(None), number(EXPONENT).prop_map(Some)].prop_map(IntensityExponent);
    let exposure = proptest::option::of(number(EXPOSURE_EV)).prop_map(Exposure);
    (number(TEMPERATURE_K), exponent, exposure).prop_map(|(temperature, intensity_exponent, exposure)| {
        LightSettings { temperature, intensity_exponent, exposure, ..LightSettings::default() }
    })
}

fn range() -> impl Strategy<Value = TimeRange> {
    let time = || number(-MAX_TIME..=MAX_TIME);
    let ends = (time(), time()).prop_map(|(a, b)| Some([a.min(b), a.max(b)]));
    prop_oneof![Just(None), ends].prop_map(TimeRange)
}

fn fit() -> impl Strategy<Value = FitSettings> {
    (FIT_SAMPLES, range(), number(NOISE_PERCENT), 0..=MAX_SEED).prop_map(
        |(fit_samples, fit_range, noise_percent, seed)| FitSettings {
            fit_samples,
            fit_range,
            noise_percent,
            seed,
            ..FitSettings::default()
        },
    )
}

fn window() -> impl Strategy<Value = WindowSettings> {
    let share = || proptest::option::of(number(0.0..=1.0)).prop_map(Share);
    (share(), share(), share()).prop_map(|(side_share, strip_share, map_share)| WindowSettings {
        side_share,
        strip_share,
        map_share,
        ..WindowSettings::default()
    })
}

fn screen() -> impl Strategy<Value = ScreenSettings> {
    let width = proptest::option::of(number(SCREEN_CM)).prop_map(ScreenWidth);
    (width, number(VIEWING_CM), number(PICTURE_MM), number(LENS_MM)).prop_map(
        |(screen_width, viewing_distance, picture_distance, lens_to_screen)| ScreenSettings {
            screen_width,
            viewing_distance,
            picture_distance,
            lens_to_screen,
        },
    )
}

fn quality_picture_and_screen() -> impl Strategy<Value = (QualitySettings, PictureSettings, ScreenSettings)> {
    let goal = prop_oneof![number(ERROR_PX).prop_map(Goal::Error), number(BUDGET_MS).prop_map(Goal::Budget)];
    let quality = goal.prop_map(|goal| QualitySettings { goal, ..QualitySettings::default() });
    let size = (1..=16_384u32, 1..=16_384u32).prop_map(|(width, height)| Size([width, height]));
    let pairs: Vec<_> = Layout::value_variants().iter().copied().filter(|layout| layout.has_both()).collect();
    let swapped = proptest::sample::subsequence(pairs.clone(), 0..=pairs.len())
        .prop_map(|layouts| layouts.into_iter().fold(Swapped::default(), Swapped::toggled));
    let picture = (size, swapped, 1..=16u32).prop_map(|(size, swapped, samples)| PictureSettings {
        size,
        swapped,
        samples,
        ..PictureSettings::default()
    });
    (quality, picture, screen())
}

fn playback() -> impl Strategy<Value = PlaybackSettings> {
    (number(RATE), range()).prop_map(|(rate, range)| PlaybackSettings {
        rate,
        range,
        ..PlaybackSettings::default()
    })
}

/// Returns flags that give every setting which takes nothing but words one of these.
fn words_of_all() -> impl Strategy<Value = Vec<String>> {
    let closed = about_all().iter().filter(|about| !about.is_open && !about.words.is_empty());
    let flag = |about: &'static About| {
        let words: Vec<_> =
            about.words.iter().map(|word| format!("--{}={}", about.name, word.name)).collect();
        proptest::sample::select(words)
    };
    closed.map(flag).collect::<Vec<_>>()
}

fn settings() -> impl Strategy<Value = Settings> {
    let followed = ([number(PLACE), number(PLACE), number(PLACE)], any::<usize>())
        .prop_map(|(place, body)| FollowedPoint { place, body });
    let top = (
        ".{0,20}",
        proptest::option::of(number(-MAX_TIME..=MAX_TIME)),
        proptest::option::of([number(PLACE), number(PLACE), number(PLACE)]),
        proptest::option::of(proptest::collection::vec(followed, 1..4).prop_map(Followed)),
    );
    let sections =
        ((motion(), riding()), look(), light(), quality_picture_and_screen(), playback(), fit(), window());
    (top, sections, words_of_all()).prop_map(
        |(
            (scene, time, point, points),
            ((motion, ride), look, light, (quality, picture, screen), playback, fit, window),
            words,
        )| {
            let mut settings = Settings {
                scene,
                time,
                point,
                points,
                motion,
                ride,
                look,
                light,
                quality,
                picture,
                screen,
                playback,
                fit,
                window,
                ..Settings::default()
            };
            settings.set(words).expect("each takes its words");
            settings
        },
    )
}

/// The settings that a file by `gamow render` records.
fn through_file(settings: &Settings, path: &Path) -> Settings {
    let provenance = Provenance {
        title: "Any".to_owned(),
        parameters: settings.command(Shell::RECORDED),
        scene_fingerprint: "0".to_owned(),
        models: "a.glb: 12 triangles".to_owned(),
    };
    let file = std::fs::File::create(path).expect("the folder is there");
    let size = [1, 1];
    if path.extension().is_some_and(|extension| extension == "png") {
        png::write(&Pixels { size, rgba: vec![[0; 4]] }, &provenance.texts(), file).expect("it is written");
    } else {
        let eyes = [(); 2].map(|()| HitImage { size, hits: vec![None] });
        let light =
            exr::ChannelLight { scene: &PreparedScene::moving(&[]), appearance: Appearance::default() };
        Measurements::of_eyes(&eyes, light, &provenance.comments()).write(file).expect("it is written");
    }
    Settings::default().with_file(path).expect("it was recorded")
}

#[test]
fn a_thousand_states_survive_every_file_and_flags() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let mut runner = TestRunner::new(Config { cases: 1000, failure_persistence: None, ..Config::default() });
    let (default, drawn) = (Settings::default().entries(), RefCell::new(BTreeSet::new()));
    let outcome = runner.run(&settings(), |state| {
        let changed = state.entries().into_iter().filter(|entry| !default.contains(entry));
        drawn.borrow_mut().extend(changed.map(|entry| entry.key));
        let text = state.to_toml();
        prop_assert_eq!(
            &Settings::default().with_toml(&text, "state.toml").expect("it is right"),
            &state,
            "{}",
            text
        );
        for line in [state.command(Shell::RECORDED), state.window_command(Shell::RECORDED)] {
            let read = Settings::default().with_command(&line, "").expect("it is right");
            prop_assert_eq!(&read, &state, "{}", line);
        }
        for name in ["picture.png", "measurements.exr"] {
            let read = through_file(&state, &folder.path().join(name));
            // A scene that is nowhere is one beside the file.
            prop_assert!(read.scene.ends_with(&state.scene), "{}", read.scene);
            prop_assert_eq!(&Settings { scene: state.scene.clone(), ..read }, &state);
        }
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
    for (section, name) in entries::names() {
        assert!(drawn.borrow().contains(name), "[{section}] {name} had its default in all of them");
    }
}

#[test]
fn every_setting_is_a_flag_under_the_heading_of_its_section() {
    let points = Some(Followed(vec![FollowedPoint { place: [0.0; 3], body: 0 }]));
    // A comparison is written where there is one.
    let look = LookSettings { compare: Compare::Rest, ..LookSettings::default() };
    let settings = Settings { time: Some(1.0), point: Some([0.0; 3]), points, look, ..Settings::default() };
    let entries = settings.entries();
    let known: Vec<_> =
        entries::names().filter(|(_, name)| !["gamma", "rapidity", "budget"].contains(name)).collect();
    let found: Vec<_> = entries.iter().map(|entry| (entry.section.clone(), entry.key.as_str())).collect();
    assert_eq!(found, known);
}

#[test]
fn a_short_file_leaves_the_rest_as_it_was() {
    let text =
        "scene = \"street\"\ntime = 2\n[motion]\ngamma = 3\n[look]\ngaze = [90, -5.5]\n[light]\nsky = false";
    let set = Settings::default().with_toml(text, "short.toml").expect("it is right");
    let mut expected = Settings { scene: "street".to_owned(), time: Some(2.0), ..Settings::default() };
    expected.motion.speed = SpeedSetting::new(SpeedParameter::Gamma, 3.0).expect("a speed");
    expected.look.gaze = GazeChoice::Fixed([90.0, -5.5]);
    expected.light.sky = false;
    assert_eq!(set, expected);
}

fn complaint(text: &str) -> String {
    Settings::default().with_toml(text, "state.toml").expect_err("it is wrong").to_string()
}

#[test]
fn what_is_wrong_in_a_file_is_said_with_its_line() {
    for (text, expected) in [
        ("[motion]\n\nd = -1", "state.toml:3: d = -1: must be between 0 and 1e6"),
        ("[motion]\nd = [1, 2]", "state.toml:2: d = 1, 2: not a number"),
        ("[motion]\nd = nan", "state.toml:2: d = nan: not a finite number"),
        ("time = -inf", "state.toml:1: time = -inf: not a finite number"),
        ("[motion]\nbeta = 1.0", "state.toml:2: beta = 1 is out of range: it must be at least 0 and below 1"),
        ("[look]\nfov = 180", "state.toml:2: fov = 180: must be between 1e-9 and 179.999 degrees"),
        (
            "[look]\ngeometry = \"sen\"",
            "state.toml:2: geometry = sen (did you mean `seen`?): must be one of seen, contracted, rest, published, one-cone",
        ),
        ("[quality]\nerror = 0", "state.toml:2: error = 0: must be between 1e-6 and 100"),
        ("[quality]\nerror = -0.1", "state.toml:2: error = -0.1: must be between 1e-6 and 100"),
        ("[quality]\nbudget = nan", "state.toml:2: budget = nan: not a finite number"),
        ("[quality]\nbudget = 0", "state.toml:2: budget = 0: must be between 0.01 and 1e6"),
        ("[light]\nsky = 1", "state.toml:2: sky = 1: must be on or off"),
        (
            "[fit]\nseed = -1",
            "state.toml:2: seed = -1: must be a whole number between 0 and 9007199254740992",
        ),
        (
            "[motion]\nbetta = 0.5",
            "state.toml:2: unknown setting `betta` (did you mean `beta`?): motion has beta, gamma, rapidity, d, roll, turn, depth-shift, height-shift",
        ),
        (
            "\nbeta = 0.5",
            "state.toml:2: unknown setting `beta`: before the first section has scene, time, point, points",
        ),
        (
            "[more]\nd = 1",
            "state.toml:1: unknown section [more]: there are motion, ride, look, light, quality, picture, screen, playback, map, plots, fit, window",
        ),
        ("[motion]\nd = 1979-05-27", "state.toml:2: d: must be a number, a word or a list of them"),
    ] {
        assert_eq!(complaint(text), expected);
    }
    assert_eq!(
        complaint("[motion]\nbeta = 0.5\ngamma = 2"),
        "state.toml:2: beta and gamma cannot both be set: choose one"
    );
    assert_eq!(
        complaint("[quality]\nbudget = 16\nrenderer = \"auto\"\nerror = 0.1"),
        "state.toml:2: budget and error cannot both be set: choose one"
    );
    assert!(complaint("time = = 2").starts_with("state.toml:1: "));
}

/// A later file or flag decides which of the two goals is kept.
#[test]
fn one_goal_takes_the_place_of_the_other() {
    let default = Settings::default();
    assert_eq!(default.quality.goal, Goal::Error(0.1));
    let hurried = default.with_toml("[quality]\nbudget = 16", "state.toml").expect("it is right");
    assert_eq!(hurried.quality.goal, Goal::Budget(16.0));
    let exact = hurried.with_command("gamow --error=0.01", "x.png").expect("it is right");
    assert_eq!(exact.quality.goal, Goal::Error(0.01));
}

#[test]
fn other_commands_make_no_settings() {
    let error =
        Settings::default().with_command("gamow rectify --beta=0.5", "x.png").expect_err("it is wrong");
    assert_eq!(error.to_string(), "x.png: it does not record the settings with which it was made");
    let error = Settings::default().with_command("gamow render --what=1", "x.png").expect_err("it is wrong");
    assert_eq!(error.to_string(), "x.png: there is no setting `what`");
}

#[test]
fn a_picture_recorded_before_still_opens() {
    let command = "gamow render --scene=street --gamma=2.5 --d=0.3 --time=2.25 --size=48x36 --fov=71.5 --gaze=100,-3.5 \
                   --geometry=seen --layout=anaglyph --colour=false --doppler-shift=on --intensity-exponent=off \
                   --exposure=-0.5 --shading=emission --ground=on --sky=off --light=off --renderer=reference --samples=2";
    let settings = Settings::default().with_command(command, "old.png").expect("it is right");
    assert_eq!((settings.scene.as_str(), settings.time, settings.motion.d), ("street", Some(2.25), 0.3));
    assert_eq!(settings.light.intensity_exponent, IntensityExponent(None));
    assert_eq!(settings.look.gaze, GazeChoice::Fixed([100.0, -3.5]));
    assert_eq!((settings.light.light, settings.picture.samples), (Daylight::Off, 2));
    // Before there was another, the picture plane followed the gaze.
    assert_eq!(settings.look.projection, ProjectionChoice::Gaze);
    let settings = Settings::of_picture(command, "old.png").expect("it is right");
    assert_eq!(settings.look.projection, ProjectionChoice::Gaze);
    let told = format!("{command} --projection=parallel");
    let settings = Settings::default().with_command(&told, "new.png").expect("it is right");
    assert_eq!(settings.look.projection, ProjectionChoice::Parallel);
}

#[test]
fn a_zero_parallax_is_a_distance_ahead() {
    let parsed = |text: &str| text.parse::<ZeroParallax>();
    assert_eq!(parsed("2.5"), Ok(ZeroParallax::Distance(2.5)));
    for (text, expected) in [
        ("0", "must be between 1e-9 and 1e12; write `point`, `infinity`, or a distance"),
        ("nan", "not a finite number; write `point`, `infinity`, or a distance"),
        ("far", "not a number; write `point`, `infinity`, or a distance"),
    ] {
        assert_eq!(parsed(text), Err(expected.to_owned()));
    }
    // Diverging lines of sight, parallel ones, and eyes in one place.
    for (separation, tangents) in
        [(0.1, [0.0, 0.1]), (0.1, [0.3, 0.3]), (0.0, [0.2, 0.2]), (0.1, [f64::NAN; 2])]
    {
        assert_eq!(ZeroParallax::of_columns(separation, tangents), ZeroParallax::Infinity);
    }
    assert_eq!(ZeroParallax::of_columns(0.1, [0.02, -0.02]), ZeroParallax::Distance(2.5));
    assert!((ZeroParallax::Distance(2.5).shift(0.1) - 0.04).abs() < 1e-15);
}

#[test]
fn a_gaze_straight_up_is_one_that_a_file_takes() {
    for elevation in [FRAC_PI_2, -FRAC_PI_2, 1.5] {
        let gaze = GazeChoice::fixed_at(Gaze { azimuth: 1.0, elevation });
        let GazeChoice::Fixed([azimuth, degrees]) = gaze else { panic!("{gaze:?}") };
        assert_eq!(format!("{azimuth},{degrees}").parse(), Ok(gaze));
        assert!((degrees.to_radians() - elevation).abs() < 2e-5, "{degrees}");
    }
}

/// Half of the world writes color.
#[test]
fn a_color_is_a_colour() {
    let read = |text: &str| Settings::default().with_toml(text, "state.toml");
    let expected = read("[light]\ncolour = \"glowing\"\nstreet-colours = \"painted\"").expect("it is right");
    let american = read("[light]\ncolor = \"glowing\"\nstreet-colors = \"painted\"");
    assert_eq!(american.expect("it is right"), expected);
    let link = Settings::default().with_file(Path::new("gamow:?color=glowing&street-colors=painted"));
    assert_eq!(link.expect("it is right"), expected);
    let both = read("[light]\ncolor = \"glowing\"\ncolour = \"false\"").expect_err("it is twice").to_string();
    assert!(both.starts_with("state.toml") && !both.contains('\n'), "{both}");
}

#[test]
fn a_scene_is_looked_for_beside_the_file_that_names_it() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let [file, scene] = ["state.toml", "ball.toml"].map(|name| folder.path().join(name));
    std::fs::write(&file, "scene = \"ball.toml\"").expect("it is writable");
    let opened = |file| Settings::default().with_file(file).expect("it is right");
    // Where it is nowhere, that is where it is missed.
    let missed = opened(&file).opened_scene().expect_err("it is not there").to_string();
    assert!(missed.starts_with(&format!("{}: cannot read this scene file: ", scene.display())), "{missed}");
    std::fs::write(&scene, "").expect("it is writable");
    assert_eq!(Path::new(&opened(&file).scene), scene);
}

#[test]
fn files_tell_a_scene_by_its_way_from_them_and_no_folder_beyond() {
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let at = |name: &str| folder.path().join(name);
    for name in ["user/pictures/below/further", "user/scenes", "user/secret/scenes"] {
        std::fs::create_dir_all(at(name)).expect("it is writable");
    }
    for (scene, expected) in [
        ("user/pictures/ball.toml", "ball.toml"),
        ("user/pictures/below/further/ball.toml", "below/further/ball.toml"),
        ("user/scenes/ball.toml", "../scenes/ball.toml"),
        ("user/ball.toml", "../ball.toml"),
        ("user/pictures/ball", "./ball"),
        ("user/pictures/-ball.toml", "-ball.toml"),
        // Further away: the name alone.
        ("user/secret/scenes/ball.toml", "ball.toml"),
        ("ball.toml", "ball.toml"),
    ] {
        std::fs::write(at(scene), "").expect("it is writable");
        let given = at(scene).to_str().expect("it is text").to_owned();
        let settings = Settings { scene: given, ..Settings::default() };
        let picture = at("user/pictures/seen.png");
        let told = settings.relative_to(&picture);
        assert_eq!(told.scene, expected, "{scene}");
        assert_eq!(Settings { scene: settings.scene.clone(), ..told.clone() }, settings);
        let mut found = told;
        found.find_scene_beside(&picture).expect("it is a name");
        let found = std::fs::canonicalize(&found.scene).ok();
        let is_far = ["ball.toml", "user/secret/scenes/ball.toml"].contains(&scene);
        assert_eq!(found == std::fs::canonicalize(at(scene)).ok(), !is_far, "{scene}");
    }
    let gone = Settings { scene: at("user/gone/gone.toml").display().to_string(), ..Settings::default() };
    assert_eq!(gone.relative_to(&at("user/pictures/seen.png")).scene, "gone.toml");
    let preset = Settings { scene: "street".to_owned(), ..Settings::default() };
    assert_eq!(preset.relative_to(&at("street/seen.png")), preset);
}

#[test]
fn settings_are_told_from_scenes() {
    assert!(looks_like_settings(&Settings::default().to_toml()));
    assert!(looks_like_settings("[look]\n"));
    assert!(!looks_like_settings(include_str!("../../assets/scenes/cyclist.toml")));
    assert!(!looks_like_settings("name = = 3"));
}

/// Pictures beside the line between the eyes would show what is abreast from the side.
#[test]
fn eyes_one_behind_the_other_have_pictures_that_follow_the_gaze() {
    let projection = |roll: f64, turn: f64| {
        let mut settings = Settings::default();
        (settings.motion.roll, settings.motion.turn) = (roll, turn);
        settings.projection()
    };
    for (roll, turn) in [(0.0, 0.0), (90.0, 0.0), (0.0, 60.0), (0.0, -60.0), (0.0, 180.0), (45.0, 90.0)] {
        assert_eq!(projection(roll, turn), ProjectionChoice::Mercator, "{roll} {turn}");
    }
    for (roll, turn) in [(0.0, 61.0), (0.0, 90.0), (0.0, -90.0), (10.0, 100.0)] {
        assert_eq!(projection(roll, turn), ProjectionChoice::Gaze, "{roll} {turn}");
    }
}

/// Whatever a setting is given by: a state file and a lesson's block, a flag, or the command that a picture
/// records.
#[test]
fn no_setting_takes_what_is_no_number_or_beyond_all_use() {
    let names: Vec<_> = super::entries::names().filter(|(_, name)| *name != "scene").collect();
    assert!(names.len() > 60);
    for (section, name) in names {
        for value in ["nan", "-nan", "inf", "-inf", "1e300", "-1e300"] {
            let head = if section.is_empty() { String::new() } else { format!("[{section}]\n") };
            for several in [value.to_owned(), format!("[{value}, 0]"), format!("[0, 0, {value}]")] {
                let read = Settings::default().with_toml(&format!("{head}{name} = {several}"), "state.toml");
                let error = read.expect_err(&format!("{name} = {several}")).to_string();
                assert!(error.starts_with("state.toml:") && error.lines().count() == 1, "{error}");
            }
            for command in ["gamow", "gamow render"] {
                let line = format!("{command} --{name}={value},0,0@0");
                assert!(Settings::default().with_command(&line, "x.png").is_err(), "{line}");
                let line = format!("{command} --{name}={value}");
                assert!(Settings::default().with_command(&line, "x.png").is_err(), "{line}");
            }
        }
    }
}

#[test]
fn a_value_that_is_long_or_no_text_is_shown_on_one_short_line() {
    let text = format!("theme = \"\\u001b[31m\\n{}\"", "x".repeat(100_000));
    let error =
        Settings::default().with_toml(&format!("[window]\n{text}"), "state.toml").expect_err("it is wrong");
    let shown = error.to_string();
    assert!(
        shown.len() < 200 && !shown.contains(['\n', '\u{1b}']) && shown.contains("light, dark"),
        "{shown}"
    );
}

#[test]
fn what_can_be_told_is_set_and_what_cannot_is_named() {
    let text =
        "time = inf\nwhat = 1\n[motion]\nbeta = 0.5\nd = nan\n[more]\nd = 1\n[look]\ngaze = [400, 1e300]\n";
    let (settings, problems) = Settings::as_far_as_told(text);
    let told = Settings::default().with_toml("[motion]\nbeta = 0.5", "").expect("it is right");
    assert_eq!(settings, told);
    let named = ["gaze = ", "d = nan: ", "unknown section [more]", "time = inf: ", "unknown setting `what`"];
    assert_eq!(problems.len(), named.len(), "{problems:?}");
    for name in named {
        assert!(problems.iter().any(|problem| problem.starts_with(name)), "{name} in {problems:?}");
    }
    let (settings, problems) = Settings::as_far_as_told("beta = 0,8");
    assert_eq!(settings, Settings::default());
    assert_eq!(problems, ["0,8 is not a number: with a decimal point it is beta = 0.8"]);
}
