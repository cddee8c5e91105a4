//! A body prepared for every way to draw it: all of it that no view changes, worked out once per scene.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use glam::{DQuat, DVec3};

use super::body::{Body, Emission};
use super::pattern::Marking;
use crate::colour::paint::Paint;
use crate::geometry::block::Block;
use crate::geometry::capsule::Capsule;
use crate::geometry::extent::Extent;
use crate::geometry::intersect::Solid;
use crate::geometry::kind::Kind;
use crate::geometry::shape::Shape;
use crate::geometry::shape::questions::{PackedForm, PackedShape};
use crate::geometry::triangles::Triangles;
use crate::kinematics::spin::Spin;

/// A placed body.
#[derive(Debug, Clone, PartialEq)]
pub struct PreparedBody {
    /// Number of the body, in the order of all bodies.
    pub number: usize,
    /// The number of its group.
    pub group: usize,
    /// Light that the body emits in its rest frame.
    pub emission: Emission,
    /// The number of that among all of the scene.
    pub(crate) emission_number: u32,
    /// Brightness beside other bodies, above 0 and at most 1.
    pub brightness: f64,
    /// Kind of shape, which chooses the shaders.
    pub(crate) kind: Kind,
    /// Shape, placed at t' = 0, and the turn from its own axes to those of the rest frame.
    pub(crate) shape: Shape,
    pub(crate) turn: DQuat,
    /// Shape and turn for the shaders.
    pub(crate) placement: Placement,
    /// Whether its surface may coincide with another's.
    pub(crate) joint: Joint,
    /// The block that contains it, if it has one.
    pub(crate) block: Option<Box<Block>>,
    /// Range of the scene's capsules that contain it otherwise.
    pub(crate) capsules: Range<usize>,
    /// Pattern on the surface; `None` for a plain body.
    pub(crate) marking: Option<Box<Marking>>,
    /// Turning of the body within its group.
    pub spin: Option<Spin>,
    /// Whether turning changes where its surface is.
    pub(crate) is_turned: bool,
    /// Whether it is an earlier body of its group once more, in the same place: that one is seen.
    pub(crate) is_repeated: bool,
    /// Whether it is drawn by a pipeline that knows patterns.
    pub(crate) is_patterned: bool,
    /// Triangles in the box that is its shape.
    pub triangles: Option<Arc<Triangles>>,
}

/// The placement of a body, for the shaders.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    /// From the middle of its group: its centre, or one end of a tube; and its radius, of bodies with flat
    /// faces half their least length.
    pub place_radius: [f32; 4],
    /// The other end of a tube; a ring's unit axis and the radius of its middle circle; half the lengths of a
    /// box or a cylinder along its own axes, and how far a model that turns reaches from its axle.
    pub form: [f32; 4],
    /// Unit quaternion from its own axes to those of the rest frame.
    pub turn: [f32; 4],
}

/// Whether a body may have a rounded end, or all of a body that is no tube, in common with another: there the
/// first of them is seen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Joint {
    /// Whether the body shares an end at its true width.
    pub as_it_is: bool,
    /// Whether it shares an end where both are drawn a pixel wide: bodies about one centre, which are as wide
    /// there.
    pub widened: bool,
}

impl Placement {
    /// Returns the placement of `shape`, with this `turn`, in a group with this `middle`.
    #[must_use]
    pub fn new(shape: &Shape, turn: DQuat, middle: DVec3) -> Self {
        let PackedShape { place, radius, form } = shape.packed();
        let place_radius = packed(place - middle, radius);
        let form = match form {
            PackedForm::Place(place) => packed(place - middle, 0.0),
            PackedForm::Vector(vector, number) => packed(vector, number),
        };
        Self { place_radius, form, turn: turn.as_quat().to_array() }
    }
}

impl PreparedBody {
    /// The body of this `number`, in the group of that number, which has this `extent`; its capsules join the
    /// others.
    pub(crate) fn new(
        number: usize,
        group: usize,
        body: &Body,
        extent: &Extent,
        capsules: &mut Vec<Capsule>,
    ) -> Self {
        let turn = body.shape.turn();
        let first = capsules.len();
        let block = body.shape.block().map(Box::new);
        let marking = Marking::new(body.pattern, body.shape.about_centre().1, turn);
        if block.is_none() {
            capsules.extend(body.shape.capsules());
        }
        Self {
            number,
            group,
            emission: body.emission,
            emission_number: 0,
            brightness: body.brightness,
            kind: if body.triangles.is_some() { Kind::Model } else { body.shape.kind() },
            shape: body.shape,
            turn,
            placement: Placement::new(&body.shape, turn, extent.middle),
            joint: Joint::default(),
            block,
            capsules: first..capsules.len(),
            marking: marking.filter(|_| body.triangles.is_none()).map(Box::new),
            spin: body.spin,
            is_turned: body.displacing_spin().is_some(),
            is_repeated: false,
            is_patterned: false,
            triangles: body.triangles.clone(),
        }
    }

    /// Returns the number of the body for the shaders: floats hold integers up to 2^24.
    pub(crate) const fn index(&self) -> f32 {
        self.number as f32
    }

    /// Returns the pattern for the shaders: 0 for none, else its number, and its steps along and around.
    pub(crate) fn pattern(&self) -> [f32; 3] {
        self.marking.as_ref().map_or([0.0; 3], |marking| marking.packed())
    }

    /// The centres of the ends of a tube, or of another body, as bits.
    fn ends(&self) -> impl Iterator<Item = [u32; 3]> + use<> {
        let place = |[x, y, z, _]: [f32; 4]| [x, y, z].map(f32::to_bits);
        let first = place(self.placement.place_radius);
        let second = (self.kind == Kind::Tube).then(|| place(self.placement.form));
        [Some(first), second.filter(|second| *second != first)].into_iter().flatten()
    }
}

/// Finds out which of `bodies`, those of one group, share an end; `solids` are theirs.
pub(crate) fn find_joints(bodies: &mut [PreparedBody], solids: &[Solid]) {
    let as_they_are = shared_ends(bodies, |body| body.placement.place_radius[3].to_bits());
    let first = bodies.first().map_or(0, |body| body.number);
    let centre = |body: &PreparedBody| solids[body.number - first].centre();
    let widened = shared_ends(bodies, |body| centre(body).to_array().map(f64::to_bits));
    for ((body, as_it_is), widened) in bodies.iter_mut().zip(as_they_are).zip(widened) {
        body.joint = Joint { as_it_is, widened };
    }
}

/// Finds out which of `bodies`, those of one group, are earlier ones once more; `solids` are theirs.
pub(crate) fn find_repeated(bodies: &mut [PreparedBody], solids: &[Solid]) {
    let place =
        |solid: &Solid| (solid.centre().to_array().map(f64::to_bits), solid.bounding_radius().to_bits());
    let mut order: Vec<usize> = (0..bodies.len()).collect();
    order.sort_by_cached_key(|&number| (place(&solids[number]), number));
    let same = |one: &PreparedBody, other: &PreparedBody| {
        let triangles = [one, other].map(|body| body.triangles.as_ref().map(Arc::as_ptr));
        (one.shape, one.turn, one.spin) == (other.shape, other.turn, other.spin)
            && triangles[0] == triangles[1]
    };
    for [first, next] in order.array_windows() {
        bodies[*next].is_repeated = same(&bodies[*first], &bodies[*next]);
    }
}

/// Decides which of `bodies`, those of one group, are drawn by pipelines that know patterns: those that carry
/// one, and with them those that share an end with others, since all of these must be drawn in their order.
pub(crate) fn find_patterned(bodies: &mut [PreparedBody]) {
    let has_patterns = bodies.iter().any(|body| body.marking.is_some());
    for body in bodies {
        let is_joined = body.joint.as_it_is || body.joint.widened;
        body.is_patterned = body.marking.is_some() || has_patterns && is_joined;
    }
}

/// Numbers what `bodies` emit, and returns it, each once.
pub(crate) fn number_emissions(bodies: &mut [PreparedBody]) -> Vec<Emission> {
    let mut emissions = Vec::new();
    let mut numbers = HashMap::new();
    for body in bodies {
        body.emission_number = *numbers.entry(identity(body.emission)).or_insert_with(|| {
            emissions.push(body.emission);
            emissions.len() as u32 - 1
        });
    }
    emissions
}

/// Returns a key that is equal for equal emissions alone.
fn identity(emission: Emission) -> (u8, [u64; 3]) {
    match emission {
        Emission::Wavelength(nm) => (0, [nm.to_bits(), 0, 0]),
        Emission::Glowing(kelvin) => (1, [kelvin.to_bits(), 0, 0]),
        Emission::Painted(Paint::Smooth(colour)) => (2, colour.map(f64::to_bits)),
        Emission::Painted(Paint::Measured(material)) => (3, [material.number() as u64, 0, 0]),
    }
}

/// Returns which of `bodies` have an end in one place with another that has the same `trait_of`.
fn shared_ends<T: Ord>(bodies: &[PreparedBody], trait_of: impl Fn(&PreparedBody) -> T) -> Vec<bool> {
    let ends = bodies.iter().enumerate();
    let ends = ends.flat_map(|(place, body)| body.ends().map(move |end| (end, place)));
    let mut ends: Vec<_> = ends.map(|(end, place)| (end, trait_of(&bodies[place]), place)).collect();
    ends.sort_unstable();
    let mut are_shared = vec![false; bodies.len()];
    for [first, second] in ends.array_windows() {
        if (first.0, &first.1) == (second.0, &second.1) && first.2 != second.2 {
            are_shared[first.2] = true;
            are_shared[second.2] = true;
        }
    }
    are_shared
}

/// Packs a vector and a number for the shaders.
pub(crate) fn packed(v: DVec3, w: f64) -> [f32; 4] {
    v.as_vec3().extend(w as f32).to_array()
}
