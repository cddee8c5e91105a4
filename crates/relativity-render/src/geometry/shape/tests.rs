//! Each shape's answers beside each other, and beside definitions.

use glam::{DQuat, DVec3};

use super::Shape;
use super::strokes::Onlooker;

#[test]
fn the_forward_most_point_of_a_shape_is_on_its_surface() {
    let turn = (DQuat::from_rotation_z(0.3) * DQuat::from_rotation_x(1.1)).to_array();
    for shape in [
        Shape::Sphere { centre: [1.0, 2.0, 3.0], radius: 0.7 },
        Shape::Tube { from: [1.0, 2.0, 3.0], to: [2.0, 0.0, 1.0], radius: 0.2 },
        Shape::Ring { centre: [1.0, 2.0, 3.0], axis: [0.6, 0.0, 0.8], radius: 0.5, tube_radius: 0.1 },
        Shape::Box { centre: [1.0, -2.0, 0.5], half: [1.0, 0.2, 3.0], turn },
        Shape::Cylinder { from: [0.0, 1.0, 2.0], to: [1.0, 3.0, -1.0], radius: 0.4 },
    ] {
        let point = shape.forward_most();
        for ahead in [-1e-3, 1e-3] {
            let off = shape.distance(point + ahead * DVec3::X);
            // At an edge or a corner the surface comes nearer from the side, but not from ahead.
            assert!(off.signum() == ahead.signum() && off.abs() <= 1e-3 + 1e-15, "{shape:?}: {off}");
        }
        assert!(shape.distance(point).abs() < 1e-15, "{shape:?}");
    }
}

#[test]
fn distances_to_a_box_and_a_cylinder_are_those_of_sides_edges_and_the_inside() {
    let cuboid = Shape::Box { centre: [1.0, 0.0, 0.0], half: [1.0, 2.0, 3.0], turn: [0.0, 0.0, 0.0, 1.0] };
    let cylinder = Shape::Cylinder { from: [0.0, 0.0, -1.0], to: [0.0, 0.0, 1.0], radius: 2.0 };
    for (shape, place, expected) in [
        (cuboid, [2.5, 0.0, 0.0], 0.5),
        (cuboid, [5.0, 6.0, 0.0], 5.0),
        (cuboid, [1.0, 0.5, 0.0], -1.0),
        (cylinder, [0.0, 2.25, 0.0], 0.25),
        (cylinder, [5.0, 0.0, 5.0], 5.0),
        (cylinder, [0.0, 0.0, 0.5], -0.5),
    ] {
        assert!((shape.distance(place.into()) - expected).abs() < 1e-15, "{shape:?} at {place:?}");
    }
}

/// The distance of `point` from the surface of `shape`, by the definition of each shape.
fn off_surface(shape: &Shape, point: DVec3) -> f64 {
    match *shape {
        Shape::Sphere { centre, radius } => (point.distance(centre.into()) - radius).abs(),
        Shape::Box { centre, half, turn } => {
            let own = DQuat::from_array(turn).inverse() * (point - DVec3::from(centre));
            let beyond = own.abs() - DVec3::from(half);
            beyond.max_element().abs()
        }
        Shape::Cylinder { from, to, radius } => {
            let axis = (DVec3::from(to) - DVec3::from(from)).normalize();
            ((point - DVec3::from(from)).reject_from_normalized(axis).length() - radius).abs()
        }
        _ => 0.0,
    }
}

#[test]
fn outlines_lie_on_the_surfaces_that_they_stand_for() {
    let turn = DQuat::from_rotation_z(0.3) * DQuat::from_rotation_x(1.1);
    for shape in [
        Shape::Box { centre: [1.0, -2.0, 0.5], half: [1.0, 0.2, 3.0], turn: turn.to_array() },
        Shape::Cylinder { from: [0.0, 1.0, 2.0], to: [1.0, 3.0, -1.0], radius: 0.4 },
    ] {
        for stroke in shape.strokes() {
            for i in 0..=8 {
                let off = off_surface(&shape, stroke.path.at(f64::from(i) / 8.0));
                assert!(off < 1e-12, "{shape:?}: {off} off at {i}/8 of {stroke:?}");
            }
        }
    }
}

/// On its silhouette a surface is met at right angles to its normal; an eye inside sees none.
#[test]
fn lines_of_sight_touch_a_ball_along_its_silhouette() {
    let (centre, radius) = (DVec3::new(1.0, -2.0, 0.5), 0.75);
    let ball = Shape::Sphere { centre: centre.into(), radius };
    for onlooker in [
        Onlooker::At(DVec3::new(3.0, 1.0, 0.0)),
        Onlooker::At(centre + DVec3::Z * 0.76),
        Onlooker::At(DVec3::new(-1e6, 0.0, 7.0)),
        Onlooker::Afar(DVec3::new(0.6, 0.0, -0.8)),
    ] {
        let around = ball.silhouette(|_| onlooker).expect("a ball has one");
        for place in [0.0, 0.2, 0.5, 0.9].map(|s| around.at(s)) {
            let sight = onlooker.line_of_sight(place).normalize();
            let slope = (place - centre).dot(sight) / radius;
            assert!(ball.distance(place).abs() < 1e-15 && slope.abs() < 1e-15, "{onlooker:?}: {slope}");
        }
    }
    let inside = ball.silhouette(|middle| Onlooker::At(middle + DVec3::X * 0.5)).expect("a ball has one");
    assert_eq!(inside.at(0.0), inside.at(0.5));
}

#[test]
fn a_ring_is_drawn_as_thick_as_it_is_around_its_middle_circle() {
    let shape =
        Shape::Ring { centre: [0.0, 3.0, 2.0], axis: [0.0, 1.0, 0.0], radius: 0.5, tube_radius: 0.03 };
    let strokes = shape.strokes();
    assert_eq!((strokes.len(), strokes[0].radius), (1, 0.03));
    let top = (0..1000).map(|i| strokes[0].path.at(f64::from(i) / 1000.0)).fold(0.0, |top, p| p.z.max(top));
    assert!((top - 2.5).abs() < 1e-5, "{top}");
}
