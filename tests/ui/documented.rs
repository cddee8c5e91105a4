//! The documentation's pictures of the window.

use super::Test;
use super::documents::run_blocks;

pub const TESTS: &[Test] = trials![
    #[cfg(unix)]
    pictures_of_the_window_are_those_that_their_commands_give,
];

#[cfg(unix)]
fn pictures_of_the_window_are_those_that_their_commands_give() {
    let count = run_blocks(|block| block.contains("--screenshot"));
    assert!(count >= 4, "{count}");
}
