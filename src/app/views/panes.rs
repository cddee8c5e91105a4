//! Panes of the views' area: their contents, and the places of the eyes' pictures in them.

use eframe::egui::{Pos2, Rect, Ui, Vec2, pos2, vec2};
use relativity_render::Composition;
use relativity_render::picture::compose::Top;

use crate::app::widgets::theme::{GAP, TITLE_HEIGHT};
use crate::eye::Eye;
use crate::flags::OnOff;
use crate::flags::choices::{Form, Layout};
use crate::settings::{PictureSettings, Settings, WindowSettings};

/// The contents of a pane. To add one beside the eyes, add a variant, its row in [`BESIDE`], a file in
/// `panels`, an arm in `shell/panes.rs`, and its switch among the settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PaneContent {
    /// The view of one eye.
    Eye(Eye),
    /// The second picture of the left eye, in place of the right eye's.
    Second,
    /// The views of both eyes, in one picture.
    Both,
    /// The left eye's picture, corrected.
    Corrected,
}

/// A pane beside the eyes' pictures, shown while its setting is on.
#[derive(Debug)]
pub struct PaneBeside {
    /// Contents of the pane.
    pub content: PaneContent,
    /// Name of the setting that shows it, and of its control.
    pub name: &'static str,
    /// The place of that setting in the section of the window.
    pub switch: fn(&mut WindowSettings) -> &mut OnOff,
}

/// The panes beside the eyes' pictures, from the left.
pub const BESIDE: [PaneBeside; 1] = [PaneBeside {
    content: PaneContent::Corrected,
    name: "corrected",
    switch: |window| &mut window.corrected,
}];

impl PaneBeside {
    /// Whether the pane is shown in a window with these settings.
    fn is_shown(&self, mut window: WindowSettings) -> bool {
        *(self.switch)(&mut window)
    }
}

/// A pane of the views' area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pane {
    /// Contents of the pane.
    pub content: PaneContent,
    /// Place of the picture.
    pub rect: Rect,
    /// Height of the band below the picture, which has its ruler; 0 without one.
    pub band: f32,
    /// Place of the picture's name.
    pub title: PaneTitle,
}

/// The place of a picture's name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PaneTitle {
    /// In the strip above the picture.
    Above,
    /// In the band below the picture.
    InBand,
    /// A picture alone before an audience has no name, and no frame.
    Nowhere,
}

impl PaneTitle {
    /// Whether the picture is that of the usual window, and not before an audience.
    #[must_use]
    pub const fn is_in_window(self) -> bool {
        matches!(self, Self::Above)
    }
}

/// The arrangement of the views' area.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arrangement {
    picture: PictureSettings,
    /// Whether both pictures are of the left eye.
    is_comparing: bool,
    /// The panes of [`BESIDE`] that are shown.
    beside: [bool; BESIDE.len()],
    /// For free viewing, how far apart the middles of pictures are at most, points.
    apart: f32,
    /// Height of titles, points; 0 before an audience.
    title: f32,
    /// Height of the band below a picture, points; 0 where the pictures have no ruler.
    pub band: f32,
    /// Magnification of text relative to the default.
    scale: f32,
}

/// Heights of the band below a picture where text has its default size, points: in the window, and before an
/// audience, where it has one row of ticks alone.
const BAND: f32 = 30.0;
const BAND_FOR_AUDIENCE: f32 = 18.0;
/// Pictures less high than this, with their bands, do without, unless they are narrow.
const LEAST_WITH_BAND: f32 = 220.0;
/// Height of a narrow picture above its band at least, in widths.
const LEAST_ABOVE_BAND: f32 = 0.74;

impl Arrangement {
    /// Returns the arrangement of `settings`, where a point of the window has this size on the screen (above
    /// 0), with titles magnified by `scale`.
    #[must_use]
    pub fn new(settings: &Settings, cm_per_point: f64, scale: f32) -> Self {
        let Settings { picture, window, screen, .. } = settings;
        let apart = (0.1 * screen.picture_distance / cm_per_point) as f32;
        let (is_comparing, title) = (settings.is_comparing(), scale * TITLE_HEIGHT);
        let band = if settings.has_ruler() { scale * BAND } else { 0.0 };
        let beside = BESIDE.map(|pane| pane.is_shown(*window));
        Self { picture: *picture, is_comparing, beside, apart, title, band, scale }
    }

    /// Returns the arrangement before an audience: the names of several pictures stand in the bands below
    /// them, and unless it has both eyes, the left one's picture stands for two that are apart.
    #[must_use]
    pub fn for_audience(self, has_both: bool) -> Self {
        let mut picture = self.picture;
        if picture.layout.shows_two_apart() && !has_both && !self.is_comparing {
            picture.layout = Layout::Left;
        }
        let without = Self { picture, title: 0.0, ..self };
        let has_band = self.band > 0.0 || !without.is_alone();
        Self { band: if has_band { self.scale * BAND_FOR_AUDIENCE } else { 0.0 }, ..without }
    }

    /// Whether there is a single picture.
    fn is_alone(&self) -> bool {
        !self.beside.contains(&true) && !matches!(self.picture.layout.form(), Form::Beside | Form::Above)
    }

    /// The panes in `area`.
    #[must_use]
    pub fn panes(&self, area: Rect) -> Vec<Pane> {
        let form = self.picture.layout.form();
        let of_eyes = if form == Form::Beside { 2.0 } else { 1.0 };
        let shown = BESIDE.into_iter().zip(self.beside).filter(|(_, is_shown)| *is_shown);
        let beside: Vec<_> = shown.map(|(pane, _)| pane.content).collect();
        let columns = of_eyes + beside.len() as f32;
        let width = ((area.width() - GAP * (columns - 1.0)) / columns).max(1.0);
        let is_narrow = area.height() - self.title - self.band >= LEAST_ABOVE_BAND * width;
        let has_band = is_narrow || area.height() >= self.scale * LEAST_WITH_BAND;
        let band = if has_band { self.band } else { 0.0 };
        let column = |number: f32, width: f32| {
            let x = area.min.x + number * (width + GAP);
            let bottom = (area.max.y - band).max(area.min.y);
            self.below_title(Rect::from_min_max(pos2(x, area.min.y), pos2(x + width, bottom)))
        };
        let title = match self.title {
            0.0 if self.is_alone() => PaneTitle::Nowhere,
            0.0 => PaneTitle::InBand,
            _ => PaneTitle::Above,
        };
        let pane = |content, rect| Pane { content, rect, band, title };
        let [first, second] = self.contents();
        let mut panes = match form {
            Form::One(_) => vec![pane(first, column(0.0, width))],
            Form::Beside => {
                let [left, right] = self.beside(column(0.0, width), column(1.0, width));
                vec![pane(first, left), pane(second, right)]
            }
            Form::Above => {
                let whole = column(0.0, width).with_min_y(area.min.y);
                let middle = whole.center().y;
                let (upper, lower) = (whole.with_max_y(middle), self.below_title(whole.with_min_y(middle)));
                // Both have the same columns, and one ruler.
                vec![Pane { band: 0.0, ..pane(first, self.below_title(upper)) }, pane(second, lower)]
            }
            Form::Composed(_) | Form::InTurn => vec![pane(PaneContent::Both, column(0.0, width))],
        };
        for (number, content) in beside.into_iter().enumerate() {
            panes.push(pane(content, column(of_eyes + number as f32, width)));
        }
        panes
    }

    /// The panes of a screen with this `area`, if the picture needs all of it: a television stretches halves
    /// of the screen, and what stood beside the picture would be in one of them only.
    #[must_use]
    pub fn whole_screen(&self, area: Rect) -> Option<Vec<Pane>> {
        let halves = [Layout::HalfSideBySide, Layout::HalfOverUnder];
        let whole = Self { beside: [false; BESIDE.len()], title: 0.0, band: 0.0, ..*self };
        halves.contains(&self.picture.layout).then(|| whole.panes(area))
    }

    fn below_title(&self, rect: Rect) -> Rect {
        rect.with_min_y((rect.min.y + self.title).min(rect.max.y))
    }

    /// The eyes' pictures, or both of one eye, in the order of the layout; one that is alone twice.
    fn contents(&self) -> [PaneContent; 2] {
        let eyes = self.picture.eyes();
        [eyes[0], eyes[eyes.len() - 1]].map(|eye| match Eye::BOTH[eye] {
            Eye::Right if self.is_comparing => PaneContent::Second,
            eye => PaneContent::Eye(eye),
        })
    }

    /// Returns the places of pictures that have these two columns: for free viewing nearer to the middle, and
    /// no wider than that they are not too far apart.
    fn beside(&self, left: Rect, right: Rect) -> [Rect; 2] {
        let apart = right.min.x - left.min.x;
        if self.picture.layout != Layout::FreeViewing || apart <= self.apart {
            return [left, right];
        }
        let gap = GAP.min(0.1 * self.apart);
        let (middle, width) = (0.5 * (left.min.x + right.max.x), (self.apart - gap).max(1.0));
        [middle - 0.5 * gap - width, middle + 0.5 * gap]
            .map(|x| Rect::from_min_max(pos2(x, left.min.y), pos2(x + width, left.max.y)))
    }
}

/// `composition` as it is shown at `rect`: interleaved rows are the screen's, whose topmost is of the first
/// picture, so that they match those of a screen that is polarised in turn.
#[must_use]
pub fn on_screen(ui: &Ui, composition: Composition, rect: Rect) -> Composition {
    let Composition::Rows { .. } = composition else { return composition };
    let window = ui.input(|input| input.viewport().inner_rect).map_or(0.0, |inner| inner.min.y);
    let row = ((window + rect.min.y) * ui.pixels_per_point()).round() as i64;
    Composition::Rows { top: if row.rem_euclid(2) == 0 { Top::First } else { Top::Second } }
}

/// The place of an eye's picture on screen, and its number of pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EyePane {
    /// Eye that the picture belongs to.
    pub eye: Eye,
    /// Whether the pane shows the second of two pictures of one eye.
    pub is_second: bool,
    /// In points; its edges lie on pixel edges, so that the picture is shown pixel for pixel, unless it is
    /// squeezed.
    pub rect: Rect,
    /// Width and height in pixels, at least 1.
    pub size: [u32; 2],
    /// Whether the other eye's picture is in the same place.
    pub is_shared: bool,
    /// Height of the band below the picture; 0 without one.
    pub band: f32,
    /// Place of the picture's name.
    pub title: PaneTitle,
}

impl EyePane {
    /// Returns the pane of `eye` in `rect`, its picture being at most `largest` pixels wide or high.
    #[must_use]
    pub fn new(eye: Eye, rect: Rect, pixels_per_point: f32, largest: u32) -> Self {
        let snapped = |p: Pos2| (p.to_vec2() * pixels_per_point).round();
        let (min, max) = (snapped(rect.min), snapped(rect.max));
        let size = [max.x - min.x, max.y - min.y].map(|side| (side as u32).clamp(1, largest));
        let rect = Rect::from_min_max((min / pixels_per_point).to_pos2(), (max / pixels_per_point).to_pos2());
        Self { eye, is_second: false, rect, size, is_shared: false, band: 0.0, title: PaneTitle::Above }
    }

    /// Returns the pane with the title and the band of `pane`, which it lies in.
    #[must_use]
    pub fn of(self, pane: &Pane) -> Self {
        let is_lowest = (self.rect.max.y - pane.rect.max.y).abs() < 2.0;
        Self { band: if is_lowest { pane.band } else { 0.0 }, title: pane.title, ..self }
    }

    /// Returns the place of the band below the picture.
    #[must_use]
    pub fn band_rect(&self) -> Rect {
        Rect::from_min_size(self.rect.left_bottom(), vec2(self.rect.width(), self.band))
    }

    /// The place of the second picture of one eye in `rect`.
    #[must_use]
    pub fn second(rect: Rect, pixels_per_point: f32, largest: u32) -> Self {
        Self { is_second: true, ..Self::new(Eye::Left, rect, pixels_per_point, largest) }
    }

    /// Returns the panes of both eyes in the `rect` that they share in this `picture`, in the order of the
    /// layout.
    #[must_use]
    pub fn both(picture: &PictureSettings, rect: Rect, pixels_per_point: f32, largest: u32) -> [Self; 2] {
        let form = picture.layout.form();
        let whole = Self::new(Eye::Left, rect, pixels_per_point, largest);
        let even = |side: u32| (side & !1).max(2);
        let [width, height] = whole.size;
        // Halves of as many pixels, each of which is made of two.
        let (size, parts) = match form {
            Form::Composed(Composition::HalfSideBySide) => ([even(width), height], [2.0, 1.0]),
            Form::Composed(Composition::HalfOverUnder) => ([width, even(height)], [1.0, 2.0]),
            _ => (whole.size, [1.0, 1.0]),
        };
        let shown = vec2(size[0] as f32, size[1] as f32) / pixels_per_point;
        let part = shown / vec2(parts[0], parts[1]);
        let is_shared = parts == [1.0, 1.0];
        let mut number = 0.0;
        [0, picture.eyes().len() - 1].map(|place| {
            let corner = whole.rect.min + (shown - part) * number;
            number += 1.0;
            let rect = if is_shared { whole.rect } else { Rect::from_min_size(corner, part) };
            Self { eye: Eye::BOTH[picture.eyes()[place]], rect, size, is_shared, ..whole }
        })
    }

    /// Whether the picture is that of the usual window, and not before an audience.
    #[must_use]
    pub const fn is_in_window(&self) -> bool {
        self.title.is_in_window()
    }

    /// Whether the pane takes the mouse: where both eyes' pictures share a place, the left eye's does.
    #[must_use]
    pub fn takes_the_mouse(&self) -> bool {
        !self.is_shared || self.eye == Eye::Left
    }

    /// The place among the two pictures, 0 or 1.
    #[must_use]
    pub const fn index(&self) -> usize {
        if self.is_second { Eye::Right.index() } else { self.eye.index() }
    }

    /// The pixel of the picture at a place on screen. A pane without room counts as one of a point.
    #[must_use]
    pub fn pixel(&self, place: Pos2) -> [f64; 2] {
        let inside = (place - self.rect.min) / self.rect.size().max(Vec2::splat(1.0));
        [f64::from(inside.x) * f64::from(self.size[0]), f64::from(inside.y) * f64::from(self.size[1])]
    }

    /// Returns the place of a pixel of the picture on screen.
    #[must_use]
    pub fn place(&self, [u, v]: [f64; 2]) -> Pos2 {
        let fraction = vec2((u / f64::from(self.size[0])) as f32, (v / f64::from(self.size[1])) as f32);
        self.rect.min + fraction * self.rect.size()
    }
}

#[cfg(test)]
mod tests {
    use clap::ValueEnum as _;

    use super::*;
    use crate::flags::choices::Swapped;

    const AREA: Rect = Rect::from_min_max(pos2(8.0, 46.0), pos2(940.0, 420.0));

    fn arrangement(layout: Layout, has_beside: bool) -> Arrangement {
        let picture = PictureSettings { layout, ..PictureSettings::default() };
        let (title, band, scale) = (TITLE_HEIGHT, BAND, 1.0);
        let beside = [has_beside; BESIDE.len()];
        Arrangement { picture, is_comparing: false, beside, apart: 227.0, title, band, scale }
    }

    #[test]
    fn every_layout_fills_the_views_and_its_panes_do_not_overlap() {
        for &layout in Layout::value_variants() {
            for has_beside in [false, true] {
                for area in [AREA, Rect::from_min_size(pos2(0.0, 0.0), vec2(3.0, 2.0))] {
                    let panes = arrangement(layout, has_beside).panes(area);
                    for (i, pane) in panes.iter().enumerate() {
                        let is_wide_enough =
                            area.width() < 20.0 || area.expand(0.01).contains_rect(pane.rect);
                        assert!(is_wide_enough, "{layout:?}: {:?}", pane.rect);
                        for other in &panes[i + 1..] {
                            let overlap = pane.rect.intersect(other.rect);
                            assert!(overlap.width() <= 0.0 || overlap.height() <= 0.0, "{layout:?}");
                        }
                    }
                }
                let with_band = |pane: &Pane| pane.rect.area() + pane.band * pane.rect.width();
                let covered: f32 = arrangement(layout, has_beside).panes(AREA).iter().map(with_band).sum();
                let is_narrow = layout == Layout::FreeViewing;
                assert!(is_narrow || covered > 0.85 * AREA.area(), "{layout:?}: {covered}");
            }
        }
    }

    #[test]
    fn a_place_is_a_pixel_in_a_pane_without_room_too() {
        for size in [vec2(0.0, 0.0), vec2(300.0, 0.0), vec2(0.0, 0.2)] {
            let pane = EyePane::new(Eye::Left, Rect::from_min_size(AREA.min, size), 1.0, 4096);
            for place in [AREA.min, AREA.center(), pos2(-500.0, 3000.0)] {
                let pixel = pane.pixel(place);
                assert!(pixel.iter().all(|coordinate| coordinate.abs() < 1e7), "{size:?}: {pixel:?}");
            }
        }
    }

    #[test]
    fn for_free_viewing_the_pictures_are_as_near_as_is_asked_and_in_the_middle() {
        let panes = arrangement(Layout::FreeViewing, false).panes(AREA);
        let [left, right] = [0, 1].map(|i: usize| panes[i].rect);
        assert!((right.center().x - left.center().x - 227.0).abs() < 1e-3);
        assert!((left.center().x + right.center().x - 2.0 * AREA.center().x).abs() < 1e-3);
        let contents = [panes[0].content, panes[1].content];
        assert_eq!(contents, [PaneContent::Eye(Eye::Left), PaneContent::Eye(Eye::Right)]);
        // Narrow columns are near enough.
        let wide = Arrangement { apart: 2000.0, ..arrangement(Layout::FreeViewing, false) };
        assert_eq!(wide.panes(AREA), arrangement(Layout::SideBySide, false).panes(AREA));
    }

    #[test]
    fn an_audience_has_halves_on_the_whole_screen() {
        let screen = Rect::from_min_size(pos2(0.0, 0.0), vec2(1920.0, 1080.0));
        for &layout in Layout::value_variants() {
            let is_half = matches!(layout, Layout::HalfSideBySide | Layout::HalfOverUnder);
            let panes = arrangement(layout, true).whole_screen(screen);
            let (content, title) = (PaneContent::Both, PaneTitle::Nowhere);
            let expected = vec![Pane { content, rect: screen, band: 0.0, title }];
            assert_eq!(panes, is_half.then_some(expected), "{layout:?}");
        }
    }

    #[test]
    fn swapped_eyes_change_places() {
        for layout in [Layout::SideBySide, Layout::CrossEyed, Layout::OverUnder] {
            let mut one = arrangement(layout, false);
            let with_defaults = one.panes(AREA);
            one.picture.swapped = Swapped::default().toggled(layout);
            let swapped = one.panes(AREA);
            assert_eq!(
                [with_defaults[0].content, with_defaults[1].content],
                [swapped[1].content, swapped[0].content]
            );
            assert_eq!([with_defaults[0].rect, with_defaults[1].rect], [swapped[0].rect, swapped[1].rect]);
        }
    }

    #[test]
    fn halves_have_as_many_pixels_each_and_map_them_per_axis() {
        for (layout, size) in [(Layout::HalfSideBySide, [932, 322]), (Layout::HalfOverUnder, [932, 322])] {
            let picture = PictureSettings { layout, ..PictureSettings::default() };
            let [pane] = arrangement(layout, false).panes(AREA).try_into().expect("one");
            let [first, second] = EyePane::both(&picture, pane.rect, 1.0, 8192);
            assert_eq!((first.size, second.size, first.is_shared), (size, size, false));
            assert_eq!((first.eye, second.eye), (Eye::Left, Eye::Right));
            assert!((first.rect.area() - second.rect.area()).abs() < 1e-2);
            for half in [first, second] {
                let [u, v] = half.pixel(half.place([100.0, 200.0]));
                assert!((u - 100.0).abs() < 1e-3 && (v - 200.0).abs() < 1e-3);
                let end = half.place(size.map(f64::from));
                assert!((end - half.rect.max).length() < 1e-3);
            }
        }
    }
}
