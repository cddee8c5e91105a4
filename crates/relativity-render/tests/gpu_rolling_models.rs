//! Models of triangles that roll, on a device, against the reference and our exact bodies.

use relativity_render::{
    Appearance, Body, Colour, EyeTarget, Geometry, Hit, MaterialPoint, Method, PreparedScene, RawModel,
    Renderers, View,
};

use crate::gpu_support::Test;
use crate::models::{
    assert_published_alike, box_model, exact_box, is_nearby, rolling, soup, spin, view, wheel_model,
};
use crate::support::{documented, spread};

const RENDERERS: &str = include_str!("../src/renderers.rs");

pub const TESTS: &[Test] = &[
    ("a_mesh_of_a_rolling_model_keeps_its_bound", a_mesh_of_a_rolling_model_keeps_its_bound),
    (
        "a_mesh_of_a_rolling_model_has_the_colours_of_the_reference",
        a_mesh_of_a_rolling_model_has_the_colours_of_the_reference,
    ),
    (
        "the_published_model_rolls_a_box_of_triangles_as_a_box",
        the_published_model_rolls_a_box_of_triangles_as_a_box,
    ),
    ("rays_show_what_the_reference_shows", rays_show_what_the_reference_shows),
    ("rays_draw_what_packets_draw", rays_draw_what_packets_draw),
];

fn triangle(hit: Option<&Hit>) -> Option<u32> {
    hit.and_then(|hit| hit.triangle).map(|point| point.triangle)
}

/// Whether the reference sees, within a pixel of the middle of this one, what is next to a hit on the model:
/// of a triangle that is all but hidden there may be too little to be found.
fn is_next_to(scene: &PreparedScene, view: &View, i: usize, hit: Option<&Hit>) -> bool {
    let (u, v) = ((i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5);
    let offs = (0..21 * 21).map(|k| [f64::from(k % 21) * 0.1 - 1.0, f64::from(k / 21) * 0.1 - 1.0]);
    offs.filter(|[right, down]| right.hypot(*down) < 1.0).any(|[right, down]| {
        let there = scene.first_hit(view, view.camera.line_of_sight([u + right, v + down]));
        let pair = there.zip(hit);
        // A pixel is 0.05 wide there.
        pair.is_some_and(|(there, hit)| there.material_position.distance(hit.material_position) < 0.05)
    })
}

fn wheel() -> RawModel {
    wheel_model(0.5, 0.06, 24, 6, 7)
}

fn a_mesh_of_a_rolling_model_keeps_its_bound(renderers: &mut Renderers) {
    let (scene, bound_px) = (rolling(wheel(), 0.57), Method::MESH_ERROR_PX);
    let mut seen = 0;
    for geometry in [Geometry::Seen, Geometry::Contracted, Geometry::OneCone, Geometry::Rest] {
        for beta in [0.0, 0.6, 0.93, 0.99] {
            let mut view = view(beta, geometry, [64, 48]);
            if geometry == Geometry::OneCone {
                (view.camera.aperture.x, view.camera.off_middle.x) = (0.1, 0.1);
            }
            let truth = scene.hit_image(&view).hits;
            let drawn = renderers.hits(Method::Mesh, &scene, &view).expect("device works").hits;
            for (i, (truth, drawn)) in truth.iter().zip(&drawn).enumerate() {
                let is_off = triangle(truth.as_ref()) != triangle(drawn.as_ref());
                assert!(
                    !is_off
                        || is_nearby(&scene, &view, i, drawn.as_ref(), bound_px)
                        || is_next_to(&scene, &view, i, drawn.as_ref()),
                    "pixel {i}, {geometry:?} at {beta}: {drawn:?} for {truth:?}"
                );
                let Some(hit) = drawn else { continue };
                let point = MaterialPoint { rest: hit.material_position, spin: Some(spin(0.57)) };
                let place = view.apparent_position(point).and_then(|place| view.camera.pixel(place));
                let [u, v] = place.expect("it is in front");
                let off = (u - (i % 64) as f64 - 0.5).hypot(v - (i / 64) as f64 - 0.5);
                assert!(off < bound_px, "pixel {i}, {geometry:?} at {beta}: {off} px off");
            }
            seen += drawn.iter().flatten().count();
        }
    }
    assert!(seen > 1000, "{seen}");
}

fn a_mesh_of_a_rolling_model_has_the_colours_of_the_reference(renderers: &mut Renderers) {
    let mut model = box_model();
    model.paints = (0..8).map(|i| spread::<3>(i).map(|part| part as f32)).collect();
    let scene = rolling(model, 1.2);
    let levels = ["colours away from outlines are within ", "away from outlines colours are within "]
        .map(|figure| documented(RENDERERS, figure));
    let plain = Appearance { sky: false, ..Appearance::default() };
    for beta in [0.6, 0.93] {
        let view = view(beta, Geometry::Seen, [80, 60]);
        let hits = scene.hit_image(&view).hits;
        for colour in [Colour::White, Colour::StreetDaylight, Colour::False] {
            let appearance = Appearance { colour, exposure_ev: 1.0, ..plain };
            let mut picture = |method, samples| {
                renderers.picture(method, &scene, &view, &appearance, samples).expect("it works").rgba
            };
            // A pixel of the packets has four samples, one of the mesh has one inside of triangles.
            let pairs = [
                (picture(Method::Mesh, 1), picture(Method::Reference, 1)),
                (picture(Method::Packets, 1), picture(Method::Reference, 4)),
            ];
            let (mut count, mut worst) = (0, [0; 2]);
            for i in 81..hits.len() - 81 {
                let own = triangle(hits[i].as_ref());
                if own.is_none()
                    || [i - 81, i - 79, i + 79, i + 81, i - 80, i + 80, i - 1, i + 1]
                        .iter()
                        .any(|&beside| triangle(hits[beside].as_ref()) != own)
                {
                    continue;
                }
                count += 1;
                for (worst, (drawn, truth)) in worst.iter_mut().zip(&pairs) {
                    let off = drawn[i].iter().zip(truth[i]).map(|(a, b)| a.abs_diff(b)).max();
                    *worst = (*worst).max(off.unwrap_or(0));
                }
            }
            assert!(
                count > 200 && f64::from(worst[0]) <= levels[0] && f64::from(worst[1]) <= levels[1],
                "{worst:?} levels of {count}: {colour:?} at {beta}"
            );
        }
    }
}

fn the_published_model_rolls_a_box_of_triangles_as_a_box(renderers: &mut Renderers) {
    let exact = PreparedScene::moving(&[Body::white(exact_box()).turning(spin(1.2))]);
    assert_published_alike(renderers, &[exact, rolling(box_model(), 1.2)], [0.3, 0.6, 0.93]);
}

/// Nearly everywhere the rays show the triangle that the reference shows there or within 0.05 px of there, at
/// the same place on the wheel.
fn rays_show_what_the_reference_shows(renderers: &mut Renderers) {
    let outline_px = documented(RENDERERS, "all of them within ");
    let (mut covered, mut other, mut wrong) = (0, 0, 0);
    for (model, radius) in [(wheel(), 0.57), (soup(true), 1.7)] {
        let scene = rolling(model, radius);
        for (beta, geometry) in [
            (0.0, Geometry::Seen),
            (0.5, Geometry::Seen),
            (0.93, Geometry::Seen),
            (0.999, Geometry::Seen),
            (0.6, Geometry::Contracted),
            (0.6, Geometry::Rest),
        ] {
            let view = view(beta, geometry, [64, 48]);
            let truth = scene.hit_image(&view).hits;
            let drawn = renderers.hits(Method::Rays, &scene, &view).expect("device works").hits;
            for (i, (truth, drawn)) in truth.iter().zip(&drawn).enumerate() {
                covered += u32::from(truth.is_some());
                if triangle(truth.as_ref()) != triangle(drawn.as_ref()) {
                    other += 1;
                    wrong += u32::from(!is_nearby(&scene, &view, i, drawn.as_ref(), outline_px));
                    continue;
                }
                let (Some(truth), Some(drawn)) = (truth, drawn) else { continue };
                let off = truth.material_position.distance(drawn.material_position);
                assert!(off < 1e-3, "pixel {i}, {geometry:?} at {beta}: {off}");
                let doppler_off = (truth.doppler_factor / drawn.doppler_factor - 1.0).abs();
                let most = 2e-4 * view.speed.gamma();
                assert!(doppler_off < most, "pixel {i}, {geometry:?} at {beta}: D is {doppler_off} off");
            }
        }
    }
    let most = 0.01 * documented(RENDERERS, "seen within those 0.05 px at up to ") * f64::from(covered);
    assert!(
        covered > 3000 && f64::from(wrong) <= most,
        "{wrong} of {covered} pixels show what is not seen there"
    );
    assert!(200 * other < covered, "{other} of {covered} pixels show another triangle");
}

/// Rays are the device's own where a model rolls, and their pictures the packets'.
fn rays_draw_what_packets_draw(renderers: &mut Renderers) {
    let scene = rolling(wheel(), 0.57);
    let appearance = Appearance { colour: Colour::White, sky: false, ..Appearance::default() };
    let view = view(0.93, Geometry::Seen, [64, 48]);
    let mut target = EyeTarget::new(renderers.gpu().expect("a device"), [64, 48]);
    let drew = renderers.draw(Method::Rays, &scene, &view, &appearance, &mut target);
    assert_eq!(drew.expect("device works"), Method::Rays);
    let [rays, packets] = [Method::Rays, Method::Packets]
        .map(|method| renderers.picture(method, &scene, &view, &appearance, 1).expect("it works").rgba);
    let off = rays.iter().zip(&packets).filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 4));
    let (off, lit) = (off.count(), packets.iter().filter(|pixel| pixel[1] > 0).count());
    assert!(lit > 80 && 50 * off < lit, "{off} of {lit} pixels differ");
}
