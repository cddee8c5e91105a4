//! Use of the pointer: hover labels appear while it moves and for a few seconds after, not where it rests
//! unused.

use eframe::egui::{Context, Event, Id, Pos2};

/// For how long after its last movement the pointer is in use, seconds.
const AFTER: f32 = 3.0;
/// Distance that the pointer may move before a label opened by a click closes, points.
const NEAR: f32 = 12.0;

/// Time of the last key, seconds, and where a click has opened what is under the pointer since then.
#[derive(Debug, Clone, Copy)]
struct LastInput {
    key: f64,
    opened: Option<Pos2>,
}

fn seen(ctx: &Context) -> LastInput {
    let id = Id::unique(("what the pointer was used for", ctx.viewport_id()));
    let before = ctx.data(|data| data.get_temp::<LastInput>(id));
    let mut seen = before.unwrap_or(LastInput { key: f64::NEG_INFINITY, opened: None });
    let is_key = |event: &Event| matches!(event, Event::Key { pressed: true, .. });
    let (time, has_key, clicked) = ctx.input(|input| {
        let clicked = input.pointer.primary_clicked().then(|| input.pointer.interact_pos()).flatten();
        (input.time, input.events.iter().any(is_key), clicked)
    });
    let here = ctx.pointer_hover_pos();
    let is_left = |at: &Pos2| here.is_none_or(|here| here.distance(*at) > NEAR);
    if has_key {
        seen = LastInput { key: time, opened: None };
    } else if clicked.is_some() || seen.opened.as_ref().is_some_and(is_left) {
        seen.opened = clicked;
    }
    ctx.data_mut(|data| data.insert_temp(id, seen));
    seen
}

/// Returns whether fewer than `seconds` have passed since the first call for `what`. Requests a repaint for
/// when they have.
#[must_use]
pub fn is_new(ctx: &Context, what: &'static str, seconds: f64) -> bool {
    let now = ctx.input(|input| input.time);
    let since = now - ctx.data_mut(|data| *data.get_temp_mut_or(Id::unique(what), now));
    let is_new = since < seconds;
    if is_new {
        ctx.request_repaint_after_secs((seconds - since) as f32 + 0.01);
    }
    is_new
}

/// Something that is shown in every frame of the window since a time.
#[derive(Debug, Clone, Copy)]
struct Shown {
    key: Id,
    since: f64,
    pass: u64,
}

/// Returns for how many seconds `what` is shown without a break, with the same `key` all the time.
#[must_use]
pub fn shown_for(ctx: &Context, what: &'static str, key: impl std::hash::Hash + std::fmt::Debug) -> f64 {
    // Two panes show it in one pass, and a pass may be discarded and made again.
    const PASSES_WITHOUT: u64 = 3;
    let (id, key) = (Id::unique((what, ctx.viewport_id())), Id::unique((what, key)));
    let (now, pass) = (ctx.input(|input| input.time), ctx.cumulative_pass_nr());
    let before = ctx.data(|data| data.get_temp::<Shown>(id));
    let goes_on = before.filter(|shown| shown.key == key && pass <= shown.pass + PASSES_WITHOUT);
    let since = goes_on.map_or(now, |shown| shown.since);
    ctx.data_mut(|data| data.insert_temp(id, Shown { key, since, pass }));
    now - since
}

/// Returns whether a click has opened the full hover label, until the pointer moves on or a key is pressed.
#[must_use]
pub fn is_opened(ctx: &Context) -> bool {
    seen(ctx).opened.is_some()
}

/// Returns whether a finger rests where it was put down for longer than a tap: it has no other way to point
/// without touching.
#[must_use]
pub fn is_held(ctx: &Context) -> bool {
    let most = ctx.options(|options| options.input_options.max_click_dist);
    ctx.input(|input| {
        let ends = input.pointer.press_origin().zip(input.pointer.latest_pos());
        let rests = ends.is_some_and(|(from, to)| from.distance(to) <= most);
        input.any_touches() && rests && input.pointer.is_decidedly_dragging()
    })
}

/// Returns whether the pointer has moved in the last seconds, and since the last key. Where it rests a frame
/// is shown when that ends.
#[must_use]
pub fn is_moved(ctx: &Context) -> bool {
    let key = seen(ctx).key;
    let (now, since) = ctx.input(|input| (input.time, input.pointer.time_since_last_movement()));
    let is_moved = since < AFTER && now - f64::from(since) >= key;
    if is_moved {
        ctx.request_repaint_after_secs(AFTER - since + 0.01);
    }
    is_moved
}
