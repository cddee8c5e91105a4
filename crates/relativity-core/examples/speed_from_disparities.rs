//! Speed and distance of a point from the disparities that two eyes measured, with their uncertainties: a
//! simulation with noise of 1 % of each curve's range, its fit, and a bootstrap.
//!
//! ```text
//! cargo run --release -p relativity-core --example speed_from_disparities
//! ```

use relativity_core::{
    Aperture, FitOptions, Model, Parameter, Simulation, SourcePoint, Speed, bootstrap, fit,
};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let simulation = Simulation {
        speed: Speed::from_beta(0.8)?,
        point: SourcePoint { x0: 0.0, y: 3.0, z: 2.0 },
        rolling: None,
        pair: Aperture::pair(0.1),
        model: Model::Exact,
        times: (0..80).map(|index| 0.15 * f64::from(index)).collect(),
        noise: 0.01,
        seed: 1,
    };
    let best = fit(&simulation.observations()?, &FitOptions::default())?;
    let replicates = bootstrap(&best, 500, 1)?;
    let truth = [simulation.speed.beta(), simulation.point.y, simulation.point.z];
    println!("        fit        standard error   truth");
    for (index, parameter) in [Parameter::Beta, Parameter::Y, Parameter::Z].into_iter().enumerate() {
        let error = replicates.standard_error(parameter);
        println!(
            "{:4} {:9.5} {error:12.5} {:12}",
            ["beta", "y", "z"][index],
            best.values[index],
            truth[index]
        );
    }
    Ok(())
}
