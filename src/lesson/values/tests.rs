use super::*;

fn told(markdown: &str) -> Result<String, (usize, String)> {
    let settings = Settings { time: Some(2.0), ..Settings::default() };
    let scene = settings.opened_scene().expect("a scene");
    filled(markdown, |asked| value(asked, &settings, &scene))
}

#[test]
fn values_are_put_in_their_places_and_formulas_stay() {
    let text = told("$\\frac{1}{\\gamma} = {contraction:.3}$ at {beta:.1} c, T = {T:.0}").expect("values");
    assert_eq!(text, "$\\frac{1}{\\gamma} = 0.436$ at 0.9 c, T = 2");
    assert_eq!(told("{a} {:.x} {b:.} {").expect("nothing to fill"), "{a} {:.x} {b:.} {");
}

#[test]
fn a_body_and_a_time_can_be_named() {
    let doppler = |asked: &str| told(&format!("{{{asked}:.9}}")).expect("a value");
    let own = doppler("D at 2");
    assert_eq!(own, doppler("D"));
    assert_ne!(own, doppler("D at -3"));
    assert_ne!(doppler("D of rear tyre at -3"), doppler("D at -3"));
}

#[test]
fn what_cannot_be_told_is_named_with_its_line() {
    let wrong = |text: &str| told(text).expect_err(text);
    assert_eq!(wrong("a\n{gane:.2}").0, 1);
    assert!(wrong("{gane:.2}").1.starts_with("no value is called `gane`: there are beta, "));
    assert!(wrong("{D of tandem:.2}").1.ends_with("has no body called `tandem`"));
    assert!(wrong("{D at noon:.2}").1.contains("must be a number"));
}

/// The documentation's table has a row for each value, in the same words, and no others.
#[test]
fn the_table_of_values_is_complete() {
    let (_, table) = include_str!("../../../assets/lessons/README.md")
        .split_once("| value | |\n|---|---|\n")
        .expect("a table");
    let written: Vec<&str> = table.lines().take_while(|line| line.starts_with('|')).collect();
    let rows: Vec<String> = all().map(|value| format!("| `{}` | {} |", value.name, value.what)).collect();
    assert_eq!(written, rows);
    let mut names: Vec<_> = all().map(|value| value.name).collect();
    names.sort_unstable();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "a name has two values: {names:?}");
}
