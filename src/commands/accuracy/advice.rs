//! Plain advice from the figures of a report: which method for which need.

use super::report::{
    AccuracyReport, EffectsReport, FormulaReport, PictureErrors, PictureRow, PublishedReport, RendererReport,
};
use crate::accuracy::Spread;

/// Angles below this are lost on binocular vision, arcseconds: about the finest stereo acuity
/// (I. P. Howard and B. J. Rogers, *Seeing in Depth*, 2002).
const STEREO_ACUITY_ARCSECONDS: f64 = 10.0;

/// A use of pictures, and the errors that it permits.
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
    advice.push(for_points(&report.formulas));
    advice.push(on_the_published_model(&report.published));
    advice.push(on_effects(&report.effects));
    if !report.setting.optimised {
        advice.push("This build is not optimised: its costs, above all those of points, mean little.".into());
    }
    advice
}

impl Need {
    /// Returns the part of `errors` that exceeds the need, if there is one.
    fn excess(&self, errors: &PictureErrors) -> Option<String> {
        let p99 = |spread: Option<Spread>| spread.map_or(0.0, |spread| spread.p99);
        let (outlines_px, doppler) = (p99(errors.outlines_px), p99(errors.doppler_relative));
        if outlines_px > self.outlines_p99_px {
            Some(format!("outlines {outlines_px:.2} px"))
        } else if doppler > self.doppler_p99 {
            Some(format!("D {doppler:.0e}"))
        } else if errors.wrong_share > self.wrong_share {
            Some(format!("wrong bodies {:.2} %", 100.0 * errors.wrong_share))
        } else {
            None
        }
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
    let worst_view = worst_view
        .map_or_else(String::new, |spread| format!("; outlines {:.4} px in its worst view", spread.p99));
    format!(
        "{purpose} (outlines {outlines_p99_px} px at 99 %, D {doppler_p99:.0e}, wrong bodies {} %): {}, {:.2} ms per eye{worst_view}.{}",
        100.0 * wrong_share,
        chosen.method,
        chosen.frame_ms,
        failures.concat()
    )
}

/// Returns the first failure of the renderer to meet the need, in the order of speed.
fn first_failure(need: &Need, renderer: &RendererReport) -> Option<String> {
    let failure = |row: &PictureRow| Some((row.view, need.excess(&row.errors)?));
    let (view, excess) = renderer.views.iter().find_map(failure)?;
    let (method, place) = (&renderer.method, view.place.name());
    Some(format!(" {method} is cheaper but fails, first at gamma = {:.4} ({place}): {excess}.", view.gamma))
}

/// Returns the cost of certainty: the reference against the rays, which are as exact as f32 is.
fn for_comparison(renderers: &[RendererReport]) -> Option<String> {
    let reference = renderers.iter().find(|renderer| renderer.is_reference)?;
    let rays = renderers.iter().find(|renderer| renderer.is_rays())?;
    let worst = rays.worst_view.line_of_sight_arcseconds?.worst;
    Some(format!(
        "For lines of sight better than the {worst:.2} arcseconds of {}, which f32 limits: {}, at {:.1} times the cost.",
        rays.method,
        reference.method,
        reference.frame_ms / rays.frame_ms
    ))
}

/// The cheapest formula that stays below what eyes resolve, as far as it was measured, and which do not.
fn for_points(formulas: &[FormulaReport]) -> String {
    let worst =
        |formula: &&FormulaReport| formula.line_of_sight_arcseconds.map_or(0.0, |spread| spread.worst);
    let largest_gamma =
        |formula: &FormulaReport| formula.views.iter().map(|row| row.view.gamma.round()).fold(1.0, f64::max);
    let mut good: Vec<_> =
        formulas.iter().filter(|formula| worst(formula) <= STEREO_ACUITY_ARCSECONDS).collect();
    good.sort_by(|a, b| a.point_ns.total_cmp(&b.point_ns));
    let best = good.first().map_or_else(
        || "no form holds them everywhere".to_owned(),
        |best| {
            let gamma = largest_gamma(best);
            let (name, ns, worst) = (&best.formula, best.point_ns, worst(best));
            format!("{name}, {ns:.2} ns per point, worst {worst:.1e} up to gamma = {gamma}")
        },
    );
    let failing =
        formulas.iter().filter(|formula| worst(formula) > STEREO_ACUITY_ARCSECONDS).map(|formula| {
            let (name, ns, gamma) = (&formula.formula, formula.point_ns, largest_gamma(formula));
            format!("; {name} ({ns:.2} ns) is off by up to {:.0}, up to gamma = {gamma}", worst(&formula))
        });
    format!(
        "For many points, with errors below the {STEREO_ACUITY_ARCSECONDS} arcseconds that stereo vision resolves: {best}{}.",
        failing.collect::<String>()
    )
}

fn on_the_published_model(published: &PublishedReport) -> String {
    let views = &published.views;
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
        published.published_ns / published.exact_ns
    )
}

fn on_effects(effects: &EffectsReport) -> String {
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

#[cfg(test)]
mod tests {
    use super::super::report::{Circumstances, EffectRow, FormulaRow, PublishedRow};
    use super::*;
    use crate::accuracy::TrackedPlace;

    fn at(gamma: f64) -> Circumstances {
        Circumstances { beta: 0.0, gamma, place: TrackedPlace::Abreast }
    }

    const fn all(error: f64) -> Spread {
        Spread { median: error, p99: error, worst: error, count: 1 }
    }

    /// A renderer with the same errors in one view.
    fn renderer(method: &str, frame_ms: f64, outlines_px: f64, arcseconds: f64) -> RendererReport {
        let errors = PictureErrors {
            outlines_px: Some(all(outlines_px)),
            line_of_sight_arcseconds: Some(all(arcseconds)),
            doppler_relative: Some(all(1e-7)),
            wrong_share: 0.0,
            wrong_pixels_off_outlines: 0,
        };
        RendererReport {
            method: method.to_owned(),
            is_reference: false,
            frame_ms,
            worst_view: errors.clone(),
            views: vec![PictureRow { view: at(2.0), frame_ms, errors, rounds: None }],
        }
    }

    fn made_up() -> Vec<RendererReport> {
        let reference = RendererReport { is_reference: true, ..renderer("reference", 30.0, 0.0, 0.0) };
        vec![reference, renderer("rays", 10.0, 0.001, 0.07), renderer("coarse", 1.0, 1.5, 142.53)]
    }

    #[test]
    fn what_f32_limits_is_the_error_of_the_rays() {
        let sentence = for_comparison(&made_up()).expect("all were measured");
        assert_eq!(
            sentence,
            "For lines of sight better than the 0.07 arcseconds of rays, which f32 limits: reference, at 3.0 times the cost."
        );
        let reference = &made_up()[..1];
        assert_eq!(for_comparison(reference), None);
    }

    #[test]
    fn a_need_takes_the_cheapest_that_meets_it_and_says_what_the_cheaper_fail_at() {
        let sentence = for_pictures(&NEEDS[0], &made_up());
        assert_eq!(
            sentence,
            "To look (outlines 0.5 px at 99 %, D 1e-3, wrong bodies 1 %): rays, 10.00 ms per eye; outlines 0.0010 px in its \
             worst view. coarse is cheaper but fails, first at gamma = 2.0000 (abreast): outlines 1.50 px."
        );
        let mut coarse = made_up();
        coarse[1].views[0].errors.doppler_relative = Some(all(1e-4));
        let sentence = for_pictures(&NEEDS[1], &coarse);
        assert!(sentence.contains("0.1 %): reference, 30.00 ms per eye"), "{sentence}");
        assert!(sentence.contains("rays is cheaper but fails, first at gamma = 2.0000 (abreast): D 1e-4"));
    }

    /// A form is recommended only as far as it was measured.
    #[test]
    fn a_form_for_points_is_named_with_the_speeds_it_was_measured_at() {
        let formula = |name: &str, point_ns: f64, gamma: f64, arcseconds: f64| FormulaReport {
            formula: name.to_owned(),
            is_reference: false,
            point_ns,
            line_of_sight_arcseconds: Some(all(arcseconds)),
            doppler_relative: None,
            views: vec![FormulaRow {
                view: at(gamma),
                point_ns,
                line_of_sight_arcseconds: Some(all(arcseconds)),
                doppler_relative: None,
            }],
        };
        let formulas = [
            formula("quick", 0.5, 1e3, 0.04),
            formula("sound", 2.0, 1e7, 1e-9),
            formula("naive", 2.5, 1e7, 6900.0),
        ];
        assert_eq!(
            for_points(&formulas),
            "For many points, with errors below the 10 arcseconds that stereo vision resolves: quick, 0.50 ns per point, \
             worst 4.0e-2 up to gamma = 1000; naive (2.50 ns) is off by up to 6900, up to gamma = 10000000."
        );
    }

    #[test]
    fn the_published_model_is_judged_by_its_worst_view_against_what_eyes_resolve() {
        let published = |arcseconds: f64| {
            let row = |error: f64| PublishedRow {
                view: at(2.0),
                line_of_sight_arcseconds: Some(all(error)),
                pixels: Some(all(error / 450.0)),
            };
            PublishedReport { published_ns: 10.0, exact_ns: 5.0, views: vec![row(1.0), row(arcseconds)] }
        };
        let sentence = on_the_published_model(&published(4500.0));
        assert!(
            sentence.contains("4500 arcseconds (10.0 px)") && sentence.contains("2.0 times"),
            "{sentence}"
        );
        assert!(sentence.ends_with("use it to reproduce the paper and for nothing else."), "{sentence}");
        assert!(
            on_the_published_model(&published(9.0))
                .ends_with("no eye would tell it from the exact one here.")
        );
    }

    #[test]
    fn only_what_is_dearer_than_noise_is_advised_to_be_left_out() {
        let row = |effect, same_geometry, ratio| EffectRow { effect, same_geometry, frame_ms: 0.0, ratio };
        let report = |repeatability: f64| EffectsReport {
            method: "rays".to_owned(),
            view: at(2.0),
            all_on_ms: 1.0,
            repeatability,
            without: vec![
                row("sky", true, 0.8),
                row("delay of light", false, 0.7),
                row("all of these", false, 0.6),
            ],
        };
        assert_eq!(
            on_effects(&report(0.01)),
            "To save time, leave out first: sky, 20 % of the picture's time; all effects and the delay of light together are 40 %."
        );
        assert_eq!(
            on_effects(&report(0.1)),
            "No effect of light was measured to cost more than 30 % of the picture's time: leave them on."
        );
    }
}
