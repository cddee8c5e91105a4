//! EXR files, against the core's light cone.

use std::collections::BTreeMap;
use std::path::Path;

use exr::prelude::{FlatSamples, read_first_flat_layer_from_file};
use gamow::scene::Scene;
use glam::DVec3;
use relativity_core::{Aperture, Sighting, SourcePoint, Speed, WheelPoint, sighting};
use relativity_render::{Camera, Gaze, Velocity};

use super::{HEIGHT, WIDTH, folder, render, run_gamow};

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

/// What the core says an aperture sees of a point at `rest` in the frame that has this `velocity`: where that
/// points towards -x, by reflection.
fn seen(velocity: Velocity, [x, y, z]: [f64; 3], aperture: Aperture, time: f64) -> Sighting {
    let sign = if velocity.is_backward { -1.0 } else { 1.0 };
    let source = SourcePoint::from_rest([sign * x, y, z], &velocity.speed);
    let reflected = Aperture { x: sign * aperture.x, ..aperture };
    let mut seen = sighting(&velocity.speed, source, reflected, time).expect("it is in the domain");
    seen.position[0] *= sign;
    seen
}

/// How directions become places in a picture.
#[derive(Debug, Clone, Copy)]
enum Pictures {
    /// Across the gaze.
    Gaze,
    /// On a plane along x, with no parallax at this distance.
    Parallel(f64),
}

/// Separation of the eyes here.
const SEPARATION: f64 = 0.4;

impl Pictures {
    fn flags(self) -> String {
        match self {
            Self::Gaze => "--projection gaze".to_owned(),
            Self::Parallel(distance) => format!("--projection parallel --zero-parallax {distance}"),
        }
    }

    /// The pixel of the picture of the left (-1) or right (1) eye at which something along `direction` is.
    fn pixel(self, side: f64, gaze: Gaze, direction: DVec3) -> [f64; 2] {
        let camera = Camera::new(Aperture::default(), gaze, 80f64.to_radians(), [WIDTH, HEIGHT]);
        let Self::Parallel(distance) = self else { return camera.pixel(direction).expect("it is in front") };
        // Where the lines of sight cross the plane one focal length from the eye that is perpendicular to the
        // part of the gaze across x: the gaze there is in the middle.
        let ahead = gaze.axes().forward;
        let across = ahead.y.hypot(ahead.z);
        let [y, z] = [ahead.y / across, ahead.z / across];
        let depth = direction.y * y + direction.z * z;
        let right = direction.x / depth - ahead.x / across + side * 0.5 * SEPARATION / distance;
        let up = (direction.z * y - direction.y * z) / depth;
        let focal_length = 0.5 * f64::from(WIDTH) / 40f64.to_radians().tan();
        [0.5 * f64::from(WIDTH) + focal_length * right, 0.5 * f64::from(HEIGHT) - focal_length * up]
    }
}

/// Holds what each pixel of `hits.exr` in `folder` tells at `time`, with d = 0.4, a field of view of 80
/// degrees and this gaze in these `pictures`, against the light cone of the point that it shows; how many
/// pixels show each group of the `scene`, whose `velocities` are these.
fn assert_on_light_cone(
    folder: &Path,
    scene: &Scene,
    time: f64,
    (pictures, gaze): (Pictures, [f64; 2]),
    velocities: &[Velocity],
) -> Vec<usize> {
    let channels = channels(&folder.join("hits.exr"));
    assert_eq!(channels.len(), 32);
    let [azimuth, elevation] = gaze.map(f64::to_radians);
    let mut pixels = vec![0; velocities.len()];
    let gaze = Gaze { azimuth, elevation };
    for ((eye, side), aperture) in
        [("left", -1.0), ("right", 1.0)].into_iter().zip(Aperture::pair(SEPARATION))
    {
        let channel = |name: &str| &channels[&format!("{eye}.{name}")];
        for pixel in 0..channel("id").len() {
            let value = |name: &str| f64::from(channel(name)[pixel]);
            if value("id") < 0.0 {
                assert_eq!([value("distance"), value("intensity"), value("rest_x")], [0.0; 3]);
                assert_eq!(value("group"), -1.0);
                continue;
            }
            let (body, group) = (value("id") as usize, value("group") as usize);
            assert!(scene.groups[group].bodies().contains(&body), "body {body} in group {group}");
            pixels[group] += 1;
            let rest = [value("rest_x"), value("rest_y"), value("rest_z")];
            let expected = seen(velocities[group], rest, aperture, time);
            let near = |name: &str, expected: f64| {
                let error = (value(name) - expected).abs();
                assert!(error <= 2e-6 * expected.abs().max(1.0), "{name}: {}, {expected}", value(name));
            };
            near("distance", expected.distance);
            near("emission_time", expected.retarded_time);
            near("proper_time", expected.proper_time);
            assert_eq!([value("material_angle"), value("material")], [-10.0, -1.0]);
            assert_eq!(["triangle", "triangle_b", "triangle_c"].map(value), [-1.0, 0.0, 0.0]);
            near("doppler", expected.doppler_factor);
            near("intensity", expected.intensity(4.0));
            let rest_nm = scene.bodies[body].emission.wavelength_nm().expect("none is white");
            let wavelength_nm = rest_nm / expected.doppler_factor;
            assert!((value("wavelength_nm") / wavelength_nm - 1.0).abs() < 2e-6);
            let [u, v] = pictures.pixel(side, gaze, expected.position.into());
            let [column, row] = [pixel % WIDTH as usize, pixel / WIDTH as usize];
            assert!((u - column as f64 - 0.5).abs() < 1e-3 && (v - row as f64 - 0.5).abs() < 1e-3);
        }
    }
    pixels
}

#[test]
fn measurements_agree_with_the_light_cone_of_each_point() {
    let cyclist = Scene::preset("cyclist").expect("a preset");
    for pictures in [Pictures::Gaze, Pictures::Parallel(3.0), Pictures::Parallel(1e9)] {
        let folder = folder();
        let flags = pictures.flags();
        render(
            folder.path(),
            &format!("--time 2 --beta 0.9 --d 0.4 --fov 80 --gaze 120,30 {flags} --out hits.exr"),
        );
        let velocity = Velocity::from_beta(0.9).expect("below 1");
        let look = (pictures, [120.0, 30.0]);
        let pixels = assert_on_light_cone(folder.path(), &cyclist, 2.0, look, &[velocity]);
        assert!(pixels[0] > 100, "only {pixels:?} pixels show a body");
    }
}

/// A ball that passes at the scene's speed, one that rests beside the road, and one that comes the other way.
const GROUPS: &str = include_str!("../groups.toml");

#[test]
fn each_group_of_a_scene_is_measured_by_its_own_speed() {
    let folder = folder();
    std::fs::write(folder.path().join("groups.toml"), GROUPS).expect("the folder is there");
    let flags = "--scene groups.toml --beta 0.9 --d 0.4 --fov 80 --gaze 90,5 --time 3.5 --projection gaze";
    render(folder.path(), &format!("{flags} --out hits.exr"));
    let scene = Scene::parse(GROUPS, "groups.toml").expect("it is right");
    let velocities = [0.9, 0.0, -0.6].map(|beta| Velocity::from_beta(beta).expect("a speed"));
    let pixels = assert_on_light_cone(folder.path(), &scene, 3.5, (Pictures::Gaze, [90.0, 5.0]), &velocities);
    assert!(pixels.iter().all(|&count| count > 20), "{pixels:?} pixels show the groups");

    let channels = channels(&folder.path().join("hits.exr"));
    let [group, doppler, wavelength] =
        ["group", "doppler", "wavelength_nm"].map(|name| &channels[&format!("left.{name}")]);
    let resting = (0..group.len()).filter(|&pixel| group[pixel] == 1.0);
    assert!(resting.clone().count() > 10);
    resting.for_each(|pixel| assert_eq!([doppler[pixel], wavelength[pixel]], [1.0, 550.0]));

    // What reads such files reads these too: the resting ball is where it was.
    let text = run_gamow(folder.path(), "measure hits.exr --object 1");
    let row: Vec<f64> =
        text.lines().last().into_iter().flat_map(|row| row.split(',')).flat_map(str::parse).collect();
    let [left, right] = Aperture::pair(0.4).map(|aperture| 4.0f64.atan2(1.0 - aperture.x));
    let pixel = 80f64.to_radians() / f64::from(WIDTH);
    assert!((row[2] - left).abs() < 0.5 * pixel && (row[3] - right).abs() < 0.5 * pixel, "{text}");
    run_gamow(folder.path(), "rectify hits.exr --beta 0.6 --backward --out corrected.exr");
    assert_eq!(self::channels(&folder.path().join("corrected.exr")).len(), 32);
}

/// A ball that rides over the observer.
const HEAD_ON: &str = r#"
name = "Head-on"
[[object]]
shape = "sphere"
centre = [0.0, 0.0, 0.0]
radius = 0.5
"#;

#[test]
fn every_channel_is_finite_at_the_extremes() {
    let folder = folder();
    std::fs::write(folder.path().join("head-on.toml"), HEAD_ON).expect("the folder is there");
    let ahead = "--scene head-on.toml --gaze 180,0 --projection gaze --size 65x49 --gamma 1e10 --d 0.1 --time=-0.050000001";
    let passing = [(1e12, 0.0), (1e30, -1e12), (1e30, 0.0), (1e30, 1e12)];
    let passing = passing.map(|(gamma, time)| format!("--size 64x48 --gamma {gamma:e} --time {time:e}"));
    for renderer in ["reference", "packets"] {
        for flags in passing.iter().map(String::as_str).chain([ahead]) {
            render(folder.path(), &format!("{flags} --renderer {renderer} --out hits.exr"));
            let channels = channels(&folder.path().join("hits.exr"));
            for (name, values) in &channels {
                let wrong = values.iter().find(|value| !value.is_finite());
                assert_eq!(wrong, None, "{name} by {renderer} with {flags}");
            }
            if flags == ahead {
                // In the middle of the picture D is 2 gamma, and its fourth power more than f32 has room for.
                let middle = |name: &str| channels[name][24 * 65 + 32];
                assert!((middle("left.doppler") / 2e10 - 1.0).abs() < 1e-5, "{}", middle("left.doppler"));
                assert_eq!(middle("left.intensity"), f32::MAX);
            }
        }
    }
}

#[test]
fn each_point_of_a_rolling_wheel_is_measured_by_its_own_light_cone() {
    const BETA: f64 = 0.93;
    let folder = folder();
    let wheel = Scene::preset("wheel").expect("a preset");
    let look = "--d 0 --fov 50 --gaze 105,-3 --time 4.2 --projection gaze";
    render(folder.path(), &format!("--scene wheel --beta {BETA} {look} --out hits.exr"));
    let channels = channels(&folder.path().join("hits.exr"));
    let channel = |name: &str| &channels[&format!("left.{name}")];
    let speed = Speed::from_beta(BETA).expect("below 1");
    let mut points = 0;
    for pixel in 0..channel("id").len() {
        let value = |name: &str| f64::from(channel(name)[pixel]);
        if value("id") < 0.0 {
            continue;
        }
        let spin = wheel.bodies[value("id") as usize].spin.expect("all of it turns");
        let [x, _, z] = spin.hub;
        let rho = (value("rest_x") - x).hypot(value("rest_z") - z) / spin.radius;
        let hub = SourcePoint { x0: x / speed.gamma(), y: value("rest_y"), z };
        let angle = value("material_angle");
        let point = WheelPoint { hub, radius: spin.radius, rho, angle, turning: spin.turning };
        let expected = sighting(&speed, point, Aperture::default(), 4.2).expect("it is in the domain");
        let near = |name: &str, expected: f64| {
            let error = (value(name) - expected).abs();
            assert!(error <= 2e-5 * expected.abs().max(1.0), "{name}: {}, {expected}", value(name));
        };
        near("distance", expected.distance);
        near("emission_time", expected.retarded_time);
        near("proper_time", expected.proper_time);
        near("doppler", expected.doppler_factor);
        let gaze = Gaze { azimuth: 105f64.to_radians(), elevation: -3f64.to_radians() };
        let camera = Camera::new(Aperture::default(), gaze, 50f64.to_radians(), [WIDTH, HEIGHT]);
        let [u, v] = camera.pixel(expected.position.into()).expect("it is in front");
        let [column, row] = [pixel % WIDTH as usize, pixel / WIDTH as usize];
        assert!((u - column as f64 - 0.5).abs() < 1e-3 && (v - row as f64 - 0.5).abs() < 1e-3);
        points += 1;
    }
    assert!(points > 100, "only {points} pixels show the wheel");

    // Corrected, the wheel turns: its own Doppler factor is left, above 1 and below.
    run_gamow(folder.path(), &format!("rectify hits.exr --beta {BETA} --out corrected.exr"));
    let channels = self::channels(&folder.path().join("corrected.exr"));
    let [id, doppler] = ["id", "doppler"].map(|name| &channels[&format!("left.{name}")]);
    let [mut least, mut most] = [f32::INFINITY, 0.0];
    for pixel in (0..id.len()).filter(|&pixel| id[pixel] >= 0.0) {
        (least, most) = (least.min(doppler[pixel]), f32::max(most, doppler[pixel]));
    }
    let head_on = ((1.0 + BETA) / (1.0 - BETA)).sqrt() as f32;
    assert!(least > 1.0 / head_on && least < 0.8 && most < head_on && most > 1.2, "{least} to {most}");
}

/// A pixel of a model names a triangle, and the weights of its corners are those of the place that it shows;
/// both stay when the file is corrected.
#[test]
fn a_pixel_of_a_model_names_a_point_of_a_triangle() {
    let folder = folder();
    let corners = [[-1.0, 3.0, 0.0], [1.0, 3.5, 0.0], [0.0, 3.0, 1.5], [1.0, 3.0, 1.5]].map(DVec3::from);
    let faces = [[0, 1, 2], [1, 3, 2]];
    let vertices = corners.iter().map(|place| format!("v {} {} {}\n", place.x, place.y, place.z));
    let triangles = faces.iter().map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1));
    let file = vertices.chain(triangles).collect::<String>();
    std::fs::write(folder.path().join("sail.obj"), file).expect("it is written");
    std::fs::write(
        folder.path().join("sail.toml"),
        "name = \"Sail\"\n\n[[model]]\npath = \"sail.obj\"\nup = \"z\"\n",
    )
    .expect("it is written");
    render(
        folder.path(),
        "--scene sail.toml --beta 0.6 --d 0 --fov 70 --gaze 90,10 --time 3.5 --projection gaze --out hits.exr",
    );
    run_gamow(folder.path(), "rectify hits.exr --beta 0.6 --out corrected.exr");
    for file in ["hits.exr", "corrected.exr"] {
        let channels = channels(&folder.path().join(file));
        let mut shown = [0; 2];
        for (pixel, &id) in channels["left.id"].iter().enumerate() {
            let value = |name: &str| f64::from(channels[&format!("left.{name}")][pixel]);
            if id < 0.0 {
                assert_eq!(["triangle", "triangle_b", "triangle_c"].map(value), [-1.0, 0.0, 0.0]);
                continue;
            }
            let triangle = value("triangle") as usize;
            shown[triangle] += 1;
            let [a, b, c] = faces[triangle].map(|corner| corners[corner]);
            let place = a + (b - a) * value("triangle_b") + (c - a) * value("triangle_c");
            let rest = DVec3::from(["rest_x", "rest_y", "rest_z"].map(value));
            assert!(place.distance(rest) < 1e-5, "{file}, pixel {pixel}: {place} for {rest}");
        }
        assert!(shown.iter().all(|&pixels| pixels > 30), "{file}: {shown:?}");
    }
}

#[test]
fn measured_materials_are_numbered_in_the_order_of_their_list() {
    let folder = folder();
    let ball = |x: f64, light: &str| {
        format!("[[object]]\nshape = \"sphere\"\n{light}\ncentre = [{x:.1}, 5.0, 0.0]\nradius = 0.6\n")
    };
    let lights = ["material = \"leaves\"", "paint = \"#b3202a\"", "material = \"sand\"", "glow_k = 2700"];
    let balls: String = lights.iter().zip([-2.4, -0.8, 0.8, 2.4]).map(|(light, x)| ball(x, light)).collect();
    std::fs::write(folder.path().join("balls.toml"), format!("name = \"Balls\"\n{balls}"))
        .expect("there is room");
    render(folder.path(), "--scene balls.toml --beta 0 --d 0 --fov 80 --gaze 90,0 --time 0 --out hits.exr");
    let channels = channels(&folder.path().join("hits.exr"));
    let description = include_str!("../../assets/scenes/README.md");
    let (_, list) = description.split_once("The measured materials are").expect("they are listed");
    let names: Vec<&str> = list.split('`').skip(1).step_by(2).take(18).collect();
    let number = |name: &str| names.iter().position(|named| *named == name).expect("it is listed") as f32;
    let expected = [number("leaves"), -1.0, number("sand"), -1.0];
    let mut seen = [0; 4];
    for (id, material) in channels["left.id"].iter().zip(&channels["left.material"]) {
        if *id < 0.0 {
            assert_eq!(*material, -1.0);
            continue;
        }
        assert_eq!(*material, expected[*id as usize]);
        seen[*id as usize] += 1;
    }
    assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
}
