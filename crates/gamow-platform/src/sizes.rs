//! Size limits of input files: a file may claim any size, and memory is for everybody.

/// Greatest length of a text that is read whole, bytes: a scene, a state, a lesson.
pub const TEXT_BYTES: u64 = 4 << 20;
/// Maximum size of a lesson, bytes.
pub const LESSON_BYTES: usize = 64 << 10;
/// Maximum number of steps in a lesson.
pub const STEPS: usize = 100;
/// Maximum number of choices in a question.
pub const CHOICES: usize = 20;
/// Maximum size of the text that a lesson shows at one time, bytes.
pub const PASSAGE_BYTES: usize = 8 << 10;
/// Maximum size of all questions and choices in a lesson, bytes: they are stored with the answers.
pub const QUESTION_BYTES: usize = 12 << 10;
/// Maximum nesting depth of quotes, lists and emphasis in a lesson's Markdown. The parsers of TOML (80),
/// formulas (32) and JSON (128) have limits of their own.
pub const NESTED: usize = 16;
/// Maximum number of formulas in the text that a lesson shows at one time.
pub const FORMULAS: usize = 100;
/// Maximum size of a formula, bytes.
pub const FORMULA_BYTES: usize = 1 << 10;
/// Maximum distance of any part of a formula from its start, em: about twenty times the width of the text.
pub const FORMULA_EM: f32 = 1000.0;
/// Maximum length of a name or title in a scene or a lesson, characters.
pub const NAME_LETTERS: usize = 100;
/// Maximum number of groups in a scene.
pub const GROUPS: usize = 200;
/// Maximum number of bodies in a scene; a million of them take 650 MB of memory.
pub const BODIES: usize = 1_000_000;
/// Maximum number of bodies that turn out of their places: no box holds one still, so that each costs a
/// picture a look.
pub const TURNING_BODIES: usize = 50_000;
/// Greatest length of a file of a model, bytes.
pub const MODEL_BYTES: u64 = 512 << 20;
/// Greatest length of another file that is kept whole, bytes, such as a table that is fitted in the window.
pub const FILE_BYTES: u64 = 64 << 20;
/// Greatest length of a row of CSV, bytes, its line ends included.
pub const ROW_BYTES: u64 = 1 << 20;
/// Greatest number of rows of a table that is fitted.
pub const FITTED_ROWS: usize = 1_000_000;
/// Greatest number of pixels of a picture that is read, as of 8192x8192. In memory each takes at most 12
/// bytes, so that a small file of one colour takes no more than 800 MB.
pub const PICTURE_PIXELS: u64 = 1 << 26;
/// Greatest number of values of measurements that are read, pixels times channels. In memory each takes 4
/// bytes.
pub const MEASURED_VALUES: u64 = 1 << 29;

/// Whether `name` is longer than [`NAME_LETTERS`], without counting all of it.
#[must_use]
pub fn is_too_long_for_a_name(name: &str) -> bool {
    name.chars().nth(NAME_LETTERS).is_some()
}
