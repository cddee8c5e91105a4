//! The outline of what a scene is about, as one or several apertures see it, and the gaze and field of view
//! that hold all of it: `picture/sight/` works it out.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;
use relativity_core::math::{atan, sin_cos, sinh, tan};

use super::mercator::{MOST_ASIDE, Mercator};
use super::{Axes, Camera, Gauge, Gaze, Projection, held};

/// The part of the picture that is left free on each side of what is framed.
const MARGIN: f64 = 0.1;
/// Narrowest horizontal field of view that frames, radians: something small or far is shown with what is
/// around it.
const NARROWEST: f64 = 42.0 * DEGREE;
/// Unless that would leave it less than this part of the picture: then the view is narrower.
const SMALLEST_SHARE: f64 = 0.1;
/// Narrowest field of view of all, radians: what is still further off is a speck.
const NARROWEST_OF_ALL: f64 = 2.0 * DEGREE;
/// Widest horizontal field of view that frames in flat pictures, radians. What reaches further is cropped.
const WIDEST: f64 = 150.0 * DEGREE;
/// Widest horizontal field of view that frames in conformal pictures, radians: u from -5.4 to 5.4.
const WIDEST_CONFORMAL: f64 = 179.5 * DEGREE;
const DEGREE: f64 = std::f64::consts::PI / 180.0;
/// Tangent that replaces all larger ones.
const FAR_OUT: f64 = 1e6;

/// The outline of a scene's subject ([`PreparedScene::subject`](crate::PreparedScene::subject)), from one or
/// several parallel apertures.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// Balls at rest on the ground, each from its aperture, that look like balls around its bodies.
    pub(crate) balls: Vec<Ball>,
    /// Whether an aperture is inside one of these, or as good as inside.
    pub(crate) surrounds: bool,
}

/// The gaze that has an outline in the middle of the picture, both ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Framing {
    /// Gaze with the outline in the middle.
    pub gaze: Gaze,
    /// The reach of the outline from there, across and up, focal lengths (in conformal pictures u and
    /// radians).
    reach: [f64; 2],
    lies: Lies,
}

/// The place of an outline in the pictures of both eyes, where these depend on the line between them.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Lies {
    /// Pictures are across the gaze, and do not depend on that line.
    Alone,
    /// In pictures parallel to that line.
    Sheared(ShearedOutline),
    /// The outline lies in conformal pictures.
    Slid(Slid),
}

/// The place of an outline in both eyes' conformal pictures.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Slid {
    /// `right` along the baseline, and as much above the outline as below.
    axes: Axes,
    /// Between which u it lies for the left eye and for the right one.
    across: [Range; 2],
    /// The reach up and down, radians.
    up: f64,
}

/// A range from its least to its greatest number.
pub(crate) type Range = [f64; 2];

/// The place of an outline in both eyes' pictures, parallel to the baseline.
#[derive(Debug, Clone, Copy, PartialEq)]
struct ShearedOutline {
    /// Axes of pictures parallel to the baseline.
    axes: Axes,
    /// Between which angles to the right of their axis it lies, for the left eye and for the right one.
    across: [Range; 2],
    /// Reach up or down, as a tangent, in pictures turned by `turn` to the right of the axes.
    up: f64,
    turn: f64,
}

/// A ball, from the aperture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ball {
    pub centre: DVec3,
    pub radius: f64,
}

impl Outline {
    /// Whether nothing of it is in the picture of a `camera` at its apertures, taking each body for the ball
    /// around it.
    #[must_use]
    pub fn is_out_of(&self, camera: &Camera) -> bool {
        let is_in = |ball: &Ball| match camera.mercator() {
            Some(mercator) => ball.is_in_conformal(&mercator, camera.size),
            None => ball.is_in_flat(camera),
        };
        !self.surrounds && !self.balls.iter().any(is_in)
    }
}

impl Ball {
    fn is_in_conformal(&self, mercator: &Mercator, size: [u32; 2]) -> bool {
        let [right, bottom] = size.map(f64::from);
        let [low, high] = [[0.0, bottom], [right, 0.0]].map(|place| mercator.coordinates_at(place));
        mercator.around_ball(self.centre, self.radius).is_none_or(|patch| patch.meets(low, high))
    }

    fn is_in_flat(&self, camera: &Camera) -> bool {
        let Gauge { right, up, forward, .. } = camera.gauge();
        // A picture of half the sky has no edges but that.
        let is_flat = !matches!(camera.projection, Projection::Vr180 { .. });
        let half_width = camera.half_width();
        let half_height = half_width * f64::from(camera.size[1]) / f64::from(camera.size[0]);
        let inside = |side: DVec3, half: f64| {
            // In front of the picture's edges, planes through the aperture, or by less than the radius behind
            // them.
            [side, -side].into_iter().all(|side| {
                let inwards = forward * half - side;
                self.centre.dot(inwards) >= -self.radius * inwards.length()
            })
        };
        let is_in_picture = || inside(right, half_width) && inside(up, half_height);
        self.centre.dot(forward) > -self.radius && (!is_flat || is_in_picture())
    }
}

impl Framing {
    /// Returns the framing of an outline that reaches as far as these angles across and up from `gaze`,
    /// between planes through the level and upright lines of a picture across it.
    pub(crate) fn level(gaze: Gaze, reach: [f64; 2]) -> Self {
        let tangent = |reach: f64| if reach < 0.5 * WIDEST { tan(reach) } else { f64::INFINITY };
        Self { gaze, reach: reach.map(tangent), lies: Lies::Alone }
    }

    /// Frames what lies between these u to the right in conformal pictures with these `axes`, for the left
    /// and for the right eye, and reaches this far up and down, radians.
    pub(crate) fn slid(axes: Axes, across: [Range; 2], up: f64) -> Self {
        let lies = Lies::Slid(Slid { axes, across, up });
        Self { gaze: Gaze::STRAIGHT_AHEAD, reach: [0.0; 2], lies }.shifted([0.0; 2])
    }

    /// Returns the framing of an outline between these angles to the right of the forward axis of `axes`,
    /// parallel to the baseline, for the left and for the right eye. `up` gives its reach up and down from
    /// the axes of a picture.
    pub(crate) fn sheared(axes: Axes, across: [Range; 2], up: impl Fn(&Axes) -> Range) -> Self {
        let turn = turn(across, [0.0; 2]);
        let up = up(&axes.turned(turn)).map(|up| tangent(up).abs());
        let lies = Lies::Sheared(ShearedOutline { axes, across, up: up[0].max(up[1]), turn });
        Self { gaze: Gaze::STRAIGHT_AHEAD, reach: [0.0; 2], lies }.shifted([0.0; 2])
    }

    /// Returns the outline in pictures of the left and of the right eye with these image shifts
    /// ([`Projection::Parallel`]): the gaze turns along the rows alone, so that shifts made for
    /// [`Self::gaze`] are those for the new one, as good as (where that turns the pictures). What both
    /// pictures show of it is in the middle of them together.
    #[must_use]
    pub fn shifted(&self, shifts: [f64; 2]) -> Self {
        match self.lies {
            Lies::Alone => *self,
            Lies::Sheared(sheared) => self.sheared_by(sheared, shifts),
            Lies::Slid(Slid { axes, across: [left, right], up }) => {
                let least = (left[0] + shifts[0]).min(right[0] + shifts[1]);
                let most = (left[1] + shifts[0]).max(right[1] + shifts[1]);
                let [least, most] = [least, most].map(|aside| aside.clamp(-MOST_ASIDE, MOST_ASIDE));
                let middle = 0.5 * (least + most);
                let gaze = Gaze::along((axes.forward + axes.right * sinh(middle)).to_array());
                Self { gaze, reach: [0.5 * (most - least), up], ..*self }
            }
        }
    }

    fn sheared_by(&self, sheared: ShearedOutline, shifts: [f64; 2]) -> Self {
        let ShearedOutline { axes, across, up, turn: known } = sheared;
        let turn = turn(across, shifts);
        let axes = axes.turned(turn);
        let [low, high] = shown(across, shifts, turn);
        let slant = held(0.5 * (low + high));
        let gaze = Gaze::along((axes.forward + axes.right * slant).to_array());
        // A height is over the distance along the axis, which turned by so much.
        let nearer =
            |angle: &f64| (sin_cos(angle - known).1 / sin_cos(angle - turn).1.max(1.0 / FAR_OUT)).max(0.0);
        let nearest = across.as_flattened().iter().map(nearer).fold(0.0, f64::max);
        Self { gaze, reach: [(high - slant).max(slant - low), up * nearest], ..*self }
    }

    /// Horizontal field of view that holds the outline with a margin, radians, in a picture of this `size`
    /// (width and height): 42 to 150 degrees (179.5 in conformal pictures), or down to 2 where the outline
    /// would fill less than a tenth of the picture.
    #[must_use]
    pub fn horizontal_fov(&self, size: [u32; 2]) -> f64 {
        let [width, height] = size.map(f64::from);
        let [across, up] = self.reach;
        let outline = across.max(up * width / height);
        let fov = |share: f64| self.fov_of(outline / share);
        let narrowest = fov(SMALLEST_SHARE).clamp(NARROWEST_OF_ALL, NARROWEST);
        fov(1.0 - 2.0 * MARGIN).clamp(narrowest, self.widest())
    }

    /// Horizontal field of view in which the outline has this `share` of the height of a picture of this
    /// `size`, radians, as far as that can be.
    #[must_use]
    pub fn fov_by_height(&self, size: [u32; 2], share: f64) -> f64 {
        let [width, height] = size.map(f64::from);
        let [_, up] = self.reach;
        self.fov_of(up * width / height / share).min(self.widest())
    }

    /// Returns the outline with what conformal pictures show seen once more, slid this far along +x as the
    /// resting picture of what moves is; that of flat pictures stays.
    #[must_use]
    pub fn and_slid(&self, along_x: f64) -> Self {
        let Lies::Slid(Slid { axes, across, up }) = self.lies else { return *self };
        let slide = along_x * axes.right.x;
        let both = |[low, high]: Range| [low.min(low + slide), high.max(high + slide)];
        Self::slid(axes, across.map(both), up)
    }

    /// The field of view of pictures that reach this far to either side, focal lengths.
    fn fov_of(&self, half_width: f64) -> f64 {
        2.0 * atan(if self.is_conformal() { sinh(half_width) } else { half_width })
    }

    const fn widest(&self) -> f64 {
        if self.is_conformal() { WIDEST_CONFORMAL } else { WIDEST }
    }

    const fn is_conformal(&self) -> bool {
        matches!(self.lies, Lies::Slid(_))
    }
}

/// Between which tangents what lies between the angles `across` is, in the shifted pictures of both eyes
/// taken together, turned by an angle to the right.
fn shown(across: [Range; 2], shifts: [f64; 2], turn: f64) -> Range {
    let [left, right] = across.map(|range| range.map(|angle| tangent(angle - turn)));
    [(left[0] + shifts[0]).min(right[0] + shifts[1]), (left[1] + shifts[0]).max(right[1] + shifts[1])]
}

/// Returns the angle by which pictures turn to the right, so that the middle does not slant too far.
fn turn(across: [Range; 2], shifts: [f64; 2]) -> f64 {
    let slant = |turn: f64| shown(across, shifts, turn).into_iter().sum::<f64>() * 0.5;
    let held_at = held(slant(0.0));
    if held_at == slant(0.0) {
        return 0.0;
    }
    // Turned by a right angle nothing is on that side.
    let [mut low, mut high] = [0.0, FRAC_PI_2.copysign(held_at)];
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        let is_too_little = (slant(middle) - held_at) * held_at > 0.0;
        *(if is_too_little { &mut low } else { &mut high }) = middle;
    }
    0.5 * (low + high)
}

/// Number of bisections that find an angle to the last digit.
const BISECTIONS: u32 = 56;

fn tangent(angle: f64) -> f64 {
    if angle.abs() < FRAC_PI_2 { tan(angle).clamp(-FAR_OUT, FAR_OUT) } else { FAR_OUT.copysign(angle) }
}
