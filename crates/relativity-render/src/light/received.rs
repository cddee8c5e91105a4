//! Received light by group and band: so that a picture can say why a part of it is dark, from the places of
//! the bodies alone.

use std::slice;

use super::screen_light::Light;
use crate::geometry::capsule::Capsule;
use crate::kinematics::spin::MaterialPoint;
use crate::scene::prepared_body::PreparedBody;
use crate::scene::prepared_scene::{PreparedGroup, PreparedScene};
use crate::view::group_view::GroupView;
use crate::view::{Appearance, View};

/// Places along a capsule at which its light is sampled, as parts of its length.
const PLACES: [f64; 3] = [1.0 / 6.0, 0.5, 5.0 / 6.0];

/// Parts of a group's picture by the band of [`Band::ALL`](crate::colour::spectrum::Band::ALL) in which they
/// are received. They add up to 1, or are all 0 where nothing of it is in the picture.
pub type Shares = [f64; 3];

impl PreparedScene {
    /// The shares of each group in the picture of `view`: about, since neither what hides what nor an outline
    /// is worked out. False colours leave nothing dark.
    ///
    /// # Examples
    ///
    /// ```
    /// use relativity_core::{Aperture, Speed};
    /// use relativity_render::{Appearance, Body, Camera, Gaze, Geometry, PreparedScene, Shape, View};
    ///
    /// // A red ball far to the left comes at 0.9 c: its light arrives at 700 nm / 4.36.
    /// let ball = Body::new(Shape::Sphere { centre: [-50.0, 1.0, 0.0], radius: 0.5 }, 700.0);
    /// let scene = PreparedScene::moving(&[ball]);
    /// let gaze = Gaze { azimuth: std::f64::consts::PI, elevation: 0.0 };
    /// let camera = Camera::new(Aperture::default(), gaze, 1.0, [640, 480]);
    /// let speed = Speed::from_beta(0.9)?;
    /// let view = View { camera, speed, observation_time: 0.0, geometry: Geometry::Seen };
    /// assert_eq!(scene.received_shares(&view, &Appearance::default()), [[1.0, 0.0, 0.0]]);
    /// # Ok::<(), relativity_core::SpeedError>(())
    /// ```
    #[must_use]
    pub fn received_shares(&self, view: &View, appearance: &Appearance) -> Vec<Shares> {
        let shares = |(group, seen): (&PreparedGroup, GroupView)| {
            let mut shares = Shares::default();
            for body in &self.bodies()[group.bodies.clone()] {
                let light = Light::new(body.emission, appearance);
                let ahead = seen.on_ground.speed.head_on_doppler_factor();
                let lit = if seen.is_lit_by_the_street(appearance) { ahead } else { 1.0 };
                let ball = body.block.as_ref().map(|block| block.ball_around());
                let capsules = ball.as_ref().map_or_else(|| self.capsules(body), slice::from_ref);
                let samples = capsules.iter().flat_map(|capsule| samples(capsule, body, &seen));
                for LightSample { weight, doppler_factor } in samples {
                    shares[light.band(appearance, lit * doppler_factor) as usize] += weight;
                }
            }
            normalised(shares)
        };
        self.groups().iter().zip(self.group_views(view)).map(shares).collect()
    }
}

/// The light that arrives from one place.
struct LightSample {
    /// About how large it is in the picture, 0 outside.
    weight: f64,
    doppler_factor: f64,
}

/// The light from the places of `capsule`, which contains a part of `body`.
fn samples<'a>(
    capsule: &'a Capsule,
    body: &'a PreparedBody,
    seen: &'a GroupView,
) -> impl Iterator<Item = LightSample> + 'a {
    let length = capsule.from.distance(capsule.to) / PLACES.len() as f64;
    let area = capsule.radius * (length + capsule.radius);
    PLACES.into_iter().filter_map(move |place| {
        let rest = capsule.from.lerp(capsule.to, place);
        let spin = body.spin.filter(|_| body.is_turned);
        let place = seen.place_when_shown(MaterialPoint { rest, spin });
        let apparent = seen.apparent_position(place)?;
        let line_of_sight = apparent.try_normalize()?;
        let of_group = seen.rest_ray_at(line_of_sight, apparent.length()).doppler_factor;
        let doppler_factor = of_group * body.spin.map_or(1.0, |spin| seen.own_doppler(&spin, place));
        // Aberration makes what is blueshifted smaller: solid angles by D^2.
        let angle = area / (place.distance_squared(seen.origin) + area) / (of_group * of_group);
        let weight = if seen.camera.shows(line_of_sight) { angle } else { 0.0 };
        weight.is_finite().then_some(LightSample { weight, doppler_factor })
    })
}

/// `shares` scaled to a sum of 1, if they have one.
fn normalised(shares: Shares) -> Shares {
    let sum: f64 = shares.iter().sum();
    if sum > 0.0 { shares.map(|share| share / sum) } else { Shares::default() }
}
