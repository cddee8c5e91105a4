//! The paper's figures of curves and of the two-dimensional bicycle, each as SVG and CSV.

use std::path::Path;

use anyhow::Context as _;
use csv::ByteRecord;
use relativity_core::{Disparity, Model};

use super::bicycle;
use super::curves::{APPENDIX_A, Setup, title};
use crate::files::csv_out;
use crate::files::whole::write_whole;
use crate::plot::{BLACK, BLUE, Dash, Line, LineStroke, Panel, VERMILION, svg, svg_of_rows};

/// Observation times of the curves, which hold all their features; and how many.
const TIMES: [f64; 2] = [-2.0, 5.0];
const SAMPLES: usize = 701;
/// The paper's speeds, and the colours it gives them, but safe for colour-blind eyes.
const SPEEDS: [(f64, &str); 3] = [(0.9, BLACK), (0.7, VERMILION), (0.5, BLUE)];
/// Place at which the middle between the eyes sees the point whose two events are drawn.
const CONSTRUCTION_PLACE: f64 = -0.8;
/// Places where the crank of the two-dimensional bicycle is seen.
const PLACES: [f64; 3] = [-7.0, 0.0, 3.0];

/// A figure of the paper that is drawn as curves.
#[derive(Debug)]
pub struct CurveFigure {
    /// Number of the figure in the paper.
    pub number: u8,
    /// Name of the figure's files.
    pub name: &'static str,
    /// Caption of the figure.
    pub caption: &'static str,
}

/// The figures of curves and of the two-dimensional bicycle.
pub const CURVES: [CurveFigure; 10] = [
    figure(1, "construction", "One point, two eyes: the events that they receive at one time"),
    figure(2, "phi", "Azimuth seen by each eye, y = z = 0.5, d = 0.3, beta = 0.9"),
    figure(3, "phi-difference", "Delta-phi at beta = 0.9, 0.7, 0.5"),
    figure(4, "theta", "Elevation seen by each eye"),
    figure(5, "theta-difference", "Delta-theta at beta = 0.9, 0.7, 0.5"),
    figure(6, "bicycle-2d", "The two-dimensional bicycle"),
    figure(7, "bicycle-2d-one-eye", "As one eye sees it, beta = 0.9"),
    figure(8, "bicycle-2d-two-eyes", "As the left eye, the right eye, and both see it, beta = 0.9, d = 0.3"),
    figure(14, "fit-phi", "Delta-phi of the tracked point and its fit"),
    figure(15, "fit-theta", "Delta-theta of the tracked point and its fit"),
];

const fn figure(number: u8, name: &'static str, caption: &'static str) -> CurveFigure {
    CurveFigure { number, name, caption }
}

/// A column of a CSV file.
pub type Column = (String, Vec<f64>);

/// Writes `name`.svg and `name`.csv into `folder`.
pub fn write(folder: &Path, name: &str, panels: &[Panel], columns: &[Column]) -> anyhow::Result<()> {
    write_text(folder, &format!("{name}.svg"), &svg(panels))?;
    write_csv(folder, name, columns)
}

/// Writes `name`.csv into `folder`; all columns are equally long.
pub fn write_csv(folder: &Path, name: &str, columns: &[Column]) -> anyhow::Result<()> {
    write_whole(&folder.join(format!("{name}.csv")), |file| {
        let mut rows = csv_out::CsvWriter::new(file);
        let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
        rows.write(&mut ByteRecord::from(names), &[])?;
        for index in 0..columns.first().map_or(0, |(_, values)| values.len()) {
            let row: Vec<f64> = columns.iter().map(|(_, values)| values[index]).collect();
            rows.write(&mut ByteRecord::new(), &row)?;
        }
        Ok(rows.flush()?)
    })
}

/// Writes `text` as the file `name` in `folder`.
pub fn write_text(folder: &Path, name: &str, text: &str) -> anyhow::Result<()> {
    use std::io::Write as _;
    write_whole(&folder.join(name), |file| Ok(file.write_all(text.as_bytes())?))
        .with_context(|| format!("writing {name}"))
}

/// Every figure of this file.
pub fn write_all(folder: &Path) -> anyhow::Result<()> {
    write_construction(folder)?;
    write_angles(folder, "phi", "azimuth phi, rad", |seen| [seen.primary.phi(), seen.secondary.phi()])?;
    let elevations = |seen: &Disparity| [seen.primary.theta(), seen.secondary.theta()];
    write_angles(folder, "theta", "elevation theta, rad", elevations)?;
    write_differences(folder, "phi-difference", "delta-phi, rad", |seen| seen.dphi)?;
    write_differences(folder, "theta-difference", "delta-theta, rad", |seen| seen.dtheta)?;
    write_resting_bicycle(folder)?;
    write_bicycle_for_one_eye(folder)?;
    write_bicycle_for_two_eyes(folder)
}

/// Two eyes and the two events that they receive of one point at one time, in the plane that holds them all.
fn write_construction(folder: &Path) -> anyhow::Result<()> {
    let setup = Setup::SECTION_3;
    let time = setup.time_when_seen_at(CONSTRUCTION_PLACE)?;
    let seen = setup.seen(Model::Exact, time)?;
    let half = 0.5 * setup.separation;
    let eyes = [-half, half];
    let received = [&seen.primary, &seen.secondary];
    let distance = (setup.y * setup.y + setup.z * setup.z).sqrt();
    let events = [0, 1].map(|eye| [eyes[eye] + received[eye].position[0], distance]);
    let light = |eye: usize, name, colour| Line::solid(name, colour, vec![events[eye], [eyes[eye], 0.0]]);
    let lines = vec![
        Line::solid("path of the point", BLACK, vec![[-1.5, distance], [0.5, distance]])
            .with(LineStroke::Line(Dash::Dashed(7))),
        light(0, "light to the left eye", BLUE),
        light(1, "light to the right eye", VERMILION),
        Line::solid("emission events", BLACK, events.to_vec()).with(LineStroke::Dots),
        eye_dots(&eyes),
    ];
    let title = format!("y = z = 0.5, d = 0.3, beta = 0.9, T = {time:.2}");
    let labels = ["x", "distance from the line of the eyes"];
    let panel = Panel { equal_scales: true, width: 720.0, ..Panel::new(title, labels, lines) };
    let columns = [
        ("eye_x".to_owned(), eyes.to_vec()),
        ("event_x".to_owned(), events.map(|[x, _]| x).to_vec()),
        ("event_distance".to_owned(), vec![distance; 2]),
        ("event_t".to_owned(), received.map(|sighting| sighting.retarded_time).to_vec()),
        ("T".to_owned(), vec![time; 2]),
    ];
    write(folder, "construction", &[panel], &columns)
}

/// An angle of both eyes, in the published and in the exact model.
fn write_angles(
    folder: &Path,
    name: &str,
    label: &'static str,
    angles: impl Fn(&Disparity) -> [f64; 2],
) -> anyhow::Result<()> {
    let setup = Setup::SECTION_3;
    let mut panels = Vec::new();
    let mut columns = Vec::new();
    for model in [APPENDIX_A, Model::Exact] {
        let eyes = [(0, "left", BLUE, Dash::Solid), (1, "right", VERMILION, Dash::Dashed(7))];
        let mut lines = Vec::new();
        for (eye, eye_name, colour, dash) in eyes {
            let curve = setup.curve(model, TIMES, SAMPLES, |seen| angles(seen)[eye])?;
            push_column(&mut columns, &format!("{name}_{eye_name}_{}", model.name()), &curve);
            lines.push(Line::solid(format!("{eye_name} eye"), colour, curve).with(LineStroke::Line(dash)));
        }
        let marks = vec![(setup.equidistance_time()?, "T0".to_owned())];
        panels.push(Panel { marks, ..Panel::new(title(model), ["T", label], lines) });
    }
    write(folder, name, &panels, &columns)
}

/// A difference at the paper's three speeds, in the published and in the exact model.
fn write_differences(
    folder: &Path,
    name: &str,
    label: &'static str,
    difference: impl Fn(&Disparity) -> f64,
) -> anyhow::Result<()> {
    let mut panels = Vec::new();
    let mut columns = Vec::new();
    for model in [APPENDIX_A, Model::Exact] {
        let mut lines = Vec::new();
        for (beta, colour) in SPEEDS {
            let setup = Setup { beta, ..Setup::SECTION_3 };
            let curve = setup.curve(model, TIMES, SAMPLES, &difference)?;
            push_column(&mut columns, &format!("{name}_beta_{beta}_{}", model.name()), &curve);
            lines.push(Line::solid(format!("beta = {beta}"), colour, curve));
        }
        let marks = vec![(Setup::SECTION_3.equidistance_time()?, "T0".to_owned())];
        panels.push(Panel { marks, ..Panel::new(title(model), ["T", label], lines) });
    }
    write(folder, name, &panels, &columns)
}

/// Appends the values of `curve`, and first its times if there is no column yet.
fn push_column(columns: &mut Vec<Column>, name: &str, curve: &[[f64; 2]]) {
    if columns.is_empty() {
        columns.push(("T".to_owned(), curve.iter().map(|point| point[0]).collect()));
    }
    columns.push((name.to_owned(), curve.iter().map(|point| point[1]).collect()));
}

const BICYCLE_LABELS: [&str; 2] = ["x", "y"];

fn bicycle_panel(title: String, lines: Vec<Line>, width: f64) -> Panel {
    Panel { equal_scales: true, width, ..Panel::new(title, BICYCLE_LABELS, lines) }
}

fn eye_dots(places: &[f64]) -> Line {
    let dots = places.iter().map(|&x| [x, 0.0]).collect();
    Line::solid(if places.len() == 1 { "eye" } else { "eyes" }, BLACK, dots).with(LineStroke::Dots)
}

/// Columns x and y of the strokes' points, with the number of the stroke before them.
fn bicycle_columns(strokes: &[bicycle::Polyline]) -> Vec<Column> {
    let points =
        || strokes.iter().enumerate().flat_map(|(part, stroke)| stroke.iter().map(move |p| (part, p)));
    vec![
        ("part".to_owned(), points().map(|(part, _)| part as f64).collect()),
        ("rest_x".to_owned(), points().map(|(_, p)| p[0]).collect()),
        ("rest_y".to_owned(), points().map(|(_, p)| p[1]).collect()),
    ]
}

fn write_resting_bicycle(folder: &Path) -> anyhow::Result<()> {
    let strokes = bicycle::strokes();
    let columns = bicycle_columns(&strokes);
    let line = Line::in_pieces("at rest", BLACK, strokes);
    write(folder, "bicycle-2d", &[bicycle_panel("the bicycle".to_owned(), vec![line], 640.0)], &columns)
}

fn write_bicycle_for_one_eye(folder: &Path) -> anyhow::Result<()> {
    let setup = Setup { separation: 0.0, ..Setup::SECTION_3 };
    let strokes = bicycle::strokes();
    let mut columns = bicycle_columns(&strokes);
    let colours = [BLACK, VERMILION, BLUE];
    let mut lines = Vec::new();
    for (place, colour) in PLACES.into_iter().zip(colours) {
        let time = bicycle::time_when_seen_at(&setup, place)?;
        let seen = |&rest: &[f64; 2]| bicycle::seen_by_one(&setup, rest, time);
        let pieces = mapped(&strokes, seen)?;
        let xs = pieces.iter().flatten().map(|point| point[0]).collect();
        columns.push((format!("x_at_T_{time}"), xs));
        lines.push(Line::in_pieces(format!("T = {time:.2}"), colour, pieces));
    }
    lines.push(eye_dots(&[0.0]));
    let title = "beta = 0.9: approaching, abreast and receding".to_owned();
    write(folder, "bicycle-2d-one-eye", &[bicycle_panel(title, lines, 1200.0)], &columns)
}

/// Below each other what the left eye sees, the right one, and both; in each model.
fn write_bicycle_for_two_eyes(folder: &Path) -> anyhow::Result<()> {
    const EYES: [(&str, &str, &str); 2] = [("left", "left eye", BLUE), ("right", "right eye", VERMILION)];
    let setup = Setup::SECTION_3;
    let strokes = bicycle::strokes();
    let mut columns = bicycle_columns(&strokes);
    let mut rows = vec![Vec::new(), Vec::new(), Vec::new()];
    for model in [APPENDIX_A, Model::Exact] {
        let mut pieces = [Vec::new(), Vec::new()];
        let offsets = bicycle::measured_from(&setup, model);
        for place in PLACES {
            let time = bicycle::time_when_seen_at(&setup, place)?;
            for (eye, pieces) in pieces.iter_mut().enumerate() {
                let seen = |&rest: &[f64; 2]| Ok(bicycle::seen_by_two(&setup, model, rest, time)?[eye]);
                let seen = mapped(&strokes, seen)?;
                let xs = seen.iter().flatten().map(|point| point[0]).collect();
                columns.push((format!("x_{}_{}_at_T_{time}", EYES[eye].0, model.name()), xs));
                let moved =
                    |stroke: bicycle::Polyline| stroke.into_iter().map(|[x, y]| [x + offsets[eye], y]);
                pieces.extend(seen.into_iter().map(|stroke| moved(stroke).collect::<bicycle::Polyline>()));
            }
        }
        let xs = || pieces.iter().flatten().flatten().map(|point| point[0]);
        let shown_x = Some([xs().fold(f64::INFINITY, f64::min), xs().fold(f64::NEG_INFINITY, f64::max)]);
        let half = 0.5 * setup.separation;
        let line = |eye: usize| Line::in_pieces(EYES[eye].1, EYES[eye].2, pieces[eye].clone());
        let shown = [
            (EYES[0].1, vec![line(0), eye_dots(&[-half])]),
            (EYES[1].1, vec![line(1), eye_dots(&[half])]),
            ("both eyes", vec![line(0), line(1), eye_dots(&[-half, half])]),
        ];
        for (row, (name, lines)) in rows.iter_mut().zip(shown) {
            let title = format!("{name}, {}: beta = 0.9, d = 0.3", title(model));
            row.push(Panel { height: 260.0, shown_x, ..bicycle_panel(title, lines, 720.0) });
        }
    }
    let name = "bicycle-2d-two-eyes";
    write_text(folder, &format!("{name}.svg"), &svg_of_rows(&rows))?;
    write_csv(folder, name, &columns)
}

fn mapped(
    strokes: &[bicycle::Polyline],
    seen: impl Fn(&[f64; 2]) -> Result<[f64; 2], relativity_core::PairError>,
) -> Result<Vec<bicycle::Polyline>, relativity_core::PairError> {
    strokes.iter().map(|stroke| stroke.iter().map(&seen).collect()).collect()
}
