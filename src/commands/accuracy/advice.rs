//! Plain advice from the figures of a report: which method for which need.

use super::report::{AccuracyReport, PictureErrors, PictureRow, RendererReport};

/// Angles below this are lost on binocular vision, arcseconds: about the finest stereo acuity
/// (I. P. Howard and B. J. Rogers, *Seeing in Depth*, 2002).
const STEREO_ACUITY_ARCSECONDS: f64 = 10.0;

/// What a picture is for, and what it must not exceed then.
struct Need {
    purpose: &'static str,
    outlines_p99_px: f64,
    doppler_p99: f64,
    wrong_share: f64,
}

const NEEDS: [Need; 2] = [
    Need { purpose: "To look", outlines_p99_px: 0.5, doppler_p99: 1e-3, wrong_share: 0.01 },
    Need { purpose: "To measure in pictures", outlines_p99_px: 0.05, doppler_p99: 1e-5, wrong_share: 0.001 },
];

/// A sentence per need.
#[must_use]
pub fn advice(report: &AccuracyReport) -> Vec<String> {
    let mut advice: Vec<_> = NEEDS.iter().map(|need| for_pictures(need, &report.renderers)).collect();
    advice.extend(for_comparison(&report.renderers));
    advice.extend(on_bounds(&report.renderers));
    advice.push(for_points(report));
    advice.push(on_the_published_model(report));
    advice.push(on_effects(report));
    if !report.setting.optimised {
        advice.push("This build is not optimised: its costs, above all those of points, mean little.".into());
    }
    advice
}

impl Need {
    fn is_met_by(&self, errors: &PictureErrors) -> bool {
        let p99 = |spread: Option<crate::accuracy::Spread>| spread.map_or(0.0, |spread| spread.p99);
        p99(errors.outlines_px) <= self.outlines_p99_px
            && p99(errors.doppler_relative) <= self.doppler_p99
            && errors.wrong_share <= self.wrong_share
    }
}

/// The cheapest renderer that meets the need in every view, and what the cheaper ones fail at.
fn for_pictures(need: &Need, renderers: &[RendererReport]) -> String {
    let Need { purpose, outlines_p99_px, doppler_p99, wrong_share } = need;
    let mut by_cost: Vec<_> = renderers.iter().collect();
    by_cost.sort_by(|a, b| a.frame_ms.total_cmp(&b.frame_ms));
    let failures: Vec<_> = by_cost.iter().map_while(|renderer| first_failure(need, renderer)).collect();
    // The reference meets every need.
    let chosen = by_cost[failures.len().min(by_cost.len() - 1)];
    let worst_view = chosen.worst_view.outlines_px;
    let worst_view =
        worst_view.map_or_else(String::new, |spread| format!("; its worst view has {:.4} px", spread.p99));
    format!(
        "{purpose} (outlines {outlines_p99_px} px at 99 %, D {doppler_p99:.0e}, wrong bodies {} %): {}, {:.2} ms per eye{worst_view}.{}",
        100.0 * wrong_share,
        chosen.method,
        chosen.frame_ms,
        failures.concat()
    )
}

/// Where the renderer first fails to meet the need, in the order of speed.
fn first_failure(need: &Need, renderer: &RendererReport) -> Option<String> {
    let PictureRow { view, .. } = renderer.views.iter().find(|row| !need.is_met_by(&row.errors))?;
    let place = view.place.name();
    Some(format!(" {} is cheaper but fails from gamma = {:.4} on ({place}).", renderer.method, view.gamma))
}

/// Whether meshes keep their bounds.
fn on_bounds(renderers: &[RendererReport]) -> Option<String> {
    let meshes = || renderers.iter().filter_map(|renderer| Some((renderer, renderer.bound_px?)));
    let worst =
        |renderer: &RendererReport| renderer.worst_view.outlines_px.map_or(0.0, |spread| spread.worst);
    let broken = meshes().filter(|(renderer, bound_px)| worst(renderer) > *bound_px);
    let broken: Vec<_> =
        broken.map(|(renderer, _)| format!("{} ({:.2} px)", renderer.method, worst(renderer))).collect();
    meshes().next()?;
    Some(if broken.is_empty() {
        "Every mesh keeps its bound on outlines in every view.".to_owned()
    } else {
        format!("Not every mesh keeps its bound on outlines in every view: {}.", broken.join(", "))
    })
}

/// What certainty costs.
fn for_comparison(renderers: &[RendererReport]) -> Option<String> {
    let reference = renderers.iter().find(|renderer| renderer.is_reference)?;
    let cheapest = renderers.iter().min_by(|a, b| a.frame_ms.total_cmp(&b.frame_ms))?;
    if cheapest.is_reference {
        return Some("Without a graphics adapter all pictures are the reference's.".to_owned());
    }
    let worst = cheapest.worst_view.line_of_sight_arcseconds?.worst;
    Some(format!(
        "For figures beyond f32 (lines of sight better than {worst:.2} arcseconds): {}, at {:.1} times the cost of {}.",
        reference.method,
        reference.frame_ms / cheapest.frame_ms,
        cheapest.method
    ))
}

/// The cheapest formula that stays below what eyes resolve, and what the naive form would gain.
fn for_points(report: &AccuracyReport) -> String {
    let worst = |formula: &&super::report::FormulaReport| {
        formula.line_of_sight_arcseconds.map_or(0.0, |spread| spread.worst)
    };
    let mut good: Vec<_> =
        report.formulas.iter().filter(|formula| worst(formula) <= STEREO_ACUITY_ARCSECONDS).collect();
    good.sort_by(|a, b| a.point_ns.total_cmp(&b.point_ns));
    let best = good.first().map_or_else(
        || "no form holds them everywhere".to_owned(),
        |best| format!("{}, {:.2} ns per point, worst {:.1e}", best.formula, best.point_ns, worst(best)),
    );
    let failing =
        report.formulas.iter().filter(|formula| worst(formula) > STEREO_ACUITY_ARCSECONDS).map(|formula| {
            format!(
                "; {} ({:.2} ns) fails with up to {:.0}",
                formula.formula,
                formula.point_ns,
                worst(&formula)
            )
        });
    format!(
        "For many points, with errors below the {STEREO_ACUITY_ARCSECONDS} arcseconds that stereo vision resolves: {best}{}.",
        failing.collect::<String>()
    )
}

fn on_the_published_model(report: &AccuracyReport) -> String {
    let views = &report.published.views;
    let medians =
        || views.iter().filter_map(|row| Some((row.line_of_sight_arcseconds?.median, row.pixels?.median)));
    let largest = medians().fold((0.0_f64, 0.0_f64), |a, b| (a.0.max(b.0), a.1.max(b.1)));
    let verdict = if largest.0 > STEREO_ACUITY_ARCSECONDS {
        "use it to reproduce the paper and for nothing else"
    } else {
        "no eye would tell it from the exact one here"
    };
    format!(
        "The published model puts the right eye's view off by {:.0} arcseconds ({:.1} px) in the median of its worst view, at {:.1} times the cost of the exact one: {verdict}.",
        largest.0,
        largest.1,
        report.published.published_ns / report.published.exact_ns
    )
}

fn on_effects(report: &AccuracyReport) -> String {
    let effects = &report.effects;
    let of_light = effects.without.iter().filter(|row| row.same_geometry);
    let dearest = of_light.min_by(|a, b| a.ratio.total_cmp(&b.ratio));
    let share = |ratio: f64| 100.0 * (1.0 - ratio);
    let least = (3.0 * effects.repeatability).max(0.05);
    match (dearest, effects.without.last()) {
        (Some(dearest), Some(all)) if dearest.ratio < 1.0 - least => format!(
            "To save time, leave out first: {}, {:.0} % of the picture's time; all effects and the delay of light together are {:.0} %.",
            dearest.effect,
            share(dearest.ratio),
            share(all.ratio)
        ),
        _ => format!(
            "No effect of light was measured to cost more than {:.0} % of the picture's time: leave them on.",
            100.0 * least
        ),
    }
}
