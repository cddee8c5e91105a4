//! The goal of automatic quality: an error that no picture exceeds, or a time that a frame may take.

use std::ops::RangeInclusive;

use clap::{ArgMatches, Args, Command, FromArgMatches};
use serde::{Serialize, Serializer};

use super::within;

/// Smallest and largest error that can be set, pixels.
pub const ERROR_PX: RangeInclusive<f64> = 1e-6..=100.0;
/// Shortest and longest time that can be, milliseconds.
pub const BUDGET_MS: RangeInclusive<f64> = 0.01..=1e6;

/// The goal that automatic quality keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Goal {
    /// The cheapest method whose stated error is no more than this, pixels.
    Error(f64),
    /// The most accurate method that draws the pictures of a frame in this time, milliseconds.
    Budget(f64),
}

impl Goal {
    /// Default error, pixels.
    pub const DEFAULT_ERROR_PX: f64 = 0.1;
    /// The budget that a control begins with, milliseconds: of a frame at 60 a second.
    pub const USUAL_BUDGET_MS: f64 = 16.0;
}

impl Default for Goal {
    fn default() -> Self {
        Self::Error(Self::DEFAULT_ERROR_PX)
    }
}

/// The two flags of a goal, of which one is given.
#[derive(Debug, Args)]
#[group(multiple = false)]
struct GoalArgs {
    /// With the automatic renderer: how far anything may be drawn from where it is seen, pixels. The cheapest
    /// method within this bound draws.
    #[arg(long, value_name = "PX", value_parser = within(ERROR_PX), allow_hyphen_values = true)]
    error: Option<f64>,
    /// With the automatic renderer: how long the pictures of a frame may take, milliseconds. The most
    /// accurate method within this budget draws; if there is none, the cheapest.
    #[arg(long, value_name = "MS", value_parser = within(BUDGET_MS), allow_hyphen_values = true)]
    budget: Option<f64>,
}

impl Serialize for Goal {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map([match self {
            Self::Error(px) => ("error", px),
            Self::Budget(ms) => ("budget", ms),
        }])
    }
}

impl Args for Goal {
    fn augment_args(command: Command) -> Command {
        GoalArgs::augment_args(command)
    }

    fn augment_args_for_update(command: Command) -> Command {
        GoalArgs::augment_args_for_update(command)
    }
}

impl FromArgMatches for Goal {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut goal = Self::default();
        goal.update_from_arg_matches(matches)?;
        Ok(goal)
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        let GoalArgs { error, budget } = GoalArgs::from_arg_matches(matches)?;
        *self = error.map(Self::Error).or(budget.map(Self::Budget)).unwrap_or(*self);
        Ok(())
    }
}
