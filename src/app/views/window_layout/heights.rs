//! Heights of the parts in the middle of the window, one below the other.

use eframe::egui::{Pos2, Rect, Vec2, vec2};

use crate::app::views::panes::Arrangement;
use crate::app::widgets::theme::GAP;
use crate::settings::WindowSettings;

/// Height of the wavelength scale with the numbers on it.
const SPECTRUM_HEIGHT: f32 = 36.0;
/// Heights of the sentence in a line and in two, and from which width on it needs but one.
const SENTENCE_HEIGHTS: [f32; 2] = [22.0, 38.0];
const NARROWEST_LINE: f32 = 1000.0;
/// Lowest plots and views of use.
pub(in crate::app) const LOWEST: f32 = 90.0;
/// Lower plots and views do without words between them.
const LOWEST_BESIDE_WORDS: f32 = 210.0;
/// Height of a view that is high enough, in widths.
const VIEW_ASPECT: f32 = 0.75;
/// Share of the window's height that the pictures have, unless they are narrower.
const PICTURES_SHARE: f32 = 0.5;
/// Height that pictures have among few controls where there is room, in widths.
const FEW_ASPECT: f32 = 0.9;
/// Lowest strips of plots below such pictures: of one plot alone, with tabs above it, and with two rows of
/// these where they are narrower than this.
const LOWEST_STRIPS: [f32; 3] = [140.0, 150.0, 224.0];
const NARROWEST_TABS: f32 = 830.0;
/// Share of the height that the plots take from the views where these give way.
const PLOTS_SHARE: f32 = 0.38;
/// Height that the fit with its table and residuals needs, or the map beside plots; no more than half, unless
/// the views leave more.
const PLOTS_HEIGHT: f32 = 310.0;

/// Conditions for the height of the strip of plots, besides the room.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::app) struct StripNeeds {
    /// Height of the window.
    pub window: f32,
    /// Whether the window is as narrow as a phone's.
    pub is_narrow: bool,
    /// Whether the strip has something that takes room from the pictures: a table, or a map on request.
    pub is_high: bool,
}

/// Heights of the views, the words below them, and the strip of plots.
pub(in crate::app) struct Heights {
    /// Heights of the wavelength scale and of the sentence.
    pub words: [f32; 2],
    /// Height for views and plots.
    pub free: f32,
    /// Height that the views have at least where there are plots.
    pub lowest: f32,
    /// Default height of the strip of plots.
    pub strip: f32,
}

impl Heights {
    /// Divides the height of a middle of this `size`. In a window as narrow as a phone's the words and the
    /// plots leave the views all the height that they need.
    pub fn new(needs: StripNeeds, size: Vec2, window: WindowSettings, arranged: &Arrangement) -> Self {
        let is_narrow = needs.is_narrow;
        let needed = |height: f32| height_of_views(arranged, vec2(size.x, height));
        let lowest = if is_narrow { needed(size.y).max(LOWEST) } else { LOWEST };
        let beside_words = if window.plots && !is_narrow { 2.0 * LOWEST_BESIDE_WORDS } else { lowest };
        let words = words_heights(size, beside_words, window);
        let free = size.y - words.iter().sum::<f32>();
        let half = 0.5 * free;
        let most = if is_narrow { half } else { (free - needed(free)).max(half) };
        let high = (free * PLOTS_SHARE).max(PLOTS_HEIGHT.min(most));
        let strip = if is_narrow || needs.is_high {
            high
        } else {
            let pictures = pictures_height(arranged, vec2(size.x, free), needs.window, window.simple);
            let lowest = match window.simple {
                true => LOWEST_STRIPS[0],
                false if size.x >= NARROWEST_TABS => LOWEST_STRIPS[1],
                false => LOWEST_STRIPS[2],
            };
            (free - pictures).max(lowest).min(high)
        };
        Self { words, free, lowest, strip }
    }
}

/// Returns the height that views `arranged` in an area of this `size` have before the plots have any, in a
/// window of this height: half of it for the pictures, and among few controls as much as suits their width.
fn pictures_height(arranged: &Arrangement, size: Vec2, window: f32, is_simple: bool) -> f32 {
    let panes = arranged.panes(Rect::from_min_size(Pos2::ZERO, size));
    let Some(first) = panes.first() else { return 0.0 };
    let (width, around) = (first.rect.width(), size.y - first.rect.height());
    let half = (PICTURES_SHARE * window).min(width);
    (if is_simple { half.max(FEW_ASPECT * width) } else { half }) + around + GAP
}

/// Returns the height that views `arranged` in an area of this `size` need: higher ones would show more of
/// the sky only.
pub(in crate::app) fn height_of_views(arranged: &Arrangement, size: Vec2) -> f32 {
    let panes = arranged.panes(Rect::from_min_size(Pos2::ZERO, size));
    let bottoms = panes.iter().map(|pane| pane.rect.min.y + VIEW_ASPECT * pane.rect.width() + pane.band);
    bottoms.fold(0.0, f32::max) + GAP
}

/// Heights of the wavelength scale and of the sentence below views of this `width`; 0 where they are switched
/// off. Where they would leave the views and the plots less than the `lowest` of `height`, the scale gives
/// way first.
fn words_heights(Vec2 { x: width, y: height }: Vec2, lowest: f32, window: WindowSettings) -> [f32; 2] {
    let [in_a_line, in_two] = SENTENCE_HEIGHTS;
    let sentence = if width >= NARROWEST_LINE { in_a_line } else { in_two };
    let wanted = [(window.spectrum, SPECTRUM_HEIGHT), (window.sentence, sentence)]
        .map(|(is_on, height)| if is_on && window.views { height } else { 0.0 });
    let fits = |words: &[f32; 2]| height - words.iter().sum::<f32>() >= lowest;
    [wanted, [0.0, wanted[1]]].into_iter().find(fits).unwrap_or_default()
}
