//! The nodes of a glTF scene, and their places in it.

use std::collections::HashMap;

use glam::{DMat4, DQuat, DVec3};
use gltf::scene::Transform;
use gltf::{Document, Node};

use super::super::accessor::{PLACES, TURNS, accessor, read};
use super::extensions::Extended;

/// A node with its place in the scene.
pub struct PlacedNode<'a> {
    pub node: Node<'a>,
    /// From its axes to those of the scene.
    pub axes: DMat4,
    /// Number of nodes that it lies in.
    pub depth: usize,
}

/// The nodes of a file.
pub struct Tree<'a> {
    /// The visible nodes of the scene, each before those that it is around.
    pub placed: Vec<PlacedNode<'a>>,
    /// Number of meshes that are hidden.
    pub hidden: usize,
    /// From the axes of each node to those of the scene; `None` of those that are nowhere.
    axes: Vec<Option<DMat4>>,
}

impl<'a> Tree<'a> {
    /// Returns the nodes of `document`.
    ///
    /// # Errors
    ///
    /// A node of the scene that is in two others, or in itself.
    pub fn new(document: &'a Document, extended: &Extended) -> Result<Self, String> {
        let scene = document.default_scene().or_else(|| document.scenes().next());
        let outermost: Vec<Node<'_>> = roots(document);
        let roots = scene.map_or_else(|| outermost.clone(), |scene| scene.nodes().collect());
        let mut tree = Self { placed: Vec::new(), hidden: 0, axes: vec![None; document.nodes().len()] };
        tree.walk(roots, |tree, node, axes, depth, is_hidden| {
            let is_hidden = is_hidden || extended.is_hidden(node.index());
            if is_hidden {
                tree.hidden += usize::from(node.mesh().is_some());
            } else {
                tree.placed.push(PlacedNode { node: node.clone(), axes, depth });
            }
            is_hidden
        })?;
        // Joints may be outside the scene.
        let others = outermost.into_iter().filter(|root| tree.axes[root.index()].is_none()).collect();
        let _ = tree.walk(others, |_, _, _, _, _| true);
        Ok(tree)
    }

    /// Places `roots` and what is in them, and calls `visit` with each node, its axes, the number of nodes
    /// that it lies in, and what that returned for the node around it.
    fn walk(
        &mut self,
        roots: Vec<Node<'a>>,
        mut visit: impl FnMut(&mut Self, &Node<'a>, DMat4, usize, bool) -> bool,
    ) -> Result<(), String> {
        let mut waiting: Vec<_> =
            roots.into_iter().rev().map(|root| (root, DMat4::IDENTITY, 0, false)).collect();
        while let Some((node, around, depth, above)) = waiting.pop() {
            let own = around * transform(&node);
            if self.axes[node.index()].replace(own).is_some() {
                return Err(format!(
                    "node {} is in its tree twice: nodes must not form circles",
                    node.index()
                ));
            }
            let of_node = visit(self, &node, own, depth, above);
            let children: Vec<_> = node.children().map(|child| (child, own, depth + 1, of_node)).collect();
            waiting.extend(children.into_iter().rev());
        }
        Ok(())
    }

    /// Returns the axes of a joint.
    pub fn joint(&self, node: usize) -> Result<DMat4, String> {
        self.axes[node].ok_or_else(|| format!("node {node}, a joint, is in no tree"))
    }
}

/// Returns the nodes that are in no other.
fn roots(document: &Document) -> Vec<Node<'_>> {
    let mut is_child = vec![false; document.nodes().len()];
    document.nodes().flat_map(|node| node.children()).for_each(|child| is_child[child.index()] = true);
    document.nodes().filter(|node| !is_child[node.index()]).collect()
}

fn transform(node: &Node<'_>) -> DMat4 {
    match node.transform() {
        Transform::Matrix { matrix } => {
            DMat4::from_cols_array_2d(&matrix.map(|column| column.map(f64::from)))
        }
        Transform::Decomposed { translation, rotation, scale } => placed(translation, rotation, scale),
    }
}

fn placed(translation: [f32; 3], rotation: [f32; 4], scale: [f32; 3]) -> DMat4 {
    DMat4::from_scale_rotation_translation(
        scale.map(f64::from).into(),
        turn(rotation.map(f64::from)),
        DVec3::from(translation.map(f64::from)),
    )
}

/// Returns the rotation of this quaternion; none of a quaternion of no length.
fn turn(quaternion: [f64; 4]) -> DQuat {
    let turn = DQuat::from_array(quaternion);
    if turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY }
}

/// Returns the places of the instances of a node in its axes, from accessors with these names and numbers.
pub fn instances(
    document: &Document,
    attributes: &HashMap<String, usize>,
    buffers: &[Vec<u8>],
) -> Result<Vec<DMat4>, String> {
    let named = |name: &str| attributes.get(name).map(|&number| accessor(document, number)).transpose();
    let places =
        |name: &str| named(name)?.map(|accessor| read::<3>(&accessor, &PLACES, buffers, false)).transpose();
    let (moves, scales) = (places("TRANSLATION")?, places("SCALE")?);
    let turns = named("ROTATION")?.map(|accessor| read::<4>(&accessor, &TURNS, buffers, true)).transpose()?;
    let counts = [moves.as_ref().map(Vec::len), turns.as_ref().map(Vec::len), scales.as_ref().map(Vec::len)];
    let count = counts.into_iter().flatten().min().unwrap_or(1);
    if counts.into_iter().flatten().any(|other| other != count) {
        return Err("the instances of a node have not as many places as turns and sizes".to_owned());
    }
    Ok((0..count)
        .map(|number| {
            placed(
                moves.as_ref().map_or([0.0; 3], |all| all[number]),
                turns.as_ref().map_or([0.0, 0.0, 0.0, 1.0], |all| all[number]),
                scales.as_ref().map_or([1.0; 3], |all| all[number]),
            )
        })
        .collect())
}
