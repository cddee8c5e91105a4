//! Bodies of a crowd: a ball, a tube and a ring in turn.

use relativity_render::{Body, Shape};

/// The body of this number, about this `centre` and this large.
pub fn body(number: u32, centre: [f64; 3], size: f64) -> Body {
    let [x, y, z] = centre;
    let shape = match number % 3 {
        0 => Shape::Sphere { centre, radius: 0.5 * size },
        1 => Shape::Tube { from: [x - size, y, z], to: [x + size, y, z + size], radius: 0.2 * size },
        _ => Shape::Ring { centre, axis: [0.0, 0.6, 0.8], radius: size, tube_radius: 0.1 * size },
    };
    Body::new(shape, 650.0)
}
