//! What the pixels of one row show of two balls, one of which is ahead of the other: the body, how far away
//! it is, when its light left, and by how much that is shifted.
//!
//! ```text
//! cargo run -p relativity-render --example what_a_pixel_shows
//! ```

use relativity_core::{Aperture, Speed};
use relativity_render::{Body, Camera, Gaze, Geometry, PreparedScene, Shape, View};

/// Size of the picture, pixels.
const SIZE: [u32; 2] = [64, 48];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let ball = |x: f64| Body::new(Shape::Sphere { centre: [x, 4.0, 0.0], radius: 0.8 }, 550.0);
    let scene = PreparedScene::moving(&[ball(0.0), ball(3.0)]);
    let view = View {
        camera: Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.5, SIZE),
        speed: Speed::from_beta(0.8)?,
        observation_time: 4.0,
        geometry: Geometry::Seen,
    };
    println!("pixel  body  distance  light left at  D");
    for column in (0..SIZE[0]).step_by(4) {
        let line_of_sight = view.camera.line_of_sight([f64::from(column) + 0.5, 24.5]);
        match scene.first_hit(&view, line_of_sight) {
            Some(hit) => println!(
                "{column:5} {:5} {:9.4} {:14.4} {:7.4}",
                hit.body, hit.distance, hit.emission_time, hit.doppler_factor
            ),
            None => println!("{column:5}     -"),
        }
    }
    Ok(())
}
