//! Bounds on where bodies are in a picture and on their size there, from which it follows which of them are
//! drawn, and how fine a grid each needs.

use glam::DVec3;
use relativity_core::math::hypot;

use crate::camera::axes::Axes;
use crate::geometry::capsule::Capsule;
use crate::view::Geometry;
use crate::view::group_view::GroupView;

/// Bounds on the bodies of a group in a picture.
pub struct Sizes<'a> {
    view: &'a GroupView,
    /// The greatest number of pixels that a radian has anywhere in the picture, or in a conformal one a unit
    /// of u.
    px_per_radian: f64,
    is_conformal: bool,
    axes: Axes,
    /// Unit vectors out of a flat picture: through its edges and behind the camera.
    outwards: [DVec3; 5],
    /// By how much a body may be seen as if it were elsewhere along the motion, and as if the camera were:
    /// rest frame, ground frame.
    shifts: [f64; 2],
}

/// A place of a body in the rest frame of its group.
#[derive(Debug, Clone, Copy)]
pub struct Whereabouts {
    /// A ball around the body.
    pub ball: Capsule,
    /// The least distance of the body from the camera's event.
    pub nearest: f64,
}

/// A bound on where a body appears.
struct Appearance {
    /// The middle of a ball around it, from the camera.
    middle: DVec3,
    reach: f64,
    /// The greatest length there of a unit of length of the body.
    longest: f64,
}

impl<'a> Sizes<'a> {
    /// The bounds of the group that `view` is of.
    pub fn new(view: &'a GroupView) -> Self {
        let camera = &view.camera;
        let is_conformal = camera.projection.is_conformal();
        let half_width = camera.half_width();
        let half_height = half_width * f64::from(camera.size[1]) / f64::from(camera.size[0]);
        let axes = camera.axes();
        let through_middle = camera.through_middle();
        let aside = hypot(through_middle.length(), half_width);
        // Towards the corners of a flat picture an angle is longer by the square of the secant; a conformal
        // one shows all of its columns alike.
        let stretch = if is_conformal { 1.0 } else { aside * aside + half_height * half_height };
        // The edge is `half` from the middle, a unit ahead.
        let edge = |outwards: DVec3, half: f64| {
            (outwards - (through_middle.dot(outwards) + half) * axes.forward).normalize()
        };
        let outwards = [
            edge(axes.right, half_width),
            edge(-axes.right, half_width),
            edge(axes.up, half_height),
            edge(-axes.up, half_height),
            -axes.forward,
        ];
        let speed = &view.velocity.speed;
        let shifts = match view.geometry {
            // Light takes at most the way between the eyes longer to one of them: of two places, twice that.
            Geometry::Published => {
                [2.0 * speed.beta() * speed.gamma() * view.published_separation().abs(), 0.0]
            }
            Geometry::OneCone => [0.0, camera.off_middle.length()],
            Geometry::Seen | Geometry::Contracted | Geometry::Rest => [0.0; 2],
        };
        Self { view, px_per_radian: camera.focal_length_px() * stretch, is_conformal, axes, outwards, shifts }
    }

    /// Whether what is inside `ball` is surely not in the picture, however near it is drawn a pixel wide.
    pub fn hides(&self, ball: &Capsule) -> bool {
        let Some(Appearance { middle, reach, .. }) = self.appearance(ball) else { return false };
        let pixel = (middle.length() + reach) / self.view.camera.focal_length_px();
        !self.is_conformal && self.outwards.iter().any(|outwards| middle.dot(*outwards) > reach + pixel)
    }

    /// Returns the greatest length in the picture, pixels, of a unit of length of the body: infinite where
    /// the picture has no bound for it.
    pub fn px_per_length(&self, body: &Whereabouts) -> f64 {
        let around = self.appearance(&body.ball).map_or(f64::INFINITY, |appearance| {
            let Appearance { middle, reach, longest } = appearance;
            let away = if self.is_conformal {
                hypot(middle.dot(self.axes.forward), middle.dot(self.axes.up))
            } else {
                middle.length()
            };
            self.px(longest, away - reach)
        });
        // A long body is nearer to the eye than it is long: then it counts how near it really is.
        let most = self.view.velocity.speed.head_on_doppler_factor();
        let nearest = (body.nearest - self.shifts[0]) / most - self.shifts[1];
        if self.is_conformal { around } else { around.min(self.px(most, nearest)) }
    }

    fn px(&self, length: f64, distance: f64) -> f64 {
        if distance > 0.0 { length * self.px_per_radian / distance } else { f64::INFINITY }
    }

    /// Returns a bound on where what is inside `ball` appears; `None` outside the domain of the core.
    ///
    /// Across the motion everything is seen where it is. Along it what is farther ahead is seen farther
    /// ahead, and what is farther from the line of motion through the eye farther behind: so the ball is seen
    /// within the ends of the rectangle that it sweeps as it is turned about that line, and nothing in it is
    /// longer than at one of that rectangle's corners, gamma (1 - beta cos) times its own length.
    fn appearance(&self, ball: &Capsule) -> Option<Appearance> {
        let Capsule { from: centre, radius, .. } = *ball;
        let view = self.view;
        let speed = &view.velocity.speed;
        let seen = |along_motion: DVec3| {
            let rest = view.origin + view.velocity.group_from_motion(along_motion);
            view.apparent_position(rest).map(|place| view.velocity.motion_from_camera(place))
        };
        let middle = view.along_motion_from_camera(centre);
        let off_line = hypot(middle.y, middle.z);
        let outwards = DVec3::new(0.0, middle.y, middle.z) / off_line;
        let outwards = if outwards.is_finite() { outwards } else { DVec3::Y };
        let (mut low, mut high, mut longest) = (f64::INFINITY, f64::NEG_INFINITY, 1.0_f64);
        // From the eye to where the middle between both is.
        let mut aside = DVec3::ZERO;
        let half_length = radius + self.shifts[0];
        for off in [(off_line - radius).max(0.0), off_line + radius] {
            for x in [middle.x - half_length, middle.x + half_length] {
                let place = off * outwards;
                let seen = seen(DVec3 { x, ..place })?;
                (low, high) = (low.min(seen.x), high.max(seen.x));
                longest = longest.max(speed.gamma() * (1.0 - speed.beta() * x / hypot(x, off)));
                aside = seen - place;
            }
        }
        let reach = hypot(0.5 * (high - low), radius);
        let middle = view.velocity.camera_from_motion(DVec3 { x: 0.5 * (low + high), ..middle + aside });
        Some(Appearance { middle, reach, longest })
    }
}
