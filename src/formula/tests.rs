//! Formulas measured against their fonts and against TeX's rules.

use super::markdown::{Fault, Markdown};
use super::*;

fn inline(tex: &str) -> Formula {
    Formula::new(tex, Style::Inline).unwrap_or_else(|error| panic!("{error}"))
}

fn displayed(tex: &str) -> Formula {
    Formula::new(tex, Style::Displayed).unwrap_or_else(|error| panic!("{error}"))
}

/// Returns the start and the size of the only glyph of this character.
fn glyph(formula: &Formula, sought: char) -> ([f32; 2], f32) {
    let found: Vec<_> = formula
        .marks
        .iter()
        .filter_map(|mark| match mark {
            Mark::Glyph { character, at, size, .. } if *character == sought => Some((*at, *size)),
            _ => None,
        })
        .collect();
    assert_eq!(found.len(), 1, "{sought:?} in {formula:?}");
    found[0]
}

fn rules(formula: &Formula) -> Vec<([f32; 2], [f32; 2])> {
    let rule = |mark: &Mark| match mark {
        Mark::Rule { min, size } => Some((*min, *size)),
        _ => None,
    };
    formula.marks.iter().filter_map(rule).collect()
}

/// The layout has widths of its own; those of the fonts' files are another source.
#[test]
fn letters_are_as_wide_as_their_fonts_say() {
    for (tex, face, character) in [
        ("x", FontFace::Italic, 'x'),
        (r"\gamma", FontFace::Italic, 'γ'),
        ("7", FontFace::Main, '7'),
        (r"\mathrm{h}", FontFace::Main, 'h'),
        (r"\Delta", FontFace::Main, 'Δ'),
        (r"\mathbf{n}", FontFace::Bold, 'n'),
    ] {
        let formula = inline(tex);
        let advance = face.advance(character).expect("the font has it");
        // TeX adds the italic correction of slanted letters.
        let correction = formula.width - advance;
        assert!((-1e-3..0.06).contains(&correction), "{tex}: {} is not {advance}", formula.width);
        if face != FontFace::Italic {
            assert!(correction.abs() < 1e-3, "{tex}: {} is not {advance}", formula.width);
        }
        assert_eq!(glyph(&formula, character), ([0.0, 0.0], 1.0), "{tex}");
    }
}

/// The widths of a sum: TeX puts a medium space of 4/18 em to both sides of a binary operator.
#[test]
fn operators_have_room_on_both_sides() {
    let width = |character| FontFace::Main.advance(character).expect("the font has it");
    let expected = width('1') + width('2') + width('+') + 2.0 * 4.0 / 18.0;
    assert!((inline("1+2").width - expected).abs() < 1e-3);
}

#[test]
fn a_fraction_has_its_bar_between_its_parts() {
    let fraction = displayed(r"\frac{3}{7}");
    let [(bar, size)] = rules(&fraction)[..] else { panic!("one bar: {fraction:?}") };
    let ((above, _), (below, _)) = (glyph(&fraction, '3'), glyph(&fraction, '7'));
    assert!(above[1] < bar[1] && below[1] > bar[1] + size[1], "{fraction:?}");
    // The axis of TeX's fonts is 0.25 em above the baseline, and a rule of theirs 0.04 em thick.
    assert!(
        (bar[1] + size[1] / 2.0 + 0.25).abs() < 1e-3 && (size[1] - 0.04).abs() < 1e-3,
        "{bar:?} {size:?}"
    );
    let alone = displayed("3");
    assert!(fraction.ascent > alone.ascent + 0.5 && fraction.descent > 0.5);
    assert!(inline(r"\frac{3}{7}").ascent < fraction.ascent, "it is smaller in a line");
    assert!((glyph(&inline(r"\frac{3}{7}"), '3').1 - 0.7).abs() < 1e-6);
}

#[test]
fn scripts_are_smaller_and_off_the_baseline() {
    let both = inline("x_a^b");
    let ((sup, sup_size), (sub, sub_size)) = (glyph(&both, 'b'), glyph(&both, 'a'));
    assert!(sup[1] < -0.3 && sub[1] > 0.1, "{both:?}");
    assert!((sup_size - 0.7).abs() < 1e-6 && (sub_size - 0.7).abs() < 1e-6);
    assert!((glyph(&inline("x^{y^z}"), 'z').1 - 0.5).abs() < 1e-6);
}

#[test]
fn a_root_covers_what_is_in_it() {
    for tex in ["1-v", r"\frac{1}{2}", r"\frac{1}{1-\frac{v}{w}}"] {
        let (body, root) = (displayed(tex), displayed(&format!(r"\sqrt{{{tex}}}")));
        let top = rules(&root).into_iter().map(|(min, _)| min[1]).fold(0.0, f32::min);
        let width = rules(&root).into_iter().map(|(_, size)| size[0]).fold(0.0, f32::max);
        assert!(-top > body.ascent && root.ascent >= -top - 1e-3, "{tex}: {top} over {}", body.ascent);
        assert!(width >= body.width - 1e-3 && root.width > body.width + 0.5, "{tex}");
    }
}

#[test]
fn brackets_grow_with_what_they_hold() {
    let tall = displayed(r"\left(\frac{1}{2}\right)");
    assert!(tall.ascent > displayed(r"\frac{1}{2}").ascent - 1e-3);
    let face = tall.marks.iter().find_map(|mark| match mark {
        Mark::Glyph { face, character: '(', .. } => Some(*face),
        _ => None,
    });
    assert!(matches!(face, Some(FontFace::Size2 | FontFace::Size3)), "{face:?}");
}

/// Marks lie within the room that the formula claims.
#[test]
fn formulas_say_how_much_room_they_take() {
    for tex in TEXTBOOK {
        let formula = displayed(tex);
        for mark in &formula.marks {
            let points = match mark {
                Mark::Glyph { at, .. } => vec![*at],
                Mark::Rule { min, size } => vec![*min, [min[0] + size[0], min[1] + size[1]]],
                Mark::Area(contours) => contours.concat(),
            };
            for [x, y] in points {
                assert!((-0.05..=formula.width + 0.05).contains(&x), "{tex}: {mark:?}");
                assert!((-formula.ascent - 0.01..=formula.descent + 0.01).contains(&y), "{tex}: {mark:?}");
            }
        }
    }
}

const TEXTBOOK: [&str; 14] = [
    r"D = \frac{1}{\gamma(1-\beta\cos\theta)}",
    r"\beta = \frac{v}{c},\quad \gamma = \frac{1}{\sqrt{1-\beta^2}},\quad \tau = \gamma\,(t - \beta x)",
    r"\Delta\varphi",
    r"\hat{n}",
    r"\vec{v}\cdot\vec{n}",
    r"\theta_{\mathrm{left}}",
    r"\sum_i \left(\frac{y_i - f(x_i)}{\sigma_i}\right)^2",
    r"\int_0^T \gamma^{-1}\,dt \approx 3\times10^{8}\ \text{m/s}",
    r"\widehat{AB} \le \overline{AB} \ne \pm\infty",
    r"\begin{pmatrix} \gamma & -\gamma\beta \\ -\gamma\beta & \gamma \end{pmatrix}",
    r"\left\{\begin{aligned} x' &= \gamma(x - \beta t) \\ t' &= \gamma(t - \beta x) \end{aligned}\right.",
    r"\underbrace{t}_{\text{happened}} = \overbrace{T - r}^{\text{received}}",
    r"\lim_{\beta\to1} \sqrt[3]{\frac{1+\beta}{1-\beta}}",
    r"T \gtrsim t \implies \bigl|\tau\bigr| \in \mathbb{R}",
];

#[test]
fn formulas_are_said_in_a_line() {
    for (tex, words) in [
        (r"D = \frac{1}{\gamma(1-\beta\cos\theta)}", "D = 1/(γ(1 − β cos θ))"),
        (r"\gamma = \frac{1}{\sqrt{1-\beta^2}}", "γ = 1/(√(1 − β²))"),
        (r"\theta_{\mathrm{left}}", "θ_left"),
        (r"\Delta\varphi", "Δφ"),
        (r"\hat{n}", "n hat"),
        (r"\sum_i \left(\frac{y_i - f(x_i)}{\sigma_i}\right)^2", "∑_i ((y_i − f(x_i))/(σ_i))²"),
        (r"\tau = \gamma\,(t - \beta x)", "τ = γ (t − βx)"),
        (r"x'' = e^{-x}", "x′′ = e^(−x)"),
        (r"\begin{aligned} x &= a \\ y &= b \end{aligned}", "x = a; y = b"),
        (r"3\times10^{8}\ \text{m per s}", "3 × 10^8 m per s"),
    ] {
        assert_eq!(inline(tex).words, words, "{tex}");
    }
}

#[test]
fn what_is_no_tex_is_said_in_a_line() {
    for (tex, reason) in [
        (r"\frac{1}{2", "}"),
        (r"\gama", r"\gama"),
        (r"\left( x", r"\right"),
        ("x^a^b", "superscript"),
        (r"\begin{nothing} x \end{nothing}", "nothing"),
        (r"\mathcal{L}", "Caligraphic"),
        ("日", "日"),
        (r"\frac{1}", "end"),
    ] {
        let Err(error) = Formula::new(tex, Style::Inline) else { panic!("{tex} is taken") };
        let message = error.to_string();
        assert!(message.to_lowercase().contains(&reason.to_lowercase()), "{tex}: {message}");
        assert!(message.lines().count() == 1, "{message}");
    }
}

#[test]
fn formulas_part_at_wide_spaces() {
    let whole = displayed(r"a = \frac{1}{2},\quad b = c\,d \qquad e");
    let parts =
        Formula::parts(r"a = \frac{1}{2},\quad b = c\,d \qquad e", Style::Displayed).expect("it is TeX");
    let words: Vec<_> = parts.iter().map(|part| part.words.as_str()).collect();
    assert_eq!(words, ["a = 1/2,", "b = c d", "e"]);
    let width: f32 = parts.iter().map(|part| part.width).sum();
    // The spaces are one and two em wide, and a comma has 3/18 em behind it only where something follows.
    let spaces = whole.width - width;
    assert!((3.0 - 1e-3..3.0 + 0.2).contains(&spaces), "{spaces}");
    assert!(Formula::parts(r"\gama \quad x", Style::Displayed).is_err());
}

#[test]
fn faults_in_markdown_have_a_line() {
    let first_fault = |text: &str| Markdown::new(text).first_fault();
    assert_eq!(first_fault("# A\n\nGood: $x$.\n\n$$\\frac{1}{2}$$\n"), None);
    let (line, error) = first_fault("# A\n\nGood: $x$,\nbad: $\\gama$.\n").expect("it is wrong");
    assert!(line == 3 && error.to_string().contains("gama"), "{line}: {error}");
    let (line, _) = first_fault("A\n\n- b\n- $$\\frac{1}$$\n").expect("it is wrong");
    assert_eq!(line, 3);
    assert_eq!(first_fault("A\n\n*b* for 3 $, $x$"), Some((2, Fault::Dollar)));
    assert_eq!(first_fault("```\n$ gamow\n```\n\n`$` is \\$"), None);
}

/// The outlines in the picture are at the same place as the marks.
#[test]
fn pictures_are_named_and_closed() {
    for tex in TEXTBOOK {
        let formula = displayed(tex);
        let svg = formula.svg();
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>") && svg.matches("<svg").count() == 1);
        assert!(svg.contains("role=\"img\" aria-label=\"") && !svg.contains("NaN") && !svg.contains("http"));
        let drawn = svg.matches("<path").count() + svg.matches("<rect").count();
        assert_eq!(drawn, formula.marks.len(), "{tex}");
        assert_eq!(svg.matches('<').count(), 2 + drawn, "{tex}: every element is closed");
    }
    assert!(inline("a<b").svg().contains("aria-label=\"a &lt; b\""));
}

#[test]
fn formulas_of_absurd_size_are_refused_in_a_line() {
    let huge = "9".repeat(60);
    for tex in [
        &format!(r"\rule{{{huge}em}}{{1em}}"),
        &format!(r"\rule{{1em}}{{{huge}{huge}{huge}{huge}{huge}{huge}em}}"),
        &format!(r"\kern{{{huge}em}}x"),
        r"\rlap{\rule{1001em}{1em}}x",
        &format!(r"\raisebox{{{huge}em}}{{x}}"),
        &format!(r"x\kern{huge}em\rule{{1em}}{{1em}}\kern-{huge}em y"),
        &r"\rule{999em}{1em}".repeat(2),
    ] {
        let error = Formula::new(tex, Style::Displayed).expect_err(tex).to_string();
        assert!(error.starts_with("the formula $") && error.len() < 250 && !error.contains('\n'), "{error}");
    }
    let svg = displayed(r"\rule{999em}{999em}").svg();
    assert!(!svg.contains("inf") && !svg.contains("NaN"), "{svg}");
}

#[test]
fn formulas_that_nest_deeply_are_refused_in_a_line() {
    for (begin, end) in [
        ("{", "}"),
        (r"\frac{1}{", "}"),
        (r"\left(", r"\right)"),
        ("x^", ""),
        (r"\sqrt", ""),
        (r"\begin{matrix}", r"\end{matrix}"),
        (r"\def\a{\a\a}\a", ""),
    ] {
        for depth in [50, 10_000] {
            let tex = begin.repeat(depth) + "x" + &end.repeat(depth);
            let error = Formula::new(&tex, Style::Displayed).expect_err(&tex).to_string();
            assert!(error.len() < 250 && !error.contains('\n'), "{error}");
        }
    }
}

#[test]
fn only_the_web_and_mail_are_linked_to() {
    for address in ["https://a.org", "HTTP://a.org/b?c", "mailto:a@b.org", "#top"] {
        assert!(markdown::is_link(address), "{address}");
    }
    for address in [
        "javascript:alert(1)",
        "JaVaScRiPt:alert(1)",
        "java\tscript:alert(1)",
        " https://a.org",
        "https://a.org\nb",
        "data:text/html,<script>",
        "file:///etc/passwd",
        "vbscript:x",
        "//a.org",
        r"\\server\share",
        "ftp://a.org",
        "a.html",
        "https:a",
        "",
        "ä",
    ] {
        assert!(!markdown::is_link(address), "{address}");
    }
}
