//! The traces of a quantity: which curves are plotted of it.

use relativity_core::Model;

use super::chart::{Hue, PINNED_DASHES, PUBLISHED_DASHES, RIGHT_DASHES, TimePlot, Trace, ValueSource};
use super::pins;
use crate::app::state::State;
use crate::app::state::plots::curves::{Curve, CurvesKey, PUBLISHED, QuantityCurves, SeenPoint, Whose};
use crate::app::state::points::Point;
use crate::eye::Eye;
use crate::plot::Dash;
use crate::quantity::{Dimension, Of, Quantity};

/// The chart of `quantity`: of every point for a disparity, of each eye of the selected one else; and of what
/// is pinned. `curves` are those that [`State::plotted_keys`] asks for; it is drawn about so high (points).
pub(super) fn chart<'a>(
    state: &State,
    curves: &'a [QuantityCurves],
    quantity: Quantity,
    height: f32,
) -> TimePlot<'a> {
    let measures = state.measures();
    let along = state.document.settings.baseline().is_along_motion();
    let words = if along { "seen abreast" } else { "seen equally far" };
    TimePlot {
        quantity,
        measures,
        unit: quantity.unit(&measures),
        time_unit: measures.time,
        clock: state.clock(),
        range: state.plotted_times(quantity),
        zoomed: state.scratch.plotting.zoom(quantity).map(|zoom| zoom.values),
        traces: traces(state, curves, quantity),
        equidistant: state.equidistance_time(state.document.points.selected()).map(|time| (time, words)),
        now: state.document.time,
        cursors: state.scratch.plotting.cursors.clone(),
        rounding: rounding(&state.seen_point(state.document.points.selected()), quantity),
        height,
    }
}

/// Returns the rounding error of a `quantity` that is 0, as plotted: for a difference in direction a part of
/// what the separation of the eyes spans at the point.
fn rounding(seen: &SeenPoint, quantity: Quantity) -> f64 {
    const SHARE: f64 = 1e-14;
    let distance = seen.point.rest.length();
    let separation = seen.baseline.separation;
    match quantity {
        _ if quantity.is_disparity() && separation > 0.0 => SHARE * separation / distance.max(separation),
        _ if quantity.row().dimension == Dimension::Angle => SHARE,
        _ => 0.0,
    }
}

/// Returns the traces of `quantity`, the ones on top last.
fn traces<'a>(state: &State, curves: &'a [QuantityCurves], quantity: Quantity) -> Vec<Trace<'a>> {
    let found = |key: CurvesKey| curves.iter().find(|curves| curves.key == key);
    let own = |point: &Point| found(state.plotted_key(point, quantity));
    let selected = own(state.document.points.selected());
    let present = if quantity.is_disparity() {
        let resting = selected.into_iter().filter_map(resting);
        of_points(state, own).into_iter().chain(resting).collect()
    } else {
        selected.map_or_else(Vec::new, of_selected)
    };
    let pinned = state.scratch.plotting.pins.iter().zip(pins::names(state)).zip(PINNED_DASHES);
    let pinned = pinned.filter_map(|((pin, name), dash)| {
        Some(of_pin(found(state.pinned_key(pin, quantity))?, &name, pin.point.number, dash))
    });
    pinned.flatten().chain(present).collect()
}

/// Returns the traces of a quantity of the selected point that is no disparity.
fn of_selected(own: &QuantityCurves) -> Vec<Trace<'_>> {
    match own.key.quantity {
        Quantity::Distance => distances(own),
        quantity if matches!(quantity.row().of, Of::Stereo(_)) => {
            models(own).map(|model| of_model("two eyes", Hue::Stereo, own, model, Whose::Both)).collect()
        }
        _ => of_eyes(own),
    }
}

/// The disparity of the point at rest, for eyes as far apart as the moving one shows them; none where motion
/// is no slide.
fn resting(own: &QuantityCurves) -> Option<Trace<'_>> {
    let is_there = !own.pieces(Whose::Resting, own.key.point.model).is_empty();
    is_there.then(|| Trace {
        name: "at rest, eyes γd apart".to_owned(),
        dash: RIGHT_DASHES,
        wide: false,
        dot: false,
        ..of_model("", Hue::Measured, own, own.key.point.model, Whose::Resting)
    })
}

/// A quantity that each eye has: the right one's dashes let the left one's line be seen where they coincide.
fn of_eyes(own: &QuantityCurves) -> Vec<Trace<'_>> {
    let traces = models(own).flat_map(|model| {
        Eye::BOTH.map(|eye| {
            let trace = of_model(eye.name(), Hue::Eye(eye), own, model, Whose::Eye(eye));
            let is_over = eye == Eye::Right && trace.dash == Dash::Solid;
            if is_over { Trace { dash: RIGHT_DASHES, ..trace } } else { trace }
        })
    });
    traces.collect()
}

/// Returns the traces in a pin of this `name`: of the distances that at which two eyes take the point to be.
fn of_pin<'a>(curves: &'a QuantityCurves, name: &str, number: usize, dash: Dash) -> Vec<Trace<'a>> {
    let quantity = curves.key.quantity;
    let trace = |(name, hue, whose): (String, Hue, Whose)| Trace {
        name: name.clone(),
        dash,
        pale: true,
        wide: true,
        dot: false,
        ..of_model(&name, hue, curves, curves.key.point.model, whose)
    };
    let kept = match Whose::of(quantity) {
        _ if quantity.is_disparity() => vec![(name.to_owned(), Hue::Point(number), Whose::Both)],
        [Whose::Both, ..] => {
            vec![(format!("{}, {name}", whose_words(Whose::Both)[0]), Hue::Stereo, Whose::Both)]
        }
        _ => Eye::BOTH.map(|eye| (format!("{}, {name}", eye.name()), Hue::Eye(eye), Whose::Eye(eye))).into(),
    };
    kept.into_iter().map(trace).collect()
}

/// The exact model where that is not what the views show, and then what they do.
fn models(curves: &QuantityCurves) -> impl Iterator<Item = Model> + use<> {
    let shown = curves.key.point.model;
    [Model::Exact].into_iter().filter(move |&exact| exact != shown).chain([shown])
}

/// Names of curves that are not the exact ones, and of the exact ones beside them.
pub(super) const ONE_CONE: &str = "one light cone";
const TWO_CONES: &str = "two light cones (exact)";

/// A curve by the model of what the views show or, where that is another, the exact one beside it.
fn of_model<'a>(name: &str, hue: Hue, curves: &'a QuantityCurves, model: Model, whose: Whose) -> Trace<'a> {
    let CurvesKey { point, quantity, .. } = &curves.key;
    let (name, dash) = match (point.model, model) {
        (Model::Exact, _) => (name.to_owned(), Dash::Solid),
        (_, Model::Exact) => (format!("{name}, {TWO_CONES}"), Dash::Dotted),
        (_, Model::OneCone) => (format!("{name}, {ONE_CONE}"), Dash::Solid),
        (_, Model::Published(_)) => (format!("{name}, published"), Dash::Solid),
    };
    let shown = point.model == model;
    Trace {
        name,
        pieces: curves.pieces(whose, model),
        hue,
        dash,
        wide: shown,
        pale: false,
        dot: shown,
        source: ValueSource { point: point.clone(), model, curve: Curve { quantity: *quantity, whose } },
    }
}

/// A disparity of every followed point: the selected one below the others, which are thinner, and the
/// published model's on top.
fn of_points<'a>(state: &State, curves: impl Fn(&Point) -> Option<&'a QuantityCurves>) -> Vec<Trace<'a>> {
    let points = &state.document.points;
    let mut all: Vec<_> = points.all().iter().enumerate().collect();
    all.sort_by_key(|(index, _)| *index != points.selected_index());
    let mut traces = Vec::new();
    for (index, point) in all {
        let Some(curves) = curves(point) else { continue };
        let is_selected = index == points.selected_index();
        let (name, hue) = (pins::name_beside(state, point), Hue::Point(point.number));
        for model in models(curves) {
            let trace = of_model(&name, hue, curves, model, Whose::Both);
            traces.push(Trace { wide: trace.wide && is_selected, ..trace });
        }
        if curves.key.published {
            traces.push(Trace {
                name: format!("{name}, published"),
                dash: PUBLISHED_DASHES,
                wide: is_selected,
                dot: true,
                ..of_model(&name, hue, curves, PUBLISHED, Whose::Both)
            });
        }
    }
    traces
}

/// The name of a distance by whose it is, short and long.
pub(super) const fn whose_words(whose: Whose) -> [&'static str; 2] {
    match whose {
        Whose::Both | Whose::Resting => ["two eyes", "Where two eyes place it"],
        Whose::Eye(Eye::Left) => ["left", "Where the left eye sees it"],
        Whose::Eye(Eye::Right) => ["right", "Where the right eye sees it"],
        Whose::Measured => ["measured", "Where it is measured now"],
    }
}

/// Returns the colour, the dashes and the width of a distance's line.
const fn distance_look(whose: Whose) -> (Hue, Dash, bool) {
    match whose {
        Whose::Both | Whose::Resting => (Hue::Stereo, Dash::Solid, true),
        Whose::Eye(Eye::Left) => (Hue::Eye(Eye::Left), Dash::Solid, true),
        Whose::Eye(Eye::Right) => (Hue::Eye(Eye::Right), RIGHT_DASHES, true),
        Whose::Measured => (Hue::Measured, Dash::Solid, false),
    }
}

/// Returns the traces of the selected point's distances: two eyes on top.
fn distances(curves: &QuantityCurves) -> Vec<Trace<'_>> {
    let all = [Whose::Measured, Whose::Eye(Eye::Left), Whose::Eye(Eye::Right), Whose::Both];
    all.into_iter()
        .map(|whose| {
            let (hue, dash, wide) = distance_look(whose);
            let name = whose_words(whose)[1].to_owned();
            Trace { name, dash, wide, dot: true, ..of_model("", hue, curves, curves.key.point.model, whose) }
        })
        .collect()
}
