//! The turn of a body: from its own axes to those of the rest frame.

use glam::{DQuat, DVec3};

use crate::shape::Shape;

/// The turn from the own axes of `shape` to the axes of the rest frame.
///
/// The own z axis of a tube and of a cylinder (from `from` to `to`) and of a ring is its axis, reached by the shortest
/// turn, which fixes the other two; to -z it is half a turn about x. A ball has the axes of the rest frame; a box says
/// how it is turned.
pub fn turn_of(shape: &Shape) -> DQuat {
    match *shape {
        Shape::Sphere { .. } => DQuat::IDENTITY,
        Shape::Tube { from, to, .. } | Shape::Cylinder { from, to, .. } => {
            turn_to(DVec3::from(to) - DVec3::from(from))
        }
        Shape::Ring { axis, .. } => turn_to(axis.into()),
        Shape::Box { turn, .. } => DQuat::from_array(turn),
    }
}

/// The shortest turn of the z axis into the direction of `axis`; none where it has none.
fn turn_to(axis: DVec3) -> DQuat {
    let Some(DVec3 { x, y, z }) = axis.try_normalize() else { return DQuat::IDENTITY };
    // 1 + z, without the difference.
    let real = if z < 0.0 { (x * x + y * y) / (1.0 - z) } else { 1.0 + z };
    let turn = DQuat::from_xyzw(-y, x, 0.0, real);
    if turn.length() == 0.0 { DQuat::from_xyzw(1.0, 0.0, 0.0, 0.0) } else { turn.normalize() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_z_axis_is_turned_into_any_axis() {
        for axis in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [1e-9, 0.0, -1.0], [-3.0, 1.0, -2.0], [1.0, 0.0, 0.0]]
        {
            let axis = DVec3::from(axis).normalize();
            let turn = turn_to(axis);
            assert!((turn.length() - 1.0).abs() < 1e-15);
            assert!((turn * DVec3::Z).distance(axis) < 1e-15, "{axis}: {}", turn * DVec3::Z);
        }
    }

    #[test]
    fn the_turn_is_the_shortest() {
        let turn = turn_to(DVec3::X);
        assert!((turn * DVec3::Y).distance(DVec3::Y) < 1e-15);
        assert!((turn_to(DVec3::Y) * DVec3::X).distance(DVec3::X) < 1e-15);
        assert!((turn_to(DVec3::NEG_Z) * DVec3::X).distance(DVec3::X) < 1e-15);
    }
}
