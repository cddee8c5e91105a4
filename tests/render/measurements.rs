//! EXR files, against the core's light cone.

use std::collections::BTreeMap;
use std::path::Path;

use exr::prelude::{FlatSamples, read_first_flat_layer_from_file};
use gamow::scene::Scene;
use relativity_core::{Aperture, SourcePoint, Speed, sighting};
use relativity_render::{Camera, Gaze};

use super::{HEIGHT, WIDTH, folder, render};

/// The channels of an EXR file.
fn channels(path: &Path) -> BTreeMap<String, Vec<f32>> {
    let image = read_first_flat_layer_from_file(path).expect("it is an EXR file");
    let channels = image.layer_data.channel_data.list.into_iter();
    let values = |samples| match samples {
        FlatSamples::F32(values) => values,
        _ => panic!("a channel is not f32"),
    };
    channels.map(|channel| (channel.name.to_string(), values(channel.sample_data))).collect()
}

#[test]
fn measurements_agree_with_the_light_cone_of_each_point() {
    let folder = folder();
    render(folder.path(), "--time 2 --beta 0.9 --d 0.4 --fov 80 --gaze 120,30 --out hits.exr");
    let channels = channels(&folder.path().join("hits.exr"));
    assert_eq!(channels.len(), 20);
    let speed = Speed::from_beta(0.9).expect("below 1");
    let scene = Scene::preset("cyclist").expect("it is a preset");
    let [azimuth, elevation] = [120f64, 30.0].map(f64::to_radians);
    for (eye, aperture) in ["left", "right"].into_iter().zip(Aperture::pair(0.4)) {
        let channel = |name: &str| &channels[&format!("{eye}.{name}")];
        let camera = Camera {
            aperture,
            gaze: Gaze { azimuth, elevation },
            horizontal_fov: 80f64.to_radians(),
            size: [WIDTH, HEIGHT],
        };
        let mut seen = 0;
        for pixel in 0..channel("id").len() {
            let value = |name: &str| f64::from(channel(name)[pixel]);
            if value("id") < 0.0 {
                assert_eq!([value("distance"), value("intensity"), value("rest_x")], [0.0; 3]);
                assert_eq!(value("group"), -1.0);
                continue;
            }
            seen += 1;
            let rest = [value("rest_x"), value("rest_y"), value("rest_z")];
            let source = SourcePoint::from_rest(rest, &speed);
            let expected = sighting(&speed, source, aperture, 2.0).expect("it is in the domain");
            let near = |name: &str, expected: f64| {
                let found = value(name);
                assert!(
                    (found - expected).abs() <= 2e-6 * expected.abs().max(1.0),
                    "{name}: {found}, {expected}"
                );
            };
            assert_eq!(value("group"), 0.0);
            near("distance", expected.distance);
            near("emission_time", expected.retarded_time);
            near("doppler", expected.doppler_factor);
            near("intensity", expected.intensity(2.0));
            let rest_wavelength_nm = scene.bodies[value("id") as usize].rest_wavelength_nm;
            let wavelength_nm = rest_wavelength_nm / expected.doppler_factor;
            assert!((value("wavelength_nm") / wavelength_nm - 1.0).abs() < 2e-6);
            let [u, v] = camera.pixel(expected.position.into()).expect("it is in front");
            let [column, row] = [pixel % WIDTH as usize, pixel / WIDTH as usize];
            assert!((u - column as f64 - 0.5).abs() < 1e-3 && (v - row as f64 - 0.5).abs() < 1e-3);
        }
        assert!(seen > 50, "only {seen} pixels show a body");
    }
}
