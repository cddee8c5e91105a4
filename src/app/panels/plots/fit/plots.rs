//! The samples, the fitted curve with its band, and what the fit leaves over.

use eframe::egui::{
    self, Align, Align2, Color32, Layout, Pos2, RichText, TextStyle, Ui, Vec2, Visuals, vec2,
};
use egui_plot::{
    FilledArea, Line, MarkerShape, Plot, PlotBounds, PlotPoint, PlotPoints, PlotTransform, PlotUi, Points,
    VLine,
};

use crate::app::commands::{FileCommand, PlaybackCommand};
use crate::app::panels::Commands;
use crate::app::panels::plots::axes::{
    Ruler, annotate, bounds, column_label, label_places, plot_over_time, time_at_pointer,
};
use crate::app::state::State;
use crate::app::state::fitting::{FitOutcome, FittedCurve, Fitting, reading};
use crate::app::widgets::theme;
use crate::quantity::Quantity;

/// Share of the height that the residuals take, with the numbers along T.
const RESIDUALS_SHARE: f32 = 0.44;
/// Room for the numbers of both plots: residuals have one digit more.
const Y_AXIS_WIDTH: f32 = 54.0;
const TITLE_HEIGHT: f32 = 20.0;
/// Half the width of a number along T, in heights of the writing.
const HALF_A_NUMBER: f32 = 0.4;
/// Heading of the lower plot of a curve.
const RESIDUALS: &str = "residuals / rad";
/// A plot less wide has no room for a caption.
const NARROWEST_WITH_CAPTION: f32 = 240.0;
/// An outdated picture is drawn this faintly.
const FAINT: f32 = 0.35;

/// Narrowest plot of use: where two do not fit the first is shown alone.
const NARROWEST: f32 = 125.0;

/// Shows the plots of the fitted curves side by side; nothing where there are no samples.
pub fn show(ui: &mut Ui, state: &State, fitting: &Fitting, commands: &mut Commands) {
    if fitting.shown().is_none_or(|outcome| outcome.data.iter().all(|data| data.is_empty())) {
        return;
    }
    let used = state.document.settings.fit.curves.used();
    let free = ui.available_size().max(vec2(20.0, 20.0));
    let room = ((free.x + theme::GAP) / (NARROWEST + theme::GAP)).max(1.0) as usize;
    let all = [Quantity::DeltaPhi, Quantity::DeltaTheta].into_iter().zip(used);
    let shown: Vec<_> = all.filter(|(_, used)| *used).take(room).collect();
    let count = shown.len() as f32;
    let width = (free.x - theme::GAP * (count - 1.0)) / count;
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = theme::GAP;
        for (quantity, _) in shown {
            ui.allocate_ui_with_layout(vec2(width, free.y), Layout::top_down(Align::Min), |ui| {
                ui.set_width(width);
                pair(ui, state, fitting, quantity, vec2(width, free.y), commands);
            });
        }
    });
}

/// The upper or the lower plot of a curve: its fit, or its residuals.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Half {
    /// The readings and the fit.
    Readings,
    /// The residuals of the fit.
    Residuals,
}

/// Shows a `half` of the first of the fitted curves in all the room there is; nothing where there are no
/// samples, or no residuals.
pub fn show_first(ui: &mut Ui, state: &State, fitting: &Fitting, half: Half, commands: &mut Commands) {
    let [uses_azimuth, _] = state.document.settings.fit.curves.used();
    let quantity = if uses_azimuth { Quantity::DeltaPhi } else { Quantity::DeltaTheta };
    let drawing = CurveDrawing::new(ui.visuals(), state, fitting, quantity);
    // The numbers along T are larger than the plot reckons with, and the last of them may reach beyond its
    // end.
    let number = TextStyle::Body.resolve(ui.style()).size;
    let size = (ui.available_size() - number * vec2(HALF_A_NUMBER, 0.5)).max(vec2(20.0, 20.0));
    let unit = column_label(quantity, &state.measures());
    let heading = match half {
        Half::Readings => &unit,
        Half::Residuals => RESIDUALS,
    };
    if drawing.has(half) {
        FitPlot { half, size, with_times: true, heading: Some(heading) }.show(ui, state, &drawing, commands);
    }
}

/// A curve and its residuals, in `size`.
fn pair(
    ui: &mut Ui,
    state: &State,
    fitting: &Fitting,
    quantity: Quantity,
    size: Vec2,
    commands: &mut Commands,
) {
    ui.spacing_mut().item_spacing.y = 2.0;
    let drawing = CurveDrawing::new(ui.visuals(), state, fitting, quantity);
    let height = (size.y - TITLE_HEIGHT - 4.0).max(20.0);
    let has_residuals = drawing.has(Half::Residuals);
    let residuals_height = if has_residuals { RESIDUALS_SHARE * height } else { 0.0 };
    let curve_height = height - residuals_height;
    let what = column_label(quantity, &state.measures());
    ui.horizontal(|ui| {
        ui.set_height(TITLE_HEIGHT);
        ui.add_space(Y_AXIS_WIDTH);
        let heading = Ruler::of_angles(curve_height).label(&what, &drawing.bounds(Half::Readings));
        ui.label(RichText::new(heading).strong());
        if size.x >= NARROWEST_WITH_CAPTION {
            ui.label(RichText::new("samples, fit, 95 % band").weak().small());
        }
    });
    let size_of = |height: f32| vec2(size.x, height);
    let (half, with_times) = (Half::Readings, !has_residuals);
    let curve = FitPlot { half, size: size_of(curve_height), with_times, heading: None };
    curve.show(ui, state, &drawing, commands);
    if has_residuals {
        let (half, heading) = (Half::Residuals, Some(RESIDUALS));
        let residuals = FitPlot { half, size: size_of(residuals_height), with_times: true, heading };
        residuals.show(ui, state, &drawing, commands);
    }
}

/// A plot of the readings or of the residuals.
struct FitPlot<'h> {
    half: Half,
    size: Vec2,
    /// Whether T is written along it.
    with_times: bool,
    /// Heading inside the plot, if the part has one.
    heading: Option<&'h str>,
}

impl FitPlot<'_> {
    fn show(&self, ui: &mut Ui, state: &State, drawing: &CurveDrawing<'_>, commands: &mut Commands) {
        let half = self.half;
        let symbol = drawing.quantity.row().symbol;
        let name = match half {
            Half::Readings => format!("Fit of {symbol} against T"),
            Half::Residuals => format!("Residuals of {symbol} against T"),
        };
        let now = VLine::new("T", state.document.time).color(theme::now_colour(ui.visuals())).width(1.0);
        let unit = state.measures().time;
        let plot: Plot<'_> = plot_over_time(ui, name.as_str(), unit, self.size)
            .show_axes([self.with_times, true])
            .y_axis_min_width(Y_AXIS_WIDTH);
        let ruler = Ruler::of_angles(self.size.y);
        let bounds = ruler.widened_bounds(Ruler::of_time(unit, self.size.x), &drawing.bounds(half));
        let response = ruler.beside(plot).show(ui, move |plot| {
            plot.set_plot_bounds(bounds);
            plot.vline(now.allow_hover(false));
            drawing.draw(half, plot);
        });
        let mut labels = label_places(&response, state.document.time);
        for point in drawing.points(half) {
            labels.avoid([response.transform.position_from_point(point)], 1.0);
        }
        if let Some(heading) = self.heading {
            let (small, weak) = (TextStyle::Small.resolve(ui.style()), ui.visuals().weak_text_color());
            let place = response.transform.frame().left_top() + vec2(5.0, 2.0);
            let text = ruler.label(heading, &bounds);
            labels.keep_free(ui.painter().text(place, Align2::LEFT_TOP, text, small, weak));
        }
        annotate(ui, &response, (state.clock(), unit), None, &mut labels);
        let info = || egui::WidgetInfo::labeled(egui::accesskit::Role::GraphicsObject, true, &name);
        response.response.widget_info(info);
        let clicked = response.response.interact_pointer_pos().filter(|_| response.response.clicked());
        let sample = clicked.and_then(|place| drawing.sample_at(half, &response.transform, place));
        if let Some(sample) = sample {
            commands.push(FileCommand::LeaveOut { sample, curve: drawing.curve }.into());
        } else if let Some(time) = time_at_pointer(&response) {
            commands.push(PlaybackCommand::GoTo(time).into());
        }
    }
}

/// A click so near to a reading, in points, is on it.
const ON_A_READING: f32 = 8.0;

/// The drawing of one curve.
struct CurveDrawing<'a> {
    outcome: Option<&'a FitOutcome>,
    quantity: Quantity,
    /// 0 for Delta-phi, 1 for Delta-theta.
    curve: usize,
    range: [f64; 2],
    data: &'a [PlotPoint],
    fitted: Option<&'a FittedCurve>,
    data_colour: Color32,
    fit_colour: Color32,
    band_colour: Color32,
    outlier_colour: Color32,
}

impl<'a> CurveDrawing<'a> {
    fn new(visuals: &Visuals, state: &State, fitting: &'a Fitting, quantity: Quantity) -> Self {
        let curve = usize::from(quantity == Quantity::DeltaTheta);
        let outcome = fitting.shown();
        let fitted = outcome.and_then(|outcome| outcome.fitted.as_ref().ok()?.curves[curve].as_ref());
        let faintness = if fitting.is_outdated() { FAINT } else { 1.0 };
        let colour = theme::point_colour(state.document.points.selected().number, visuals);
        Self {
            outcome,
            quantity,
            curve,
            range: outcome.map_or([0.0, 1.0], |outcome| outcome.range),
            data: outcome.map_or(&[], |outcome: &FitOutcome| &outcome.data[curve]),
            fitted,
            data_colour: visuals.weak_text_color().gamma_multiply(faintness),
            fit_colour: colour.gamma_multiply(faintness),
            band_colour: colour.gamma_multiply(0.35 * faintness),
            outlier_colour: visuals.error_fg_color.gamma_multiply(faintness),
        }
    }

    /// Whether there is anything to show in a half.
    fn has(&self, half: Half) -> bool {
        match half {
            Half::Readings => {
                self.outcome.is_some_and(|outcome| !outcome.data.iter().all(|data| data.is_empty()))
            }
            Half::Residuals => self.fitted.is_some(),
        }
    }

    fn bounds(&self, half: Half) -> PlotBounds {
        match half {
            Half::Readings => {
                let line = self.fitted.iter().flat_map(|fitted| fitted.line.iter());
                let shown = self.data.iter().chain(line).map(|point| point.y);
                bounds(shown.chain(self.left_out_places(half).map(|(_, place)| place.y)), self.range)
            }
            Half::Residuals => {
                let residuals = self.fitted.iter().flat_map(|fitted| fitted.residuals.iter());
                let band = self.fitted.iter().flat_map(|fitted| &fitted.band).flatten();
                // Zero is in the middle, whichever side has the largest residual.
                let values = residuals.map(|point| point.y).chain(band.copied());
                let largest = values.fold(0.0f64, |a, b| a.max(b.abs()));
                bounds([-largest, largest].into_iter(), self.range)
            }
        }
    }

    /// Returns the dots of a half.
    fn points(&self, half: Half) -> &[PlotPoint] {
        match half {
            Half::Readings => self.data,
            Half::Residuals => self.fitted.map_or(&[], |fitted| &fitted.residuals),
        }
    }

    /// Draws a half; residuals only where there is a fit.
    fn draw<'p>(&'p self, half: Half, plot: &mut PlotUi<'p>) {
        let (name, middle): (_, fn(&PlotPoint) -> f64) = match half {
            Half::Readings => ("sample", |point| point.y),
            Half::Residuals => ("sample − fit", |_| 0.0),
        };
        self.band(plot, middle);
        plot.points(
            Points::new(name, self.points(half)).color(self.data_colour).radius(1.3).allow_hover(false),
        );
        self.outliers(plot, half as usize);
        self.left_out(plot, half);
        let Some(fitted) = self.fitted else { return };
        let line = match half {
            Half::Readings => Line::new("fit", &*fitted.line).allow_band(false).width(1.6),
            Half::Residuals => Line::new("0", self.range.map(|time| [time, 0.0]).to_vec()).width(1.2),
        };
        plot.line(line.color(self.fit_colour).allow_hover(false));
    }

    /// The band around `middle` of the line.
    fn band(&self, plot: &mut PlotUi<'_>, middle: impl Fn(&PlotPoint) -> f64) {
        let Some(fitted) = self.fitted.filter(|fitted| !fitted.band.is_empty()) else { return };
        let edge = |end: usize| -> Vec<f64> {
            fitted.line.iter().zip(&fitted.band).map(|(point, band)| middle(point) + band[end]).collect()
        };
        let times: Vec<f64> = fitted.line.iter().map(|point| point.x).collect();
        let area = FilledArea::new("95 % band", &times, &edge(0), &edge(1));
        plot.add(area.fill_color(self.band_colour).allow_hover(false));
    }

    /// Crosses at samples that stand out, or at what is left of them.
    fn outliers<'p>(&'p self, plot: &mut PlotUi<'p>, half: usize) {
        let Some(fitted) = self.fitted.filter(|fitted| !fitted.outliers[half].is_empty()) else { return };
        let crosses =
            Points::new("stands out", &*fitted.outliers[half]).shape(MarkerShape::Cross).radius(4.5);
        plot.points(crosses.color(self.outlier_colour).allow_hover(false));
    }

    /// Circles at readings that are left out.
    fn left_out(&self, plot: &mut PlotUi<'_>, half: Half) {
        let places: Vec<PlotPoint> = self.left_out_places(half).map(|(_, place)| place).collect();
        if !places.is_empty() {
            let circles = Points::new("left out", PlotPoints::Owned(places)).radius(4.0).filled(false);
            plot.points(circles.color(self.data_colour).allow_hover(false));
        }
    }

    /// The samples whose readings are left out, with their places.
    fn left_out_places(&self, half: Half) -> impl Iterator<Item = (usize, PlotPoint)> {
        let file = self.outcome.and_then(|outcome| outcome.key.file());
        let of_curve =
            file.into_iter().flat_map(|file| &file.left_out).filter(|left| left.curve == self.curve);
        of_curve.filter_map(move |left| {
            Some((left.sample, self.place(half, left.sample, [left.time, left.value])?))
        })
    }

    /// The place of a reading of a sample; `None` among residuals where there is no fit.
    fn place(&self, half: Half, sample: usize, [time, value]: [f64; 2]) -> Option<PlotPoint> {
        let fitted =
            || (*self.outcome?.fitted.as_ref().ok()?.at_samples.get(sample)?)?.get(self.curve).copied();
        let base = if half == Half::Readings { 0.0 } else { fitted()? };
        Some(PlotPoint::new(time, value - base))
    }

    /// The sample of own data whose reading is at `pointer`, left out or not.
    fn sample_at(&self, half: Half, transform: &PlotTransform, pointer: Pos2) -> Option<usize> {
        let outcome = self.outcome.filter(|outcome| outcome.key.file().is_some())?;
        let taken = outcome.samples.iter().enumerate().filter_map(|(number, sample)| {
            Some((number, self.place(half, number, [sample.time, reading(sample, self.curve)?])?))
        });
        let distance = |place: &PlotPoint| transform.position_from_point(place).distance(pointer);
        let all = taken.chain(self.left_out_places(half)).map(|(number, place)| (number, distance(&place)));
        let nearest = all.min_by(|a, b| a.1.total_cmp(&b.1));
        nearest.filter(|(_, distance)| *distance < ON_A_READING).map(|(number, _)| number)
    }
}
