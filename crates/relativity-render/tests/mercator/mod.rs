//! The conformal picture by formulas of its own, from the rest frame straight to the picture: no camera, no
//! light cone and no aberration is asked. For eyes whose baseline is along the motion.

#![allow(dead_code, reason = "each program that includes this module uses its own part")]
#![allow(clippy::allow_attributes, reason = "an expectation would fail in the programs that use every part")]

use glam::{DVec2, DVec3};
use relativity_core::{Aperture, Speed};
use relativity_render::{
    Body, Camera, Gaze, Geometry, HitImage, Method, PreparedScene, Projection, Renderers, Shape, View,
};

use crate::scenes::{still_life, time_seen_at, view_following};
use crate::support::sweep;

pub const FOLLOWED: [f64; 3] = [-0.4, 3.0, 0.7];

/// The map between u, v and the pixels of a conformal picture.
#[derive(Debug, Clone, Copy)]
pub struct Chart {
    /// u and v in the middle of the picture.
    middle: DVec2,
    /// Width and height, px.
    size: DVec2,
    /// Pixels per unit of u and per radian of v.
    pub px_per_unit: f64,
}

/// The rapidity at this speed.
#[must_use]
pub fn rapidity(speed: &Speed) -> f64 {
    (speed.beta() * speed.gamma()).asinh()
}

/// xi: how far along x the point at `rest` is from the eye's event, in its own frame.
#[must_use]
pub fn along(view: &View, rest: DVec3) -> f64 {
    let speed = &view.speed;
    rest.x + speed.gamma() * (speed.beta() * view.observation_time - view.camera.aperture.x)
}

/// u and v at which the point at `rest` is seen: arsinh(xi/rho) - eta, and its angle about the baseline.
#[must_use]
pub fn seen(view: &View, rest: DVec3) -> DVec2 {
    let (y, z) = (rest.y - view.camera.aperture.y, rest.z - view.camera.aperture.z);
    DVec2::new((along(view, rest) / y.hypot(z)).asinh() - rapidity(&view.speed), z.atan2(y))
}

/// D of what is seen at this u.
#[must_use]
pub fn doppler_factor(speed: &Speed, u: f64) -> f64 {
    u.cosh() / (u + rapidity(speed)).cosh()
}

impl Chart {
    /// Returns the map of the picture of `view`.
    #[must_use]
    pub fn new(view: &View) -> Self {
        let camera = &view.camera;
        let Projection::Mercator { right: DVec3::X, shift } = camera.projection else {
            panic!("it is conformal, about the x axis")
        };
        let Gaze { azimuth, elevation } = camera.gaze;
        let gaze = [elevation.cos() * azimuth.cos(), elevation.cos() * azimuth.sin(), elevation.sin()];
        let aside = gaze[0] / gaze[1].hypot(gaze[2]);
        let size = DVec2::from(camera.size.map(f64::from));
        Self {
            middle: DVec2::new(aside.asinh() - shift, gaze[2].atan2(gaze[1])),
            size,
            px_per_unit: 0.5 * size.x / (0.5 * camera.horizontal_fov).tan().asinh(),
        }
    }

    /// Column and row, px, of these u and v.
    #[must_use]
    pub fn place(&self, coordinates: DVec2) -> DVec2 {
        let off = (coordinates - self.middle) * self.px_per_unit;
        0.5 * self.size + DVec2::new(off.x, -off.y)
    }

    /// u and v of a column and row, px.
    #[must_use]
    pub fn coordinates(&self, place: DVec2) -> DVec2 {
        let off = (place - 0.5 * self.size) / self.px_per_unit;
        self.middle + DVec2::new(off.x, -off.y)
    }
}

/// The centre of pixel `i` of `image`.
#[must_use]
pub fn pixel_centre(image: &HitImage, i: usize) -> DVec2 {
    let width = image.size[0] as usize;
    DVec2::new((i % width) as f64 + 0.5, (i / width) as f64 + 0.5)
}

/// The largest distance, px, of a shown point from its pixel's centre, and the number of pixels that show
/// something.
#[must_use]
pub fn farthest_off(image: &HitImage, view: &View) -> (f64, usize) {
    let chart = Chart::new(view);
    let (mut most, mut covered) = (0.0f64, 0);
    for (i, hit) in image.hits.iter().enumerate().filter_map(|(i, hit)| Some((i, (*hit)?))) {
        let place = chart.place(seen(view, hit.rest_position));
        most = most.max(place.distance(pixel_centre(image, i)));
        covered += 1;
    }
    (most, covered)
}

#[must_use]
pub fn beta(beta: f64) -> Speed {
    Speed::from_beta(beta).expect("below 1")
}

#[must_use]
pub fn gamma(gamma: f64) -> Speed {
    Speed::from_gamma(gamma).expect("at least 1")
}

/// The speeds at which u and v are measured.
#[must_use]
pub fn speeds() -> [Speed; 6] {
    [beta(0.0), beta(0.5), beta(0.9), beta(0.99), beta(0.9999), gamma(1e6)]
}

/// Views of the left eye, which follow a point before, abreast and after: of a part of the sky, and of nearly
/// all between the ends of the baseline.
pub fn views() -> impl Iterator<Item = View> {
    let cases = speeds().into_iter().flat_map(|speed| [-3.0, -0.8, 0.0, 2.5].map(|along| (speed, along)));
    cases.flat_map(|(speed, along)| {
        [(45.0, 0.03), (150.0, 0.3)].map(|(fov_degrees, shift)| {
            let mut view =
                view_following(FOLLOWED, speed, time_seen_at(FOLLOWED, &speed, along), fov_degrees);
            let [left, _] = Aperture::pair(0.2);
            view.camera.projection = Projection::Mercator { right: DVec3::X, shift };
            view.camera.aperture = left;
            view.camera.off_middle = DVec3::X * left.x;
            view
        })
    })
}

/// Whether u and v of what each pixel shows are linear in its column and row, with as many pixels per unit
/// both ways: off by less than `bound_px`.
pub fn u_and_v_are_linear(renderers: &mut Renderers, method: Method, bound_px: f64) {
    let scene = PreparedScene::moving(&still_life());
    let mut most = 0.0f64;
    for view in sweep(0, 3, views()) {
        let image = renderers.hits(method, &scene, &view).expect("it is drawn");
        let (off, covered) = farthest_off(&image, &view);
        let context = format!("{method}, gamma {} T {}", view.speed.gamma(), view.observation_time);
        assert!(covered > 100, "{context}: {covered} pixels are too few to judge by");
        assert!(off < bound_px, "{context}: {off} px off");
        most = most.max(off);
    }
    println!("{method}: {most:e} px at most");
}

/// A ball's centre and radius.
pub const BALL: ([f64; 3], f64) = ([0.3, 2.4, 1.8], 0.9);

/// A view of the ball, before, abreast or after.
fn view_of_ball(speed: Speed, along: f64) -> View {
    let (centre, _) = BALL;
    let mut view = view_following(centre, speed, time_seen_at(centre, &speed, along), 75.0);
    if speed == Speed::REST {
        let aside = along * centre[1].hypot(centre[2]);
        view.camera.aperture.x = centre[0] - aside;
        view.camera.gaze = Gaze::along([aside, centre[1], centre[2]]);
    }
    view.camera.projection = Projection::Mercator { right: DVec3::X, shift: 0.0 };
    view
}

/// The middle of the outline of the ball.
#[must_use]
pub fn middle_of_ball(view: &View) -> DVec2 {
    let (centre, radius) = (DVec3::from(BALL.0), BALL.1);
    let (y, z) = (centre.y - view.camera.aperture.y, centre.z - view.camera.aperture.z);
    let tangent = (y * y + z * z - radius * radius).sqrt();
    DVec2::new((along(view, centre) / tangent).asinh() - rapidity(&view.speed), z.atan2(y))
}

/// Whether the ball has one outline all the way and at every speed: that of cos(v) = sqrt(1 - k^2) cosh(u),
/// which is 2 artanh k wide and 2 arcsin k high; each pixel within `reach_px`, its width and height within 1
/// px.
pub fn a_ball_keeps_its_outline(renderers: &mut Renderers, method: Method, reach_px: f64) {
    let (centre, radius) = BALL;
    let scene = PreparedScene::moving(&[Body::new(Shape::Sphere { centre, radius }, 600.0)]);
    let cases = [0.0, 0.6, 0.95, 0.999].into_iter().flat_map(|of| [-2.0, 0.0, 2.0].map(|along| (of, along)));
    for (of, along) in cases {
        let view = view_of_ball(beta(of), along);
        let image = renderers.hits(method, &scene, &view).expect("it is drawn");
        has_outline(&image, &view, reach_px, &format!("{method}, beta {of}, along {along}"));
    }
}

fn has_outline(image: &HitImage, view: &View, reach_px: f64, context: &str) {
    let (centre, radius) = BALL;
    let k = radius / centre[1].hypot(centre[2]);
    let chart = Chart::new(view);
    let middle = middle_of_ball(view);
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for (i, hit) in image.hits.iter().enumerate() {
        let off = chart.coordinates(pixel_centre(image, i)) - middle;
        // All along the outline its gradient is k long.
        let inside = (off.y.cos() - (1.0 - k * k).sqrt() * off.x.cosh()) / k * chart.px_per_unit;
        assert!(
            inside.abs() < reach_px || hit.is_some() == (inside > 0.0),
            "{context}: {inside} px inside at {off}"
        );
        if hit.is_some() {
            (low, high) = (low.min(off), high.max(off));
        }
    }
    // From the first pixel's edge to the last one's.
    let size = (high - low) * chart.px_per_unit + 1.0;
    let expected = 2.0 * DVec2::new(k.atanh(), k.asin()) * chart.px_per_unit;
    assert!(expected.min_element() > 80.0, "{context}: {expected} px are too few to judge by");
    assert!((size - expected).abs().max_element() <= 1.0, "{context}: {size} px for {expected}");
}

/// Speeds, and by how many columns each is to move the picture.
const SLIDES: [(f64, usize); 4] = [(0.3, 90), (0.9, 370), (0.99, 450), (0.99999, 800)];

/// The comparison of a picture with the resting one, moved back by the rapidity.
#[derive(Debug, Clone, Copy, Default)]
pub struct Slid {
    /// Pixels that show a body.
    pub shown: usize,
    /// Pixels of these, and of others, that show another body than at rest.
    pub differing: usize,
    /// The largest distance between the points of one body that the other pixels show, on each body.
    pub farthest: f64,
}

/// Compares the scene in motion with the scene at rest from the same event, as `method` draws it; the
/// reference decides whether a differing pixel is within `reach_px` of an outline.
pub fn slid(renderers: &mut Renderers, method: Method, reach_px: f64) -> Slid {
    let scene = PreparedScene::moving(&still_life());
    let mut all = Slid::default();
    let cases = SLIDES.into_iter().flat_map(|slide| [-0.5, 0.0, 0.4].map(|time| (slide, time)));
    for ((of, columns), time) in cases {
        let views = slid_views(beta(of), columns, time);
        let [moving, resting] = views.map(|view| renderers.hits(method, &scene, &view).expect("it is drawn"));
        let width = moving.size[0] as usize;
        let before = all.shown;
        for (i, hit) in moving.hits.iter().enumerate().filter(|(i, _)| i % width + columns < width) {
            let at_rest = resting.hits[i + columns];
            all.shown += usize::from(hit.is_some());
            let bodies = [*hit, at_rest].map(|hit| hit.map(|hit| hit.body));
            if bodies[0] != bodies[1] {
                all.differing += 1;
                let near = bodies_around(&scene, &views[0], pixel_centre(&moving, i), reach_px);
                assert!(
                    bodies.iter().all(|body| near.contains(body)),
                    "{method}, beta {of} T {time}: {bodies:?} at {}",
                    pixel_centre(&moving, i)
                );
            } else if let (Some(hit), Some(at_rest)) = (hit, at_rest) {
                all.farthest = all.farthest.max(hit.rest_position.distance(at_rest.rest_position));
            }
        }
        assert!(all.shown > before + 1000, "{method}, beta {of} T {time}: too few pixels to judge by");
    }
    println!("{method}: {all:?}");
    all
}

/// The bodies that the reference shows this far from `place`, and there.
#[must_use]
pub fn bodies_around(scene: &PreparedScene, view: &View, place: DVec2, reach_px: f64) -> Vec<Option<usize>> {
    let turned = |k: u32| DVec2::from_angle(std::f64::consts::TAU * f64::from(k) / 16.0);
    let places = (0..16).map(|k| place + turned(k) * reach_px).chain([place]);
    let body =
        |place: DVec2| scene.first_hit(view, view.camera.line_of_sight(place.to_array())).map(|hit| hit.body);
    places.map(body).collect()
}

/// Views of the moving scene, and of the same at rest from the same event, in which eta is this many columns.
fn slid_views(speed: Speed, columns: usize, time: f64) -> [View; 2] {
    let size = [1200, 400];
    let eta = rapidity(&speed);
    let half_width = 0.5 * f64::from(size[0]) * eta / columns as f64;
    // Where the eye's event is along x, in the rest frame.
    let event = -speed.gamma() * speed.beta() * time;
    let aperture = Aperture { x: event, y: 0.0, z: 0.0 };
    let [x, y, z] = FOLLOWED;
    // At rest as far on the right as on the left in motion.
    let rho = y.hypot(z);
    let u = ((x - event) / rho).asinh() - 0.5 * eta;
    let gaze = Gaze::along([rho * u.sinh(), y, z]);
    let camera = Camera::new(Aperture::default(), gaze, 2.0 * half_width.sinh().atan(), size);
    let camera = Camera { projection: Projection::Mercator { right: DVec3::X, shift: 0.0 }, ..camera };
    let moving = View { camera, speed, observation_time: time, geometry: Geometry::Seen };
    let resting = View {
        camera: Camera { aperture, ..camera },
        speed: Speed::REST,
        observation_time: speed.gamma() * time,
        geometry: Geometry::Seen,
    };
    [moving, resting]
}
