//! The command line as a whole: what is wrong with it in one line, and the flags of all commands.

use super::{gamow, run, words};

#[test]
fn a_bad_command_line_is_one_line_that_says_what_would_be_right() {
    let curve = "; `gamow curve --help` says more";
    for (arguments, expected) in [
        ("curve --bta 0.5", "there is no flag --bta (did you mean `--beta`?)"),
        ("curve --zzz", "there is no flag --zzz"),
        ("curve -q", "there is no flag -q"),
        ("curve 3", "`3` is one word too many"),
        ("curve --beta", "--beta needs a value"),
        ("curve --beta nan", "--beta nan: not a finite number"),
        ("curve --beta 0.5 --gamma 2", "--beta and --gamma cannot both be given: choose one"),
        (
            "curve --model exactt",
            "--model exactt (did you mean `exact`?): must be one of exact, one-cone, published, published-text",
        ),
        ("curve --rho 1", "--angle, --wheel-radius is missing"),
        ("curve --threads 0", "--threads 0: 0 is not in 1..=1024"),
        ("curve --stereo=on", "--stereo takes no value, and `on` is given"),
        (
            "--beta 0.5 curve",
            "--beta before curve is a flag of the window: those of a command stand behind its name, as in `gamow curve --beta`",
        ),
    ] {
        assert_eq!(words(arguments).complaint(), format!("gamow: {expected}{curve}"), "{arguments}");
    }
    for (arguments, expected) in [
        ("crve", "there is no command `crve` (did you mean `curve`?); `gamow --help` says more"),
        ("--scen x", "there is no flag --scen (did you mean `--scene`?); `gamow --help` says more"),
        ("rectify x.png", "--out is missing; `gamow rectify --help` says more"),
        ("measure x.png", "--point or --object or --marker is missing; `gamow measure --help` says more"),
        ("fit --d -1", "--d -1: must be above 0 and at most 1e60; `gamow fit --help` says more"),
        ("completions", "SHELL is missing; `gamow completions --help` says more"),
    ] {
        assert_eq!(words(arguments).complaint(), format!("gamow: {expected}"), "{arguments}");
    }
    for (arguments, expected) in [
        ("render --scene stret", "no scene is called `stret` (did you mean `street`?): there are street, "),
        ("render --state globee", "no preset is called `globee` (did you mean `globe`?): there are "),
        ("lesson rod --lab x.html", "no lesson is called `rod` (did you mean `rods`?): there are "),
    ] {
        let complaint = words(arguments).complaint();
        assert!(complaint.starts_with(&format!("gamow: {expected}")), "{complaint}");
    }
}

/// The flags of every command stand before its name or behind it.
#[test]
fn results_do_not_depend_on_threads_or_on_silence() {
    let data = words("curve --samples 200").text();
    let fit = |arguments: &str| run(gamow().args(arguments.split(' ')), data.as_bytes()).text();
    let expected = fit("fit --bootstrap 20 --fit-x0");
    assert_eq!(fit("--threads 1 --quiet fit --bootstrap 20 --fit-x0"), expected);
    assert_eq!(fit("fit --bootstrap 20 --fit-x0 --quiet --threads 3"), expected);
}

#[test]
fn silence_leaves_out_remarks_and_no_error() {
    let data = format!("Measured today\n\n{}", words("curve --samples 200").text());
    let fit = |arguments: &str| run(gamow().args(arguments.split(' ')), data.as_bytes());
    let (told, quiet) = (fit("fit --bootstrap 0"), fit("fit --bootstrap 0 --quiet"));
    assert!(told.stderr.starts_with("gamow: standard input: "), "{}", told.stderr);
    assert_eq!(quiet.text().into_bytes(), told.stdout);
    let complaint = fit("fit --bootstrap 0 --quiet --use both --d 3 --loss-scale 2").complaint();
    assert!(complaint.starts_with("gamow: "), "{complaint}");
}
