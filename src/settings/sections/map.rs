//! The section of the map: its face, its frame, and the part of the world that it holds.

use clap::{Args, ValueEnum};
use serde::Serialize;

/// The face of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MapFace {
    /// Where everything is at the present T, from above and from the side.
    #[default]
    Space,
    /// When everything happens: x against t, light at 45 degrees.
    Spacetime,
}

/// A frame of reference for the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MapFrame {
    /// Frame of the street, where eyes and houses rest.
    #[default]
    Ground,
    /// Frame of everything that moves at the scene's speed: eyes and street ride past.
    Bicycle,
    /// Frame in which whoever rides rests at this moment, counted from there: the street rides past. That of
    /// the ground while nobody rides.
    Rider,
}

/// Extent of a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum MapFraming {
    /// The whole passage, past both eyes.
    #[default]
    Passage,
    /// The selected body, close up: in space where it is seen and where two eyes place it, with the length of
    /// a rod; in spacetime where the followed points are now, with their clocks.
    CloseUp,
}

/// The contents of the map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Map")]
pub struct MapSettings {
    /// Face of the map.
    #[arg(long, value_enum)]
    pub face: MapFace,
    /// The frame in which the map is drawn.
    #[arg(long, value_enum)]
    pub frame: MapFrame,
    /// The part of the world that the map holds.
    #[arg(long, value_enum)]
    pub framing: MapFraming,
}
