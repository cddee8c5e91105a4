//! Meshes that change their form: morphed by their default weights, and skinned in the pose of their nodes.
//!
//! Reference: Khronos Group, *glTF 2.0 Specification* (2021), 3.7.2.2 (morph targets) and 3.7.3 (skins).

use std::sync::Arc;

use glam::{DMat4, DVec3};
use gltf::mesh::Semantic;
use gltf::{Node, Primitive, Skin};

use super::super::accessor::{JOINTS, MATRICES, PLACES, WEIGHTS, read};
use super::nodes::Tree;

/// Largest number of moves of a model's corners, by targets and joints.
const MOST_MOVES: usize = 200_000_000;

/// The number of moves of corners so far.
#[derive(Default)]
pub struct Moves(usize);

impl Moves {
    /// Counts more of them, and refuses more than a model may have.
    fn add(&mut self, more: usize) -> Result<(), String> {
        self.0 = self.0.saturating_add(more);
        if self.0 <= MOST_MOVES {
            return Ok(());
        }
        Err(format!("its corners are moved more than {MOST_MOVES} times, by morph targets and joints"))
    }
}

/// Adds to `places` the morph targets of `primitive`, with the default weights of `node`, or else of its
/// mesh.
pub fn morph(
    places: &mut [DVec3],
    primitive: &Primitive<'_>,
    node: &Node<'_>,
    buffers: &[Vec<u8>],
    moves: &mut Moves,
) -> Result<(), String> {
    let weights = node.weights().or_else(|| node.mesh()?.weights()).unwrap_or_default();
    for (target, &weight) in primitive.morph_targets().zip(weights) {
        let Some(target) = target.positions().filter(|_| weight != 0.0) else { continue };
        if target.count() != places.len() {
            return Err("a mesh has not as many corners as its morph target".to_owned());
        }
        moves.add(places.len())?;
        let target = read::<3>(&target, &PLACES, buffers, false)?;
        for (place, along) in places.iter_mut().zip(target) {
            *place += f64::from(weight) * DVec3::from(along.map(f64::from));
        }
    }
    Ok(())
}

/// The joints of a skin: from the axes of its mesh, bound, to those of the scene.
pub type Joints = Arc<[DMat4]>;

/// Returns the joints of `skin`.
pub fn joints(skin: &Skin<'_>, tree: &Tree<'_>, buffers: &[Vec<u8>]) -> Result<Joints, String> {
    let inverse = match skin.inverse_bind_matrices() {
        Some(matrices) => read::<16>(&matrices, &MATRICES, buffers, false)?,
        None => Vec::new(),
    };
    let inverse = |number: usize| {
        inverse.get(number).map_or(DMat4::IDENTITY, |parts| DMat4::from_cols_array(&parts.map(f64::from)))
    };
    let of_joint = |(number, joint): (usize, Node<'_>)| Ok(tree.joint(joint.index())? * inverse(number));
    skin.joints().enumerate().map(of_joint).collect()
}

/// Moves `places` of `primitive` as its weights of `joints` say.
pub fn skin(
    places: &mut [DVec3],
    primitive: &Primitive<'_>,
    joints: &[DMat4],
    buffers: &[Vec<u8>],
    moves: &mut Moves,
) -> Result<(), String> {
    let mut sums = vec![(DVec3::ZERO, 0.0); places.len()];
    for set in 0.. {
        let named = |semantic| primitive.get(&semantic);
        let (Some(numbers), Some(weights)) = (named(Semantic::Joints(set)), named(Semantic::Weights(set)))
        else {
            break;
        };
        if numbers.count() != places.len() || weights.count() != places.len() {
            return Err("a mesh has not as many joints and weights as corners".to_owned());
        }
        moves.add(places.len())?;
        let numbers = read::<4>(&numbers, &JOINTS, buffers, false)?;
        let weights = read::<4>(&weights, &WEIGHTS, buffers, true)?;
        for (at, sum) in sums.iter_mut().enumerate() {
            for (number, weight) in
                numbers[at].into_iter().zip(weights[at]).filter(|(_, weight)| *weight != 0.0)
            {
                let joint =
                    joints.get(number as usize).ok_or("a mesh names a joint that its skin has not")?;
                let weight = f64::from(weight);
                sum.0 += weight * joint.transform_point3(places[at]);
                sum.1 += weight;
            }
        }
    }
    for (place, (sum, weight)) in places.iter_mut().zip(sums) {
        // A corner without weights goes with the first joint, as in other readers.
        let first = || joints.first().map_or(*place, |joint| joint.transform_point3(*place));
        *place = if weight == 0.0 { first() } else { sum / weight };
    }
    Ok(())
}
