//! Completions and manual pages, which are made from the flags.

use std::collections::BTreeSet;
use std::fs;
use std::process::Command;

use super::{gamow, run, shell, words};

/// The commands, and those flags of each that its help shows.
fn commands() -> Vec<(String, BTreeSet<String>)> {
    let help = words("--help").text();
    let (_, commands) = help.split_once("Commands:\n").expect("there are commands");
    let names = commands.lines().take_while(|line| !line.is_empty());
    // Lines that go on have more blanks before them.
    let names =
        names.filter_map(|line| line.strip_prefix("  ")?.split(' ').next()).filter(|name| !name.is_empty());
    let flags = |help: String| {
        let lines = help.lines().map(str::trim_start).filter(|line| line.starts_with('-'));
        let flags = lines.flat_map(|line| line.split([' ', '='])).filter_map(|word| word.strip_prefix("--"));
        flags.filter(|flag| !flag.is_empty()).map(str::to_owned).collect()
    };
    [String::new()]
        .into_iter()
        .chain(names.map(str::to_owned))
        .filter(|name| name != "help")
        .map(|name| {
            let all = flags(words(&format!("{name} --help")).text());
            (name, all)
        })
        .collect()
}

#[test]
fn every_command_has_a_page_with_its_flags() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    run(gamow().arg("man").arg(folder.path()), b"").text();
    let all = commands();
    assert!(all.len() > 10, "{}", all.len());
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), all.len());
    for (name, flags) in all {
        let file = if name.is_empty() { "gamow.1".to_owned() } else { format!("gamow-{name}.1") };
        let page = fs::read_to_string(folder.path().join(&file)).expect("a page");
        for section in [".SH NAME", ".SH SYNOPSIS", ".SH DESCRIPTION", ".SH \"EXAMPLES\"", ".SH \"SEE ALSO\""]
        {
            assert_eq!(page.matches(section).count(), 1, "{file}: {section}");
        }
        for flag in &flags {
            let spelt = format!("\\-\\-{}", flag.replace('-', "\\-"));
            assert!(page.contains(&spelt), "{file}: --{flag}");
        }
        // Nobody formats it where there is no such program.
        let Ok(read) = Command::new("man")
            .args(["--warnings=all", "-l"])
            .arg(folder.path().join(&file))
            .env("LC_ALL", "C.UTF-8")
            .output()
        else {
            continue;
        };
        assert!(
            read.status.success() && read.stderr.is_empty(),
            "{file}: {}",
            String::from_utf8_lossy(&read.stderr)
        );
    }
}

#[test]
fn every_shell_gets_the_flags_of_every_command() {
    let all = commands();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = words(&format!("completions {shell}")).text();
        for (name, flags) in &all {
            assert!(script.contains(name), "{shell}: {name}");
            for flag in flags {
                let spelt = if shell == "fish" { format!("-l {flag} ") } else { format!("--{flag}") };
                assert!(script.contains(&spelt), "{shell}: --{flag}");
            }
        }
    }
}

/// What bash offers for a line, whose last word it completes.
#[cfg(unix)]
fn offered(line: &[&str]) -> BTreeSet<String> {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    fs::write(folder.path().join("gamow.bash"), words("completions bash").stdout).expect("it is written");
    let (quoted, last) = (line.join(" "), line.len() - 1);
    let script = format!(
        "source ./gamow.bash; complete -p gamow | grep -q _gamow || exit 1; COMP_WORDS=({quoted}); COMP_CWORD={last}; \
         cur=\"${{COMP_WORDS[COMP_CWORD]}}\"; _gamow gamow \"$cur\" \"${{COMP_WORDS[COMP_CWORD-1]}}\"; printf '%s\\n' \"${{COMPREPLY[@]}}\""
    );
    fs::write(folder.path().join("run.bash"), script).expect("it is written");
    shell("bash ./run.bash", folder.path()).text().split_whitespace().map(str::to_owned).collect()
}

#[test]
#[cfg(unix)]
fn bash_completes_commands_flags_and_words() {
    if Command::new("bash").arg("--version").output().is_err() {
        return;
    }
    let is = |words: &[&str]| words.iter().map(ToString::to_string).collect::<BTreeSet<_>>();
    assert_eq!(offered(&["gamow", "re"]), is(&["rectify", "render"]));
    assert_eq!(offered(&["gamow", "curve", "--obs"]).len(), 8);
    assert_eq!(offered(&["gamow", "curve", "--model", "o"]), is(&["one-cone"]));
    assert_eq!(offered(&["gamow", "render", "--proj"]), is(&["--projection"]));
    assert_eq!(offered(&["gamow", "completions", "z"]), is(&["zsh"]));
}
