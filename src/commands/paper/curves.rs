//! The paper's curves: angles and their differences against time, in each model.

use relativity_core::{
    Aperture, Disparity, Model, PairError, PublishedVariant, SourcePoint, Speed, equidistance_time,
    observation_time_when_seen_at,
};

/// The paper's model as its Appendix A prints it.
pub const APPENDIX_A: Model = Model::Published(PublishedVariant::AppendixA);
/// The paper's model with the sign of its text.
pub const TEXT_SIGN: Model = Model::Published(PublishedVariant::TextSign);

/// Returns the name of `model` in the figures.
pub const fn title(model: Model) -> &'static str {
    match model {
        APPENDIX_A => "published (Appendix A)",
        TEXT_SIGN => "published, text's sign",
        Model::Exact => "exact",
        Model::OneCone => "one light cone",
    }
}

/// A tracked point, as the paper sets it up: it passes x = 0 at t = 0.
#[derive(Debug, Clone, Copy)]
pub struct Setup {
    pub beta: f64,
    pub y: f64,
    pub z: f64,
    pub separation: f64,
}

impl Setup {
    /// The point of the paper's section 3.
    pub const SECTION_3: Self = Self { beta: 0.9, y: 0.5, z: 0.5, separation: 0.3 };
    /// The forward-most point of the cyclist's front wheel.
    pub const CYCLIST: Self = Self { beta: 0.9, y: 3.0, z: 2.0, separation: 0.1 };

    pub fn speed(&self) -> Speed {
        Speed::from_beta(self.beta).expect("the paper's speeds are below 1")
    }

    fn point(&self) -> SourcePoint {
        SourcePoint { x0: 0.0, y: self.y, z: self.z }
    }

    /// T0 of the tracked point.
    pub fn equidistance_time(&self) -> Result<f64, PairError> {
        let time = equidistance_time(&self.speed(), self.point(), Aperture::pair(self.separation))?;
        Ok(time.expect("the paper's speeds are above 0"))
    }

    /// When the tracked point is seen at `x` from the origin; 0 at rest.
    pub fn time_when_seen_at(&self, x: f64) -> Result<f64, PairError> {
        let time = observation_time_when_seen_at(&self.speed(), self.point(), x, Aperture::pair(0.0))?;
        Ok(time.unwrap_or_default())
    }

    /// Returns the disparity of the tracked point.
    pub fn seen(&self, model: Model, time: f64) -> Result<Disparity, PairError> {
        self.seen_at(model, self.point(), time)
    }

    /// Returns the disparity of another point of the same body.
    pub fn seen_at(&self, model: Model, point: SourcePoint, time: f64) -> Result<Disparity, PairError> {
        model.disparity(&self.speed(), point, Aperture::pair(self.separation), time)
    }

    /// A quantity of what is seen against time, at `count` times.
    pub fn curve(
        &self,
        model: Model,
        [from, to]: [f64; 2],
        count: usize,
        quantity: impl Fn(&Disparity) -> f64,
    ) -> Result<Vec<[f64; 2]>, PairError> {
        let time = |index: usize| from + (to - from) * index as f64 / (count - 1) as f64;
        (0..count).map(|index| Ok([time(index), quantity(&self.seen(model, time(index))?)])).collect()
    }
}

/// Extremes of a curve and where it is zero.
#[derive(Debug, Clone)]
pub struct CurveExtremes {
    pub least: f64,
    pub largest: f64,
    pub zeros: Vec<f64>,
}

/// Extremes and zeros of a dense curve, between its points by parabolas and straight lines.
pub fn extent(curve: &[[f64; 2]]) -> CurveExtremes {
    let values = || curve.iter().map(|point| point[1]);
    let mut extent = CurveExtremes {
        least: values().fold(f64::INFINITY, f64::min),
        largest: values().fold(f64::NEG_INFINITY, f64::max),
        zeros: Vec::new(),
    };
    for three in curve.windows(3) {
        let [before, here, after] = [three[0][1], three[1][1], three[2][1]];
        let curvature = before - 2.0 * here + after;
        if (here - before) * (after - here) < 0.0 {
            let extreme = here - (after - before).powi(2) / (8.0 * curvature);
            extent.least = extent.least.min(extreme);
            extent.largest = extent.largest.max(extreme);
        }
    }
    for two in curve.windows(2) {
        let [[from, before], [to, after]] = [two[0], two[1]];
        if before * after < 0.0 {
            extent.zeros.push(from + (to - from) * before / (before - after));
        }
    }
    extent
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table of extremes that the errata rest on, as worked out independently of this program.
    #[test]
    fn extremes_and_zeros_of_each_model_are_the_known_ones() {
        let known = [
            (APPENDIX_A, [-0.3295, 0.0712], [-0.0032, 0.2240], vec![0.723], vec![0.567, 0.723]),
            (TEXT_SIGN, [-0.0858, 0.4394], [-0.2694, 0.0045], vec![0.723], vec![0.504, 0.723]),
            (Model::Exact, [-0.6678, f64::NAN], [-0.0973, 0.3219], vec![], vec![0.723]),
        ];
        for (model, dphi, dtheta, dphi_zeros, dtheta_zeros) in known {
            let curve = |quantity: fn(&Disparity) -> f64| {
                Setup::SECTION_3.curve(model, [-20.0, 40.0], 60_001, quantity).expect("inside the domain")
            };
            let [phi, theta] = [extent(&curve(|seen| seen.dphi)), extent(&curve(|seen| seen.dtheta))];
            assert_near(&[phi.least], &dphi[..1], 5e-5);
            assert_near(&[theta.least, theta.largest], &dtheta, 5e-5);
            assert_near(&phi.zeros, &dphi_zeros, 5e-4);
            assert_near(&theta.zeros, &dtheta_zeros, 5e-4);
            match model {
                Model::Exact | Model::OneCone => assert!(phi.largest < 0.0),
                Model::Published(_) => assert_near(&[phi.largest], &dphi[1..], 5e-5),
            }
        }
    }

    fn assert_near(values: &[f64], known: &[f64], tolerance: f64) {
        assert_eq!(values.len(), known.len(), "{values:?} {known:?}");
        for (value, known) in values.iter().zip(known) {
            assert!((value - known).abs() <= tolerance, "{value} is not {known}");
        }
    }
}
