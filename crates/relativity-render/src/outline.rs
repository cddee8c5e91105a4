//! The outline of what a scene is about, as one or several apertures see it, and the gaze and field of view that hold
//! all of it: `sight.rs` works it out.

use glam::DVec3;
use relativity_core::math::{atan, tan};

use crate::camera::{Camera, Gaze};

/// The part of the picture that is left free on each side of what is framed.
const MARGIN: f64 = 0.1;
/// Narrowest horizontal field of view that frames, radians: something small or far is shown with what is around it.
const NARROWEST: f64 = 42.0 * DEGREE;
/// Unless that would leave it less than this part of the picture: then the view is narrower.
const SMALLEST_SHARE: f64 = 0.1;
/// Narrowest field of view of all, radians: what is still further off is a speck.
const NARROWEST_OF_ALL: f64 = 2.0 * DEGREE;
/// Widest horizontal field of view that frames, radians. What reaches further is cropped.
const WIDEST: f64 = 150.0 * DEGREE;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// What a scene is about ([`PreparedScene::subject`](crate::PreparedScene::subject)), from one or several parallel apertures.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Balls at rest on the ground, each from its aperture, that look like balls around its bodies.
    pub(crate) balls: Vec<Ball>,
    /// Whether an aperture is inside one of these, or as good as inside.
    pub(crate) surrounds: bool,
    pub(crate) framing: Option<Framing>,
}

/// The gaze that has an outline in the middle of the picture, both ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Framing {
    /// It.
    pub gaze: Gaze,
    /// How far the outline reaches from there, radians: across and up, as angles between planes through the picture's
    /// upright and level lines.
    pub(crate) reach: [f64; 2],
}

/// A ball, from the aperture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ball {
    pub center: DVec3,
    pub radius: f64,
}

impl Outline {
    /// How to hold all of it in a picture; `None` where there is nothing.
    #[must_use]
    pub const fn framing(&self) -> Option<Framing> {
        self.framing
    }

    /// Whether nothing of it is in the picture of a `camera` at its apertures, taking each body for the ball around it.
    #[must_use]
    pub fn is_out_of(&self, camera: &Camera) -> bool {
        let axes = camera.gaze.axes();
        let half_width = tan(0.5 * camera.horizontal_fov);
        let half_height = half_width * f64::from(camera.size[1]) / f64::from(camera.size[0]);
        let is_in = |ball: &Ball| {
            let depth = ball.center.dot(axes.forward);
            let inside = |side: DVec3, half: f64| {
                // In front of the picture's edge, a plane through the aperture, or by less than the radius behind it.
                half * depth - ball.center.dot(side).abs() >= -ball.radius * (1.0 + half * half).sqrt()
            };
            depth > -ball.radius && inside(axes.right, half_width) && inside(axes.up, half_height)
        };
        !self.surrounds && !self.balls.iter().any(is_in)
    }
}

impl Framing {
    /// Horizontal field of view that holds the outline with a margin, radians, in a picture of this `size` (width and
    /// height): 42 to 150 degrees, or down to 2 where the outline would fill less than a tenth of the picture.
    #[must_use]
    pub fn horizontal_fov(&self, size: [u32; 2]) -> f64 {
        let [width, height] = size.map(f64::from);
        let [across, up] =
            self.reach.map(|reach| if reach < 0.5 * WIDEST { tan(reach) } else { f64::INFINITY });
        let outline = across.max(up * width / height);
        let fov = |share: f64| 2.0 * atan(outline / share);
        let narrowest = fov(SMALLEST_SHARE).clamp(NARROWEST_OF_ALL, NARROWEST);
        fov(1.0 - 2.0 * MARGIN).clamp(narrowest, WIDEST)
    }
}
