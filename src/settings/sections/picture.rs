//! The section of pictures: how those of two eyes are laid out, and how files are made of them.

use clap::Args;
use serde::Serialize;

use crate::flags::choices::{Layout, Size, Swapped};
use crate::flags::{OnOff, switch};

/// The layout of the eyes' pictures, and how `gamow render` makes a file of them. The window's views are as
/// large as its panes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Args)]
#[serde(rename_all = "kebab-case")]
#[command(next_help_heading = "Picture")]
pub struct PictureSettings {
    /// Size of one eye's picture, pixels.
    #[arg(long, value_name = "WxH")]
    pub size: Size,
    /// Layout of the pictures of the two eyes. Those of an .exr file are layers of their own.
    #[arg(long, value_enum)]
    pub layout: Layout,
    /// The layouts whose two pictures are swapped, like `anaglyph,rows`: each has its own choice. `none`
    /// leaves all as described.
    #[arg(long, value_name = "none|LAYOUTS")]
    pub swapped: Swapped,
    /// Labels: a letter above each of two pictures beside or above each other, and a bar between them. Both
    /// lie outside the pictures.
    #[arg(long, value_parser = switch, value_name = "on|off")]
    pub labels: OnOff,
    /// Rays per pixel of the reference renderer: N x N.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=16))]
    pub samples: u32,
}

impl PictureSettings {
    /// The eyes that are shown (0 left, 1 right), in the order of the layout.
    #[must_use]
    pub const fn eyes(&self) -> &'static [usize] {
        self.layout.eyes(self.swapped.has(self.layout))
    }
}

impl Default for PictureSettings {
    fn default() -> Self {
        Self {
            size: Size([960, 720]),
            layout: Layout::SideBySide,
            swapped: Swapped::default(),
            labels: true,
            samples: 3,
        }
    }
}
