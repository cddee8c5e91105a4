//! A head that is turned any way, as in front of a viewer's lenses: the line between the eyes turns with it,
//! and both look across that line.

use glam::{DMat3, DVec3};
use relativity_core::math::{asin, atan2, sin_cos};
use relativity_render::Gaze;
use relativity_render::camera::Axes;

use super::{LookSettings, MotionSettings, PictureSettings, Settings};
use crate::flags::FieldOfView;
use crate::flags::choices::{Compare, GazeChoice, Layout, ProjectionChoice, ZeroParallax};

/// The directions of a head: unit vectors across each other, along the axes of the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Head {
    /// From the left eye to the right one.
    pub right: DVec3,
    /// The direction that both eyes look in.
    pub forward: DVec3,
}

impl Head {
    /// Returns the level head that looks along `gaze`.
    #[must_use]
    pub fn level(gaze: Gaze) -> Self {
        let Axes { right, forward, .. } = gaze.axes();
        Self { right, forward }
    }

    /// Returns this head, turned to the left about the vertical by `angle`, radians.
    #[must_use]
    pub fn turned(self, angle: f64) -> Self {
        let (sine, cosine) = sin_cos(angle);
        let turn = DMat3::from_cols(DVec3::new(cosine, sine, 0.0), DVec3::new(-sine, cosine, 0.0), DVec3::Z);
        Self { right: turn * self.right, forward: turn * self.forward }
    }

    /// Returns the gaze of the head.
    #[must_use]
    pub fn gaze(&self) -> Gaze {
        Gaze::along(self.forward.to_array())
    }
}

impl Settings {
    /// Returns these settings for the pictures of a stereoscope before this `head`: flat, in parallel, each
    /// as wide as `fov` degrees.
    #[must_use]
    pub(crate) fn before_head(&self, head: &Head, fov: f64) -> Self {
        let DVec3 { x, y, z } = head.right;
        let (roll, turn) = (asin(z.clamp(-1.0, 1.0)).to_degrees(), atan2(y, x).to_degrees());
        Self {
            motion: MotionSettings { roll, turn, ..self.motion },
            look: LookSettings {
                compare: Compare::Off,
                gaze: GazeChoice::fixed_at(head.gaze()),
                fov: FieldOfView(Some(fov)),
                projection: ProjectionChoice::Parallel,
                zero_parallax: ZeroParallax::Infinity,
                ..self.look
            },
            picture: PictureSettings { layout: Layout::SideBySide, ..self.picture },
            ..self.clone()
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::flags::RideLegs;
    use crate::scene::Scene;
    use crate::settings::Subject;

    /// Every 15 degrees around and up to 75 degrees up and down, tilted by up to 80 degrees.
    fn heads() -> impl Iterator<Item = Head> {
        let angles =
            |most: i32, step| (-most..=most).step_by(step).map(|angle| f64::from(angle).to_radians());
        angles(180, 15).flat_map(move |azimuth| {
            angles(75, 25).flat_map(move |elevation| {
                angles(80, 40).map(move |tilt| {
                    let Axes { right, up, forward } = Gaze { azimuth, elevation }.axes();
                    let (sine, cosine) = sin_cos(tilt);
                    Head { right: right * cosine - up * sine, forward }
                })
            })
        })
    }

    #[test]
    fn both_pictures_are_across_the_gaze_with_their_rows_along_the_eyes_wherever_the_head_is_turned() {
        let scene = Scene::preset("street").expect("a preset");
        let prepared = scene.prepared();
        let subject = Subject { scene: &prepared, tracked: scene.track(None) };
        for is_riding in [false, true] {
            let mut settings = Settings::default();
            if is_riding {
                settings.ride.ride = RideLegs::from_legs(Vec::new()).expect("no legs");
            }
            for head in heads() {
                let views = settings.before_head(&head, 74.0).views(subject, 0.0, [400, 300]);
                let [left, right] = views.map(|view| view.camera);
                let middle = left.line_of_sight([200.0, 150.0]);
                assert!(middle.distance(head.forward) < 1e-9, "{head:?}: {middle}");
                let row = left.line_of_sight([400.0, 150.0]);
                let (sine, cosine) = sin_cos(37f64.to_radians());
                let expected = head.forward * cosine + head.right * sine;
                assert!(row.distance(expected) < 1e-9, "{head:?}: {row} for {expected}");
                assert!((right.off_middle - left.off_middle).distance(head.right * settings.motion.d) < 1e-9);
            }
        }
    }

    #[test]
    fn a_head_turns_about_the_vertical() {
        let head = Head::level(Gaze::STRAIGHT_AHEAD).turned(0.5 * PI);
        assert!(head.forward.distance(-DVec3::X) < 1e-12 && head.right.distance(DVec3::Y) < 1e-12);
        let Gaze { azimuth, elevation } =
            Head::level(Gaze { azimuth: 1.0, elevation: 0.4 }).turned(0.3).gaze();
        assert!((azimuth - 1.3).abs() < 1e-12 && (elevation - 0.4).abs() < 1e-12);
    }
}
