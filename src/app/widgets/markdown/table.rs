//! Tables in Markdown.

use eframe::egui::vec2;
use pulldown_cmark::Alignment;

use super::blocks::InlineItem;
use super::lines::least_room;
use super::page::{Writer, translated};
use super::paragraph::{Paragraph, Side, lay_out};

impl Writer<'_, '_> {
    /// Adds a table, a row after the other.
    pub fn table(&mut self, alignments: &[Alignment], rows: &[Vec<Vec<InlineItem>>], left: f32) {
        let between = 1.4 * self.size();
        let columns = alignments.len();
        let ink = self.setting.ink.clone();
        let (mut natural, mut least) = (vec![0.0_f32; columns], vec![0.0_f32; columns]);
        for row in rows {
            for ((natural, least), cell) in natural.iter_mut().zip(&mut least).zip(row) {
                let line = lay_out(self.fonts, self.pixels, &ink, cell, (f32::INFINITY, Side::Left));
                *natural = natural.max(line.size.x.ceil() + 1.0);
                *least = least.max(least_room(self.fonts, &ink, cell).ceil() + 1.0);
            }
        }
        let room = self.room(left) - between * columns.saturating_sub(1) as f32;
        let widths = column_widths(&natural, &least, room.max(1.0));
        let whole = widths.iter().sum::<f32>() + between * columns.saturating_sub(1) as f32;
        for (index, row) in rows.iter().enumerate() {
            let mut x = 0.0;
            let mut whole_row = Paragraph {
                size: vec2(whole, 0.0),
                baseline: 0.0,
                shapes: Vec::new(),
                links: Vec::new(),
                text: String::new(),
            };
            let cells: Vec<Paragraph> = (0..columns)
                .map(|column| {
                    let side = match alignments[column] {
                        Alignment::Center => Side::Middle,
                        Alignment::Right => Side::Right,
                        Alignment::Left | Alignment::None => Side::Left,
                    };
                    let cell = row.get(column).map_or(&[][..], Vec::as_slice);
                    lay_out(self.fonts, self.pixels, &ink, cell, (widths[column], side))
                })
                .collect();
            let baseline = cells.iter().map(|cell| cell.baseline).fold(0.0, f32::max);
            for (cell, width) in cells.into_iter().zip(&widths) {
                let at = vec2(self.pixels.nearest(x), baseline - cell.baseline);
                whole_row.size.y = whole_row.size.y.max(at.y + cell.size.y);
                whole_row.shapes.extend(cell.shapes.into_iter().map(|shape| translated(shape, at)));
                whole_row.links.extend(cell.links.into_iter().map(|(rect, link)| (rect.translate(at), link)));
                if !whole_row.text.is_empty() {
                    whole_row.text.push_str(", ");
                }
                whole_row.text.push_str(&cell.text);
                x += width + between;
            }
            if index > 0 {
                self.rule(left, whole);
            }
            self.add(whole_row, left);
        }
    }
}

/// Widths of columns that want `natural` and need `least`, together no more than `room`.
fn column_widths(natural: &[f32], least: &[f32], room: f32) -> Vec<f32> {
    let spare = room - least.iter().sum::<f32>();
    if spare < 0.0 {
        return shared(natural, room);
    }
    let wanted: Vec<f32> =
        natural.iter().zip(least).map(|(natural, least)| (natural - least).max(0.0)).collect();
    shared(&wanted, spare).iter().zip(least).map(|(more, least)| least + more).collect()
}

/// Returns the widths of columns that need `natural` in this `room`: columns that need no more than an equal
/// part get their width, and the others share the rest.
fn shared(natural: &[f32], room: f32) -> Vec<f32> {
    let mut order: Vec<usize> = (0..natural.len()).collect();
    order.sort_by(|&one, &other| natural[one].total_cmp(&natural[other]));
    let mut widths = vec![0.0; natural.len()];
    let mut left = room;
    for (index, &column) in order.iter().enumerate() {
        widths[column] = natural[column].min(left / (natural.len() - index) as f32);
        left -= widths[column];
    }
    widths
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_share_what_room_there_is() {
        assert_eq!(column_widths(&[10.0, 90.0], &[5.0, 30.0], 200.0), [10.0, 90.0], "all they want");
        assert_eq!(column_widths(&[10.0, 90.0], &[5.0, 30.0], 60.0), [10.0, 50.0], "the small one has all");
        assert_eq!(column_widths(&[90.0, 90.0], &[60.0, 10.0], 80.0), [65.0, 15.0], "words stay whole");
        assert_eq!(column_widths(&[90.0, 90.0], &[60.0, 60.0], 80.0), [40.0, 40.0], "words are parted");
    }
}
