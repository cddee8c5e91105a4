//! The report as text.

use std::fmt;

use gamow_platform::messages;

use super::report::{AccuracyReport, Circumstances, FormulaRow, PictureErrors, PictureRow, RendererReport};
use crate::accuracy::{RESOLUTION_PX, Spread};

impl fmt::Display for AccuracyReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_setting(f)?;
        self.write_pictures(f)?;
        self.write_formulas(f)?;
        self.write_published(f)?;
        self.write_effects(f)?;
        writeln!(f, "\nAdvice, from the figures above")?;
        self.advice.iter().try_for_each(|sentence| writeln!(f, "- {sentence}"))
    }
}

impl AccuracyReport {
    fn write_setting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let setting = &self.setting;
        let [width, height] = setting.size_px;
        writeln!(
            f,
            "{}: {}, {} bodies, {width}x{height} per eye, {} degrees wide",
            setting.program,
            messages::shown(&setting.scene),
            setting.bodies,
            setting.fov_degrees
        )?;
        let device = setting.device.as_deref().unwrap_or("none");
        let build = if setting.optimised { "" } else { "; NOT AN OPTIMISED BUILD" };
        writeln!(f, "graphics: {device}; CPU threads: {}{build}", setting.threads)?;
        writeln!(
            f,
            "ms, ns and their ratios, and advice that rests on them, differ from run to run; errors are the same in every run"
        )?;
        self.missing.iter().try_for_each(|missing| writeln!(f, "not measured: {missing}"))
    }

    fn write_pictures(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "\nPictures: ms per eye; median, 99 % and worst error of the worst view")?;
        writeln!(f, "{:36}{PICTURE_HEADER}", "")?;
        for renderer in &self.renderers {
            writeln!(
                f,
                "{:36}{}",
                renderer.method,
                picture(renderer, renderer.frame_ms, &renderer.worst_view)
            )?;
        }
        for renderer in self.renderers.iter().filter(|renderer| !renderer.is_reference) {
            writeln!(f, "\n{:36}{PICTURE_HEADER}", renderer.method)?;
            for row in &renderer.views {
                writeln!(f, "{:36}{}", view(&row.view), picture(renderer, row.frame_ms, &row.errors))?;
            }
        }
        writeln!(f, "\nWorst error of D by speed, relative, over all three places")?;
        let worst = |row: &PictureRow| (row.view, row.errors.doppler_relative);
        self.renderers.iter().filter(|renderer| !renderer.is_reference).try_for_each(|renderer| {
            by_speed(f, &renderer.method, &renderer.views.iter().map(worst).collect::<Vec<_>>())
        })
    }

    fn write_formulas(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "\nPoints: ns per point, one thread; median, 99 % and worst error of the worst view, against stable f64; f32 up to gamma = 1000"
        )?;
        writeln!(
            f,
            "{:36}{:>9}  {:^30}  {:^30}",
            "", "ns/point", "line of sight, arcseconds", "D, relative"
        )?;
        for formula in &self.formulas {
            let errors = if formula.is_reference {
                "truth".to_owned()
            } else {
                format!(
                    "{}  {}",
                    spread(formula.line_of_sight_arcseconds, 0.0),
                    spread(formula.doppler_relative, 0.0)
                )
            };
            writeln!(f, "{:36}{:9.2}  {errors}", formula.formula, formula.point_ns)?;
        }
        writeln!(f, "\nWorst line of sight by speed, arcseconds, over all three places")?;
        let worst = |row: &FormulaRow| (row.view, row.line_of_sight_arcseconds);
        self.formulas.iter().filter(|formula| !formula.is_reference).try_for_each(|formula| {
            by_speed(f, &formula.formula, &formula.views.iter().map(worst).collect::<Vec<_>>())
        })
    }

    fn write_published(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let published = &self.published;
        writeln!(
            f,
            "\nPublished model against the exact one, right eye: median, 99 % and worst ({:.0} and {:.0} ns per point)",
            published.published_ns, published.exact_ns
        )?;
        writeln!(f, "{:36}{:^30}  {:^30}", "", "line of sight, arcseconds", "pixels")?;
        for row in &published.views {
            let sights = spread(row.line_of_sight_arcseconds, 0.0);
            writeln!(f, "{:36}{sights}  {}", view(&row.view), spread(row.pixels, 0.0))?;
        }
        Ok(())
    }

    fn write_effects(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let effects = &self.effects;
        writeln!(f, "\nWhat effects cost: {}, {}", effects.method, view(&effects.view))?;
        writeln!(f, "{:36}{:>9}", "", "ms/eye")?;
        writeln!(f, "{:36}{:9.2}", "everything on", effects.all_on_ms)?;
        let again = 100.0 * effects.repeatability;
        writeln!(f, "(timed twice, it differed by {again:.0} %; smaller differences are noise)")?;
        let row = |row: &super::report::EffectRow| {
            let name = format!("without {}", row.effect);
            writeln!(f, "{name:44}{:9.2} {:9.2} of that", row.frame_ms, row.ratio)
        };
        effects.without.iter().try_for_each(row)
    }
}

const PICTURE_HEADER: &str = "   ms/eye          outline, pixels             line of sight, arcseconds              D, relative              wrong body, %";

fn picture(renderer: &RendererReport, frame_ms: f64, errors: &PictureErrors) -> String {
    let sights = spread(errors.line_of_sight_arcseconds, 0.0);
    if renderer.is_reference {
        return format!("{frame_ms:9.2}  {:^30}  {sights}", "truth");
    }
    let off = errors.wrong_pixels_off_outlines;
    let off = if off == 0 { String::new() } else { format!(", {off} pixels off outlines") };
    format!(
        "{frame_ms:9.2}  {}  {sights}  {}  {:>10.3}{off}",
        spread(errors.outlines_px, RESOLUTION_PX),
        spread(errors.doppler_relative, 0.0),
        100.0 * errors.wrong_share
    )
}

fn view(view: &Circumstances) -> String {
    let Circumstances { beta, gamma, place } = view;
    // From here on beta says less than gamma.
    let speed = if *beta > 0.99991 { format!("gamma {gamma}") } else { format!("beta {beta}") };
    if *beta == 0.0 { "at rest".to_owned() } else { format!("{speed}, {}", place.name()) }
}

/// Median, 99 % and worst, each 10 wide; zeros are below the `resolution`.
fn spread(spread: Option<Spread>, resolution: f64) -> String {
    let number = |value: f64| match value {
        0.0 if resolution > 0.0 => format!("<{resolution:.5}"),
        value if value == 0.0 || (1e-4..1e5).contains(&value) => format!("{value:.4}"),
        value => format!("{value:.2e}"),
    };
    spread.map_or_else(
        || format!("{:^30}", "-"),
        |Spread { median, p99, worst, .. }| {
            format!("{:>9} {:>9} {:>10}", number(median), number(p99), number(worst))
        },
    )
}

/// The worst of the errors at each speed, of rows in the order of speeds.
fn by_speed(f: &mut fmt::Formatter<'_>, name: &str, rows: &[(Circumstances, Option<Spread>)]) -> fmt::Result {
    write!(f, "{name:36}")?;
    for rows in rows.chunk_by(|(a, _), (b, _)| a.gamma == b.gamma) {
        let worst = rows.iter().filter_map(|(_, errors)| Some((*errors)?.worst)).fold(0.0, f64::max);
        let speed = view(&rows[0].0);
        let speed = speed.split(',').next().unwrap_or_default();
        write!(f, "  {speed}: {worst:.2e}")?;
    }
    writeln!(f)
}
