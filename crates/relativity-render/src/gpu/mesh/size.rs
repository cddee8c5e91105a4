//! Bounds on the size of bodies in a picture, from which it follows how fine a grid each of them needs.

use glam::DVec3;
use relativity_core::math::hypot;

use crate::camera::axes::Axes;
use crate::geometry::capsule::Capsule;
use crate::view::group_view::GroupView;

/// Tells how large the bodies of a group are in a picture.
pub struct Sizes<'a> {
    view: &'a GroupView,
    /// The greatest number of pixels that a radian has anywhere in the picture, or in a conformal one a unit
    /// of u.
    px_per_radian: f64,
    /// The axes of a conformal picture.
    axes: Option<Axes>,
}

impl<'a> Sizes<'a> {
    /// The sizes of the group that `view` is of.
    pub fn new(view: &'a GroupView) -> Self {
        let camera = &view.camera;
        let is_conformal = camera.projection.is_conformal();
        let half_width = camera.half_width();
        let half_height = half_width * f64::from(camera.size[1]) / f64::from(camera.size[0]);
        let aside = hypot(camera.through_middle().length(), half_width);
        // Towards the corners of a flat picture an angle is longer by the square of the secant; a conformal
        // one shows all of its columns alike.
        let stretch = if is_conformal { 1.0 } else { aside * aside + half_height * half_height };
        let axes = is_conformal.then(|| camera.axes());
        Self { view, px_per_radian: camera.focal_length_px() * stretch, axes }
    }

    /// Returns the greatest length in the picture, pixels, of a unit of length of what is inside `ball`:
    /// infinite where the picture has no bound for it.
    ///
    /// Across the motion everything is seen where it is. Along it what is farther ahead is seen farther
    /// ahead, and what is farther from the line of motion through the eye farther behind: so the ball is seen
    /// within the ends of the rectangle that it sweeps as it is turned about that line, and nothing in it is
    /// longer than at one of that rectangle's corners, gamma (1 - beta cos) times its own length.
    pub fn px_per_length(&self, ball: &Capsule) -> f64 {
        let Capsule { from: center, radius, .. } = *ball;
        let view = self.view;
        let speed = &view.velocity.speed;
        let seen = |along_motion: DVec3| {
            let rest = view.origin + view.velocity.group_from_motion(along_motion);
            view.apparent_position(rest).map(|place| view.velocity.motion_from_camera(place))
        };
        let middle = view.along_motion_from_camera(center);
        let off_line = hypot(middle.y, middle.z);
        let outwards = DVec3::new(0.0, middle.y, middle.z) / off_line;
        let outwards = if outwards.is_finite() { outwards } else { DVec3::Y };
        let (mut low, mut high, mut longest) = (f64::INFINITY, f64::NEG_INFINITY, 1.0_f64);
        // From the eye to where the middle between both is.
        let mut aside = DVec3::ZERO;
        for off in [(off_line - radius).max(0.0), off_line + radius] {
            for x in [middle.x - radius, middle.x + radius] {
                let place = off * outwards;
                let Some(seen) = seen(DVec3 { x, ..place }) else { return f64::INFINITY };
                (low, high) = (low.min(seen.x), high.max(seen.x));
                longest = longest.max(speed.gamma() * (1.0 - speed.beta() * x / hypot(x, off)));
                aside = seen - place;
            }
        }
        let reach = hypot(0.5 * (high - low), radius);
        let middle = view.velocity.camera_from_motion(DVec3 { x: 0.5 * (low + high), ..middle + aside });
        let away = self
            .axes
            .map_or_else(|| middle.length(), |axes| hypot(middle.dot(axes.forward), middle.dot(axes.up)));
        let distance = away - reach;
        if distance > 0.0 { longest * self.px_per_radian / distance } else { f64::INFINITY }
    }
}
