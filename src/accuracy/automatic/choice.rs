//! The automatic choice, and its description in words.

use std::fmt;

use relativity_render::Method;

use crate::flags::Goal;
use crate::number_text;

/// An automatic choice, and the reason for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Choice {
    /// Method that draws.
    pub method: Method,
    /// No point is drawn further from where it is seen, pixels.
    pub error_px: f64,
    /// Time for a frame's pictures, milliseconds.
    pub ms: f64,
    /// Whether that was measured, else it is expected.
    pub is_measured: bool,
    /// Goal of the choice.
    pub goal: Goal,
    /// Whether the goal is kept, as far as is known.
    pub holds: bool,
}

/// Returns the name of a method.
#[must_use]
pub const fn method_name(method: Method) -> &'static str {
    match method {
        Method::Rays => "rays",
        Method::Packets => "packets",
        Method::Mesh => "mesh",
        Method::Reference => "reference",
    }
}

/// A number in the fewest digits that say enough of it.
fn short(number: f64) -> String {
    number_text::trimmed(number, 6)
}

/// Formats a choice like `packets, 4 ms, within 0.002 px`.
impl fmt::Display for Choice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(method_name(self.method))?;
        if self.is_measured {
            let ms = if self.ms < 99.5 {
                number_text::significant(self.ms, 2)
            } else {
                number_text::fixed(self.ms, 0)
            };
            write!(f, ", {ms} ms")?;
            if let (Goal::Budget(budget), true) = (self.goal, self.holds) {
                write!(f, " of {}", short(budget))?;
            }
        }
        match self.error_px {
            0.0 => f.write_str(", exact")?,
            px if px.is_finite() => write!(f, ", within {} px", short(px))?,
            _ => f.write_str(", in 32-bit floats, which err at such speeds")?,
        }
        match self.goal {
            Goal::Error(px) if !self.holds => write!(f, "; no method here keeps {} px", short(px)),
            Goal::Budget(ms) if !self.holds => write!(f, "; no method keeps {} ms", short(ms)),
            Goal::Error(_) | Goal::Budget(_) => Ok(()),
        }
    }
}
