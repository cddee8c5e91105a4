//! What two eyes see of a point that passes: where and when its light left, by how much it is shifted, and
//! how the directions differ, against the observation time.
//!
//! ```text
//! cargo run -p relativity-core --example passage
//! ```

use relativity_core::{
    Aperture, SourcePoint, Speed, disparity, doppler, observation_time_when_seen_at, sighting,
};

/// Wavelength of the point's light at rest, nm.
const REST_NM: f64 = 550.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let speed = Speed::from_beta(0.9)?;
    let point = SourcePoint { x0: 0.0, y: 3.0, z: 2.0 };
    let pair = Aperture::pair(0.1);
    println!("seen at x    T         t         D       wavelength   dphi, deg   dtheta, deg");
    for x in [-8.0, -4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 4.0, 8.0] {
        let time = observation_time_when_seen_at(&speed, point, x, pair)?.ok_or("it rests")?;
        let seen = sighting(&speed, point, Aperture::default(), time)?;
        let both = disparity(&speed, point, pair[0], pair[1], time)?;
        println!(
            "{:9.2} {time:8.3} {:9.3} {:9.4} {:9.0} nm {:11.4} {:12.4}",
            seen.position[0],
            seen.retarded_time,
            seen.doppler_factor,
            doppler::received_wavelength(REST_NM, seen.doppler_factor),
            both.dphi.to_degrees(),
            both.dtheta.to_degrees()
        );
    }
    Ok(())
}
