//! Colours and sizes. The colours of the points differ to colour-blind eyes, too: they are from M. Okabe and
//! K. Ito, *Color universal design* (2008), like those of the eyes.

use eframe::egui::{
    self, Color32, FontDefinitions, FontFamily, FontId, Stroke, TextStyle, ThemePreference, Visuals,
    epaint::CornerRadius,
    style::{ScrollFadeStyle, ScrollStyle},
};

use crate::app::state::points::MAX_POINTS;
use crate::app::widgets::formula;
use crate::comfort::ComfortVerdict;
use crate::eye::Eye;
use crate::eye_colours;
use crate::settings::Theme;

/// Space around and between the parts of the window, points.
pub const GAP: f32 = 8.0;
/// Height of the titles of panes.
pub const TITLE_HEIGHT: f32 = 22.0;

/// The first of two colours (red, green, blue) on a dark background, the second on a light one.
fn either(is_dark: bool, [dark, light]: [[u8; 3]; 2]) -> Color32 {
    let [r, g, b] = if is_dark { dark } else { light };
    Color32::from_rgb(r, g, b)
}

/// The colour of an eye, on this background.
#[must_use]
pub fn eye_colour(eye: Eye, visuals: &Visuals) -> Color32 {
    let of = |colours: [[u8; 3]; 2]| colours[eye.index()];
    either(visuals.dark_mode, [of(eye_colours::ON_DARK), of(eye_colours::ON_LIGHT)])
}

/// The colour of the followed point with this number (from 1), on this background.
#[must_use]
pub fn point_colour(number: usize, visuals: &Visuals) -> Color32 {
    const COLOURS: [[[u8; 3]; 2]; MAX_POINTS] = [
        [[0x1F, 0xD0, 0x9E], [0x00, 0x7A, 0x58]],
        [[0xE7, 0x9B, 0xC8], [0xA8, 0x45, 0x7F]],
        [[0xF0, 0xE4, 0x42], [0x7A, 0x68, 0x00]],
        [[0xC8, 0xC8, 0xC8], [0x55, 0x55, 0x55]],
        [[0xA7, 0x8B, 0xFA], [0x6D, 0x4A, 0xD8]],
    ];
    either(visuals.dark_mode, COLOURS[(number + MAX_POINTS - 1) % MAX_POINTS])
}

/// Returns the colour of places where two eyes take something to be, on this background.
#[must_use]
pub fn stereo_colour(visuals: &Visuals) -> Color32 {
    either(visuals.dark_mode, [[0xF0, 0x62, 0xB8], [0xB8, 0x1E, 0x7A]])
}

/// Whether a pair can be fused in comfort, on this background.
#[must_use]
pub fn verdict_colour(verdict: ComfortVerdict, visuals: &Visuals) -> Color32 {
    let colours = match verdict {
        ComfortVerdict::Comfortable => [[0x1F, 0xD0, 0x9E], [0x00, 0x7A, 0x58]],
        ComfortVerdict::Tiring => [[0xF0, 0xE4, 0x42], [0x7A, 0x68, 0x00]],
        ComfortVerdict::TooMuch => [[0xFF, 0x6B, 0x5E], [0xB8, 0x24, 0x18]],
    };
    either(visuals.dark_mode, colours)
}

/// Returns the colour of a message, which separates failure from success, on this background.
#[must_use]
pub fn notice_colour(is_error: bool, visuals: &Visuals) -> Color32 {
    verdict_colour(if is_error { ComfortVerdict::TooMuch } else { ComfortVerdict::Comfortable }, visuals)
}

/// Returns the colour of what is measured at one time, on this background.
#[must_use]
pub fn measured_colour(visuals: &Visuals) -> Color32 {
    visuals.strong_text_color()
}

/// The ring around what the keyboard is at.
#[must_use]
pub fn focus_stroke(visuals: &Visuals) -> Stroke {
    Stroke::new(2.0, either(visuals.dark_mode, [[0x8A, 0xC7, 0xFF], [0x1B, 0x5F, 0xA8]]))
}

/// Returns the colour that sets a marker off from any picture.
#[must_use]
pub fn halo_colour(visuals: &Visuals) -> Color32 {
    if visuals.dark_mode { Color32::from_black_alpha(170) } else { Color32::from_white_alpha(210) }
}

/// Colour of text on the dark tags of pictures, in either theme.
pub const TAG_TEXT: Color32 = Color32::from_gray(205);

/// Returns the colours of a primary button or an open tab: its background, and its text.
#[must_use]
pub fn primary_colours(visuals: &Visuals) -> [Color32; 2] {
    [either(visuals.dark_mode, [[0x2F, 0x6B, 0xA8], [0x1B, 0x5F, 0xA8]]), Color32::WHITE]
}

/// The line at the present T.
#[must_use]
pub fn now_colour(visuals: &Visuals) -> Color32 {
    visuals.strong_text_color()
}

/// The line at T0.
#[must_use]
pub fn equidistance_colour(visuals: &Visuals) -> Color32 {
    visuals.weak_text_color()
}

/// Returns the toolkit's name for the choice of theme.
#[must_use]
pub const fn preference(theme: Theme) -> ThemePreference {
    match theme {
        Theme::Light => ThemePreference::Light,
        Theme::Dark => ThemePreference::Dark,
        Theme::System => ThemePreference::System,
    }
}

/// Size of small writing, the smallest there is, points.
pub const SMALL_SIZE: f32 = 12.0;
/// Size of most writing, points.
pub const BODY_SIZE: f32 = 14.0;
/// Size of titles, and of the speed, points. There are no sizes but these three.
pub const HEADING_SIZE: f32 = 20.0;

/// Magnifies all text by `scale`.
pub fn scale_text(ctx: &egui::Context, scale: f32) {
    ctx.all_styles_mut(|style| set_body_size(style, scale * BODY_SIZE));
}

/// Has the toolkit's parts move, or change at once.
pub fn set_animations(ctx: &egui::Context, is_on: bool) {
    let time = if is_on { egui::Style::default().animation_time } else { 0.0 };
    if ctx.global_style().animation_time != time {
        ctx.all_styles_mut(|style| style.animation_time = time);
    }
}

/// Has all writing stand out, and all edges seen, or each as much as is usual.
pub fn set_contrast(ctx: &egui::Context, is_strong: bool) {
    let edge = ctx.global_style().visuals.widgets.inactive.bg_stroke;
    if is_strong != (edge != Stroke::NONE) {
        ctx.all_styles_mut(|style| {
            palette(&mut style.visuals);
            if is_strong {
                strengthen(&mut style.visuals);
            }
        });
    }
}

/// Makes all writing of this `style` as large as suits most writing of this `size`, points.
pub fn set_body_size(style: &mut egui::Style, size: f32) {
    let size = |points: f32, family| FontId::new(size / BODY_SIZE * points, family);
    style.text_styles = [
        (TextStyle::Small, size(SMALL_SIZE, FontFamily::Proportional)),
        (TextStyle::Body, size(BODY_SIZE, FontFamily::Proportional)),
        (TextStyle::Button, size(BODY_SIZE, FontFamily::Proportional)),
        (TextStyle::Heading, size(HEADING_SIZE, FontFamily::Proportional)),
        (TextStyle::Monospace, size(SMALL_SIZE, FontFamily::Monospace)),
    ]
    .into();
}

/// Returns the magnification of text.
#[must_use]
pub fn text_scale(style: &egui::Style) -> f32 {
    TextStyle::Body.resolve(style).size / BODY_SIZE
}

/// Sets fonts, spacing and both palettes.
pub fn install(ctx: &egui::Context) {
    ctx.set_fonts(fonts());
    scale_text(ctx, 1.0);
    ctx.all_styles_mut(|style| {
        style.spacing.item_spacing = egui::vec2(GAP, 6.0);
        style.spacing.button_padding = egui::vec2(7.0, 3.0);
        style.spacing.interact_size.y = 22.0;
        style.spacing.slider_rail_height = 4.0;
        style.spacing.tooltip_width = 320.0;
        // Bars have room of their own, and what continues fades away at the edge.
        style.spacing.scroll = ScrollStyle { floating_allocated_width: 9.0, ..ScrollStyle::thin() };
        style.spacing.scroll.fade = ScrollFadeStyle { strength: 0.9, size: 26.0 };
        style.visuals.slider_trailing_fill = true;
        style.visuals.widgets.noninteractive.corner_radius = CornerRadius::same(5);
        for widget in [
            &mut style.visuals.widgets.inactive,
            &mut style.visuals.widgets.hovered,
            &mut style.visuals.widgets.active,
            &mut style.visuals.widgets.open,
        ] {
            widget.corner_radius = CornerRadius::same(5);
        }
        palette(&mut style.visuals);
    });
}

/// The usual fonts, with arrows for the proportional one from the monospaced one, and those of formulas.
fn fonts() -> FontDefinitions {
    let mut fonts = FontDefinitions::default();
    let monospace = fonts.families.get(&FontFamily::Monospace).cloned().unwrap_or_default();
    fonts.families.entry(FontFamily::Proportional).or_default().extend(monospace);
    formula::add_fonts(&mut fonts);
    fonts
}

/// The colours of the window's parts, on dark and on light.
fn palette(visuals: &mut Visuals) {
    let is_dark = visuals.dark_mode;
    let colour = |dark, light| either(is_dark, [dark, light]);
    visuals.weak_text_color = Some(colour([0x9A, 0xA2, 0xB1], [0x5A, 0x61, 0x6E]));
    visuals.error_fg_color = colour([0xFF, 0x6B, 0x5E], [0xB8, 0x24, 0x18]);
    visuals.panel_fill = colour([0x16, 0x18, 0x1D], [0xF6, 0xF7, 0xF9]);
    visuals.window_fill = colour([0x1D, 0x20, 0x27], [0xFF, 0xFF, 0xFF]);
    visuals.extreme_bg_color = colour([0x0E, 0x10, 0x14], [0xFF, 0xFF, 0xFF]);
    visuals.faint_bg_color = colour([0x1C, 0x1F, 0x26], [0xEC, 0xEE, 0xF2]);
    visuals.window_stroke = Stroke::new(1.0, colour([0x3C; 3], [0xBE; 3]));
    let still = &mut visuals.widgets.noninteractive;
    still.fg_stroke.color = colour([0xC4, 0xC9, 0xD4], [0x33, 0x38, 0x42]);
    still.bg_stroke = Stroke::new(1.0, colour([0x2D, 0x32, 0x3C], [0xD5, 0xD9, 0xE0]));
    let inactive = &mut visuals.widgets.inactive;
    inactive.bg_stroke = Stroke::NONE;
    inactive.weak_bg_fill = colour([0x2A, 0x2F, 0x39], [0xE3, 0xE6, 0xEC]);
    inactive.bg_fill = colour([0x33, 0x39, 0x45], [0xD3, 0xD8, 0xE1]);
    inactive.fg_stroke.color = colour([0xD6, 0xDA, 0xE3], [0x2B, 0x30, 0x3A]);
    visuals.selection.bg_fill = colour([0x2F, 0x5D, 0x8C], [0xB9, 0xD8, 0xF2]);
    visuals.selection.stroke.color = colour([0xFF, 0xFF, 0xFF], [0x08, 0x2F, 0x52]);
}

/// Black and white in place of what lies near them, and an edge around each control.
fn strengthen(visuals: &mut Visuals) {
    let colour = |dark, light| either(visuals.dark_mode, [[dark; 3], [light; 3]]);
    let [ground, ink] = [colour(0x00, 0xFF), colour(0xFF, 0x00)];
    let edge = Stroke::new(1.0, colour(0xA0, 0x5A));
    visuals.weak_text_color = Some(colour(0xD0, 0x38));
    [visuals.panel_fill, visuals.window_fill, visuals.extreme_bg_color] = [ground; 3];
    visuals.window_stroke = edge;
    let widgets = &mut visuals.widgets;
    for widget in [&mut widgets.noninteractive, &mut widgets.inactive] {
        (widget.fg_stroke.color, widget.bg_stroke) = (ink, edge);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Contrast of two opaque colours: Web Content Accessibility Guidelines 2.1, "contrast ratio".
    fn contrast(one: Color32, other: Color32) -> f64 {
        let luminance = |colour: Color32| {
            let [r, g, b] = [colour.r(), colour.g(), colour.b()].map(|channel| {
                let value = f64::from(channel) / 255.0;
                if value <= 0.03928 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
            });
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        let (one, other) = (luminance(one), luminance(other));
        (one.max(other) + 0.05) / (one.min(other) + 0.05)
    }

    #[test]
    fn the_contrast_of_black_and_white_is_21() {
        assert!((contrast(Color32::BLACK, Color32::WHITE) - 21.0).abs() < 1e-9);
        assert!((contrast(Color32::from_gray(0x77), Color32::WHITE) - 4.48).abs() < 0.01);
    }

    /// Text has the contrast of level AAA of the same guidelines, and edges of controls that of level AA.
    #[test]
    fn more_contrast_is_seen_and_goes_again() {
        let ctx = egui::Context::default();
        install(&ctx);
        let themes =
            || [egui::Theme::Dark, egui::Theme::Light].map(|theme| ctx.style_of(theme).visuals.clone());
        let usual = themes();
        set_contrast(&ctx, true);
        for visuals in themes() {
            let inactive = &visuals.widgets.inactive;
            for ground in [visuals.panel_fill, visuals.window_fill, visuals.extreme_bg_color] {
                for text in [visuals.text_color(), visuals.weak_text_color(), inactive.fg_stroke.color] {
                    assert!(contrast(text, ground) >= 7.0, "{text:?} on {ground:?}");
                }
                assert!(contrast(inactive.bg_stroke.color, ground) >= 3.0, "{ground:?}");
            }
        }
        set_contrast(&ctx, false);
        assert!(themes() == usual);
    }

    #[test]
    fn all_writing_can_be_read_in_both_themes() {
        let ctx = egui::Context::default();
        install(&ctx);
        for theme in [egui::Theme::Dark, egui::Theme::Light] {
            let style = ctx.style_of(theme);
            let visuals = &style.visuals;
            let backgrounds =
                [visuals.panel_fill, visuals.window_fill, visuals.extreme_bg_color, visuals.faint_bg_color];
            let verdicts = [ComfortVerdict::Comfortable, ComfortVerdict::Tiring, ComfortVerdict::TooMuch];
            let mut written = vec![
                ("text", visuals.text_color()),
                ("strong text", visuals.strong_text_color()),
                ("weak text", visuals.weak_text_color()),
                ("error", visuals.error_fg_color),
                ("message", notice_colour(true, visuals)),
                ("good message", notice_colour(false, visuals)),
                ("stereo", stereo_colour(visuals)),
            ];
            written.extend(Eye::BOTH.map(|eye| ("eye", eye_colour(eye, visuals))));
            written.extend(verdicts.map(|verdict| ("verdict", verdict_colour(verdict, visuals))));
            written.extend((1..=MAX_POINTS).map(|number| ("point", point_colour(number, visuals))));
            for (name, colour) in written {
                for background in backgrounds {
                    let contrast = contrast(colour, background);
                    assert!(contrast >= 4.5, "{theme:?} {name} {colour:?} on {background:?}: {contrast:.2}");
                }
            }
            let buttons = [visuals.widgets.inactive.weak_bg_fill, visuals.widgets.inactive.bg_fill];
            for button in buttons {
                let contrast = contrast(visuals.widgets.inactive.fg_stroke.color, button);
                assert!(contrast >= 4.5, "{theme:?} button: {contrast:.2}");
            }
            let [ground, ink] = primary_colours(visuals);
            assert!(contrast(ground, ink) >= 4.5, "{theme:?} what leads on");
            let chosen = contrast(visuals.selection.stroke.color, visuals.selection.bg_fill);
            assert!(chosen >= 4.5, "{theme:?} what is chosen: {chosen:.2}");
        }
    }

    #[test]
    fn there_are_three_sizes_of_writing_and_none_below_twelve_points() {
        let ctx = egui::Context::default();
        install(&ctx);
        for theme in [egui::Theme::Dark, egui::Theme::Light] {
            for (name, font) in &ctx.style_of(theme).text_styles {
                let sizes = [SMALL_SIZE, BODY_SIZE, HEADING_SIZE];
                assert!(font.size >= 12.0 && sizes.contains(&font.size), "{theme:?} {name}: {}", font.size);
            }
        }
    }
}
