//! Commands print what is theirs and nothing else, whatever the environment of the graphics libraries is.

use super::{gamow, run};

/// What `arguments` print on standard error where no session is known to the system.
fn stderr_without_session(arguments: &str) -> (Option<i32>, String) {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let mut command = gamow();
    for name in ["XDG_RUNTIME_DIR", "WAYLAND_DISPLAY", "DISPLAY"] {
        command.env_remove(name);
    }
    let outcome = run(command.current_dir(folder.path()).args(arguments.split_whitespace()), b"");
    (outcome.status, outcome.stderr)
}

/// A layer of the graphics driver looks for a display, and complains of there being none.
#[test]
fn a_picture_is_drawn_without_a_word_of_the_graphics_libraries() {
    let (status, stderr) = stderr_without_session("render --size 32x24 --out picture.png");
    assert_eq!((status, stderr.as_str()), (Some(0), ""));
}

#[test]
fn a_screenshot_says_nothing_or_why_there_is_none() {
    let (status, stderr) = stderr_without_session("--window-size 64x64 --screenshot window.png");
    if status == Some(0) {
        assert_eq!(stderr, "");
    } else {
        assert!(stderr.starts_with("gamow: ") && stderr.lines().count() == 1, "{stderr}");
    }
}
