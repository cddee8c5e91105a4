//! Under the Accuracy tab's table: how far off spokes are after each round of a search along straight lines.

use eframe::egui::{Grid, RichText, Ui};

use super::table::cell;
use crate::accuracy::RoundsError;
use crate::app::views::examination::Examination;
use crate::app::widgets::named_text;
use crate::number_text;

const HEADS: [(&str, &str); 5] = [
    (
        "spokes",
        "A cheaper search for spokes than the one that draws: in each round, straight lines stand for the \
            spokes' curved paths.",
    ),
    ("ns", "Time per ray and body on this machine, one thread, nanoseconds."),
    (
        "along / radii",
        "From the exact entry, along the ray, in radii of the wheel: 99 % of the rays are nearer.",
    ),
    ("outlines / px", "How far the outlines of spokes are off: 99 % of the places are better."),
    ("missed", "Share of the rays that find no entry."),
];

/// Shows the errors of rounds, once the reference has found what is exact; nothing where nothing turns.
pub fn show(ui: &mut Ui, examination: &Examination) {
    let mut measured = examination.rows().filter_map(|row| row.measured());
    let Some(error) = measured.find_map(|figures| figures.rounds.as_ref()) else { return };
    ui.add_space(8.0);
    Grid::new("rounds").num_columns(HEADS.len()).spacing([14.0, 2.0]).show(ui, |ui| {
        for (head, tip) in HEADS {
            ui.label(RichText::new(head).weak()).on_hover_text(tip);
        }
        ui.end_row();
        rows(ui, error);
    });
}

fn rows(ui: &mut Ui, error: &RoundsError) {
    for after in &error.after {
        let name = if after.rounds == 1 { "1 round".to_owned() } else { format!("{} rounds", after.rounds) };
        ui.label(&name);
        let ns = (number_text::fixed(after.ray_ns, 0), String::new());
        let missed = (format!("{} %", number_text::fixed(100.0 * after.missed_share, 2)), String::new());
        let [along, outlines] = [after.along_radii, after.outlines_px].map(|spread| cell(spread, 0.0));
        for ((text, tip), (head, _)) in [ns, along, outlines, missed].into_iter().zip(&HEADS[1..]) {
            let label = named_text(ui, RichText::new(&text), format!("{name}, {head}: {text}"));
            if !tip.is_empty() {
                label.on_hover_text(tip);
            }
        }
        ui.end_row();
    }
    ui.label("exact");
    let ns = number_text::fixed(error.exact_ns, 0);
    named_text(ui, RichText::new(&ns), format!("exact, {}: {ns}", HEADS[1].0));
    ui.end_row();
}
