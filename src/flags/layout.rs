//! Layouts: how the pictures of the two eyes are shown together, in the window and in files.

use std::str::FromStr;

use clap::ValueEnum;
use relativity_render::Composition;
use relativity_render::picture::compose::Top;
use serde::{Serialize, Serializer};

use crate::eye_colours;

/// The layout of the pictures of the two eyes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, ValueEnum, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Layout {
    /// The left eye's picture on the left, the right eye's on the right.
    #[default]
    SideBySide,
    /// Side by side for eyes that look in parallel, through the screen: no further apart than pupils are
    /// (--picture-distance), as far as the screen's density is known (--screen-width). A file records how
    /// large it has to be shown for that.
    FreeViewing,
    /// The other way round, for eyes that look at a point in front of the screen.
    CrossEyed,
    /// The left eye only.
    Left,
    /// The right eye only.
    Right,
    /// For red-cyan glasses: the left eye's brightness in red, the right eye's in cyan. No colour is lost.
    Anaglyph,
    /// For red-cyan glasses: colours as faithful as they allow, by Dubois' least squares. Pure red is dark to
    /// the right eye.
    Dubois,
    /// The left eye in blue and the right eye in orange, added.
    Overlay,
    /// The left eye's picture above the right eye's.
    OverUnder,
    /// Side by side, each picture at half its width, as 3-D televisions and projectors take it.
    HalfSideBySide,
    /// The left eye's picture above the right eye's, each at half its height, as 3-D televisions and
    /// projectors take it.
    HalfOverUnder,
    /// Rows of the left and the right eye's picture in turn, the topmost the left eye's, for screens whose
    /// rows are polarised in turn.
    Rows,
    /// The left eye's picture and the right eye's in turn, three times a second: depth shows without glasses.
    /// A file is animated.
    Flicker,
}

/// The form in which the pictures share the place where they are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// A single eye's picture (0 left, 1 right).
    One(usize),
    /// Pictures beside each other.
    Beside,
    /// Pictures one above the other.
    Above,
    /// Pictures mixed pixel by pixel.
    Composed(Composition),
    /// Pictures one after the other.
    InTurn,
}

impl Layout {
    /// Returns the form in which the pictures share the place where they are shown.
    #[must_use]
    pub const fn form(self) -> Form {
        match self {
            Self::SideBySide | Self::FreeViewing | Self::CrossEyed => Form::Beside,
            Self::Left => Form::One(0),
            Self::Right => Form::One(1),
            Self::Anaglyph => Form::Composed(Composition::Anaglyph),
            Self::Dubois => Form::Composed(Composition::Dubois),
            Self::Overlay => Form::Composed(Composition::Overlay(eye_colours::ON_DARK)),
            Self::OverUnder => Form::Above,
            Self::HalfSideBySide => Form::Composed(Composition::HalfSideBySide),
            Self::HalfOverUnder => Form::Composed(Composition::HalfOverUnder),
            Self::Rows => Form::Composed(Composition::Rows { top: Top::First }),
            Self::Flicker => Form::InTurn,
        }
    }

    /// The eyes it shows (0 left, 1 right): the first is on the left, above, in red, in the topmost row, or
    /// before the other. `is_swapped` changes them.
    #[must_use]
    pub const fn eyes(self, is_swapped: bool) -> &'static [usize] {
        match (self, is_swapped) {
            (Self::Left, _) => &[0],
            (Self::Right, _) => &[1],
            (Self::CrossEyed, false) => &[1, 0],
            (Self::CrossEyed, true) | (_, false) => &[0, 1],
            (_, true) => &[1, 0],
        }
    }

    /// Whether the layout shows both eyes.
    #[must_use]
    pub const fn has_both(self) -> bool {
        !matches!(self.form(), Form::One(_))
    }

    /// Whether the layout shows two pictures apart that nobody is to fuse, each for itself: one of them may
    /// stand alone.
    #[must_use]
    pub const fn shows_two_apart(self) -> bool {
        matches!(self, Self::SideBySide | Self::OverUnder)
    }

    /// Whether the layout is made for two eyes that fuse its pictures, with glasses, crossed or on a screen
    /// of their own.
    #[must_use]
    pub const fn is_fused(self) -> bool {
        match self {
            Self::SideBySide | Self::Left | Self::Right | Self::OverUnder | Self::Flicker => false,
            Self::FreeViewing
            | Self::CrossEyed
            | Self::Anaglyph
            | Self::Dubois
            | Self::Overlay
            | Self::HalfSideBySide
            | Self::HalfOverUnder
            | Self::Rows => true,
        }
    }

    /// Whether the pictures that the layout shows can be recovered from it.
    #[must_use]
    pub const fn loses_nothing(self) -> bool {
        !matches!(self.form(), Form::Composed(_))
    }

    /// Returns the name of the layout in files and flags.
    #[must_use]
    pub fn name(self) -> String {
        self.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
    }

    /// Returns the bit of the layout in a set.
    const fn bit(self) -> u16 {
        1 << self as u16
    }
}

/// The layouts whose eyes are swapped.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Swapped(u16);

/// Name of the empty set.
const NONE: &str = "none";

impl Swapped {
    /// Whether the eyes of `layout` are.
    #[must_use]
    pub const fn has(self, layout: Layout) -> bool {
        self.0 & layout.bit() != 0
    }

    /// Returns the set with the eyes of `layout` swapped, or swapped back. One eye alone is not swapped.
    #[must_use]
    pub fn toggled(self, layout: Layout) -> Self {
        if layout.has_both() { Self(self.0 ^ layout.bit()) } else { self }
    }

    /// Returns the layouts of the set, in their order.
    pub fn layouts(self) -> impl Iterator<Item = Layout> {
        Layout::value_variants().iter().copied().filter(move |&layout| self.has(layout))
    }
}

impl FromStr for Swapped {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut swapped = Self::default();
        for name in text.split(',').map(str::trim).filter(|name| ![NONE, ""].contains(name)) {
            let layout = Layout::from_str(name, false).map_err(|_| {
                let known = Layout::value_variants().iter().map(|layout| layout.name());
                format!(
                    "write `none`, or names like anaglyph,rows: there are {}",
                    known.collect::<Vec<_>>().join(", ")
                )
            })?;
            if !layout.has_both() {
                return Err(format!("{name} shows one eye, so there is nothing to swap"));
            }
            swapped.0 |= layout.bit();
        }
        Ok(swapped)
    }
}

impl Serialize for Swapped {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if *self == Self::default() {
            return serializer.serialize_str(NONE);
        }
        serializer.collect_seq(self.layouts())
    }
}
