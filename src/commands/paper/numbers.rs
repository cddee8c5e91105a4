//! The numbers of the paper's section 3 and 4(a), beside those of each model.

use relativity_core::{Aperture, Disparity, Model, PairError, SourcePoint, sighting};

use super::curves::{APPENDIX_A, CurveExtremes, Setup, TEXT_SIGN, extent};

/// Observation times that hold all extremes and zeros.
const TIMES: [f64; 2] = [-20.0, 40.0];
const SAMPLES: usize = 60_001;
/// Speed at which the limit of the zeros as beta tends to 1 is settled to four digits.
const FAST: f64 = 0.999_999;
/// Observation times that hold both zeros then.
const ZERO_TIMES: [f64; 2] = [0.3, 1.0];
const ZERO_SAMPLES: usize = 7_001;
/// Distance, in units of that of closest approach, at which ratios have their limits.
const FAR: f64 = 1e6;
/// Shortest length that counts as short against its distance.
const ROD: f64 = 1e-3;

/// A number that the paper states, beside ours.
#[derive(Debug)]
pub struct PaperNumber {
    /// Name of the quantity.
    pub quantity: &'static str,
    /// Number that the paper states.
    pub paper: &'static str,
    /// In the models of [`MODELS`], or one value for all.
    pub ours: Vec<String>,
    /// Remark on the numbers.
    pub remark: &'static str,
}

/// The models, in the order of the columns.
pub const MODELS: [Model; 3] = [APPENDIX_A, TEXT_SIGN, Model::Exact];

/// Returns every row of the table.
pub fn rows() -> Result<Vec<PaperNumber>, PairError> {
    let mut rows = difference_rows()?;
    rows.extend(motion_rows()?);
    Ok(rows)
}

const fn row(
    quantity: &'static str,
    paper: &'static str,
    ours: Vec<String>,
    remark: &'static str,
) -> PaperNumber {
    PaperNumber { quantity, paper, ours, remark }
}

fn difference_rows() -> Result<Vec<PaperNumber>, PairError> {
    let setup = Setup::SECTION_3;
    let extents = |quantity: fn(&Disparity) -> f64| -> Result<Vec<CurveExtremes>, PairError> {
        MODELS.iter().map(|&model| Ok(extent(&setup.curve(model, TIMES, SAMPLES, quantity)?))).collect()
    };
    let (phi, theta) = (extents(|seen| seen.dphi)?, extents(|seen| seen.dtheta)?);
    let each = |extents: &[CurveExtremes], of: fn(&CurveExtremes) -> String| extents.iter().map(of).collect();
    let t0 = setup.equidistance_time()?;
    Ok(vec![
        row("T0 for y = z = 0.5, d = 0.3", "0.72", vec![format!("{t0:.4}")], "as stated"),
        row("least delta-phi, rad", "-0.34", each(&phi, least), "E5: no variant gives the quoted value"),
        row(
            "largest delta-phi, rad",
            "0.06",
            each(&phi, largest),
            "E5; exactly, delta-phi never changes its sign (E3)",
        ),
        row(
            "zeros of delta-phi, T",
            "0.72",
            each(&phi, zeros),
            "exactly there is none: ordinary parallax is always negative (E3)",
        ),
        row("least delta-theta, rad", "-0.015", each(&theta, least), "E5"),
        row("largest delta-theta, rad", "0.19", each(&theta, largest), "E5"),
        row(
            "zeros of delta-theta, T",
            "two, the later at 0.72",
            each(&theta, zeros),
            "exactly there is one, at T0, where both eyes see the point equally far (E3)",
        ),
        row(
            "time between these zeros as beta tends to 1",
            "tends to 0",
            vec![gap(APPENDIX_A)?, gap(TEXT_SIGN)?, "one zero".to_owned()],
            "E7: in the published model about d/(2 beta)",
        ),
    ])
}

/// Time between the two zeros of delta-theta, almost at the speed of light.
fn gap(model: Model) -> Result<String, PairError> {
    let setup = Setup { beta: FAST, ..Setup::SECTION_3 };
    let curve = setup.curve(model, ZERO_TIMES, ZERO_SAMPLES, |seen| seen.dtheta)?;
    Ok(match extent(&curve).zeros.as_slice() {
        [first, .., last] => format!("{:.4}", last - first),
        _ => "one zero".to_owned(),
    })
}

fn least(extent: &CurveExtremes) -> String {
    format!("{:.4}", extent.least)
}

/// A curve that only comes near 0 at its ends has no lobe above it.
fn largest(extent: &CurveExtremes) -> String {
    if extent.largest < 0.0 { "below 0".to_owned() } else { format!("{:.4}", extent.largest) }
}

fn zeros(extent: &CurveExtremes) -> String {
    let zeros: Vec<String> = extent.zeros.iter().map(|zero| format!("{zero:.4}")).collect();
    if zeros.is_empty() { "none".to_owned() } else { zeros.join(", ") }
}

/// Returns the rows of what one aperture sees, the same in every model.
fn motion_rows() -> Result<Vec<PaperNumber>, PairError> {
    let setup = Setup::CYCLIST;
    let doppler = |x: f64| -> Result<f64, PairError> { Ok(700.0 / seen_at(&setup, x, 0.0)?.doppler_factor) };
    let [before, after] = [apparent_length(&setup, -FAR)?, apparent_length(&setup, FAR)?];
    let [approaching, receding] = [apparent_speed(&setup, -FAR)?, apparent_speed(&setup, FAR)?];
    Ok(vec![
        row(
            "apparent length over rest length, far ahead",
            "sqrt((1+beta)/(1-beta)) = 4.3589",
            vec![format!("{before:.4}")],
            "as stated",
        ),
        row(
            "apparent length over rest length, far past",
            "sqrt((1-beta)/(1+beta)) = 0.2294",
            vec![format!("{after:.4}")],
            "as stated",
        ),
        row(
            "apparent speed, approaching",
            "above c",
            vec![format!("up to {approaching:.3} c")],
            "beta/(1 - beta)",
        ),
        row(
            "apparent speed, receding",
            "at most c/2",
            vec![format!("down to {receding:.3} c")],
            "beta/(1 + beta); right after the passage it is still above c/2",
        ),
        row(
            "received wavelength of 700 nm, approaching",
            "about 200 nm",
            vec![format!("{:.0} nm far ahead, {:.0} nm at x = -10", doppler(-FAR)?, doppler(-10.0)?)],
            "the paper's value is that of its frames, where the cyclist is not far ahead",
        ),
        row(
            "received wavelength of 700 nm, receding",
            "about 1000 nm",
            vec![format!("{:.0} nm at x = 0, {:.0} nm far past", doppler(0.0)?, doppler(FAR)?)],
            "E9: about 1000 nm come from parts still seen ahead of the eyes",
        ),
    ])
}

/// Returns the sighting by an eye at the origin of the tracked point or one `xr` further forward in the rest
/// frame, when it sees the tracked point at `x`.
fn seen_at(setup: &Setup, x: f64, xr: f64) -> Result<relativity_core::Sighting, PairError> {
    let time = setup.time_when_seen_at(x)?;
    let point = SourcePoint::from_rest([xr, setup.y, setup.z], &setup.speed());
    Ok(sighting(&setup.speed(), point, Aperture::default(), time)?)
}

fn apparent_length(setup: &Setup, x: f64) -> Result<f64, PairError> {
    let length = ROD * x.abs();
    let [rear, front] = [seen_at(setup, x, 0.0)?, seen_at(setup, x, length)?];
    Ok((front.position[0] - rear.position[0]) / length)
}

fn apparent_speed(setup: &Setup, x: f64) -> Result<f64, PairError> {
    let point = SourcePoint { x0: 0.0, y: setup.y, z: setup.z };
    let time = setup.time_when_seen_at(x)?;
    let later = time + ROD * x.abs();
    let at = |time| -> Result<f64, PairError> {
        Ok(sighting(&setup.speed(), point, Aperture::default(), time)?.position[0])
    };
    Ok((at(later)? - at(time)?) / (later - time))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ratios_and_apparent_speeds_have_their_limits() {
        let setup = Setup::CYCLIST;
        let ratio = 19.0_f64.sqrt();
        assert!((apparent_length(&setup, -FAR).expect("inside") / ratio - 1.0).abs() < 1e-6);
        assert!((apparent_length(&setup, FAR).expect("inside") * ratio - 1.0).abs() < 1e-6);
        assert!((apparent_speed(&setup, -FAR).expect("inside") - 9.0).abs() < 1e-6);
        assert!((apparent_speed(&setup, FAR).expect("inside") - 0.9 / 1.9).abs() < 1e-6);
    }
}
