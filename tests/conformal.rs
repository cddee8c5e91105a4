//! The conformal picture of the paper's cyclist in motion: that of the cyclist at rest, moved back by the
//! rapidity.

use gamow::scene::Scene;
use gamow::settings::{Settings, Subject};
use glam::DVec3;
use relativity_core::Speed;
use relativity_render::{Camera, Gaze, Geometry, HitImage, Projection, View};

/// Width and height, px, and how many columns the rapidity is.
const SIZE: [u32; 2] = [1600, 500];
const COLUMNS: usize = 600;
/// The least distance from the centre of a pixel at which rounding does not decide on which side of an
/// outline it is, px.
const ROUNDING_PX: f64 = 1e-6;

/// Each pixel shows the point of the body that the pixel so many columns further to the right shows to a
/// camera that moves along, at the same event: frame, rider, and wheels as they stand at their own time.
/// Pixels on which an outline lies to 1e-6 px do not count; of outlines some 10,000 px long at most one is to
/// be expected.
#[test]
fn the_cyclist_slides_by_the_rapidity() {
    let scene = Scene::preset("cyclist").expect("a preset");
    let prepared = scene.prepared();
    let settings = Settings { scene: "cyclist".to_owned(), ..Settings::default() };
    for time in [0.0, 1.6, 4.0] {
        let subject = Subject { scene: &prepared, tracked: scene.track(None) };
        let [view, _] = settings.views(subject, time, SIZE);
        let moving = slid(&View { speed: Speed::from_beta(0.9).expect("below 1"), ..view }, &subject);
        let resting = View { geometry: Geometry::Rest, ..moving };
        let [seen, at_rest] = [moving, resting].map(|view| prepared.hit_image(&view));
        let width = SIZE[0] as usize;
        let (mut shown, mut differing, mut farthest, mut doppler) = (0, 0, 0.0f64, [f64::INFINITY, 0.0]);
        for (i, hit) in seen.hits.iter().enumerate().filter(|(i, _)| i % width + COLUMNS < width) {
            let rest = at_rest.hits[i + COLUMNS];
            let bodies = [*hit, rest].map(|hit| hit.map(|hit| hit.body));
            shown += usize::from(hit.is_some());
            if bodies[0] != bodies[1] {
                differing += 1;
                let around = bodies_around(&prepared, &moving, centre(&seen, i));
                assert!(bodies.iter().all(|body| around.contains(body)), "T {time}, pixel {i}: {bodies:?}");
            } else if let (Some(hit), Some(rest)) = (hit, rest) {
                farthest = farthest.max(hit.material_position.distance(rest.material_position));
                doppler = [doppler[0].min(hit.doppler_factor), doppler[1].max(hit.doppler_factor)];
            }
        }
        println!("T {time}: {shown} shown, {differing} differ, {farthest:e} apart, D {doppler:?}");
        assert!(shown > 5000, "T {time}: {shown} pixels are too few to judge by");
        assert!(differing <= 1, "T {time}: {differing} of {shown} pixels");
        assert!(farthest < 1e-6, "T {time}: {farthest:e}");
    }
}

/// `view` with the cyclist as far on the left in motion as on the right at rest, and this many columns apart.
fn slid(view: &View, subject: &Subject<'_>) -> View {
    let point = subject.tracked.point();
    let places = [Geometry::Seen, Geometry::Rest]
        .map(|geometry| View { geometry, ..*view }.apparent_position(point).expect("in the domain"));
    let middle = 0.5 * places.iter().map(|place| (place.x / place.y.hypot(place.z)).asinh()).sum::<f64>();
    let half_width =
        0.5 * f64::from(SIZE[0]) * (view.speed.beta() * view.speed.gamma()).asinh() / COLUMNS as f64;
    let [_, y, z] = places[0].to_array();
    let gaze = Gaze::along([y.hypot(z) * middle.sinh(), y, z]);
    let camera = Camera {
        gaze,
        horizontal_fov: 2.0 * half_width.sinh().atan(),
        projection: Projection::Mercator { right: DVec3::X, shift: 0.0 },
        ..view.camera
    };
    View { camera, geometry: Geometry::Seen, ..*view }
}

/// The centre of pixel `i`.
fn centre(image: &HitImage, i: usize) -> [f64; 2] {
    let width = image.size[0] as usize;
    [(i % width) as f64 + 0.5, (i / width) as f64 + 0.5]
}

/// The bodies that are seen this near to `place`, and there.
fn bodies_around(
    scene: &relativity_render::PreparedScene,
    view: &View,
    [x, y]: [f64; 2],
) -> Vec<Option<usize>> {
    let places = (0..17).map(|k| {
        let (sine, cosine) = (std::f64::consts::TAU * f64::from(k) / 16.0).sin_cos();
        let reach = if k < 16 { ROUNDING_PX } else { 0.0 };
        [x + reach * cosine, y + reach * sine]
    });
    let body = |place| scene.first_hit(view, view.camera.line_of_sight(place)).map(|hit| hit.body);
    places.map(body).collect()
}
