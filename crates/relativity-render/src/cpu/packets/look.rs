//! The look of one view: the shaders' parameters, computed once and used by all tiles.

use std::sync::OnceLock;

use crate::frame::pipeline_key::AmongOthers;
use crate::frame::uniform::FrameUniform;
use crate::light::hatch::Hatch;
use crate::light::screen_light::{Light, exposed};
use crate::scene::prepared_body::PreparedBody;
use crate::scene::prepared_scene::PreparedScene;
use crate::scene::wheel::packed::{TurningStart, Turns};
use crate::view::effects::{Effects, Spectrum};
use crate::view::group_view::{GroupView, reference_of_depths};
use crate::view::{Appearance, View};

use super::body::PacketGroup;

/// The look of one view of a scene.
pub struct Look<'a> {
    pub scene: &'a PreparedScene,
    /// View of each group.
    pub views: Vec<GroupView>,
    frames: Vec<FrameUniform>,
    /// The hatch for light outside the visible range.
    pub hatch: Hatch,
    /// Number of the group in which the depths of all are compared.
    reference: usize,
    /// Bodies that turn, with their numbers, which ascend.
    turning: Vec<(usize, Turns, TurningStart)>,
    /// Light of each emission of the scene in the units of the shaders, without and with a Doppler effect.
    lights: Vec<[OnceLock<[f32; 4]>; 2]>,
}

/// A body in one view.
#[derive(Debug, Clone, Copy)]
pub struct Seen<'a> {
    pub body: &'a PreparedBody,
    pub number: usize,
    pub turns: Turns,
    pub shown: TurningStart,
}

impl<'a> Look<'a> {
    /// Returns the look of a picture with `appearance`, or of numbers.
    pub fn new(scene: &'a PreparedScene, view: &View, appearance: Option<&Appearance>) -> Self {
        let views = scene.group_views(view);
        let plain = Appearance::default();
        let appearance = appearance.unwrap_or(&plain);
        let frames = FrameUniform::of_groups(scene, &views, appearance);
        let turning = scene.spinning().iter().filter_map(|&number| {
            let body = &scene.bodies()[number as usize];
            let view = &views[body.group];
            let turns = view.turns(body);
            let shown = view.shown(body, scene.groups()[body.group].extent.middle);
            (turns != Turns::Not).then_some((body.number, turns, shown))
        });
        Self {
            turning: turning.collect(),
            lights: scene.emissions().iter().map(|_| Default::default()).collect(),
            reference: reference_of_depths(&views),
            scene,
            views,
            frames,
            hatch: Hatch::new(view.camera.size, appearance.light),
        }
    }

    /// The group of this number, for the formulas.
    pub fn group(&self, number: usize) -> PacketGroup<'_> {
        PacketGroup { frame: &self.frames[number], geometry: self.views[number].geometry }
    }

    /// Returns the place of the group of this number among others, if there are any.
    pub fn among_others(&self, number: usize) -> Option<AmongOthers> {
        AmongOthers::beside(&self.views, self.reference, number)
    }

    /// The frame of what lies behind all groups.
    pub fn frame(&self) -> &FrameUniform {
        &self.frames[0]
    }

    /// The body of this number.
    #[inline]
    pub fn seen(&self, number: usize) -> Seen<'_> {
        let body = &self.scene.bodies()[number];
        let place = || self.turning.binary_search_by_key(&number, |(number, ..)| *number).ok();
        let (turns, shown) = match body.spin.and_then(|_| place()) {
            Some(place) => (self.turning[place].1, self.turning[place].2),
            None => (Turns::Not, TurningStart { placement: body.placement, spin: [0.0; 4], rim: [0.0; 2] }),
        };
        Seen { body, number, turns, shown }
    }

    /// Returns the effects on a body that turns in this way, in the group of this number.
    pub fn effects(&self, group: usize, turns: Turns, appearance: &Appearance) -> Effects {
        self.views[group].effects(turns, appearance)
    }

    /// The light of `body` for the formulas.
    pub fn light(&self, body: &PreparedBody, turns: Turns, appearance: &Appearance) -> [f32; 4] {
        let effects = self.effects(body.group, turns, appearance);
        let is_changed = effects.spectrum() != Spectrum::AtRest;
        let light = || {
            let light = Light::new(body.emission, appearance).packed(appearance, effects);
            exposed(light, self.frame().exposure, is_changed)
        };
        *self.lights[body.emission_number as usize][usize::from(is_changed)].get_or_init(light)
    }
}
