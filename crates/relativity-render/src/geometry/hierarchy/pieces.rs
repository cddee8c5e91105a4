//! The boxes that a body is given: a long, thin or bent one has several, along it.

use glam::DVec3;

use crate::geometry::capsule::Capsule;
use crate::geometry::extent::Extent;
use crate::geometry::intersect::Solid;

/// Longer than this part of the reach of its group, a body may have several boxes.
const LONG: f64 = 1.0 / 24.0;
/// Half as long as a box of a thin body is, in radii of that.
const LEAST_SLENDER: f64 = 3.0;
/// Greatest number of halvings of one capsule.
const MOST_HALVINGS: u32 = 4;

/// A part of a body, in a box.
#[derive(Debug, Clone, Copy)]
pub struct BodyPart {
    /// The number of the body.
    pub body: u32,
    /// Whether it has others.
    pub is_one_of_some: bool,
    /// The lowest and the highest corner, rest frame.
    pub corners: [DVec3; 2],
}

/// Returns the pieces of the body of this `number` and form, which these capsules contain if there are any,
/// in a group of this `extent`.
pub fn pieces(
    solid: &Solid,
    capsules: &[Capsule],
    number: u32,
    extent: &Extent,
) -> impl Iterator<Item = BodyPart> + use<> {
    let longest = LONG * extent.reach;
    let mut boxes = Vec::new();
    let is_long = solid.bounding_radius() > longest;
    if is_long && !capsules.is_empty() {
        for capsule in capsules {
            add_halves(capsule, longest, MOST_HALVINGS, &mut boxes);
        }
    } else {
        boxes.push(around(solid));
    }
    let is_one_of_some = boxes.len() > 1;
    boxes.into_iter().map(move |corners| BodyPart { body: number, is_one_of_some, corners })
}

fn add_halves(capsule: &Capsule, longest: f64, halvings: u32, out: &mut Vec<[DVec3; 2]>) {
    let Capsule { from, to, radius } = *capsule;
    if halvings > 0 && from.distance(to) > longest.max(2.0 * LEAST_SLENDER * radius) {
        for half in capsule.halves() {
            add_halves(&half, longest, halvings - 1, out);
        }
        return;
    }
    out.push([from.min(to) - radius, from.max(to) + radius]);
}

/// The least box around `solid`.
fn around(solid: &Solid) -> [DVec3; 2] {
    let half = solid.form.answers().half_sides();
    [-half, half].map(|half| solid.centre() + half)
}
