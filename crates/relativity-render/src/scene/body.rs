//! Bodies, which a scene consists of: shapes, the light that they emit, and their turning.

use std::sync::Arc;

use glam::{DQuat, DVec3};

use crate::colour::paint::Paint;
use crate::geometry::shape::Shape;
use crate::geometry::shape::strokes::{Onlooker, Path, Stroke};
use crate::geometry::triangles::Triangles;
use crate::kinematics::spin::Spin;

/// The light that a body emits, alike in all directions in its rest frame.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Emission {
    /// Light of one wavelength, nm, above 0.
    Wavelength(f64),
    /// The light of a lamp that glows as a black body of this temperature, K, above 0.
    Glowing(f64),
    /// Daylight, which this paint reflects.
    Painted(Paint),
}

impl Emission {
    /// White light: daylight, all of which is reflected.
    pub const WHITE: Self = Self::Painted(Paint::WHITE);

    /// Returns the wavelength in the rest frame, nm; `None` for light of many.
    #[must_use]
    pub const fn wavelength_nm(self) -> Option<f64> {
        match self {
            Self::Wavelength(nm) => Some(nm),
            Self::Glowing(_) | Self::Painted(_) => None,
        }
    }
}

/// A pattern on a body. The own z axis of a tube (from `from` to `to`), of a cylinder and of a ring is its
/// axis; a ball has the axes of the rest frame, a box its own.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Pattern {
    /// No pattern.
    #[default]
    Plain,
    /// The faces of a die on a box: 1 at the end of its x axis, 2 of y, 3 of z; opposite faces sum to 7.
    /// Plain on all others.
    Faces,
    /// Meridians around the axis, and parallels across it. On the side of a tube or cylinder parallels follow
    /// from its beginning at as long an arc, on its ends and on a ring's tube as well. Those at multiples of
    /// 90 degrees are twice as wide. Plain on a box.
    Graticule {
        /// From one line to the next, degrees, a divisor of 90.
        step_degrees: f64,
    },
    /// Squares, light and dark in turn. On a box they count from its lowest corner; along a tube or cylinder
    /// from its beginning, and around it there are as many as come closest to `step`, an even number, as
    /// around a ball or ring (where they are equal parts of both circles).
    Chequer {
        /// Side of a square, above 0.
        step: f64,
    },
    /// Bands across the z axis, light and dark in turn: from the beginning of a tube or cylinder, or a ball's
    /// middle. On a box they lie across its x axis, from its low end; on a ring along its middle circle, from
    /// its own x axis.
    Stripes {
        /// Width of a band, above 0.
        step: f64,
    },
}

/// A shape, and the light it sends.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Body {
    /// Place and form of the body; of a model, the box around its triangles.
    pub shape: Shape,
    /// Light that it emits in its rest frame.
    pub emission: Emission,
    /// Brightness beside other bodies, above 0 and at most 1.
    pub brightness: f64,
    /// Pattern on its surface.
    pub pattern: Pattern,
    /// Turning of the body within its group; `None` if it does not turn there.
    pub spin: Option<Spin>,
    /// Triangles of a model, which take the place of the box's own surface. They carry no pattern, and their
    /// light is [`Emission::WHITE`].
    #[cfg_attr(feature = "serde", serde(with = "crate::geometry::triangles::shared"))]
    pub triangles: Option<Arc<Triangles>>,
}

impl Body {
    /// A plain body of this `shape` and `rest_wavelength_nm`, above 0.
    #[must_use]
    pub const fn new(shape: Shape, rest_wavelength_nm: f64) -> Self {
        Self::of_light(shape, Emission::Wavelength(rest_wavelength_nm))
    }

    /// A plain white body of this `shape`.
    #[must_use]
    pub const fn white(shape: Shape) -> Self {
        Self::of_light(shape, Emission::WHITE)
    }

    const fn of_light(shape: Shape, emission: Emission) -> Self {
        Self { shape, emission, brightness: 1.0, pattern: Pattern::Plain, spin: None, triangles: None }
    }

    /// A model of triangles, where they were given.
    #[must_use]
    pub fn of_triangles(triangles: Arc<Triangles>) -> Self {
        let (centre, half) = (triangles.middle().to_array(), triangles.half().to_array());
        let shape = Shape::Box { centre, half, turn: DQuat::IDENTITY.to_array() };
        Self { triangles: Some(triangles), ..Self::white(shape) }
    }

    /// The body, turning so.
    #[must_use]
    pub fn turning(self, spin: Spin) -> Self {
        Self { spin: Some(spin), ..self }
    }

    /// Returns the turning of the body, if that changes the place of its surface.
    #[must_use]
    pub fn displacing_spin(&self) -> Option<Spin> {
        self.spin.filter(|spin| !self.shape.is_round_about(spin))
    }

    /// Returns the shape that outlines the body: of a model that turns, the cylinder about its axle that it
    /// never leaves.
    #[must_use]
    pub fn outline(&self) -> Shape {
        match (&self.triangles, self.spin, self.shape) {
            (Some(_), Some(spin), Shape::Box { centre: [_, y, _], half, turn }) => {
                let width = (DQuat::from_array(turn).conjugate() * DVec3::Y).abs().dot(half.into());
                let [x, _, z] = spin.hub;
                Shape::Cylinder { from: [x, y - width, z], to: [x, y + width, z], radius: spin.radius }
            }
            _ => self.shape,
        }
    }

    /// Returns the strokes that it is drawn with, whoever looks: of a model its sharp edges, and of one that
    /// turns the cylinder as well that it never leaves.
    #[must_use]
    pub fn strokes(&self) -> Vec<Stroke> {
        let Some(model) = self.model() else { return self.shape.strokes() };
        let around = self.spin.map_or_else(Vec::new, |_| self.outline().strokes());
        around.into_iter().chain(model.edges(model.triangles.sharp_edges())).collect()
    }

    /// Returns the strokes that it is drawn with besides, where its surface turns away from whoever looks at
    /// the middle of it: around a ball, and along a model that does not turn.
    #[must_use]
    pub fn silhouette(&self, onlooker_at: impl Fn(DVec3) -> Onlooker) -> Vec<Stroke> {
        match self.model() {
            Some(_) if self.spin.is_some() => Vec::new(),
            Some(model) => {
                let onlooker = onlooker_at(model.middle).in_axes(model.middle, model.turn);
                model.edges(model.triangles.turning_edges(onlooker)).collect()
            }
            None => self.shape.silhouette(onlooker_at).map(Stroke::edge).into_iter().collect(),
        }
    }

    /// Returns the triangles of the body with their place at rest; `None` unless it is a model.
    fn model(&self) -> Option<Model<'_>> {
        let Shape::Box { centre, turn, .. } = self.shape else { return None };
        let triangles = self.triangles.as_deref()?;
        Some(Model { triangles, middle: centre.into(), turn: DQuat::from_array(turn) })
    }

    /// Returns the point of it with the largest x.
    #[must_use]
    pub fn forward_most(&self) -> DVec3 {
        let Some(model) = self.model() else { return self.shape.forward_most() };
        let places = model.triangles.corners().map(|corner| model.place(corner));
        places.max_by(|a, b| a.x.total_cmp(&b.x)).unwrap_or(model.middle)
    }

    /// The body moved by `offset`.
    #[must_use]
    pub fn moved(self, offset: [f64; 3]) -> Self {
        let spin = self.spin.map(|spin| spin.moved(offset));
        Self { shape: self.shape.moved(offset), spin, ..self }
    }
}

/// The triangles of a model, with the middle and the turn of its box at rest.
#[derive(Debug, Clone, Copy)]
struct Model<'a> {
    triangles: &'a Triangles,
    middle: DVec3,
    turn: DQuat,
}

impl Model<'_> {
    /// The place at rest of a place in the axes of the box.
    fn place(&self, in_box: DVec3) -> DVec3 {
        self.middle + self.turn * in_box
    }

    /// The edges between these places in the axes of the box.
    fn edges(&self, ends: impl Iterator<Item = [DVec3; 2]>) -> impl Iterator<Item = Stroke> {
        ends.map(|ends| {
            let [from, to] = ends.map(|end| self.place(end));
            Stroke::edge(Path::Line { from, to })
        })
    }
}
