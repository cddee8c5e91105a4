//! Automatic quality: which method draws a view, from what is stated of each one's error and known of its
//! cost.
//!
//! Costs are measured in passing. What is not measured is expected; what might be cheaper is tried for a
//! frame now and then while pictures change, in at most [`TRIED_SHARE`] of the time.

mod best;
mod choice;
mod costs;
mod stated;
#[cfg(test)]
mod tests;

use relativity_render::{Geometry, Method, PreparedScene, View};

use best::{Offer, best};
pub use choice::{Choice, method_name};
use costs::Costs;
pub use costs::Machine;
use stated::{StatedMethod, candidates};

use super::REFERENCE_SAMPLES;
use crate::flags::Goal;

/// The share of the time in which other methods are tried.
const TRIED_SHARE: f64 = 0.02;
/// Time from the appearance of a scene to the first trial, and from one trial to the next, milliseconds.
const FIRST_TRIAL_MS: f64 = 1000.0;
/// Time after which a measured method is tried again, milliseconds.
const STALE_MS: f64 = 10_000.0;
/// Factor of cost from which a measured method is far worse, and is not tried again.
const FAR_WORSE: f64 = 3.0;
/// Factor of cost from which a method that is only expected to be worse is not tried at all.
const EXPECTED_FAR_WORSE: f64 = 5.0;

/// The views of a frame that are drawn by one method.
#[derive(Debug, Clone, Copy)]
pub struct MethodViews<'a> {
    /// Scene that is seen.
    pub scene: &'a PreparedScene,
    /// The view that is drawn, of those of the frame.
    pub view: &'a View,
    /// Number of pixels of all views.
    pub pixels: f64,
}

/// The automatic choice: the cheapest method that keeps an error, or the most accurate that keeps a time.
#[derive(Debug)]
pub struct Automatic {
    /// The costs that were measured, from which others are expected.
    pub costs: Costs,
    scene: Option<PreparedScene>,
    /// Methods that drew views of each kind last.
    kept: Vec<(Geometry, Method)>,
    /// When something may be tried, milliseconds.
    next_trial_ms: Option<f64>,
    /// Whether the rays of the device may be chosen, if there is one.
    has_rays: bool,
}

impl Automatic {
    /// On this `machine`, of which nothing is known yet.
    #[must_use]
    pub const fn new(machine: Machine) -> Self {
        Self::with_samples(machine, REFERENCE_SAMPLES)
    }

    /// Automatic quality on this `machine`, where the reference draws with `samples` times `samples` rays per
    /// pixel.
    #[must_use]
    pub const fn with_samples(machine: Machine, samples: u32) -> Self {
        let costs = Costs::new(machine, samples);
        Self { costs, scene: None, kept: Vec::new(), next_trial_ms: None, has_rays: true }
    }

    /// Returns this with `has_rays`: whether the rays of the device may be chosen.
    #[must_use]
    pub fn with_rays(self, has_rays: bool) -> Self {
        Self { has_rays, ..self }
    }

    /// The methods that there are for `sight`, and what each is known or expected to cost.
    fn offers(&self, sight: MethodViews<'_>) -> Vec<Offer> {
        let MethodViews { scene, view, pixels } = sight;
        let has_gpu = self.costs.machine != Machine::Cpu;
        let offer = |StatedMethod { method, error_px }| {
            let ms = self.costs.expected_ms(method, view.geometry, pixels);
            Offer { method, error_px, ms }
        };
        let is_drawn = |candidate: &StatedMethod| self.has_rays || candidate.method != Method::Rays;
        candidates(has_gpu, scene, view).into_iter().filter(is_drawn).map(offer).collect()
    }

    /// Returns the method that draws `sight`; `None` if none does.
    pub fn choose(&mut self, goal: Goal, sight: MethodViews<'_>) -> Option<Choice> {
        if self.scene.as_ref() != Some(sight.scene) {
            self.scene = Some(sight.scene.clone());
            self.costs.forget();
            self.kept.clear();
            self.next_trial_ms = None;
        }
        let geometry = sight.view.geometry;
        let place = self.kept.iter().position(|(of, _)| *of == geometry);
        let kept = place.map(|place| self.kept.swap_remove(place).1);
        let Offer { method, error_px, ms } = best(goal, &self.offers(sight), kept)?;
        self.kept.push((geometry, method));
        let is_measured = self.costs.measured_at(method, geometry).is_some();
        let holds = match goal {
            Goal::Error(px) => error_px <= px,
            Goal::Budget(budget) => ms <= budget,
        };
        Some(Choice { method, error_px, ms, is_measured, goal, holds })
    }

    /// Returns the method that draws the next frame of `sight` in place of the one `chosen`, so that its cost
    /// becomes known.
    pub fn trial(&mut self, chosen: &Choice, sight: MethodViews<'_>, now_ms: f64) -> Option<Method> {
        let geometry = sight.view.geometry;
        // The cost of what draws comes first.
        let own_ms = self.costs.measured_ms(chosen.method, geometry, sight.pixels)?;
        let next_ms = *self.next_trial_ms.get_or_insert(now_ms + FIRST_TRIAL_MS);
        if now_ms < next_ms {
            return None;
        }
        let offers = self.offers(sight);
        let is_worth_it = |offer: &Offer| {
            let at_ms = self.costs.measured_at(offer.method, geometry);
            let most = if at_ms.is_some() { FAR_WORSE } else { EXPECTED_FAR_WORSE };
            let is_of_use = match chosen.goal {
                Goal::Error(px) => offer.error_px <= px && offer.ms <= most * own_ms,
                Goal::Budget(budget) if chosen.holds => {
                    offer.error_px < chosen.error_px && offer.ms <= most * budget
                }
                Goal::Budget(_) => offer.ms <= most * own_ms,
            };
            let is_old = at_ms.is_none_or(|at_ms| now_ms - at_ms >= STALE_MS);
            offer.method != chosen.method && is_of_use && is_old
        };
        let tried = offers.into_iter().filter(is_worth_it).min_by(|a, b| a.ms.total_cmp(&b.ms))?;
        // Paid for before it is done: at what it is expected to take.
        self.next_trial_ms = Some(now_ms + FIRST_TRIAL_MS.max(tried.ms / TRIED_SHARE));
        Some(tried.method)
    }
}
