//! The traces of a quantity: which curves are plotted of it.

use relativity_core::Model;

use super::axes::shown_in;
use super::chart::{Chart, Dash, Hue, Source, Trace};
use super::pins;
use crate::app::plots::curves::{Curve, Curves, CurvesKey, DistanceKind, PUBLISHED, Quantity};
use crate::app::state::State;
use crate::app::state::points::Point;
use crate::app::views::eye::Eye;

/// The chart of `quantity`: of every point for a disparity, of each eye of the selected one else; and of what is pinned.
/// `curves` are those that [`State::plotted_keys`] asks for; it is drawn about so high (points).
pub(super) fn chart<'a>(state: &State, curves: &'a [Curves], quantity: Quantity, height: f32) -> Chart<'a> {
    let measures = state.measures();
    let along = state.document.settings.baseline().is_along_motion();
    let words = if along { "seen abreast" } else { "seen equally far" };
    Chart {
        quantity,
        unit: shown_in(quantity, measures.length),
        time_unit: measures.time,
        clock: state.clock(),
        range: state.plotted_times(quantity),
        zoomed: state.scratch.plotting.zoom(quantity).map(|zoom| zoom.values),
        traces: traces(state, curves, quantity),
        equidistant: state.equidistance_time(state.document.points.selected()).map(|time| (time, words)),
        now: state.document.time,
        cursors: state.scratch.plotting.cursors().to_vec(),
        rounding: rounding(&state.curve_key(state.document.points.selected()), quantity),
        height,
    }
}

/// Returns the rounding error of a `quantity` that is 0, as plotted: for a difference in direction a part of what the separation of the
/// eyes spans at the point.
fn rounding(key: &CurvesKey, quantity: Quantity) -> f64 {
    const SHARE: f64 = 1e-14;
    let distance = key.point.rest.length();
    let separation = key.baseline.separation;
    match quantity {
        _ if quantity.is_disparity() && separation > 0.0 => SHARE * separation / distance.max(separation),
        Quantity::Phi | Quantity::Theta => SHARE,
        _ => 0.0,
    }
}

/// Returns the traces of `quantity`, the ones on top last.
fn traces<'a>(state: &State, curves: &'a [Curves], quantity: Quantity) -> Vec<Trace<'a>> {
    let found = |key: CurvesKey| curves.iter().find(|curves| *curves.key() == key);
    let own = |point: &Point| found(state.plotted_key(point, quantity));
    let selected = own(state.document.points.selected());
    let of_selected = |traces: fn(&'a Curves) -> Vec<Trace<'a>>| selected.map_or(Vec::new(), traces);
    let present = match quantity {
        Quantity::DeltaPhi => of_points(state, own, Curve::DeltaPhi),
        Quantity::DeltaTheta => of_points(state, own, Curve::DeltaTheta),
        Quantity::DeltaU => {
            let resting = of_selected(|own| resting(own).into_iter().collect());
            of_points(state, own, Curve::DeltaU).into_iter().chain(resting).collect()
        }
        Quantity::DeltaV => of_points(state, own, Curve::DeltaV),
        Quantity::Phi => of_selected(|own| of_eyes(own, Curve::Phi)),
        Quantity::Theta => of_selected(|own| of_eyes(own, Curve::Theta)),
        Quantity::LogDoppler => of_selected(|own| of_eyes(own, Curve::LogDoppler)),
        Quantity::LogGain => of_selected(|own| {
            let of = |model| of_model("two eyes", Hue::Stereo, own, model, Curve::LogGain);
            models(own).map(of).collect()
        }),
        Quantity::LogDistance => of_selected(distances),
    };
    let pinned = state.scratch.plotting.pins().iter().zip(pins::names(state)).zip(Dash::PINNED);
    let pinned = pinned.filter_map(|((pin, name), dash)| {
        Some(of_pin(found(state.pinned_key(pin, quantity))?, &name, pin.point.number, dash, quantity))
    });
    pinned.flatten().chain(present).collect()
}

/// The disparity of the point at rest, for eyes as far apart as the moving one shows them; none where motion is no slide.
fn resting(own: &Curves) -> Option<Trace<'_>> {
    let (curve, model) = (Curve::RestingU, Model::Exact);
    let pieces = own.pieces(curve, model);
    (!pieces.is_empty()).then(|| Trace {
        name: "at rest, eyes γd apart".to_owned(),
        pieces,
        hue: Hue::Measured,
        dash: Dash::RIGHT,
        wide: false,
        pale: false,
        dot: false,
        source: Source { key: own.key().clone(), model, curve },
    })
}

/// A quantity that each eye has: the right one's dashes let the left one's line be seen where they coincide.
fn of_eyes(own: &Curves, curve: fn(usize) -> Curve) -> Vec<Trace<'_>> {
    let traces = models(own).flat_map(|model| {
        Eye::BOTH.map(|eye| {
            let trace = of_model(eye.name(), Hue::Eye(eye), own, model, curve(eye.index()));
            let is_over = eye == Eye::Right && trace.dash == Dash::Solid;
            if is_over { Trace { dash: Dash::RIGHT, ..trace } } else { trace }
        })
    });
    traces.collect()
}

/// Returns the traces of `quantity` in a pin of this `name`: of the distances that at which two eyes take the point to be.
fn of_pin<'a>(
    curves: &'a Curves,
    name: &str,
    number: usize,
    dash: Dash,
    quantity: Quantity,
) -> Vec<Trace<'a>> {
    let trace = |name: &str, hue: Hue, curve: Curve| Trace {
        name: name.to_owned(),
        dash,
        pale: true,
        wide: true,
        dot: false,
        ..of_model(name, hue, curves, curves.key().model, curve)
    };
    let of_eyes = |curve: fn(usize) -> Curve| {
        let of = |eye: Eye| {
            let name = format!("{}, {name}", eye.name());
            trace(&name, Hue::Eye(eye), curve(eye.index()))
        };
        Eye::BOTH.map(of).into()
    };
    match quantity {
        Quantity::DeltaPhi => vec![trace(name, Hue::Point(number), Curve::DeltaPhi)],
        Quantity::DeltaTheta => vec![trace(name, Hue::Point(number), Curve::DeltaTheta)],
        Quantity::DeltaU => vec![trace(name, Hue::Point(number), Curve::DeltaU)],
        Quantity::DeltaV => vec![trace(name, Hue::Point(number), Curve::DeltaV)],
        Quantity::Phi => of_eyes(Curve::Phi),
        Quantity::Theta => of_eyes(Curve::Theta),
        Quantity::LogDoppler => of_eyes(Curve::LogDoppler),
        Quantity::LogGain => vec![trace(&format!("two eyes, {name}"), Hue::Stereo, Curve::LogGain)],
        Quantity::LogDistance => {
            let kind = DistanceKind::Stereo;
            vec![trace(
                &format!("{}, {name}", distance_words(kind)[0]),
                Hue::Stereo,
                Curve::LogDistance(kind),
            )]
        }
    }
}

/// The exact model where that is not what the views show, and then what they do.
fn models(curves: &Curves) -> impl Iterator<Item = Model> + use<> {
    let shown = curves.key().model;
    [Model::Exact].into_iter().filter(move |&exact| exact != shown).chain([shown])
}

/// Names of curves that are not the exact ones, and of the exact ones beside them.
pub(super) const ONE_CONE: &str = "one light cone";
const TWO_CONES: &str = "two light cones (exact)";

/// A curve by the model of what the views show or, where that is another, the exact one beside it.
fn of_model<'a>(name: &str, hue: Hue, curves: &'a Curves, model: Model, curve: Curve) -> Trace<'a> {
    let key = curves.key();
    let (name, dash) = match (key.model, model) {
        (Model::Exact, _) => (name.to_owned(), Dash::Solid),
        (_, Model::Exact) => (format!("{name}, {TWO_CONES}"), Dash::Dotted),
        (_, Model::OneCone) => (format!("{name}, {ONE_CONE}"), Dash::Solid),
        (_, Model::Published(_)) => (format!("{name}, published"), Dash::Solid),
    };
    let shown = key.model == model;
    Trace {
        name,
        pieces: curves.pieces(curve, model),
        hue,
        dash,
        wide: shown,
        pale: false,
        dot: shown,
        source: Source { key: key.clone(), model, curve },
    }
}

/// A disparity of every followed point: the selected one below the others, which are thinner, and the published model's
/// on top.
fn of_points<'a>(
    state: &State,
    curves: impl Fn(&Point) -> Option<&'a Curves>,
    curve: Curve,
) -> Vec<Trace<'a>> {
    let points = &state.document.points;
    let mut all: Vec<_> = points.all().iter().enumerate().collect();
    all.sort_by_key(|(index, _)| *index != points.selected_index());
    let mut traces = Vec::new();
    for (index, point) in all {
        let Some(curves) = curves(point) else { continue };
        let is_selected = index == points.selected_index();
        let (name, hue) = (pins::name_beside(state, point), Hue::Point(point.number));
        for model in models(curves) {
            let trace = of_model(&name, hue, curves, model, curve);
            traces.push(Trace { wide: trace.wide && is_selected, ..trace });
        }
        if curves.key().published {
            traces.push(Trace {
                name: format!("{name}, published"),
                pieces: curves.pieces(curve, PUBLISHED),
                hue,
                dash: Dash::PUBLISHED,
                wide: is_selected,
                pale: false,
                dot: true,
                source: Source { key: curves.key().clone(), model: PUBLISHED, curve },
            });
        }
    }
    traces
}

/// The name of a distance, short and long.
pub(super) const fn distance_words(kind: DistanceKind) -> [&'static str; 2] {
    match kind {
        DistanceKind::Stereo => ["two eyes", "Where two eyes place it"],
        DistanceKind::Seen(0) => ["left", "Where the left eye sees it"],
        DistanceKind::Seen(_) => ["right", "Where the right eye sees it"],
        DistanceKind::Measured => ["measured", "Where it is measured now"],
    }
}

/// Returns the colour, the dashes and the width of a distance's line.
pub(super) const fn distance_look(kind: DistanceKind) -> (Hue, Dash, bool) {
    match kind {
        DistanceKind::Stereo => (Hue::Stereo, Dash::Solid, true),
        DistanceKind::Seen(0) => (Hue::Eye(Eye::Left), Dash::Solid, true),
        DistanceKind::Seen(_) => (Hue::Eye(Eye::Right), Dash::RIGHT, true),
        DistanceKind::Measured => (Hue::Measured, Dash::Solid, false),
    }
}

/// Returns the traces of the selected point: two eyes on top.
fn distances(curves: &Curves) -> Vec<Trace<'_>> {
    let model = curves.key().model;
    let kinds = [DistanceKind::Measured, DistanceKind::Seen(0), DistanceKind::Seen(1), DistanceKind::Stereo];
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
                pale: false,
                dot: true,
                source: Source { key: curves.key().clone(), model, curve },
            }
        })
        .collect()
}
