//! One frame: what each of the two eyes is to draw at one observation time.

use anyhow::Context as _;
use clap::Args;
use glam::DVec3;
use relativity_core::{Aperture, SourcePoint, Speed, sighting};
use relativity_render::{Camera, Gaze, Geometry, View};

use crate::flags::choices::{GazeChoice, Size, field_of_view, word};
use crate::flags::{SpeedArgs, finite_number};
use crate::passage::{passage_times, time_seen_at};

/// Speed of the paper's cyclist.
const CYCLIST_BETA: f64 = 0.9;

/// Flags of motion and eyes.
#[derive(Debug, Clone, Args)]
pub struct ObserverArgs {
    #[command(flatten)]
    speed: SpeedArgs,
    /// Aperture separation: the eyes rest at x = -d/2 and +d/2.
    #[arg(long, default_value_t = 0.1, value_parser = finite_number, allow_hyphen_values = true)]
    d: f64,
    /// Size of one eye's picture, pixels.
    #[arg(long, default_value_t = Size([960, 720]), value_name = "WxH")]
    size: Size,
    /// Horizontal field of view, degrees.
    #[arg(long, default_value_t = 60.0, value_name = "DEG", value_parser = field_of_view)]
    fov: f64,
    /// Where both eyes look: towards the tracked point, or azimuth (from +x towards +y; 90 is straight
    /// ahead) and elevation in degrees.
    #[arg(long, default_value_t = GazeChoice::Track, value_name = "track|AZ,EL", allow_hyphen_values = true)]
    gaze: GazeChoice,
    /// Which geometry is shown.
    #[arg(long, value_enum, default_value = "seen")]
    geometry: Geometry,
}

/// Eyes, motion and tracked point: all that decides the views but the observation time.
#[derive(Debug, Clone)]
pub struct Observer {
    args: ObserverArgs,
    speed: Speed,
    tracked: [f64; 3],
}

impl Observer {
    /// The observer of a scene with the rest-frame point `tracked`.
    ///
    /// # Errors
    ///
    /// A speed that is none.
    pub fn new(args: &ObserverArgs, tracked: [f64; 3]) -> anyhow::Result<Self> {
        anyhow::ensure!(args.d >= 0.0, "--d {} is negative", args.d);
        Ok(Self { speed: args.speed.speed(CYCLIST_BETA)?, args: args.clone(), tracked })
    }

    /// When the tracked point is seen 45 degrees before it is abreast, as in the window at the start: the
    /// visible strip of the spectrum then runs across the cyclist. 0 at rest.
    pub fn time_of_approach(&self) -> anyhow::Result<f64> {
        let time = time_seen_at(-1.0, &self.speed, self.tracked_source(), self.args.d)?;
        Ok(time.unwrap_or(0.0))
    }

    /// The observation times from which to which the tracked point is seen to pass.
    pub fn passage_times(&self) -> anyhow::Result<[f64; 2]> {
        let times = passage_times(&self.speed, self.tracked_source(), self.args.d)?;
        times.context("a scene at rest passes at no time; --from and --to are needed")
    }

    /// Width and height of one eye's picture, pixels.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.args.size.0
    }

    /// Which geometry is shown.
    #[must_use]
    pub fn geometry(&self) -> Geometry {
        self.args.geometry
    }

    /// What the left and the right eye are shown at `observation_time`.
    ///
    /// # Errors
    ///
    /// A time or a place outside the domain of the core.
    pub fn views(&self, observation_time: f64) -> anyhow::Result<[View; 2]> {
        let straight_ahead = Gaze::along([0.0, 1.0, 0.0]);
        let mut views = Aperture::pair(self.args.d).map(|aperture| View {
            camera: Camera {
                aperture,
                gaze: straight_ahead,
                horizontal_fov: self.args.fov.to_radians(),
                size: self.args.size.0,
            },
            speed: self.speed,
            observation_time,
            geometry: self.args.geometry.of_left_eye(),
        });
        let gaze = match self.args.gaze.fixed() {
            Some(gaze) => gaze,
            None => self.tracking_gaze(&views)?,
        };
        for view in &mut views {
            view.camera.gaze = gaze;
        }
        if self.args.geometry == Geometry::Published {
            views[1] = View { geometry: Geometry::Published, ..views[0] };
        }
        Ok(views)
    }

    /// Towards the mean of the two places where the tracked point appears.
    fn tracking_gaze(&self, views: &[View; 2]) -> anyhow::Result<Gaze> {
        let [left, right] = [self.apparent_position(&views[0])?, self.apparent_position(&views[1])?];
        Ok(Gaze::along((left + right).to_array()))
    }

    /// The tracked point as `view` shows it, from the view's aperture.
    fn apparent_position(&self, view: &View) -> anyhow::Result<DVec3> {
        let Aperture { x, y, z } = view.camera.aperture;
        let source = self.tracked_source();
        let seen = sighting(&self.speed, source, view.camera.aperture, view.observation_time)?;
        Ok(match view.geometry {
            Geometry::Seen | Geometry::Published => seen.position.into(),
            Geometry::Contracted => {
                let objective_x = source.x0 + self.speed.beta() * view.observation_time;
                DVec3::new(objective_x, source.y, source.z) - DVec3::new(x, y, z)
            }
            Geometry::Rest => DVec3::from(self.tracked) - view.rest_origin(),
        })
    }

    fn tracked_source(&self) -> SourcePoint {
        SourcePoint::from_rest(self.tracked, &self.speed)
    }

    /// The flags that make the same views again at `observation_time`, the gaze in angles: whoever
    /// measures a picture needs to know them.
    pub fn flags(&self, observation_time: f64) -> anyhow::Result<Vec<(&'static str, String)>> {
        let (speed, value) = self.args.speed.parameter(CYCLIST_BETA);
        let Gaze { azimuth, elevation } = self.views(observation_time)?[0].camera.gaze;
        Ok(vec![
            (speed.name(), value.to_string()),
            ("d", self.args.d.to_string()),
            ("time", observation_time.to_string()),
            ("size", self.args.size.to_string()),
            ("fov", self.args.fov.to_string()),
            ("gaze", format!("{},{}", azimuth.to_degrees(), elevation.to_degrees())),
            ("geometry", word(&self.args.geometry)),
        ])
    }
}
