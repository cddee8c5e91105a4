//! Patterns on bodies: they show how a body is turned, and are rulers on it.
//!
//! A pattern multiplies the light of a body by a factor in (0, 1], its mark. That follows from where on the
//! body a ray meets it, in the body's own axes, and so is the same in every frame. Marks are averaged over
//! what a pixel covers of the surface, so that lines thinner than a pixel fade instead of breaking up.
//! `shaders/pattern.wgsl` repeats this with the same constants.

mod chart;
pub(crate) mod coverage;
pub(crate) mod die;

use std::f64::consts::FRAC_PI_2;

use glam::{DQuat, DVec3};

use crate::geometry::shape::PreparedShape;
use crate::scene::body::Pattern;
use crate::view::Geometry;
use crate::view::effects::{Constant, number};
use chart::SurfacePlace;
pub(crate) use coverage::SampleShifts;
use coverage::{line, wave};

/// Share of the light that is left where a pattern is dark.
pub(crate) const DARK: f64 = 0.2;
/// Half the width of a graticule's line, in steps.
pub(crate) const LINE_REACH: f64 = 0.035;
/// Depth below the surface at which stripes and squares are looked up, in steps: an end lies where one of
/// them does.
pub(crate) const NUDGE: f64 = 1e-3;

/// Values of the shaders' constants for a scene shown in this `geometry`.
pub(crate) fn constants(has_patterns: bool, geometry: Geometry) -> [Constant; 11] {
    [
        ("PATTERNS", number(has_patterns)),
        ("ONE_CONE", number(geometry == Geometry::OneCone)),
        ("DARK", DARK),
        ("LINE_REACH", LINE_REACH),
        ("PIP_RADIUS", die::PIP_RADIUS),
        ("PIP_PLACE", die::PIP_PLACE),
        ("RIM", die::RIM),
        ("LEAST_COVERED", coverage::COVERED[0]),
        ("MOST_COVERED", coverage::COVERED[1]),
        ("NUDGE", NUDGE),
        ("GRAZING", coverage::GRAZING),
    ]
}

/// A pattern prepared for one body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Marking {
    ruling: Ruling,
    form: PreparedShape,
    /// From the body's own axes to those of the rest frame.
    turn: DQuat,
    /// From one line or square to the next: along the axis, a length; around it, radians.
    along_step: f64,
    around_step: f64,
}

/// The rulings of patterns, as the shaders number them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ruling {
    Faces = 1,
    Graticule = 2,
    Chequer = 3,
    Stripes = 4,
}

impl Marking {
    /// Returns the marking of `pattern` on this `form`, with this `turn`; `None` where that leaves a body
    /// plain.
    pub fn new(pattern: Pattern, form: PreparedShape, turn: DQuat) -> Option<Self> {
        let (ruling, [along_step, around_step]) = match (pattern, form) {
            (Pattern::Faces, PreparedShape::Box(_)) => (Ruling::Faces, [1.0; 2]),
            (Pattern::Plain | Pattern::Faces, _) | (Pattern::Graticule { .. }, PreparedShape::Box(_)) => {
                return None;
            }
            (Pattern::Graticule { step_degrees }, form) => {
                let angle = step_degrees.to_radians();
                (Ruling::Graticule, [angle * form.answers().parallels_radius(), angle])
            }
            (Pattern::Chequer { step }, form) => (Ruling::Chequer, form.answers().squares(step)),
            (Pattern::Stripes { step }, _) => (Ruling::Stripes, [step, 1.0]),
        };
        Some(Self { ruling, form, turn, along_step, around_step })
    }

    /// For the shaders: its number among rulings, and its steps.
    pub fn packed(&self) -> [f32; 3] {
        [f32::from(self.ruling as u8), self.along_step as f32, self.around_step as f32]
    }

    /// Share of the light, in (0, 1], that is left at `place` (from the body's middle) with this `normal`,
    /// both in the rest frame, on average over what is `covered`.
    pub fn mark(&self, place: DVec3, normal: DVec3, covered: SampleShifts) -> f64 {
        let to_own = self.turn.conjugate();
        let [place, normal] = [place, normal].map(|v| to_own * v);
        1.0 - (1.0 - DARK) * self.darkness(place, normal, covered.turned(to_own))
    }

    /// Share of what is `covered` that is dark; in the body's own axes.
    fn darkness(&self, place: DVec3, normal: DVec3, covered: SampleShifts) -> f64 {
        if let PreparedShape::Box(cuboid) = self.form {
            return self.darkness_of_box(cuboid.half, place, normal, covered);
        }
        let chart = SurfacePlace::new(&self.form, place, normal);
        let SurfacePlace { along, around, off_axis, .. } = chart;
        let [along_step, around_step] = [self.along_step, self.around_step];
        let along_covered = covered.range(chart.along_gradient) / along_step;
        let around_covered = covered.range(chart.around_gradient) / around_step;
        match self.ruling {
            Ruling::Faces => 0.0,
            Ruling::Graticule => {
                let quarter = FRAC_PI_2 / around_step;
                let parallels = line(along / along_step, LINE_REACH, quarter, along_covered);
                let width = LINE_REACH * along_step / (off_axis * around_step).max(1e-30);
                parallels.max(line(around / around_step, width, quarter, around_covered))
            }
            Ruling::Chequer => {
                let along = wave(along / along_step, along_covered);
                0.5 - 0.5 * along * wave(around / around_step, around_covered)
            }
            Ruling::Stripes => {
                let form = self.form.answers();
                let (level, gradient) = match form.stripes_radius() {
                    Some(radius) => (radius * around, chart.around_gradient * radius),
                    None => self.level(place, normal, form.half_length(), DVec3::Z),
                };
                0.5 - 0.5 * wave(level / along_step, covered.range(gradient) / along_step)
            }
        }
    }

    /// Returns the distance along `axis` of `place` from the low end, just below the surface; and the
    /// gradient of that.
    fn level(&self, place: DVec3, normal: DVec3, half_length: f64, axis: DVec3) -> (f64, DVec3) {
        let below = place - normal * (NUDGE * self.along_step);
        (below.dot(axis) + half_length, axis)
    }

    fn darkness_of_box(&self, half: DVec3, place: DVec3, normal: DVec3, covered: SampleShifts) -> f64 {
        let wave_along = |axis: DVec3| {
            let (level, gradient) = self.level(place, normal, half.dot(axis), axis);
            wave(level / self.along_step, covered.range(gradient) / self.along_step)
        };
        match self.ruling {
            Ruling::Faces => die::face(half, place, normal, covered),
            Ruling::Graticule => 0.0,
            Ruling::Chequer => 0.5 - 0.5 * wave_along(DVec3::X) * wave_along(DVec3::Y) * wave_along(DVec3::Z),
            Ruling::Stripes => 0.5 - 0.5 * wave_along(DVec3::X),
        }
    }
}
