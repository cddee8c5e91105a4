//! A picture of a ball that passes at 0.9 c, drawn in f64 on the CPU and written as a portable pixmap.
//!
//! ```text
//! cargo run --release -p relativity-render --example passing_ball > ball.ppm
//! ```

use std::io::{self, Write as _};

use relativity_core::{Aperture, Speed};
use relativity_render::{Appearance, Body, Camera, Gaze, Geometry, PreparedScene, Shape, View};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let ball = Shape::Sphere { centre: [0.0, 4.0, 0.0], radius: 1.0 };
    let scene = PreparedScene::moving(&[Body::new(ball, 600.0)]);
    let mut view = View {
        camera: Camera::new(Aperture::default(), Gaze::STRAIGHT_AHEAD, 1.2, [320, 240]),
        speed: Speed::from_beta(0.9)?,
        observation_time: 3.0,
        geometry: Geometry::Seen,
    };
    let seen_at = view.apparent_position([0.0, 4.0, 0.0]).ok_or("outside the domain")?;
    view.camera.gaze = Gaze::along(seen_at.to_array());
    let picture = scene.picture(&view, &Appearance::default(), 3);
    let [width, height] = picture.size;
    let mut out = io::stdout().lock();
    write!(out, "P6\n{width} {height}\n255\n")?;
    for [red, green, blue, _] in &picture.rgba {
        out.write_all(&[*red, *green, *blue])?;
    }
    Ok(())
}
