//! What a tab of plots against T shows, as plain data: the window draws it, and files hold it.

use eframe::egui::{Color32, Visuals};
use egui_plot::PlotPoint;
use relativity_core::{Model, math};

use super::axes::{Ruler, shown_in, value_range};
use crate::app::curves::{self, Curve, Curves, CurvesKey, DistanceKind, PUBLISHED, Quantity};
use crate::app::observer::Eye;
use crate::app::state::State;
use crate::app::theme;
use crate::settings::PlotTab;
use crate::units::Unit;

/// A plot against T.
pub(super) struct Chart<'a> {
    /// What is plotted.
    pub quantity: Quantity,
    /// The unit of its values as they are shown.
    pub unit: Unit,
    /// The unit of T as it is shown.
    pub time_unit: Unit,
    /// First and last T, in the scene's unit.
    pub range: [f64; 2],
    /// The curves, those on top last.
    pub traces: Vec<Trace<'a>>,
    /// T0, and what that is in words.
    pub equidistant: Option<(f64, &'static str)>,
    /// T.
    pub now: f64,
}

/// A curve of a chart.
pub(super) struct Trace<'a> {
    /// What it is called.
    pub name: String,
    /// Its pieces, as plotted: logarithms of a quantity that is one.
    pub pieces: &'a [Vec<PlotPoint>],
    /// Whose colour it has.
    pub hue: Hue,
    /// How its line is drawn.
    pub dash: Dash,
    /// Whether it is drawn strongly.
    pub wide: bool,
    /// Whether a dot shows where it is at T.
    pub dot: bool,
    /// What it is computed from.
    pub source: Source,
}

/// What a curve is computed from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Source {
    /// Of which point, seen how.
    pub key: CurvesKey,
    /// By which model.
    pub model: Model,
    /// Which curve.
    pub curve: Curve,
}

/// Whose colour a curve has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hue {
    /// A followed point's, by its number.
    Point(usize),
    /// An eye's.
    Eye(Eye),
    /// That of where two eyes take something to be.
    Stereo,
    /// That of what is measured at one time.
    Measured,
}

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Dash {
    Solid,
    /// Dashes of this length, points.
    Dashed(u8),
    Dotted,
}

impl Dash {
    /// Of the right eye, over the left one.
    pub const RIGHT: Self = Self::Dashed(7);
    /// Of the published model.
    pub const PUBLISHED: Self = Self::Dashed(4);
}

impl Hue {
    /// The colour on such a background.
    pub fn colour(self, visuals: &Visuals) -> Color32 {
        match self {
            Self::Point(number) => theme::point_colour(number, visuals),
            Self::Eye(eye) => theme::eye_colour(eye, visuals),
            Self::Stereo => theme::stereo_colour(visuals),
            Self::Measured => theme::measured_colour(visuals),
        }
    }
}

impl Source {
    /// Its value at `time` as plotted, of the core itself.
    pub fn value(&self, time: f64) -> Option<f64> {
        curves::value(&self.key, self.model, self.curve, time)
    }
}

impl Chart<'_> {
    /// What its values are measured with in a plot of this height.
    pub fn ruler(&self, height: f32) -> Ruler {
        Ruler::of_values(self.quantity, self.unit, height)
    }

    /// Lowest and highest value, as plotted.
    pub fn value_range(&self) -> [f64; 2] {
        let values = self.traces.iter().flat_map(|trace| trace.pieces).flatten().map(|point| point.y);
        self.ruler(0.0).widened(value_range(self.quantity, values))
    }

    /// A value as plotted, in the chart's unit: of a logarithm the number that it is one of.
    pub fn shown(&self, plotted: f64) -> f64 {
        self.unit.shown(if self.quantity.is_logarithm() { math::powf(10.0, plotted) } else { plotted })
    }
}

/// What the plots of a tab show; nothing of those that do not plot against T.
pub(super) const fn quantities(tab: PlotTab) -> &'static [Quantity] {
    match tab {
        PlotTab::Disparity => &[Quantity::DeltaPhi, Quantity::DeltaTheta],
        PlotTab::Angles => &[Quantity::Phi, Quantity::Theta],
        PlotTab::Doppler => &[Quantity::LogDoppler],
        PlotTab::Stereo => &[Quantity::LogGain, Quantity::LogDistance],
        PlotTab::Fit | PlotTab::Accuracy => &[],
    }
}

/// The chart of `quantity`: of every point for a disparity, of each eye of the selected one else. `curves` are those of the
/// followed points, in order.
pub(super) fn chart<'a>(state: &State, curves: &'a [Curves], quantity: Quantity) -> Chart<'a> {
    let measures = state.measures();
    let along = state.settings.baseline().is_along_motion();
    let words = if along { "seen abreast" } else { "seen equally far" };
    Chart {
        quantity,
        unit: shown_in(quantity, measures.length),
        time_unit: measures.time,
        range: state.time_range(),
        traces: traces(state, curves, quantity),
        equidistant: state.equidistance_time(state.session.points.selected()).map(|time| (time, words)),
        now: state.session.time,
    }
}

fn traces<'a>(state: &State, curves: &'a [Curves], quantity: Quantity) -> Vec<Trace<'a>> {
    let selected = state.session.points.selected_index();
    let own = curves.get(selected);
    let of_eyes = |curve: fn(usize) -> Curve| -> Vec<Trace<'a>> {
        let Some(own) = own else { return Vec::new() };
        let all = models(own).flat_map(|model| Eye::BOTH.map(|eye| (eye, model)));
        all.map(|(eye, model)| {
            let dash = if eye == Eye::Left { Dash::Solid } else { Dash::RIGHT };
            let trace = of_model(eye.name(), Hue::Eye(eye), own, model, curve(eye.index()));
            if trace.dash == Dash::Solid { Trace { dash, ..trace } } else { trace }
        })
        .collect()
    };
    match quantity {
        Quantity::DeltaPhi => of_points(state, curves, Curve::DeltaPhi),
        Quantity::DeltaTheta => of_points(state, curves, Curve::DeltaTheta),
        Quantity::Phi => of_eyes(Curve::Phi),
        Quantity::Theta => of_eyes(Curve::Theta),
        Quantity::LogDoppler => of_eyes(Curve::LogDoppler),
        Quantity::LogGain => own.map_or(Vec::new(), |own| {
            models(own)
                .map(|model| of_model("Stereo gain", Hue::Stereo, own, model, Curve::LogGain))
                .collect()
        }),
        Quantity::LogDistance => own.map_or(Vec::new(), |own| distances(state, own)),
    }
}

/// The exact model where that is not what the views show, and then what they do.
fn models(curves: &Curves) -> impl Iterator<Item = Model> + use<> {
    let shown = curves.key().model;
    [Model::Exact].into_iter().filter(move |&exact| exact != shown).chain([shown])
}

/// What curves are called that are not the exact ones, and these beside them.
pub(super) const ONE_CONE: &str = "one light cone";
const TWO_CONES: &str = "two light cones (exact)";

/// A curve by the model of what the views show or, where that is another, the exact one beside it.
fn of_model<'a>(name: &str, hue: Hue, curves: &'a Curves, model: Model, curve: Curve) -> Trace<'a> {
    let key = *curves.key();
    let (name, dash) = match (key.model, model) {
        (Model::Exact, _) => (name.to_owned(), Dash::Solid),
        (_, Model::Exact) => (format!("{name}, {TWO_CONES}"), Dash::Dotted),
        (Model::Published(_), _) => (format!("{name}, published"), Dash::Solid),
        (Model::OneCone, _) => (format!("{name}, {ONE_CONE}"), Dash::Solid),
    };
    let shown = key.model == model;
    Trace {
        name,
        pieces: curves.pieces(curve, model),
        hue,
        dash,
        wide: shown,
        dot: shown,
        source: Source { key, model, curve },
    }
}

/// A disparity of every followed point: the selected one below the others, which are thinner, and the published model's
/// on top.
fn of_points<'a>(state: &State, curves: &'a [Curves], curve: Curve) -> Vec<Trace<'a>> {
    let points = &state.session.points;
    let mut all: Vec<_> = points.all().iter().zip(curves).enumerate().collect();
    all.sort_by_key(|(index, _)| *index != points.selected_index());
    let mut traces = Vec::new();
    for (index, (point, curves)) in all {
        let is_selected = index == points.selected_index();
        let (name, hue) = (state.name_of(point), Hue::Point(point.number));
        for model in models(curves) {
            let trace = of_model(&name, hue, curves, model, curve);
            traces.push(Trace { wide: trace.wide && is_selected, ..trace });
        }
        if curves.key().published && curves.key().model != PUBLISHED {
            traces.push(Trace {
                name: format!("{name}, published"),
                pieces: curves.pieces(curve, PUBLISHED),
                hue,
                dash: Dash::PUBLISHED,
                wide: is_selected,
                dot: true,
                source: Source { key: *curves.key(), model: PUBLISHED, curve },
            });
        }
    }
    traces
}

/// The name of a distance, short and long.
pub(super) const fn distance_words(kind: DistanceKind) -> [&'static str; 2] {
    match kind {
        DistanceKind::Stereo => ["two eyes", "Where two eyes take it to be"],
        DistanceKind::Seen(0) => ["left", "Where the left eye sees it"],
        DistanceKind::Seen(_) => ["right", "Where the right eye sees it"],
        DistanceKind::Measured => ["measured", "Where it is measured now"],
    }
}

/// How the line of a distance looks.
pub(super) const fn distance_look(kind: DistanceKind) -> (Hue, Dash, bool) {
    match kind {
        DistanceKind::Stereo => (Hue::Stereo, Dash::Solid, true),
        DistanceKind::Seen(eye) => (Hue::Eye(Eye::BOTH[eye]), Dash::Dashed(5), true),
        DistanceKind::Measured => (Hue::Measured, Dash::Solid, false),
    }
}

/// Those of the selected point: two eyes on top.
fn distances<'a>(state: &State, curves: &'a Curves) -> Vec<Trace<'a>> {
    let model = state.settings.model();
    let kinds = [DistanceKind::Measured, DistanceKind::Seen(1), DistanceKind::Seen(0), DistanceKind::Stereo];
    kinds
        .into_iter()
        .map(|kind| {
            let (hue, dash, wide) = distance_look(kind);
            let curve = Curve::LogDistance(kind);
            Trace {
                name: distance_words(kind)[1].to_owned(),
                pieces: curves.pieces(curve, model),
                hue,
                dash,
                wide,
                dot: true,
                source: Source { key: *curves.key(), model, curve },
            }
        })
        .collect()
}
