//! What two apertures see of a point of a wheel, in every binocular model.

use crate::apparent::{Aperture, Sighting, check_inputs, sighting};
use crate::disparity::Disparity;
use crate::model::{Model, PairError};
use crate::one_cone::{middle, one_cone_disparity};
use crate::speed::Speed;
use crate::stereo::{self, Stereo, StereoError};
use crate::wheel::WheelPoint;

/// [`Model::disparity`] of a point of a wheel.
pub(crate) fn disparity(
    model: Model,
    speed: &Speed,
    wheel: WheelPoint,
    pair: [Aperture; 2],
    observation_time: f64,
) -> Result<Disparity, PairError> {
    for aperture in pair {
        check_inputs(wheel.hub, aperture, observation_time)?;
    }
    Ok(match model {
        Model::Exact => {
            let [primary, secondary] =
                pair.map(|eye| wheel.seen(speed, eye, observation_time).sighting(speed, eye));
            let (dphi, dtheta) = (primary.phi() - secondary.phi(), primary.theta() - secondary.theta());
            Disparity { primary, secondary, dphi, dtheta }
        }
        Model::OneCone => {
            let seen = wheel.seen(speed, middle(pair), observation_time);
            let both = one_cone_disparity(speed, seen.place, pair, observation_time)?;
            let turning = |at_rest: Sighting| Sighting {
                doppler_factor: at_rest.doppler_factor * seen.own_doppler,
                ..at_rest
            };
            Disparity { primary: turning(both.primary), secondary: turning(both.secondary), ..both }
        }
        Model::Published(_) => {
            let place = wheel.seen(speed, pair[0], observation_time).place;
            model.disparity(speed, place, pair, observation_time)?
        }
    })
}

/// [`Model::stereo`] of a point of a wheel.
pub(crate) fn stereo(
    model: Model,
    speed: &Speed,
    wheel: WheelPoint,
    pair: [Aperture; 2],
    observation_time: f64,
) -> Result<Stereo, StereoError> {
    match model {
        Model::Exact => stereo::stereo(
            speed,
            wheel.seen(speed, middle(pair), observation_time).place,
            pair,
            observation_time,
        ),
        Model::OneCone => {
            let position = sighting(speed, wheel, middle(pair), observation_time)?.position;
            Ok(Stereo { gain: 1.0, position, miss: 0.0 })
        }
        Model::Published(_) => Err(StereoError::Published(model.name())),
    }
}
