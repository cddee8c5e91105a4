//! The fonts of formulas: those of `KaTeX`, which hold TeX's own letters.

use ratex_font::FontId;
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, MetadataProvider as _};

/// A font, by its face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FontFace {
    /// Upright: digits, operators, names of functions, capital Greek.
    Main,
    /// Upright bold letters.
    Bold,
    /// Slanted letters, for variables.
    Italic,
    /// Further symbols (AMS).
    Ams,
    /// Signs of sums, brackets and roots, a little larger.
    Size1,
    /// Large operators of displayed formulas.
    Size2,
    /// Brackets and roots around fractions.
    Size3,
    /// Brackets and roots around more.
    Size4,
}

impl FontFace {
    /// Every font.
    pub const ALL: [Self; 8] =
        [Self::Main, Self::Bold, Self::Italic, Self::Ams, Self::Size1, Self::Size2, Self::Size3, Self::Size4];

    /// Returns the name of the font.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Main => "KaTeX_Main-Regular",
            Self::Bold => "KaTeX_Main-Bold",
            Self::Italic => "KaTeX_Math-Italic",
            Self::Ams => "KaTeX_AMS-Regular",
            Self::Size1 => "KaTeX_Size1-Regular",
            Self::Size2 => "KaTeX_Size2-Regular",
            Self::Size3 => "KaTeX_Size3-Regular",
            Self::Size4 => "KaTeX_Size4-Regular",
        }
    }

    /// Returns the TrueType file of the font.
    #[must_use]
    pub const fn file(self) -> &'static [u8] {
        match self {
            Self::Main => include_bytes!("../../assets/fonts/KaTeX_Main-Regular.ttf"),
            Self::Bold => include_bytes!("../../assets/fonts/KaTeX_Main-Bold.ttf"),
            Self::Italic => include_bytes!("../../assets/fonts/KaTeX_Math-Italic.ttf"),
            Self::Ams => include_bytes!("../../assets/fonts/KaTeX_AMS-Regular.ttf"),
            Self::Size1 => include_bytes!("../../assets/fonts/KaTeX_Size1-Regular.ttf"),
            Self::Size2 => include_bytes!("../../assets/fonts/KaTeX_Size2-Regular.ttf"),
            Self::Size3 => include_bytes!("../../assets/fonts/KaTeX_Size3-Regular.ttf"),
            Self::Size4 => include_bytes!("../../assets/fonts/KaTeX_Size4-Regular.ttf"),
        }
    }

    fn font(self) -> Option<FontRef<'static>> {
        FontRef::new(self.file()).ok()
    }

    /// Draws a character with `pen`, y up, and returns how many of its units are an em; `None` if the font
    /// lacks it.
    pub(super) fn draw(self, character: char, pen: &mut impl OutlinePen) -> Option<f32> {
        let font = self.font()?;
        let glyph = font.outline_glyphs().get(font.charmap().map(character)?)?;
        glyph.draw(DrawSettings::unhinted(Size::unscaled(), LocationRef::default()), pen).ok()?;
        Some(f32::from(font.metrics(Size::unscaled(), LocationRef::default()).units_per_em))
    }

    /// Returns the advance of a character, em; `None` if the font lacks it.
    pub(super) fn advance(self, character: char) -> Option<f32> {
        let font = self.font()?;
        let location = LocationRef::default();
        let units = f32::from(font.metrics(Size::unscaled(), location).units_per_em);
        let advance =
            font.glyph_metrics(Size::unscaled(), location).advance_width(font.charmap().map(character)?)?;
        Some(advance / units)
    }
}

/// The font and character for those that the layout names.
pub(super) fn glyph(font: &str, code: u32) -> Result<(FontFace, char), String> {
    let id = FontId::parse(font).ok_or_else(|| format!("there is no font {font}"))?;
    let character = ratex_font::katex_ttf_glyph_char(id, code);
    let face = FontFace::ALL
        .into_iter()
        .find(|face| face.name().strip_prefix("KaTeX_") == Some(font))
        .ok_or_else(|| format!("the letters of {character:?} are not among the fonts ({font})"))?;
    let is_there = face.font().is_some_and(|font| font.charmap().map(character).is_some());
    if is_there { Ok((face, character)) } else { Err(format!("{font} has no {character:?}")) }
}
