//! How much is taken in of a file before it is refused: a file may claim any size, and memory is for everybody.

/// Most bytes of a text that is read whole: a scene, a state, a lesson.
pub const TEXT_BYTES: u64 = 4 << 20;
/// Most bytes of another file that is kept whole, such as a table that is fitted in the window.
pub const FILE_BYTES: u64 = 64 << 20;
/// Most bytes of a row of CSV, its line ends included.
pub const ROW_BYTES: u64 = 1 << 20;
/// Most rows of a table that is fitted.
pub const FITTED_ROWS: usize = 1_000_000;
/// Most pixels of a picture that is read, as of 16384x16384. In memory each takes 8 bytes.
pub const PICTURE_PIXELS: u64 = 1 << 28;
/// Most values of measurements that are read, pixels times channels. In memory each takes 4 bytes.
pub const MEASURED_VALUES: u64 = 1 << 29;
