//! The binocular models: the ways in which two apertures' views of one point are computed.

use thiserror::Error;

use crate::aperture::Aperture;
use crate::apparent::{Sighting, check_inputs, sighting};
use crate::cone_pair::{ConePair, SightPair};
use crate::disparity::{Disparity, disparity};
use crate::domain::DomainError;
use crate::one_cone::{self, middle, one_cone_disparity};
use crate::published::{self, PublishedVariant, published_disparity};
use crate::source::Source;
use crate::source::SourcePoint;
use crate::speed::Speed;
use crate::stereo::{Stereo, StereoError, stereo};
use crate::wheel::baseline;

/// A binocular model.
///
/// Its [name](Self::name) stands for it as a flag's value and in files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(from = "saved::SavedModel", into = "saved::SavedModel")
)]
pub enum Model {
    /// Each aperture solves its own light cone.
    #[default]
    Exact,
    /// Both apertures receive the events that the middle between them receives.
    OneCone,
    /// The paper's model, which leaves out parallax.
    Published(PublishedVariant),
}

/// Reasons why a model does not say what a pair of apertures sees.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum PairError {
    /// A coordinate or time outside the domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// A published model, which knows apertures along the motion.
    #[error("the model {} has both eyes along the motion: the head can be neither tilted nor turned", .0.name())]
    OffTheMotion(Model),
}

impl Model {
    /// Every model, the exact one first.
    pub const ALL: [Self; 4] = [
        Self::Exact,
        Self::OneCone,
        Self::Published(PublishedVariant::AppendixA),
        Self::Published(PublishedVariant::TextSign),
    ];

    /// Returns the name of the model on the command line and in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::OneCone => "one-cone",
            Self::Published(PublishedVariant::AppendixA) => "published",
            Self::Published(PublishedVariant::TextSign) => "published-text",
        }
    }

    /// Disparity of `source` in this model for the `pair` of apertures.
    ///
    /// # Accuracy
    ///
    /// As [`disparity()`], [`one_cone_disparity`] and [`published_disparity`], which it is.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain; a pair that is not along x, in a published model.
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::{Aperture, Model, SourcePoint, Speed};
    ///
    /// let speed = Speed::from_beta(0.9)?;
    /// let point = SourcePoint { x0: 0.0, y: 0.5, z: 0.5 };
    /// // What parallax makes of the paper's section 3, at T0: the published model leaves it out.
    /// let (pair, time) = (Aperture::pair(0.3), 0.522_5_f64.sqrt());
    /// let [exact, _, appendix_a, _] = Model::ALL.map(|model| model.disparity(&speed, point, pair, time));
    /// assert!((exact?.dphi + 0.582_9).abs() < 1e-4);
    /// assert!(appendix_a?.dphi.abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn disparity(
        self,
        speed: &Speed,
        source: impl Into<Source>,
        pair: [Aperture; 2],
        observation_time: f64,
    ) -> Result<Disparity, PairError> {
        let source = source.into();
        let [left, right] = pair;
        Ok(match self {
            Self::Exact => disparity(speed, source, left, right, observation_time)?,
            Self::OneCone => one_cone_disparity(speed, source, pair, observation_time)?,
            Self::Published(variant) => {
                if (left.y, left.z) != (right.y, right.z) {
                    return Err(PairError::OffTheMotion(self));
                }
                match source.simplest() {
                    Source::Point(point) => published_of_pair(speed, point, pair, observation_time, variant)?,
                    Source::Wheel(wheel) => {
                        check_inputs(wheel, left, observation_time)?;
                        check_inputs(wheel, right, observation_time)?;
                        wheel.published_disparity(speed, pair, observation_time, variant)
                    }
                }
            }
        })
    }

    /// Returns the stereo position of `source` in this model for the `pair` of apertures, from the middle
    /// between them.
    ///
    /// # Accuracy
    ///
    /// As [`stereo()`], which it is; with one cone as [`sighting`].
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain; lines of sight that do not meet, as in a published model.
    pub fn stereo(
        self,
        speed: &Speed,
        source: impl Into<Source>,
        pair: [Aperture; 2],
        observation_time: f64,
    ) -> Result<Stereo, StereoError> {
        match self {
            Self::Exact => stereo(speed, source, pair, observation_time),
            // Both look at one event, which they take to be where it is.
            Self::OneCone => {
                let position = sighting(speed, source, middle(pair), observation_time)?.position;
                Ok(Stereo { gain: 1.0, position, miss: 0.0 })
            }
            Self::Published(_) => Err(StereoError::Published(self.name())),
        }
    }

    /// Both lines of sight in this model; `None` of a point inside both apertures.
    ///
    /// # Errors
    ///
    /// A coordinate or time outside the domain; a pair that is not along x, in a published model.
    pub(crate) fn lines_of_sight(
        self,
        speed: &Speed,
        source: impl Into<Source>,
        pair: [Aperture; 2],
        observation_time: f64,
    ) -> Result<Option<SightPair<f64>>, PairError> {
        let source = source.into();
        let [left, right] = pair;
        for aperture in pair {
            check_inputs(source, aperture, observation_time)?;
        }
        if matches!(self, Self::Published(_)) && (left.y, left.z) != (right.y, right.z) {
            return Err(PairError::OffTheMotion(self));
        }
        let Aperture { y, z, .. } = middle(pair);
        Ok(match (self, source.simplest()) {
            (_, Source::Point(point)) => {
                let (cones, _) = self.cone_pair(speed, point, pair, observation_time);
                cones.lines_of_sight(point.y - y, point.z - z)
            }
            (Self::Exact, Source::Wheel(wheel)) => {
                Some(wheel.seen_by_pair(speed, pair, observation_time, baseline(pair)).lines)
            }
            (Self::OneCone, Source::Wheel(wheel)) => {
                let seen = wheel.seen(speed, middle(pair), observation_time).cone;
                one_cone::cone_pair(&seen, pair).lines_of_sight(seen.y, seen.z)
            }
            (Self::Published(variant), Source::Wheel(wheel)) => {
                Some(wheel.seen_as_published(speed, pair, observation_time, variant).0.lines)
            }
        })
    }

    /// Both light cones, and by how much the second one's observation time is later. The published model
    /// takes pairs of apertures on a line along x.
    #[inline]
    pub(crate) fn cone_pair(
        self,
        speed: &Speed,
        point: SourcePoint,
        pair: [Aperture; 2],
        observation_time: f64,
    ) -> (ConePair<f64>, f64) {
        let [primary, secondary] = pair;
        match self {
            Self::Exact => {
                let coefficients = speed.coefficients();
                (ConePair::new(&coefficients, point, primary, secondary, observation_time), 0.0)
            }
            Self::OneCone => {
                let middle = one_cone::middle_cone(speed, point, pair, observation_time);
                (one_cone::cone_pair(&middle, pair), 0.0)
            }
            Self::Published(variant) => {
                // The paper puts the origin midway between both apertures.
                let point = point.relative_to(middle(pair));
                published::cone_pair(speed, point, secondary.x - primary.x, observation_time, variant)
            }
        }
    }
}

/// The published model of a pair along x, of which it knows one about the origin.
fn published_of_pair(
    speed: &Speed,
    point: SourcePoint,
    [left, right]: [Aperture; 2],
    observation_time: f64,
    variant: PublishedVariant,
) -> Result<Disparity, DomainError> {
    let middle = middle([left, right]);
    let separation = right.x - left.x;
    let both = published_disparity(speed, point.relative_to(middle), separation, observation_time, variant)?;
    // The clock's zero stays with the ground's origin.
    let shift = speed.beta() * speed.gamma() * middle.x;
    let proper_time = |seen: Sighting| Sighting { proper_time: seen.proper_time - shift, ..seen };
    Ok(Disparity { primary: proper_time(both.primary), secondary: proper_time(both.secondary), ..both })
}

#[cfg(feature = "clap")]
impl clap::ValueEnum for Model {
    fn value_variants<'a>() -> &'a [Self] {
        &Self::ALL
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        let help = match self {
            Self::Exact => "Each eye solves its own light cone",
            Self::OneCone => {
                "As if both eyes received the same events: those that the middle between them receives"
            }
            Self::Published(PublishedVariant::AppendixA) => {
                "The paper's binocular model, as its Appendix A prints it: the right eye is the left one at T − ΔT, without parallax"
            }
            Self::Published(PublishedVariant::TextSign) => {
                "The same with the sign of the delay that the paper's text gives"
            }
        };
        Some(clap::builder::PossibleValue::new(self.name()).help(help))
    }
}

#[cfg(feature = "serde")]
mod saved {
    use crate::published::PublishedVariant;

    /// The models as files spell them.
    #[derive(serde::Serialize, serde::Deserialize)]
    #[serde(rename_all = "kebab-case")]
    pub enum SavedModel {
        Exact,
        OneCone,
        Published,
        PublishedText,
    }

    impl From<SavedModel> for super::Model {
        fn from(saved: SavedModel) -> Self {
            match saved {
                SavedModel::Exact => Self::Exact,
                SavedModel::OneCone => Self::OneCone,
                SavedModel::Published => Self::Published(PublishedVariant::AppendixA),
                SavedModel::PublishedText => Self::Published(PublishedVariant::TextSign),
            }
        }
    }

    impl From<super::Model> for SavedModel {
        fn from(model: super::Model) -> Self {
            match model {
                super::Model::Exact => Self::Exact,
                super::Model::OneCone => Self::OneCone,
                super::Model::Published(PublishedVariant::AppendixA) => Self::Published,
                super::Model::Published(PublishedVariant::TextSign) => Self::PublishedText,
            }
        }
    }
}
