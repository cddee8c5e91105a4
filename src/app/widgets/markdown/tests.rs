//! Text as it comes out at several sizes.

use std::sync::Mutex;

use egui::epaint::{Shape, TextShape};
use egui::{Color32, OutputCommand, Theme, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;

use super::*;
use crate::app::widgets::theme;

const SAMPLE: &str = r"# Abreast

The Doppler factor is $D = \frac{1}{\gamma(1-\beta\cos\theta)}$, so that abreast $D = 1/\gamma$. It is **not** what *one eye* measures, whatever `gamow eval` says; see [the paper](https://doi.org/10.1098/rspa.2019.0703).

$$\beta = \frac{v}{c},\quad \gamma = \frac{1}{\sqrt{1-\beta^2}},\quad \tau = \gamma\,(t - \beta x)$$

## What is measured

With $\Delta\varphi$ and $\hat{n}$, $\theta_{\mathrm{left}}$ and $\sum_i \left(\frac{y_i - f(x_i)}{\sigma_i}\right)^2$ it is the sum of squares:

$$\sum_i \left(\frac{y_i - f(x_i)}{\sigma_i}\right)^2 \le \widehat{AB}\cdot\vec{v} \qquad \left\{\begin{aligned} x' &= \gamma(x - \beta t) \\ t' &= \gamma(t - \beta x) \end{aligned}\right.$$

1. Light is received at $T$, and it happened at $t = T - r$.
2. The clock shows $\tau$:
   - at rest, $\tau = t$,
   - in motion, $\tau = t/\gamma$.

| quantity | at $\beta = 0.6$ | at $\beta = 0.9$ |
|---|--:|--:|
| $\gamma$ | 1.25 | 2.294 |
| $\sqrt{\frac{1+\beta}{1-\beta}}$ | 2 | 4.359 |

> A wrong one is $\gama$ here.

```
gamow eval --model exact
```
";

/// A window that shows this text, in points and pixels per point, with writing this much larger than usual.
fn window(text: &'static str, [width, pixels]: [f32; 2], scale: f32) -> Harness<'static> {
    let mut is_ready = false;
    let mut harness = Harness::builder()
        .with_size(Vec2::new(width, 800.0))
        .with_pixels_per_point(pixels)
        .build_ui(move |ui| {
            if is_ready {
                show(ui, &Markdown::new(text));
            } else {
                theme::install(ui.ctx());
                theme::scale_text(ui.ctx(), scale);
                is_ready = true;
            }
        });
    harness.run_steps(3);
    harness
}

/// The text on a page, and what it is set in.
fn page(text: &'static str, width: f32, scale: f32) -> (Arc<WrittenText>, PageSetting) {
    let found = Arc::new(Mutex::new(None));
    let taken = found.clone();
    let mut is_ready = false;
    let mut harness = Harness::builder().build_ui(move |ui| {
        if is_ready {
            let setting = PageSetting { width, ..setting(ui) };
            let written = written(ui.ctx(), &Markdown::new(text), &setting);
            *taken.lock().expect("it is free") = Some((written, setting));
        } else {
            theme::install(ui.ctx());
            theme::scale_text(ui.ctx(), scale);
            is_ready = true;
        }
    });
    harness.run_steps(2);
    found.lock().expect("it is free").take().expect("it was shown")
}

fn texts(page: &Page) -> Vec<&TextShape> {
    let shapes = page.parts.iter().flat_map(|part| &part.shapes);
    shapes.filter_map(|shape| if let Shape::Text(text) = shape { Some(text) } else { None }).collect()
}

/// Height of the baseline of each text on the page, and its font's size.
fn baselines(page: &Page) -> Vec<(String, f32, f32)> {
    texts(page)
        .iter()
        .map(|text| {
            let glyph = text.galley.rows[0].glyphs[0];
            let size = text.galley.job.sections[0].format.font_id.size;
            (text.galley.text().to_owned(), text.pos.y + glyph.pos.y, size)
        })
        .collect()
}

#[test]
fn formulas_stand_on_the_baseline_of_the_text_around_them() {
    for scale in [1.0, 1.3, 1.6] {
        let (written, _) = page("on $xyz$ it", 400.0, scale);
        let found = baselines(&written.page);
        assert_eq!(found.len(), 5, "{found:?}");
        assert!(found.iter().all(|(_, baseline, _)| *baseline == found[0].1), "{found:?}");
        // A line's height does not change with a letter in it.
        assert_eq!(written.page.height, page("on xyz it", 400.0, scale).0.page.height);
        assert!(page("on $\\frac{1}{x}$ it", 400.0, scale).0.page.height > written.page.height);
    }
}

#[test]
fn scripts_are_off_the_baseline() {
    let (written, _) = page("a $x^2_i$", 400.0, 1.0);
    let found = baselines(&written.page);
    let of = |sought: &str| found.iter().find(|(text, ..)| text == sought).expect("it is there").clone();
    let ((_, base, size), (_, sup, sup_size), (_, sub, _)) = (of("x"), of("2"), of("i"));
    assert!(sup < base - 3.0 && sub > base + 1.0, "{found:?}");
    assert!((sup_size / size - 0.7).abs() < 1e-3);
}

#[test]
fn nothing_is_wider_than_the_room() {
    for width in [120.0, 200.0, 300.0, 423.7, 600.0] {
        for scale in [1.0, 1.6] {
            let (written, _) = page(SAMPLE, width, scale);
            for part in &written.page.parts {
                assert!(part.rect.min.x >= 0.0 && part.rect.max.x <= width + 0.01, "{width}: {part:?}");
            }
            for text in texts(&written.page) {
                let end = text.pos.x + text.galley.rect.max.x;
                let size = text.galley.job.sections[0].format.font_id.size;
                // What is slanted, or bolder, leans out of its room a little.
                assert!(text.pos.x >= 0.0 && end <= width + 0.1 * size, "{width} {scale}: {end} {text:?}");
            }
        }
    }
    let (narrow, wide) = (page(SAMPLE, 200.0, 1.0).0, page(SAMPLE, 600.0, 1.0).0);
    assert!(narrow.page.height > wide.page.height, "less room takes more lines");
}

#[test]
fn what_belongs_to_a_word_or_formula_stays_with_it() {
    let text = "One two three four five six seven ($\\gamma$), eight nine ten **eleven**; twelve.";
    for width in (80..400).step_by(7) {
        let (written, _) = page(text, width as f32, 1.0);
        let found = baselines(&written.page);
        let of = |start: &str| {
            let place = found.iter().find(|(text, ..)| text.trim_start().starts_with(start));
            place.unwrap_or_else(|| panic!("{start}: {found:?}")).1
        };
        assert_eq!(of("γ"), of("),"), "{width}: {found:?}");
        assert_eq!(of("eleven"), of(";"), "{width}: {found:?}");
    }
}

#[test]
fn displayed_formulas_stand_in_the_middle_and_shrink_to_fit() {
    let (written, _) = page("$$x$$", 401.0, 1.0);
    let letter = texts(&written.page)[0].clone();
    let glyph = letter.galley.rows[0].glyphs[0];
    let middle = letter.pos.x + glyph.pos.x + glyph.advance_width / 2.0;
    assert!((middle - 200.5).abs() < 1.0, "{middle}");
    let size = |width| {
        let (written, _) = page("$$aaaaaaaaaa + bbbbbbbbbb + cccccccccc$$", width, 1.0);
        texts(&written.page)[0].galley.job.sections[0].format.font_id.size
    };
    assert!((size(150.0) / size(75.0) - 2.0).abs() < 1e-3, "{} {}", size(150.0), size(75.0));
    assert_eq!(size(600.0), size(900.0));
    // What has wide spaces is parted there before it shrinks.
    let lines = |width| {
        let (written, _) = page("$$aaaaaaaa\\quad bbbbbbbb\\quad cccccccc$$", width, 1.0);
        let mut found = baselines(&written.page);
        assert!(found.iter().all(|(_, _, size)| *size == found[0].2));
        found.dedup_by_key(|(_, baseline, _)| *baseline);
        found.len()
    };
    assert_eq!([lines(600.0), lines(150.0)], [1, 3]);
}

#[test]
fn writing_follows_the_colours_and_sizes_of_the_window() {
    let (written, setting) = page("a $x$ **b** [c](https://d.org) $\\gama$", 400.0, 1.0);
    let colours: Vec<Color32> =
        texts(&written.page).iter().map(|text| text.galley.job.sections[0].format.color).collect();
    let ink = &setting.ink;
    for colour in [ink.text, ink.strong, ink.link, ink.wrong] {
        assert!(colours.contains(&colour), "{colour:?} is not in {colours:?}");
    }
    let (larger, _) = page("a $x$ **b** [c](https://d.org) $\\gama$", 640.0, 1.6);
    for (one, other) in baselines(&written.page).iter().zip(baselines(&larger.page)) {
        assert!((other.2 / one.2 - 1.6).abs() < 1e-3, "{one:?} {other:?}");
    }
}

#[test]
fn paragraphs_are_labels_with_their_formulas_in_words() {
    let harness = window(SAMPLE, [600.0, 1.0], 1.0);
    for label in [
        "Abreast",
        "The Doppler factor is D = 1/(γ(1 − β cos θ)), so that abreast D = 1/γ. It is not what one eye measures, \
         whatever gamow eval says; see the paper.",
        "1. Light is received at T, and it happened at t = T − r.",
        "at rest, τ = t,",
        "γ, 1.25, 2.294",
        "gamow eval --model exact",
    ] {
        assert!(harness.query_by_label(label).is_some(), "{label}");
    }
}

#[test]
fn links_open_their_address() {
    let mut harness = window("See [the paper](https://doi.org/10.1098/rspa.2019.0703).", [400.0, 1.0], 1.0);
    harness.get_by_label("https://doi.org/10.1098/rspa.2019.0703").click();
    harness.step();
    let opened = |command: &OutputCommand| match command {
        OutputCommand::OpenUrl(open) => Some(open.url.clone()),
        _ => None,
    };
    let commands = &harness.output().platform_output.commands;
    let urls: Vec<String> = commands.iter().filter_map(opened).collect();
    assert_eq!(urls, ["https://doi.org/10.1098/rspa.2019.0703"]);
}

#[test]
fn what_is_no_link_is_text() {
    let text = "[a](javascript:x) [b](file:///c) [d](#e) [f](data:text/html,g) [h](https://i.org)";
    let (written, _) = page(text, 400.0, 1.0);
    assert_eq!(written.links, ["https://i.org"]);
    assert_eq!(written.page.parts[0].text, "a b d f h");
}

#[test]
fn what_is_nested_without_end_is_shown() {
    for text in [">", "- ", "1. ", "> - ", "*a **b ", "[", "![a ", "- a\n\n  > "] {
        let text: &'static str = (text.repeat(8000) + "x").leak();
        let (written, _) = page(text, 400.0, 1.0);
        assert!(written.page.parts.last().is_some_and(|part| part.text.ends_with('x')), "{text:.9}");
    }
}

#[test]
fn a_text_is_set_once_and_anew_when_its_setting_changes() {
    let seen = Arc::new(Mutex::new(Vec::<Arc<WrittenText>>::new()));
    let pages = Arc::new(Mutex::new(0));
    let (taken, count) = (seen.clone(), pages.clone());
    let mut frame = 0;
    let mut harness = Harness::builder().build_ui(move |ui| {
        frame += 1;
        if frame == 1 {
            theme::install(ui.ctx());
            return;
        }
        if frame <= 10 {
            let now = written(ui.ctx(), &Markdown::new(SAMPLE), &setting(ui));
            taken.lock().expect("it is free").push(now);
        }
        if frame == 4 {
            ui.ctx().set_theme(Theme::Light);
        }
        if frame == 7 {
            ui.ctx().set_pixels_per_point(2.0);
        }
        *count.lock().expect("it is free") =
            ui.ctx().memory_mut(|memory| memory.caches.cache::<Pages>().len());
    });
    harness.run_steps(14);
    let seen = seen.lock().expect("it is free");
    let mut different: Vec<&Arc<WrittenText>> = seen.iter().collect();
    different.dedup_by(|one, other| Arc::ptr_eq(one, other));
    assert_eq!(different.len(), 3, "it was set {} times in {} frames", different.len(), seen.len());
    assert_eq!(*pages.lock().expect("it is free"), 0, "what is not shown is not kept");
}
