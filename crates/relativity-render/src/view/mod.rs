//! Views: the physics (`View`) and the looks (`Appearance`) of one aperture's picture.

pub(crate) mod cap;
pub(crate) mod cone;
pub(crate) mod effects;
pub(crate) mod group_view;
mod shown;

use glam::DVec3;
use relativity_core::doppler::BOLOMETRIC_INTENSITY_EXPONENT;
use relativity_core::{Boost, ObserverVelocity, Speed};

use crate::camera::Camera;
use crate::kinematics::relative_velocity::RelativeVelocity;
use crate::kinematics::velocity::Velocity;

/// The geometry that a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
pub enum Geometry {
    /// Exactly as seen, each eye by its own past light cone: each point where it was when its light left it,
    /// t = T − R.
    #[default]
    Seen,
    /// Contracted only: where everything is measured to be at the observation time, x = x₀/γ + βT, as if
    /// light were instantaneous. What Gamow drew. No Doppler effect (D = 1).
    Contracted,
    /// At rest: what a camera that rides along photographs at the same event. D = 1.
    Rest,
    /// The paper's binocular model: the right eye sees of each point what the left eye sees at T − ΔT,
    /// without parallax. Drawn by the mesh renderer.
    ///
    /// A view of it is the right eye's, from the left eye's camera; no ray leads back from there.
    Published,
    /// One light cone for both eyes: as if both received the same events, those that the middle between them
    /// receives. What disappears is due to there being two. Drawn by the mesh renderer and by the reference.
    ///
    /// The middle is where the camera has it: its own place less [`Camera::off_middle`].
    OneCone,
}

impl Geometry {
    /// Returns the shaders' `GEOMETRY`.
    pub(crate) fn number(self) -> f64 {
        match self {
            Self::Seen | Self::Published | Self::OneCone => 0.0,
            Self::Contracted => 1.0,
            Self::Rest => 2.0,
        }
    }

    /// The mesh shaders' `MAP`.
    pub(crate) fn map_number(self) -> f64 {
        match self {
            Self::Seen | Self::Contracted | Self::Rest => self.number(),
            Self::Published => 3.0,
            Self::OneCone => 4.0,
        }
    }

    /// Whether the Doppler factor is other than 1.
    #[must_use]
    pub const fn has_doppler_effect(self) -> bool {
        matches!(self, Self::Seen | Self::Published | Self::OneCone)
    }

    /// Returns the geometry of a pair's left eye: the published model gives it its own light cone.
    #[must_use]
    pub const fn of_left_eye(self) -> Self {
        if matches!(self, Self::Published) { Self::Seen } else { self }
    }
}

/// The view of one aperture: everything that decides which point of which body a pixel shows.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct View {
    /// The camera at the aperture.
    pub camera: Camera,
    /// The scene's speed along +x: that of all groups that have none of their own.
    pub speed: Speed,
    /// T: when the light is received.
    pub observation_time: f64,
    /// Geometry to show.
    pub geometry: Geometry,
}

impl View {
    /// Returns the view in a picture of another size (width and height, pixels).
    #[must_use]
    pub fn with_size(&self, size: [u32; 2]) -> Self {
        Self { camera: Camera { size, ..self.camera }, ..*self }
    }

    /// The velocity of whoever sees it on the ground: the camera's, or in [`Geometry::Rest`] the scene's.
    pub(crate) fn observer_velocity(&self) -> ObserverVelocity {
        if self.geometry == Geometry::Rest {
            return Velocity::forward(self.speed).into();
        }
        self.camera.velocity
    }

    /// Ground time of emission of what is seen along `line_of_sight` (unit vector) at `distance`: in the
    /// ground frame, or in the rest frame for [`Geometry::Rest`].
    pub(crate) fn emission_time(&self, line_of_sight: DVec3, distance: f64) -> f64 {
        let received = self.observation_time;
        // A way on the ground is as much longer as its light is redshifted to the camera.
        let ground = RelativeVelocity::new(Velocity::REST, &self.observer_velocity());
        let on_ground = |line: DVec3, distance: f64| distance / ground.doppler_factor(line);
        match self.geometry {
            Geometry::Seen | Geometry::Published | Geometry::Rest => {
                received - on_ground(line_of_sight, distance)
            }
            Geometry::OneCone => {
                let (_, received) = self.camera.event_of_middle(received);
                let from_middle = self.camera.off_middle + line_of_sight * distance;
                let (line, distance) = (from_middle.normalize_or(line_of_sight), from_middle.length());
                received - on_ground(line, distance)
            }
            // What is measured at one time of the camera's, that is later on the ground where it is further
            // ahead.
            Geometry::Contracted => {
                let later = Boost::from(ground.speed).simultaneous_step(distance).t;
                received - later * ground.motion_from_camera(line_of_sight).x
            }
        }
    }
}

/// The light that the bodies emit, and its way to a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
pub enum Colour {
    /// Each body sends light of one wavelength (a spectral line), as in the paper.
    #[default]
    OneWavelength,
    /// Each body glows: a black body of one temperature H, seen as one of the temperature D·H (Planck's law).
    Glowing,
    /// Each body reflects daylight as it is measured at the ground, as if the lamp rode along with it: by its
    /// paint, or as smooth paint of the colour of its wavelength, if eyes see that.
    White,
    /// Each body reflects the street's daylight, which comes equally from all sides there: what moves
    /// receives it blue and bright ahead, red and dim behind, and its light is shifted again on its way to
    /// the eye. Needs the Doppler shift, and a camera that does not ride along with the scene; else as
    /// `white`.
    StreetDaylight,
    /// False colours, which show the Doppler factor: grey at D = 1, blue above, red below.
    False,
}

/// Colours of the street, its ground, its house fronts and the sky before eyes that ride along it: to eyes at
/// rest they are as painted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
pub enum StreetColours {
    /// As painted, at any speed: something for motion to be seen against.
    Painted,
    /// Doppler shifted, bluer ahead and redder behind; white stays as bright as at rest, so that contrasts
    /// do.
    #[default]
    Shifted,
    /// Doppler shifted and as bright as received: dazzling ahead, dark behind.
    Received,
}

/// The way in which form is shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "kebab-case"))]
pub enum Shading {
    /// Plain emission, as in the paper.
    Emission,
    /// A gentle shading fixed to the rest frame.
    #[default]
    Form,
}

/// The looks of a picture. Each effect that is off costs nothing.
#[expect(clippy::struct_excessive_bools, reason = "they are independent switches")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Appearance {
    /// Light that bodies emit.
    pub colour: Colour,
    /// Temperature of bodies that glow, K, above 0.
    pub temperature_k: f64,
    /// Whether the Doppler factor shifts the wavelength.
    pub doppler_shift: bool,
    /// Exponent n of the received intensity D^n of light of one wavelength; `None` leaves it out.
    pub intensity_exponent: Option<f64>,
    /// Exposure: factor on linear light is 2^`exposure_ev`.
    pub exposure_ev: f64,
    /// Whether what is received as ultraviolet or infrared keeps its form, in hatched grey; else it is black.
    pub invisible: bool,
    /// Shading of the bodies.
    pub shading: Shading,
    /// Height z of the resting ground; `None` leaves it out.
    pub ground_z: Option<f64>,
    /// Place of a road along x on the ground: y of its near and of its far kerb. `None` draws a grid.
    pub road: Option<[f64; 2]>,
    /// y of a row of house fronts beyond that road; `None` leaves them out. They lie behind all bodies.
    pub fronts: Option<f64>,
    /// Whether the sky behind is a gradient (else plain).
    pub sky: bool,
    /// Colours of street and sky before a camera that rides.
    pub street: StreetColours,
    /// Whether sky and ground suit a light window (else a dark one).
    pub light: bool,
}

impl Appearance {
    /// The temperature of what glows unless another is chosen, K: 1000 degrees Celsius, orange.
    pub const TEMPERATURE_K: f64 = 1273.15;

    /// Whether what moves is lit by daylight that rests on the street, as `geometry` shows it.
    #[must_use]
    pub fn is_lit_by_the_street(&self, geometry: Geometry) -> bool {
        self.colour == Colour::StreetDaylight && self.doppler_shift && geometry.has_doppler_effect()
    }
}

impl Default for Appearance {
    /// The intensity of a surface that shines in one wavelength, every effect on, no ground.
    fn default() -> Self {
        Self {
            colour: Colour::default(),
            temperature_k: Self::TEMPERATURE_K,
            doppler_shift: true,
            intensity_exponent: Some(BOLOMETRIC_INTENSITY_EXPONENT),
            exposure_ev: 0.0,
            invisible: true,
            shading: Shading::default(),
            ground_z: None,
            road: None,
            fronts: None,
            sky: true,
            street: StreetColours::default(),
            light: false,
        }
    }
}
