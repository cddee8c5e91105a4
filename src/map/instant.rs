//! The present T of an observer, as the map asks for it: where points are, and where they are seen.

use glam::DVec3;
use relativity_core::{Aperture, Model, Observer, ObserverVelocity, Stereo, Worldline};
use relativity_render::{Camera, Geometry, GroupView, MaterialPoint, Motion, Velocity, View};

use super::present::{Present, measured_by};
use crate::scene::Track;
use crate::settings::{LookSettings, MapFrame, Rider, Settings};

/// A picture of a body on the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyPicture {
    /// The whole body at one time of the frame that is drawn.
    Measured,
    /// The body where the left (0) or the right (1) eye sees it.
    Seen(usize),
    /// The body where two eyes place it: where their lines of sight cross.
    Stereo,
}

impl BodyPicture {
    /// Every picture, in the order in which they are drawn.
    pub const ALL: [Self; 4] = [Self::Measured, Self::Seen(0), Self::Seen(1), Self::Stereo];

    /// Returns the words for the picture, after the name of a body.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Measured => "measured now",
            Self::Seen(0) => "as the left eye sees it",
            Self::Seen(_) => "as the right eye sees it",
            Self::Stereo => "where two eyes place it",
        }
    }
}

/// The present T, in the frame in which the map is drawn.
#[derive(Debug, Clone)]
pub struct MapInstant<'a> {
    settings: &'a Settings,
    /// The time of the settings: T, or the clock of who rides.
    time: f64,
    rider: Rider,
    seen: [View; 2],
    model: Model,
}

impl<'a> MapInstant<'a> {
    /// T = `time` of `settings`.
    #[must_use]
    pub fn new(settings: &'a Settings, time: f64) -> Self {
        // Whatever the views show: what both eyes see, each from where it is.
        let model = settings.model();
        let geometry = if model == Model::OneCone { Geometry::OneCone } else { Geometry::Seen };
        let shown = Settings { look: LookSettings { geometry, ..settings.look }, ..settings.clone() };
        Self { settings, time, rider: settings.rider(time), seen: shown.views_ahead(time), model }
    }

    /// The frame that is drawn.
    #[must_use]
    pub fn frame(&self) -> MapFrame {
        self.settings.map_frame()
    }

    /// Whether what moves so belongs to the street: it has no speed, whatever the scene's is.
    #[must_use]
    pub fn rests(&self, motion: Motion) -> bool {
        motion == Motion::Own(Velocity::REST)
    }

    /// Returns the places of the left and the right eye: of eyes that ride, where light reaches each of them.
    #[must_use]
    pub fn eyes(&self) -> [DVec3; 2] {
        if self.frame() == MapFrame::Rider {
            return self.pair();
        }
        let street = self.places(Motion::Own(Velocity::REST));
        if !self.settings.ride.is_on() {
            return self.settings.apertures().map(|eye| street.measured(position(eye)));
        }
        let frame = self.settings.frame(self.time);
        self.seen.map(|view| {
            let place = position(view.camera.aperture) + street.shift;
            DVec3 { x: frame.event_at(place.into(), view.observation_time).x, ..place }
        })
    }

    /// The eyes in the axes of whoever rides, from the middle between them.
    fn pair(&self) -> [DVec3; 2] {
        self.settings.baseline_at(self.time).apertures().map(position)
    }

    /// The middle between the eyes on the ground.
    #[must_use]
    pub fn observer(&self) -> Observer {
        self.rider.observer()
    }

    /// The place on the map of the middle between the eyes.
    #[must_use]
    pub fn middle(&self) -> DVec3 {
        let [left, right] = self.eyes();
        0.5 * (left + right)
    }

    /// Returns the places of everything with this `motion`.
    #[must_use]
    pub fn places(&self, motion: Motion) -> Places {
        let Settings { motion: set, .. } = self.settings;
        let frame = self.settings.frame(self.time);
        let observer = self.rider.observer();
        let (here, is_riders) = (DVec3::from(observer.place), self.frame() == MapFrame::Rider);
        let now = frame.event_at(observer.place, observer.time);
        let shift = DVec3::new(0.0, set.depth_shift, set.height_shift);
        // On the ground is what eyes at rest would see that receive the same light.
        let from = if is_riders { frame } else { ObserverVelocity::REST };
        let seen = self.seen.map(|view| View { camera: Camera { velocity: from, ..view.camera }, ..view });
        let along_street = Velocity::along_street(&frame);
        let velocity = self.settings.velocity(motion);
        Places {
            shift,
            origin: if is_riders { DVec3 { x: now.x, ..here } } else { DVec3::ZERO },
            eyes: match self.frame() {
                MapFrame::Rider => self.pair(),
                _ => seen.map(|view| position(view.camera.aperture) + shift),
            },
            pair: self.settings.baseline_at(self.time).stereo_apertures(self.settings.ride.is_on()),
            model: self.model,
            seen: seen.map(|view| view.of_group(motion)),
            observer,
            present: Present {
                on_ground: velocity,
                relative: velocity.seen_from(along_street.unwrap_or(Velocity::REST)),
                time: now.t,
            },
            aslant: along_street
                .is_none()
                .then(|| measured_by(&observer, here - shift, self.settings.speed()).of_group(motion)),
            frame: self.frame(),
        }
    }

    /// Returns the place of the point in `picture`; `None` where there is none, or outside the domain of the
    /// core.
    #[must_use]
    pub fn place(&self, point: &Track, picture: BodyPicture) -> Option<DVec3> {
        self.places(point.motion).place(picture, point.point())
    }
}

/// The places of a group's points in each picture.
#[derive(Debug, Clone, Copy)]
pub struct Places {
    /// From the scene's coordinates to those from between the eyes.
    shift: DVec3,
    /// The origin of the map in its frame.
    origin: DVec3,
    /// Places of the eyes on the map, where light reaches them.
    eyes: [DVec3; 2],
    /// The eyes, from the middle between them.
    pair: [Aperture; 2],
    model: Model,
    seen: [GroupView; 2],
    /// The observer at the present.
    observer: Observer,
    /// The present of the frame that is drawn.
    present: Present,
    /// View of what is measured in the frame of an observer who does not move along the street.
    aslant: Option<GroupView>,
    frame: MapFrame,
}

impl Places {
    /// Returns the place of the scene's `point` in `picture`; `None` where there is none, or outside the
    /// domain of the core.
    #[must_use]
    pub fn place(&self, picture: BodyPicture, point: impl Into<MaterialPoint>) -> Option<DVec3> {
        let point = point.into();
        let place = match (picture, self.frame) {
            (BodyPicture::Measured, _) => self.measured(point),
            (BodyPicture::Seen(eye), MapFrame::Ground | MapFrame::Rider) => {
                self.eyes[eye] + self.seen[eye].apparent_position(point)?
            }
            // Two eyes that ride place it in their own frame.
            (BodyPicture::Stereo, MapFrame::Ground) if !self.observer.velocity.is_rest() => return None,
            (BodyPicture::Stereo, MapFrame::Ground | MapFrame::Rider) => self.stereo(point)?.position.into(),
            // Its light left it where it was in that frame.
            (BodyPicture::Seen(eye), MapFrame::Bicycle) if self.present.relative == Velocity::REST => {
                self.seen[eye].place_when_shown(point) + self.shift
            }
            _ => return None,
        };
        place.is_finite().then_some(place)
    }

    /// Returns the image of a ball of this `radius` around the `point`: its radii along x, y and z, from the
    /// place of the point.
    #[must_use]
    pub fn ball(
        &self,
        picture: BodyPicture,
        point: impl Into<MaterialPoint>,
        radius: f64,
    ) -> Option<[DVec3; 3]> {
        let point = point.into();
        let centre = self.place(picture, point)?;
        let radius_along = |axis: DVec3| {
            let end = MaterialPoint { rest: point.rest + radius * axis, ..point };
            Some(self.place(picture, end)? - centre)
        };
        Some([radius_along(DVec3::X)?, radius_along(DVec3::Y)?, radius_along(DVec3::Z)?])
    }

    fn stereo(&self, point: MaterialPoint) -> Option<Stereo> {
        let point = point.moved(self.shift.to_array());
        self.present.on_ground.stereo_before(&self.observer, self.model, point, self.pair).ok()
    }

    /// Returns the place of the `point` now.
    #[must_use]
    pub fn measured(&self, point: impl Into<MaterialPoint>) -> DVec3 {
        if let Some(aslant) = &self.aslant {
            return aslant.apparent_position(point).unwrap_or(DVec3::NAN);
        }
        let Present { relative, time, .. } = self.present;
        let place = self.present.place(point.into());
        let now = Worldline::at_rest(relative, place.x).at(time);
        DVec3 { x: now.x, ..place } - self.origin + self.shift
    }
}

fn position(eye: Aperture) -> DVec3 {
    DVec3::new(eye.x, eye.y, eye.z)
}
