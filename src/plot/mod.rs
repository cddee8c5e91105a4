//! Plots without the toolkit: what is in a panel, its axes and ticks, how curves are sampled, where labels
//! stand; and panels as SVG.

mod axis;
mod curve;
mod drawing;
mod grid;
mod panel;
mod places;
mod tick_text;

pub use self::axis::{
    Axis, MOST_TICKS, Tick, at_least, extent, round_step, ticks_along, widened, with_margin, zoom_step,
};
pub use self::curve::{CurveSample, CurveSampling, RefinementLimits, even_times, refined};
pub use self::drawing::svg;
#[cfg(feature = "desktop")]
pub use self::drawing::svg_of_rows;
#[cfg(feature = "desktop")]
pub use self::panel::VERMILION;
pub use self::panel::{BLACK, BLUE, Dash, Line, LineStroke, Panel};
pub use self::places::{Area, LabelPlaces};
