//! Fonts and colours of words.

use eframe::egui::{
    Color32, FontId, TextFormat,
    epaint::text::{FontsView, LayoutJob},
};

use super::blocks::{WordKind, WordStyle};

/// The fonts and colours of text.
#[derive(Debug, Clone, PartialEq)]
pub struct TextInk {
    pub font: FontId,
    pub code_font: FontId,
    pub text: Color32,
    pub strong: Color32,
    pub link: Color32,
    pub wrong: Color32,
    pub code_background: Color32,
}

impl TextInk {
    pub fn format(&self, look: WordStyle) -> TextFormat {
        let color = match look {
            WordStyle { kind: WordKind::Wrong, .. } => self.wrong,
            WordStyle { link: Some(_), .. } => self.link,
            WordStyle { is_strong: true, .. } => self.strong,
            _ => self.text,
        };
        let (font_id, background) = match look.kind {
            WordKind::Words => (self.font.clone(), Color32::TRANSPARENT),
            WordKind::Code | WordKind::Wrong => (self.code_font.clone(), self.code_background),
        };
        TextFormat { italics: look.is_slanted, background, ..TextFormat::simple(font_id, color) }
    }
}

/// A line of text, to be laid out.
pub fn job(text: &str, format: TextFormat) -> LayoutJob {
    LayoutJob {
        break_on_newline: false,
        round_output_to_gui: false,
        ..LayoutJob::single_section(text.to_owned(), format)
    }
}

/// Returns the advance of a line of text, points.
pub fn width(fonts: &mut FontsView<'_>, text: &str, format: TextFormat) -> f32 {
    fonts.layout_job(job(text, format)).intrinsic_size().x
}
