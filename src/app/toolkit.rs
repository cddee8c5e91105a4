//! What is kept from one time to the next of what the windowing library remembers: how large everything is, and which
//! sections are folded away. The rest of it, such as how a list was scrolled, is not worth being believed.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

/// Where it is kept: where the library looks for it.
pub const KEY: &str = "egui";

/// Smallest and largest factor by which everything is larger than usual: those of the library's own keys.
const ZOOM: RangeInclusive<f64> = 0.2..=5.0;
/// Tallest section, points.
const TALLEST: f64 = 1e5;

/// The library's memory, as far as it is kept.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(default)]
struct Memory {
    options: Options,
    data: Data,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(default)]
struct Options {
    zoom_factor: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self { zoom_factor: 1.0 }
    }
}

/// The state of each widget that has some, by its number.
#[derive(Debug, Default, Serialize, Deserialize)]
struct Data(Vec<(u64, Element)>);

#[derive(Debug, Serialize, Deserialize)]
struct Element {
    type_id: TypeId,
    ron: String,
    generation: usize,
}

#[derive(Debug, Serialize, Deserialize)]
struct TypeId(u64);

/// That of a section that can be folded away.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Section {
    #[serde(rename = "open")]
    _is_open: bool,
    open_height: Option<f64>,
}

impl Element {
    fn is_kept(&self) -> bool {
        let section = ron::from_str::<Section>(&self.ron);
        section
            .is_ok_and(|section| section.open_height.is_none_or(|height| (0.0..=TALLEST).contains(&height)))
    }
}

/// What is kept of the library's memory in `text`; and what in it is out of range, if something is.
pub fn kept(text: &str) -> (String, Option<String>) {
    let (mut memory, mut problem) = match ron::from_str::<Memory>(text) {
        Ok(memory) => (memory, None),
        Err(error) => (Memory::default(), Some(format!("the size of everything cannot be read ({error})"))),
    };
    let zoom = memory.options.zoom_factor;
    if !ZOOM.contains(&zoom) {
        let (least, most) = ZOOM.into_inner();
        problem = Some(format!("zoom_factor = {zoom}: must be between {least} and {most}"));
        memory.options = Options::default();
    }
    memory.data.0.retain(|(_, element)| element.is_kept());
    memory.data.0.sort_by_key(|(number, _)| *number);
    (ron::to_string(&memory).expect("it is numbers and text"), problem)
}

#[cfg(test)]
mod tests {
    use eframe::egui::{self, Context};

    /// The memory of a window in which a section was folded away and everything enlarged.
    fn used() -> (String, egui::Id) {
        let ctx = Context::default();
        ctx.set_zoom_factor(1.5);
        let id = egui::Id::unique("section");
        let mut section = egui::collapsing_header::CollapsingState::load_with_default_open(&ctx, id, true);
        section.set_open(false);
        section.store(&ctx);
        egui::scroll_area::State::default().store(&ctx, egui::Id::unique("list"));
        ctx.begin_pass(egui::RawInput::default());
        ctx.end_pass().textures_delta.clear();
        (ctx.memory(ron::to_string).expect("it can be written"), id)
    }

    #[test]
    fn the_zoom_and_what_is_folded_away_are_kept_and_nothing_else() {
        let (text, section) = used();
        let (kept, problem) = super::kept(&text);
        assert_eq!(problem, None);
        assert!(text.contains("scroll_stuck") && !kept.contains("scroll_stuck"), "{kept}");
        assert_eq!(super::kept(&kept), (kept.clone(), None));
        let ctx = Context::default();
        let memory: egui::Memory = ron::from_str(&kept).expect("the library reads it");
        ctx.memory_mut(|own| *own = memory);
        assert_eq!(ctx.memory(|memory| memory.options.zoom_factor), 1.5);
        let state = egui::collapsing_header::CollapsingState::load(&ctx, section);
        assert!(!state.expect("it is kept").is_open());
    }

    #[test]
    fn a_zoom_that_cannot_be_is_named() {
        for zoom in ["0", "-1", "NaN", "inf", "1000", "1e300"] {
            let (kept, problem) = super::kept(&format!("(options:(zoom_factor:{zoom},max_passes:99999999))"));
            assert!(problem.expect("it is named").starts_with("zoom_factor = "), "{zoom}");
            let memory: egui::Memory = ron::from_str(&kept).expect("the library reads it");
            assert_eq!((memory.options.zoom_factor, memory.options.max_passes.get()), (1.0, 2));
        }
        let (kept, problem) = super::kept("(((((");
        assert!(problem.is_some() && ron::from_str::<egui::Memory>(&kept).is_ok());
    }
}
