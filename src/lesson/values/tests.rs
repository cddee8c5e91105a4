use super::places::filled;
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
    assert_eq!(told("$x_{a}^{T}$ {").expect("nothing to fill"), "$x_{a}^{T}$ {");
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
    let told = wrong("{gane:.2}").1;
    assert!(told.starts_with("no value is called `gane`: there are "), "{told}");
    assert!(told.contains("the nearest are gain, ") && told.len() < 200, "{told}");
    assert!(wrong("{D of tandem:.2}").1.contains("has no body called `tandem`: there are "));
    assert!(wrong("{D at noon:.2}").1.contains("must be a number"));
}

#[test]
fn what_was_meant_for_a_value_is_found_in_html_too() {
    for text in ["{gain:2}", "<div>{gain:2}</div>", "a <b>b</b> {gain}", "$\\gamma + {gain}$"] {
        let (line, problem) = places::checked(Markdown::new(text), |asked| asked == "gain").expect_err(text);
        assert!(line == 0 && problem.contains("`{gain:.2}` is one"), "{text}: {problem}");
    }
    assert!(
        places::checked(Markdown::new("`{gain}` \\{gain} $\\frac{a}{b}$"), |asked| asked == "gain").is_ok()
    );
}

#[test]
fn no_two_values_have_one_name() {
    let mut known: Vec<_> = all().map(|value| value.name).collect();
    let count = known.len();
    known.sort_unstable();
    known.dedup();
    assert_eq!(known.len(), count);
}
