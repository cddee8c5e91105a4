//! How much is taken in of a file before it is refused: a file may claim any size, and memory is for everybody.

/// Most bytes of a text that is read whole: a scene, a state, a lesson.
pub const TEXT_BYTES: u64 = 4 << 20;
/// Most bytes of a lesson.
pub const LESSON_BYTES: usize = 64 << 10;
/// Most steps of a lesson.
pub const STEPS: usize = 100;
/// Most choices of a question.
pub const CHOICES: usize = 20;
/// Most bytes of a text of a lesson that is shown at once.
pub const PASSAGE_BYTES: usize = 8 << 10;
/// Most bytes of all questions of a lesson with their choices, which are kept beside the answers.
pub const QUESTION_BYTES: usize = 12 << 10;
/// How deeply quotes, lists and emphasis are nested at most in a text of a lesson. TOML has a limit of its own (80), and so
/// have formulas (32), what is remembered of the window (RON, 128) and the answers in it (JSON, 128).
pub const NESTED: usize = 16;
/// Most formulas of a text that is shown at once.
pub const FORMULAS: usize = 100;
/// Most bytes of a formula.
pub const FORMULA_BYTES: usize = 1 << 10;
/// How far a formula reaches at most from where it begins, em: some twenty times as far as the text is wide.
pub const FORMULA_EM: f32 = 1000.0;
/// Most letters of a name, or of another word of a scene or a lesson.
pub const NAME_LETTERS: usize = 100;
/// Most groups of a scene.
pub const GROUPS: usize = 200;
/// Most bodies of a scene. In memory a million takes 650 MB.
pub const BODIES: usize = 1_000_000;
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
