//! Turning of bodies and lengths on them, read from patterns in pictures alone, without the formulas behind
//! them.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use relativity_core::{Aperture, Speed};
use relativity_render::colour::srgb_decoded;
use relativity_render::{
    Appearance, Body, Camera, Gaze, Geometry, Pattern, Picture, PreparedScene, Shading, Shape, View,
};

/// Far away compared with the bodies, which are about 1 large.
const FAR: f64 = 1000.0;
const SIDE: u32 = 120;

/// White bodies, so that only patterns make anything darker, on a dark ground.
fn appearance() -> Appearance {
    Appearance {
        doppler_shift: false,
        intensity_exponent: None,
        shading: Shading::Emission,
        sky: false,
        ..Appearance::default()
    }
}

/// Returns the view of distant bodies straight ahead, in light that left them there.
fn abeam(beta: f64) -> View {
    View {
        camera: Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 2.6 / FAR, [SIDE; 2]),
        speed: Speed::from_beta(beta).expect("a speed"),
        observation_time: FAR,
        geometry: Geometry::Seen,
    }
}

/// A body straight ahead that rests, from a camera moved around it by this angle towards -x.
fn from_behind(angle: f64) -> View {
    let mut view = abeam(0.0);
    let (sine, cosine) = angle.sin_cos();
    view.camera.aperture = Aperture { x: -FAR * sine, y: FAR - FAR * cosine, z: 0.0 };
    view.camera.gaze = Gaze { azimuth: FRAC_PI_2 - angle, elevation: 0.0 };
    view
}

fn picture(body: Body, view: &View) -> Picture {
    PreparedScene::moving(&[body]).picture(view, &appearance(), 2)
}

fn globe() -> Body {
    let pattern = Pattern::Graticule { step_degrees: 15.0 };
    Body { pattern, ..Body::white(Shape::Sphere { centre: [0.0, FAR, 0.0], radius: 1.0 }) }
}

/// Sum of the differences of two pictures, levels.
fn difference(a: &Picture, b: &Picture) -> f64 {
    let pairs = a.rgba.iter().zip(&b.rgba);
    pairs.map(|(a, b)| f64::from(a[1].abs_diff(b[1]))).sum()
}

#[test]
fn a_globe_abeam_at_0_8_c_shows_its_side_as_if_turned_by_53_1_degrees() {
    let passing = picture(globe(), &abeam(0.8));
    let tried = (0..=60).map(|i| 50.0 + 0.1 * f64::from(i));
    let off = |degrees: f64| difference(&passing, &picture(globe(), &from_behind(degrees.to_radians())));
    let turned = tried.min_by(|a, b| off(*a).total_cmp(&off(*b))).expect("angles");
    assert!((turned - 53.1).abs() <= 0.5, "turned by {turned} degrees");
    // And it is that picture, not only the nearest: 2 levels on average of all pixels.
    assert!(off(turned) < 2.0 * f64::from(SIDE * SIDE), "{} levels off", off(turned));
}

#[test]
fn the_middle_of_a_globe_abeam_at_0_8_c_lies_53_1_degrees_from_what_faces_the_eye() {
    let hits = PreparedScene::moving(&[globe()]).hit_image(&abeam(0.8));
    let columns = (0..SIDE).flat_map(|v| (0..SIDE).map(move |u| (u, v)));
    let covered: Vec<_> = columns.filter(|(u, v)| hits.hits[(v * SIDE + u) as usize].is_some()).collect();
    let middle = |of: fn(&(u32, u32)) -> u32| {
        let (low, high) = (covered.iter().map(of).min(), covered.iter().map(of).max());
        u32::midpoint(low.expect("a globe"), high.expect("a globe"))
    };
    let (u, v) = (middle(|at| at.0), middle(|at| at.1));
    let hit = hits.hits[(v * SIDE + u) as usize].expect("its middle is seen");
    let place = hit.material_position - DVec3::Y * FAR;
    let turned = (-place.x).atan2(-place.y).to_degrees();
    // The middle lies within a pixel, which is 1/46 of the radius: 1.2 degrees, and half of that at a pixel's
    // centre.
    assert!((turned - 53.1).abs() <= 0.5 + 0.7 / 53.1f64.to_radians().cos(), "{turned} degrees");
}

fn die() -> Body {
    let shape = Shape::Box { centre: [0.0, FAR, 0.0], half: [0.5; 3], turn: [0.0, 0.0, 0.0, 1.0] };
    Body { pattern: Pattern::Faces, ..Body::white(shape) }
}

/// Returns the number of spots the size of a pip that are dark and surrounded by light.
fn pips(picture: &Picture) -> usize {
    let side = SIDE as usize;
    let is_dark = |i: usize| (90..190).contains(&picture.rgba[i][1]);
    let mut seen = vec![false; side * side];
    let mut spots = 0;
    for start in 0..side * side {
        let (mut found, mut area) = (vec![start], 0);
        while let Some(i) = found.pop() {
            if seen[i] || !is_dark(i) {
                continue;
            }
            seen[i] = true;
            area += 1;
            found.extend([i.saturating_sub(1), i + 1, i.saturating_sub(side), i + side]);
            found.retain(|&i| i < side * side);
        }
        spots += usize::from((8..80).contains(&area));
    }
    spots
}

#[test]
fn a_die_abeam_shows_the_five_before_it_and_at_0_8_c_the_six_behind_as_well() {
    assert_eq!(pips(&picture(die(), &abeam(0.0))), 5);
    assert_eq!(pips(&picture(die(), &abeam(0.8))), 5 + 6);
}

#[test]
fn opposite_faces_sum_to_seven() {
    let from = |degrees: f64| pips(&picture(die(), &from_behind(degrees.to_radians())));
    assert_eq!([from(0.0), from(180.0)], [5, 2]);
    assert_eq!([from(90.0), from(-90.0)], [6, 1]);
}

/// Returns the distance of `place` (a column, pixels) from the boundary of light and dark in the middle row,
/// from the share of light there.
fn edge_off(picture: &Picture, place: f64) -> f64 {
    const REACH: usize = 8;
    let [width, height] = picture.size;
    let row = &picture.rgba[(height / 2 * width) as usize..][..width as usize];
    let first = place as usize - REACH;
    let light: Vec<_> = row[first..place as usize + REACH]
        .iter()
        .map(|pixel| srgb_decoded(f64::from(pixel[1]) / 255.0))
        .collect();
    let (start, end) = (light[0], light[light.len() - 1]);
    assert!((start / end).ln().abs() > 1.0, "no edge at {place}");
    let of_start = light.iter().map(|light| (light - end) / (start - end)).sum::<f64>();
    first as f64 + of_start - place
}

#[test]
fn stripes_stand_at_their_spacing() {
    let spacing = 0.125;
    let (from, to, radius) = ([-1.0, 3.0, 0.0], [1.0, 3.0, 0.0], 0.05);
    let cuboid =
        Shape::Box { centre: [0.0, 3.0, 0.0], half: [1.0, radius, radius], turn: [0.0, 0.0, 0.0, 1.0] };
    let mut view = abeam(0.0);
    view.camera.horizontal_fov = 0.8;
    view.camera.size = [601, 3];
    for shape in [Shape::Tube { from, to, radius }, Shape::Cylinder { from, to, radius }, cuboid] {
        let body = Body { pattern: Pattern::Stripes { step: spacing }, ..Body::white(shape) };
        let picture = picture(body, &view);
        for k in 1..16 {
            let edge = DVec3::new(-1.0 + spacing * f64::from(k), 2.95, 0.0);
            let [column, _] = view.camera.pixel(edge).expect("in front");
            let off = edge_off(&picture, column);
            assert!(off.abs() < 0.05, "{shape:?}, edge {k}: {off} px");
        }
    }
}
