//! The environment of the program: its variables, arguments and standard input, the session that graphics
//! libraries see, and the folder of the user's data.
#![expect(clippy::disallowed_methods, reason = "this is where the environment is read")]

use std::ffi::OsString;
use std::io::Read;
use std::path::PathBuf;

/// Returns the environment's variable called `name`; `None` where it is not set, or empty. A browser has
/// none.
#[must_use]
pub fn variable(name: &str) -> Option<OsString> {
    std::env::var_os(name).filter(|value| !value.is_empty())
}

/// Returns the words that the program was started with, its own name first.
pub fn arguments() -> impl Iterator<Item = OsString> {
    std::env::args_os()
}

/// Returns what arrives on standard input.
#[must_use]
pub fn standard_input() -> impl Read {
    std::io::stdin().lock()
}

/// Returns the folder in which the program called `name` keeps data of its user: in `$XDG_DATA_HOME`, else
/// `~/.local/share`; on macOS in `~/Library/Application Support`, on Windows in `%APPDATA%`. `None` if the
/// user has no home.
#[must_use]
pub fn data_folder(name: &str) -> Option<PathBuf> {
    let home = |inside: &str| std::env::home_dir().map(|home| home.join(inside));
    let given = |name: &str| variable(name).map(PathBuf::from).filter(|path| path.is_absolute());
    let base = if cfg!(windows) {
        given("APPDATA").or_else(|| home("AppData/Roaming"))
    } else if cfg!(target_os = "macos") {
        home("Library/Application Support")
    } else {
        given("XDG_DATA_HOME").or_else(|| home(".local/share"))
    };
    Some(base?.join(name))
}

/// Names the folder in which the programs of a session meet: among others, the sockets of displays are in it.
#[cfg(unix)]
const SESSION_FOLDER: &str = "XDG_RUNTIME_DIR";
/// A path that holds none.
#[cfg(unix)]
const NO_FOLDER: &str = "/dev/null";

/// Has graphics libraries find no session where there is none, in place of complaining of it on standard
/// error: one of theirs looks for a display even where nothing is to be shown. The program starts once more,
/// in this process and with the same arguments, since an environment cannot be changed safely once there may
/// be threads. Where it cannot be started, it goes on as it is.
pub fn settle_without_session() {
    #[cfg(unix)]
    if !names_a_folder(std::env::var_os(SESSION_FOLDER).as_deref()) {
        use std::os::unix::process::CommandExt as _;
        let mut arguments = std::env::args_os();
        let Ok(program) = std::env::current_exe() else { return };
        let mut again = std::process::Command::new(program);
        if let Some(name) = arguments.next() {
            again.arg0(name);
        }
        // It returns only if it has failed.
        let _ = again.args(arguments).env(SESSION_FOLDER, NO_FOLDER).exec();
    }
}

/// Whether libraries take `value` for the path of a folder: they ask for an absolute one.
#[cfg(unix)]
fn names_a_folder(value: Option<&std::ffi::OsStr>) -> bool {
    value.is_some_and(|value| std::path::Path::new(value).is_absolute())
}

#[cfg(all(test, unix))]
mod tests {
    use std::ffi::OsStr;

    use super::*;

    #[test]
    fn what_is_settled_once_stays() {
        assert!(!names_a_folder(None) && !names_a_folder(Some(OsStr::new(""))));
        assert!(!names_a_folder(Some(OsStr::new("run"))));
        assert!(
            names_a_folder(Some(OsStr::new(NO_FOLDER))) && names_a_folder(Some(OsStr::new("/run/user/0")))
        );
    }
}
