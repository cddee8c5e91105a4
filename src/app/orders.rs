//! What is asked for that more than the state is needed for: the graphics device, the clipboard, or what is plotted.

use std::path::PathBuf;

use super::chooser::Product;

/// What is asked for.
#[derive(Debug, Clone, PartialEq)]
pub enum Order {
    /// Write a file.
    Save(Saving),
    /// Copy something.
    Copy(Copied),
    /// Give up what is being made.
    Stop,
}

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Saving {
    /// What.
    pub product: Product,
    /// Where to; a folder for a film that is a sequence of pictures.
    pub path: PathBuf,
    /// Width and height of an eye's picture, pixels, of what is made of pictures.
    pub size: [u32; 2],
}

/// What can be copied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Copied {
    /// The views, as a picture.
    Picture,
    /// The command that opens a window that shows the same.
    Command,
    /// The link that opens the same.
    Link,
    /// The command that draws the same picture.
    RenderCommand,
    /// The command that gives the numbers of the selected point's curves.
    CurveCommand,
    /// What both eyes see of the selected point at T.
    Values,
}
