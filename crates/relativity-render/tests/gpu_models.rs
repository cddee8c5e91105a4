//! Models of triangles by the rays on a device, against the reference, our exact bodies and themselves.

use relativity_render::{
    Appearance, Body, Colour, Geometry, Group, Hit, HitImage, Method, Motion, PreparedScene, RawModel,
    Renderers, Shading, Shape, Velocity, View,
};

use crate::gpu_support::Test;
use crate::gpu_support::scenes::{conformal_views, parallel_views, speeds, time_seen_at, view_following};
use crate::models::{
    assert_published_alike, ball_model, box_model, exact_box, is_nearby, scene_of, soup, view,
};
use crate::support::{documented, spread};

pub const TESTS: &[Test] = &[
    ("hits_agree_with_the_reference", hits_agree_with_the_reference),
    ("no_ray_passes_between_triangles", no_ray_passes_between_triangles),
    ("colours_agree_with_the_reference", colours_agree_with_the_reference),
    ("a_box_of_triangles_looks_like_a_box", a_box_of_triangles_looks_like_a_box),
    ("edges_are_as_smooth_as_the_references", edges_are_as_smooth_as_the_references),
    ("models_are_told_from_other_bodies_by_depth", models_are_told_from_other_bodies_by_depth),
    ("each_scene_has_its_own_models", each_scene_has_its_own_models),
    ("a_mesh_keeps_its_bound", a_mesh_keeps_its_bound),
    ("a_mesh_has_no_gaps", a_mesh_has_no_gaps),
    ("a_mesh_has_the_colours_of_the_reference", a_mesh_has_the_colours_of_the_reference),
    (
        "the_published_model_shows_a_box_of_triangles_as_a_box",
        the_published_model_shows_a_box_of_triangles_as_a_box,
    ),
];

const RENDERERS: &str = include_str!("../src/renderers.rs");
const MIDDLE: [f64; 3] = [0.0, 4.0, 0.5];

/// Views at all speeds, approaching, abreast and receding, flat and conformal.
fn views() -> impl Iterator<Item = View> {
    let across = speeds().into_iter().flat_map(|speed| {
        [-3.0, 0.0, 2.0].map(|along| view_following(MIDDLE, speed, time_seen_at(MIDDLE, &speed, along), 40.0))
    });
    let oblique = parallel_views(speeds(), MIDDLE).chain(conformal_views(speeds(), MIDDLE));
    across.chain(oblique.step_by(3)).map(|mut view| {
        view.camera.size = [80, 60];
        view
    })
}

fn hits(renderers: &mut Renderers, scene: &PreparedScene, view: &View) -> HitImage {
    renderers.hits(Method::Rays, scene, view).expect("device works")
}

fn hits_agree_with_the_reference(renderers: &mut Renderers) {
    let [outline_px, doppler_error, surface_error] =
        ["all of them within ", "D is within ", "hits lie within "]
            .map(|figure| documented(RENDERERS, figure));
    let most_percent = documented(RENDERERS, "models of triangles show another triangle at up to ");
    let (mut covered, mut other) = (0, 0);
    for model in [soup(true), soup(false), ball_model(MIDDLE, 0.6, 24)] {
        let (corners, scene) = (model.corners.clone(), scene_of(model.clone()));
        for (view, geometry) in
            views().zip([Geometry::Seen, Geometry::Contracted, Geometry::Rest].into_iter().cycle())
        {
            let view = View { geometry, ..view };
            let expected = scene.hit_image(&view).hits;
            for (i, (expected, found)) in
                expected.iter().zip(&hits(renderers, &scene, &view).hits).enumerate()
            {
                let context = format!("pixel {i}, {geometry:?}, gamma {}", view.speed.gamma());
                let triangle =
                    |hit: &Option<Hit>| hit.and_then(|hit| hit.triangle).map(|point| point.triangle);
                covered += u32::from(expected.is_some());
                if triangle(expected) != triangle(found) {
                    other += 1;
                    let is_nearby = is_nearby(&scene, &view, i, found.as_ref(), outline_px);
                    assert!(is_nearby, "{context}: {found:?} for {expected:?}");
                }
                let Some(found) = found else { continue };
                let point = found.triangle.expect("of triangles");
                let [a, b, c] =
                    model.triangles[point.triangle as usize].map(|i| glam::DVec3::from(corners[i as usize]));
                let [second, third] = point.weights.map(f64::from);
                let off = (a + (b - a) * second + (c - a) * third).distance(found.rest_position);
                assert!(off < surface_error, "{context}: {off:e} off");
                assert!(second > -1e-4 && third > -1e-4 && second + third < 1.0001, "{context}: {point:?}");
                if let Some(expected) =
                    expected.filter(|expected| triangle(&Some(*expected)) == Some(point.triangle))
                {
                    let doppler_off = (expected.doppler_factor / found.doppler_factor - 1.0).abs();
                    assert!(doppler_off < doppler_error, "{context}: D is {doppler_off:e} off");
                    assert!(expected.rest_normal.distance(found.rest_normal) < 1e-9, "{context}");
                }
            }
        }
    }
    let most = 0.01 * most_percent * f64::from(covered);
    assert!(covered > 30_000 && f64::from(other) < most, "{other} of {covered} pixels show another triangle");
}

/// Every ray that passes well inside the outline of a closed surface meets it, also where it goes through
/// corners and along edges.
fn no_ray_passes_between_triangles(renderers: &mut Renderers) {
    let (radius, rings) = (0.6, 40);
    let model = scene_of(ball_model(MIDDLE, radius, rings));
    let inner = Shape::Sphere { centre: MIDDLE, radius: 0.99 * radius };
    let inner = PreparedScene::moving(&[Body::white(inner)]);
    let mut inside = 0;
    for (speed, along) in speeds().into_iter().zip([0.0, 0.7, -1.3].into_iter().cycle()) {
        for fov in [0.05, 2.0, 25.0] {
            let mut view = view_following(MIDDLE, speed, time_seen_at(MIDDLE, &speed, along), fov);
            view.camera.size = [160, 120];
            let found = hits(renderers, &model, &view).hits;
            for (i, (inner, found)) in inner.hit_image(&view).hits.iter().zip(&found).enumerate() {
                inside += u32::from(inner.is_some());
                assert!(
                    found.is_some() || inner.is_none(),
                    "pixel {i}, {fov} degrees, gamma {}",
                    speed.gamma()
                );
            }
        }
    }
    assert!(inside > 100_000, "{inside}");
}

/// Appearances that use every way to a colour.
fn appearances() -> [Appearance; 6] {
    let plain = Appearance { sky: false, ..Appearance::default() };
    [
        Appearance { colour: Colour::White, intensity_exponent: None, doppler_shift: false, ..plain },
        Appearance { colour: Colour::White, exposure_ev: 1.0, ..plain },
        Appearance { colour: Colour::StreetDaylight, exposure_ev: 1.0, ..plain },
        Appearance { colour: Colour::False, ..plain },
        Appearance { colour: Colour::White, light: true, ground_z: Some(0.2), sky: true, ..plain },
        Appearance { colour: Colour::White, shading: Shading::Emission, ..plain },
    ]
}

/// Whether the pixel and those around it show one triangle.
fn is_inside(hits: &HitImage, i: usize) -> bool {
    let [width, height] = hits.size.map(|side| side as usize);
    let (u, v) = (i % width, i / width);
    let triangle = |i: usize| hits.hits[i].and_then(|hit| hit.triangle).map(|point| point.triangle);
    (1..width - 1).contains(&u)
        && (1..height - 1).contains(&v)
        && triangle(i).is_some()
        && [width + 1, width, width - 1, 1]
            .iter()
            .all(|step| triangle(i - step) == triangle(i) && triangle(i + step) == triangle(i))
}

/// Returns the greatest difference between both pictures in a pixel that `counts`, in levels, and the number
/// of these.
fn levels_off(drawn: &[[u8; 4]], truth: &[[u8; 4]], counts: impl Fn(usize) -> bool) -> (u8, usize) {
    let pixels = drawn.iter().zip(truth).enumerate().filter(|(i, _)| counts(*i));
    let off =
        |(drawn, truth): (&[u8; 4], &[u8; 4])| drawn.iter().zip(truth).map(|(a, b)| a.abs_diff(*b)).max();
    pixels.fold((0, 0), |(worst, count), (_, pair)| (worst.max(off(pair).unwrap_or(0)), count + 1))
}

/// A ball of large triangles, painted.
fn painted_ball() -> RawModel {
    let mut model = ball_model(MIDDLE, 0.6, 6);
    model.paints = (0..model.corners.len() as u32).map(|i| spread::<3>(i).map(|part| part as f32)).collect();
    model
}

/// Checks that inside triangles the pictures of a painted ball by `method` are the reference's within these
/// `levels`.
///
/// The rays of a pixel are four, whose colours are averaged after the shoulder: that is no colour of their
/// average where paint changes much from pixel to pixel, so the reference has many rays there, too.
fn assert_colours(renderers: &mut Renderers, method: Method, levels: f64) {
    let samples = if method == Method::Rays { 4 } else { 1 };
    let scene = scene_of(painted_ball());
    for beta in [0.0, 0.7, 0.99] {
        let view = view(beta, Geometry::Seen, [160, 120]);
        let expected = scene.hit_image(&view);
        for appearance in appearances() {
            let [truth, drawn] = [Method::Reference, method].map(|method| {
                renderers.picture(method, &scene, &view, &appearance, samples).expect("device works").rgba
            });
            let (off, count) = levels_off(&drawn, &truth, |i| is_inside(&expected, i));
            assert!(count > 500 && f64::from(off) <= levels, "{off} levels at {beta}, {appearance:?}");
        }
    }
}

fn colours_agree_with_the_reference(renderers: &mut Renderers) {
    assert_colours(renderers, Method::Rays, documented(RENDERERS, "away from outlines colours are within "));
}

fn a_mesh_has_the_colours_of_the_reference(renderers: &mut Renderers) {
    let levels = documented(RENDERERS, "colours away from outlines are within ");
    assert_colours(renderers, Method::Mesh, levels);
}

/// Every pixel shows the triangle that the reference shows there or within the bound of there, and what it
/// shows is seen there.
fn a_mesh_keeps_its_bound(renderers: &mut Renderers) {
    let geometries = [Geometry::Seen, Geometry::Contracted, Geometry::OneCone, Geometry::Rest];
    let bound_px = Method::MESH_ERROR_PX;
    let models = [box_model(), painted_ball(), soup(true)];
    for (view, (geometry, model)) in views()
        .step_by(2)
        .zip(geometries.iter().zip(models.iter().cycle().flat_map(|model| [model; 3])).cycle())
    {
        let (scene, mut view) = (scene_of(model.clone()), View { geometry: *geometry, ..view });
        if *geometry == Geometry::OneCone {
            (view.camera.aperture.x, view.camera.off_middle.x) = (0.3, 0.3);
        }
        let truth = scene.hit_image(&view).hits;
        let drawn = renderers.hits(Method::Mesh, &scene, &view).expect("device works").hits;
        let triangle = |hit: &Option<Hit>| hit.and_then(|hit| hit.triangle).map(|point| point.triangle);
        for (i, (truth, drawn)) in truth.iter().zip(&drawn).enumerate() {
            let is_off = triangle(truth) != triangle(drawn);
            assert!(
                !is_off || is_nearby(&scene, &view, i, drawn.as_ref(), bound_px),
                "pixel {i}, {geometry:?}, gamma {}: {drawn:?} for {truth:?}",
                view.speed.gamma()
            );
            let Some(hit) = drawn else { continue };
            let place = view
                .apparent_position(hit.rest_position.to_array())
                .and_then(|place| view.camera.pixel(place));
            let [u, v] = place.expect("it is in front");
            let width = view.camera.size[0] as usize;
            let off = (u - (i % width) as f64 - 0.5).hypot(v - (i / width) as f64 - 0.5);
            assert!(off < bound_px, "pixel {i}, {geometry:?}, gamma {}: {off} px off", view.speed.gamma());
        }
    }
}

/// Triangles are divided differently, and nowhere does the background show between them.
fn a_mesh_has_no_gaps(renderers: &mut Renderers) {
    let scene = scene_of(ball_model(MIDDLE, 0.6, 7));
    for beta in [0.0, 0.9, 0.999] {
        let view = view(beta, Geometry::Seen, [240, 180]);
        let truth = scene.hit_image(&view).hits;
        let drawn = renderers.hits(Method::Mesh, &scene, &view).expect("device works").hits;
        let is_within = |i: usize| {
            let around =
                [0, 1, 239, 240, 241].iter().flat_map(|step| [i.checked_sub(*step), i.checked_add(*step)]);
            around.flatten().all(|i| truth.get(i).is_some_and(Option::is_some))
        };
        let gaps = (0..drawn.len()).filter(|&i| drawn[i].is_none() && is_within(i)).count();
        assert!(gaps == 0 && drawn.iter().flatten().count() > 3000, "{gaps} gaps at {beta}");
    }
}

fn the_published_model_shows_a_box_of_triangles_as_a_box(renderers: &mut Renderers) {
    let scenes = [PreparedScene::moving(&[Body::white(exact_box())]), scene_of(box_model())];
    assert_published_alike(renderers, &scenes, [0.0, 0.6, 0.95]);
}

fn a_box_of_triangles_looks_like_a_box(renderers: &mut Renderers) {
    let (exact, model) = (PreparedScene::moving(&[Body::white(exact_box())]), scene_of(box_model()));
    for beta in [0.0, 0.9] {
        let view = view(beta, Geometry::Seen, [80, 60]);
        let hits = model.hit_image(&view);
        for appearance in appearances() {
            let [truth, drawn] = [&exact, &model].map(|scene| {
                renderers.picture(Method::Rays, scene, &view, &appearance, 1).expect("device works").rgba
            });
            let (off, count) = levels_off(&drawn, &truth, |i| is_inside(&hits, i));
            assert!(count > 200 && off <= 2, "{off} levels at {beta}, {appearance:?}");
        }
    }
}

/// The light of a picture is that of the reference with sixteen rays a pixel: the samples lie where they
/// should.
fn edges_are_as_smooth_as_the_references(renderers: &mut Renderers) {
    let appearance =
        Appearance { intensity_exponent: None, sky: false, colour: Colour::White, ..Appearance::default() };
    let scene = scene_of(soup(true));
    let view = view(0.5, Geometry::Seen, [160, 120]);
    let light = |picture: &relativity_render::Picture| -> f64 {
        picture
            .rgba
            .iter()
            .flat_map(|pixel| &pixel[..3])
            .map(|level| (f64::from(*level) / 255.0).powf(2.2))
            .sum()
    };
    let [expected, found] = [(Method::Reference, 4), (Method::Rays, 1)].map(|(method, samples)| {
        renderers.picture(method, &scene, &view, &appearance, samples).expect("device works")
    });
    let share = light(&found) / light(&expected) - 1.0;
    assert!(share.abs() < 0.01, "{share}");
    // Pixels of edges differ from one ray's, and by less from many rays'.
    let single =
        renderers.picture(Method::Reference, &scene, &view, &appearance, 1).expect("it needs no device");
    let apart = |other: &[[u8; 4]]| -> f64 {
        let pairs = expected.rgba.iter().flatten().zip(other.iter().flatten());
        pairs.map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum()
    };
    assert!(
        apart(&found.rgba) < 0.3 * apart(&single.rgba),
        "{} of {}",
        apart(&found.rgba),
        apart(&single.rgba)
    );
}

/// A box of triangles with balls through its faces, in groups that fly apart: each pixel shows the body that
/// the reference sees.
fn models_are_told_from_other_bodies_by_depth(renderers: &mut Renderers) {
    let ball = |centre| Body::white(Shape::Sphere { centre, radius: 0.4 });
    let model = Body::of_triangles(box_model().prepared().expect("a model"));
    let (moving, resting) = ([model, ball([0.9, 3.4, 0.7])], [ball([0.2, 3.2, 0.4]), ball([-0.6, 4.0, 0.9])]);
    let scene = PreparedScene::new([
        Group { motion: Motion::Scene, bodies: &moving },
        Group { motion: Motion::Own(Velocity::REST), bodies: &resting },
    ]);
    for beta in [0.0, 0.6, 0.95] {
        let view = view(beta, Geometry::Seen, [96, 72]);
        let expected = scene.hit_image(&view).hits;
        let found = hits(renderers, &scene, &view).hits;
        let body = |hit: &Option<Hit>| hit.map(|hit| hit.body);
        let wrong = expected.iter().zip(&found).filter(|(a, b)| body(a) != body(b)).count();
        let covered = expected.iter().flatten().count();
        assert!(covered > 800 && wrong * 1000 <= covered.max(1000), "{wrong} of {covered} at {beta}");
    }
}

/// Scenes drawn in turn, one of them with two bodies of one model and a third of another.
fn each_scene_has_its_own_models(renderers: &mut Renderers) {
    let [first, second] = [soup(true), box_model()].map(|model| model.prepared().expect("a model"));
    let bodies = [
        Body::of_triangles(first.clone()).moved([-1.5, 0.5, 0.0]),
        Body::of_triangles(second).moved([1.5, 0.5, 0.0]),
        Body::of_triangles(first).moved([0.2, 1.0, 0.3]),
    ];
    let scenes = [
        PreparedScene::moving(&bodies),
        scene_of(ball_model(MIDDLE, 0.6, 12)),
        PreparedScene::moving(&bodies[..1]),
    ];
    for view in [view(0.3, Geometry::Seen, [80, 60]), view(0.8, Geometry::Seen, [80, 60])] {
        for scene in &scenes {
            let expected = scene.hit_image(&view).hits;
            let found = hits(renderers, scene, &view).hits;
            let seen =
                |hit: &Option<Hit>| hit.map(|hit| (hit.body, hit.triangle.map(|point| point.triangle)));
            let wrong = expected.iter().zip(&found).filter(|(a, b)| seen(a) != seen(b)).count();
            let covered = expected.iter().flatten().count();
            assert!(covered > 200 && wrong <= 3, "{wrong} of {covered}");
        }
    }
}
