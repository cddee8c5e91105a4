//! The light of the paper's cyclist in pictures: nothing clipped, exponents that can be told apart, and an
//! exposure that stays the same while time runs.

use gamow::flags::{Exposure, IntensityExponent};
use gamow::scene::Scene;
use gamow::settings::{Settings, Subject};
use relativity_render::{Colour, PreparedScene, View};

const SIZE: [u32; 2] = [160, 120];
/// From far before it is abreast to well after, at 0.9 c.
const TIMES: [f64; 6] = [0.5, 1.1, 1.6, 2.0, 2.5, 3.6];
/// The cyclist's light at rest, nm.
const REST_NM: f64 = 700.0;

/// The cyclist with the intensity D^`exponent`.
fn settings(exponent: f64) -> Settings {
    let mut settings = Settings { scene: "cyclist".to_owned(), ..Settings::default() };
    settings.light.intensity_exponent = IntensityExponent(Some(exponent));
    settings
}

/// What the left eye receives at `time`, nm, and the largest component of its picture there, level by level,
/// where a body in colour fills the pixel.
fn coloured_levels(
    settings: &Settings,
    prepared: &PreparedScene,
    scene: &Scene,
    view: &View,
) -> Vec<(f64, u8)> {
    let picture = prepared.picture(view, &settings.appearance(scene, 0.0, false), 1);
    let hits = prepared.hit_image(view).hits;
    let level = |(hit, [red, green, blue, _]): (&Option<_>, &[u8; 4])| {
        let hit: &relativity_render::Hit = hit.as_ref()?;
        Some((REST_NM / hit.doppler_factor, *red.max(green).max(blue)))
    };
    let levels = hits.iter().zip(&picture.rgba).filter_map(level);
    levels.filter(|(nm, _)| (400.0..745.0).contains(nm)).collect()
}

/// All of them at [`TIMES`].
fn all_levels(exponent: f64) -> Vec<(f64, u8)> {
    let settings = settings(exponent);
    let scene = Scene::preset("cyclist").expect("a preset");
    let prepared = scene.prepared();
    let levels = |time| {
        let subject = Subject { scene: &prepared, tracked: scene.track(None) };
        let [mut view, _] = settings.views(subject, time, SIZE);
        view.camera.horizontal_fov = 1.0;
        coloured_levels(&settings, &prepared, &scene, &view)
    };
    TIMES.into_iter().flat_map(levels).collect()
}

/// The mean level of what is received between these wavelengths, nm.
fn mean(levels: &[(f64, u8)], [shortest, longest]: [f64; 2]) -> f64 {
    let within = || levels.iter().filter(|(nm, _)| (shortest..longest).contains(nm));
    within().map(|(_, level)| f64::from(*level)).sum::<f64>() / within().count() as f64
}

#[test]
fn hardly_a_pixel_is_clipped_and_the_exponents_can_be_told_apart() {
    let of_exponents = [2.0, 3.0, 4.0].map(all_levels);
    for (exponent, levels) in (2..).zip(&of_exponents) {
        let clipped = levels.iter().filter(|(_, level)| *level == 255).count();
        assert!(levels.len() > 1000, "{} pixels in colour", levels.len());
        assert!(clipped * 50 < levels.len(), "D^{exponent}: {clipped} of {} are clipped", levels.len());
    }
    // Beside the blue, which is bright in all of them, red is the dimmer the larger the exponent is.
    let reds = of_exponents.each_ref().map(|levels| mean(levels, [640.0, 720.0]));
    let blues = of_exponents.each_ref().map(|levels| mean(levels, [420.0, 480.0]));
    let contrasts = [0, 1, 2].map(|i| blues[i] - reds[i]);
    assert!(contrasts[1] > contrasts[0] + 15.0 && contrasts[2] > contrasts[1] + 15.0, "{reds:?}, {blues:?}");
    assert!(reds[0] > reds[1] + 10.0 && reds[1] > reds[2] + 10.0, "{reds:?}");
}

#[test]
fn exposure_is_found_once_for_a_scene_and_recorded_as_a_number() {
    let scene = Scene::preset("cyclist").expect("a preset");
    let found = |settings: Settings| settings.exposed_for(&scene).light.exposure.0.expect("it is a number");
    let early = found(Settings { time: Some(-3.0), ..settings(4.0) });
    assert_eq!(early.to_bits(), found(Settings { time: Some(5.0), ..settings(4.0) }).to_bits());
    assert!((-2.0..-1.0).contains(&early), "{early}");
    let set = Settings {
        light: gamow::settings::LightSettings { exposure: Exposure(Some(0.5)), ..settings(4.0).light },
        ..settings(4.0)
    };
    assert_eq!(found(set), 0.5);
}

/// Beside a street in sunlight a cyclist goes dark, and the street stays as it is; a rider's street does not.
#[test]
fn in_sunlight_the_exposure_is_for_what_stands_there() {
    let scene = Scene::preset("town-cyclist").expect("a preset");
    let of_flags = |flags: &str| {
        let settings =
            Settings::default().with_command(&format!("gamow {flags}"), "a test").expect("settings");
        settings.automatic_ev(&scene, 0.0)
    };
    for beta in [0.0, 0.3, 0.9, 0.99] {
        assert_eq!(of_flags(&format!("--scene town-cyclist --beta {beta}")), 0.0, "{beta}");
    }
    let riding =
        of_flags("--scene town-cyclist --beta 0 --ride coast --ride-speed 0.9 --street-colours received");
    assert!(riding > 1.0, "{riding}");
}

#[test]
fn at_rest_nothing_needs_an_exposure() {
    let scene = Scene::preset("cyclist").expect("a preset");
    for colour in [Colour::OneWavelength, Colour::Glowing, Colour::White, Colour::False] {
        let mut settings = settings(4.0);
        settings.motion.speed =
            gamow::flags::SpeedSetting::new(gamow::flags::SpeedParameter::Beta, 0.0).expect("a speed");
        settings.light.colour = colour;
        assert_eq!(settings.automatic_ev(&scene, 0.0).abs(), 0.0, "{colour:?}");
    }
}
