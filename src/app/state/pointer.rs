//! Gestures of the pointer in a picture.

use crate::eye::Eye;
use crate::scene::Track;

/// A movement of the pointer that takes the scene along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn {
    /// The eye of the picture under the pointer.
    pub eye: Eye,
    /// Whether that is the second of two pictures of one eye.
    pub is_second: bool,
    /// Start of the gesture, in pixels from the top left corner.
    pub from: [f64; 2],
    /// End of the gesture.
    pub to: [f64; 2],
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
}

/// A turn of the wheel over a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Zoom {
    /// The eye of the picture under the pointer.
    pub eye: Eye,
    /// Whether the pointer is in the second of two pictures of one eye.
    pub is_second: bool,
    /// Place of the gesture, in pixels from the top left corner.
    pub pixel: [f64; 2],
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Factor of the field of view.
    pub factor: f64,
}

/// A click into a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pick {
    /// The eye of the picture under the pointer.
    pub eye: Eye,
    /// Whether the pointer is in the second of two pictures of one eye.
    pub is_second: bool,
    /// Place of the click, in pixels from the top left corner.
    pub pixel: [f64; 2],
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// Whether to follow the point beside the others.
    pub add: bool,
}

/// A point of the scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Select {
    /// Track of the point: its place at rest, and the motion of that.
    pub track: Track,
    /// The number of the body that the point is on.
    pub body: usize,
    /// Whether to follow the point beside the others.
    pub add: bool,
}
