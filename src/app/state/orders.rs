//! Orders: requests that need more than the state, such as the graphics device, the clipboard or the plotted
//! curves.

use std::path::PathBuf;

use crate::app::state::files::purpose::Product;

/// A request that needs more than the state.
#[derive(Debug, Clone, PartialEq)]
pub enum Order {
    /// Writes a file of a product.
    Save(Saving),
    /// Copies something to the clipboard.
    Copy(Copied),
    /// Gives up what is being made.
    Stop,
    /// Opens a file, or a link.
    Open(PathBuf),
}

/// A file to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Saving {
    /// Product to save.
    pub product: Product,
    /// Path of the file; a folder for a film that is a sequence of pictures.
    pub path: PathBuf,
    /// Width and height of an eye's picture, pixels, of what is made of pictures.
    pub size: [u32; 2],
}

/// An object that can be copied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Copied {
    /// The views, as a picture.
    Picture,
    /// The command that opens a window that shows the same.
    Command,
    /// The link that opens the same.
    Link,
    /// The link with the answers in the open lesson.
    Answers,
    /// The command that draws the same picture.
    RenderCommand,
    /// The command that gives the numbers of the selected point's curves.
    CurveCommand,
    /// Values for both eyes of the selected point at T.
    Values,
}
