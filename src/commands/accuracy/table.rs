//! The report as text.

use std::fmt;

use gamow_platform::messages;

use super::report::{AccuracyReport, Circumstances, PictureErrors, RendererReport};
use crate::accuracy::{RESOLUTION_PX, Spread};

impl fmt::Display for AccuracyReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_setting(f)?;
        self.write_pictures(f)
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
        writeln!(f, "ms differ from run to run; errors are the same in every run")?;
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
        let mut compared = self.renderers.iter().filter(|renderer| !renderer.is_reference);
        compared.try_for_each(|renderer| doppler_by_speed(f, renderer))
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

/// The worst error of D at each speed; a renderer's views are in the order of speeds.
fn doppler_by_speed(f: &mut fmt::Formatter<'_>, renderer: &RendererReport) -> fmt::Result {
    write!(f, "{:36}", renderer.method)?;
    for rows in renderer.views.chunk_by(|a, b| a.view.gamma == b.view.gamma) {
        let errors = rows.iter().filter_map(|row| row.errors.doppler_relative);
        let worst = errors.map(|errors| errors.worst).fold(0.0, f64::max);
        let speed = view(&rows[0].view);
        let speed = speed.split(',').next().unwrap_or_default();
        write!(f, "  {speed}: {worst:.2e}")?;
    }
    writeln!(f)
}
