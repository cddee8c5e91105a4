//! Changes of a window's picture from one frame to the next.

use std::collections::HashSet;

use eframe::egui::epaint::ClippedShape;
use eframe::egui::{Pos2, Rect, Shape, TextureId};

/// Greatest number of shapes that are skipped to find one that stayed.
const REACH: usize = 12;
/// Two areas are one where that is larger by no more than this, square points: each costs something of its
/// own.
const SPARE: f32 = 4000.0;
/// Greatest number of areas.
const MOST: usize = 24;
/// Distance beyond their outlines to which shapes are painted, to be smooth, pixels.
const SMOOTH: f32 = 2.0;

/// The areas that hold all that is different where `new` shapes are painted in the place of `old` ones, or
/// the same with pictures that are drawn `anew`; inside of the `whole` window, bounded by whole pixels.
///
/// Shapes that are in both in the same order are the same in what they cover: a pixel changes only where one
/// of the others is.
pub fn areas(
    old: &[ClippedShape],
    new: &[ClippedShape],
    anew: &HashSet<TextureId>,
    whole: Rect,
    pixels_per_point: f32,
) -> Vec<Rect> {
    let is_same = |old: &ClippedShape, new: &ClippedShape| old == new && !shows_any(&new.shape, anew);
    let mut areas = Vec::new();
    let mut add = |shape: &ClippedShape| {
        let area = pixels(extent(shape, pixels_per_point), pixels_per_point).intersect(whole);
        if area.is_positive() {
            join(&mut areas, area);
        }
    };
    let (mut i, mut j) = (0, 0);
    while i < old.len() && j < new.len() {
        if is_same(&old[i], &new[j]) {
            (i, j) = (i + 1, j + 1);
            continue;
        }
        let (a, b) = next_same(&old[i..], &new[j..], is_same);
        old[i..i + a].iter().chain(&new[j..j + b]).for_each(&mut add);
        (i, j) = (i + a, j + b);
    }
    old[i..].iter().chain(&new[j..]).for_each(&mut add);
    areas
}

/// Returns the area of the window that a shape can change, points, with its smooth edge.
pub fn extent(shape: &ClippedShape, pixels_per_point: f32) -> Rect {
    let outline = shape.shape.visual_bounding_rect();
    if outline.is_negative() {
        return Rect::NOTHING;
    }
    let outline = shape.transform_after_tessellation * outline;
    // What has no place may be anywhere.
    let outline = if outline.is_finite() { outline } else { Rect::EVERYTHING };
    outline.expand(SMOOTH / pixels_per_point).intersect(shape.clip_rect)
}

/// Returns the numbers of `old` and of `new` items before the next that is in both; at least one, and no more
/// than there are.
fn next_same<T>(old: &[T], new: &[T], is_same: impl Fn(&T, &T) -> bool) -> (usize, usize) {
    for sum in 1..=REACH {
        for a in 0..=sum {
            let b = sum - a;
            if let (Some(old), Some(new)) = (old.get(a), new.get(b))
                && is_same(old, new)
            {
                return (a, b);
            }
        }
    }
    (1, 1)
}

/// Whether the shape shows one of these pictures.
fn shows_any(shape: &Shape, pictures: &HashSet<TextureId>) -> bool {
    match shape {
        Shape::Vec(shapes) => shapes.iter().any(|shape| shows_any(shape, pictures)),
        _ => pictures.contains(&shape.texture_id()),
    }
}

/// The pixels that it touches.
fn pixels(area: Rect, pixels_per_point: f32) -> Rect {
    let of = |pos: Pos2, round: fn(f32) -> f32| {
        Pos2::new(round(pos.x * pixels_per_point), round(pos.y * pixels_per_point)) / pixels_per_point
    };
    Rect::from_min_max(of(area.min, f32::floor), of(area.max, f32::ceil))
}

/// Adds `area`, as one with those that are near it.
fn join(areas: &mut Vec<Rect>, mut area: Rect) {
    let growth = |one: Rect, other: Rect| one.union(other).area() - one.area() - other.area();
    while let Some(near) = areas.iter().position(|other| growth(*other, area) <= SPARE) {
        area = area.union(areas.swap_remove(near));
    }
    areas.push(area);
    if areas.len() > MOST {
        let last = areas.len() - 1;
        let nearest = (0..last).min_by(|&a, &b| growth(areas[a], area).total_cmp(&growth(areas[b], area)));
        if let Some(nearest) = nearest {
            areas.pop();
            let other = areas.swap_remove(nearest);
            join(areas, area.union(other));
        }
    }
}
