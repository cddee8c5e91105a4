//! Riding by two thumbs, on a screen that knows touches and has no keys to hold: one holds a pedal, the other
//! looks around. The toolkit itself has one pointer, so fingers are followed here.

use std::collections::BTreeMap;

use eframe::egui::{Context, Event, Id, Pos2, Rect, TouchPhase};

use crate::app::state::riding::saddle::PushDirection;

/// A pedal: where it was shown, and which way it pushes.
pub type Pedal = (Rect, PushDirection);

/// The pedals that are shown, and the fingers on the screen.
#[derive(Debug, Clone, Default)]
struct Thumbs {
    pedals: Vec<Pedal>,
    /// The pass in which they were shown last, in one picture or in two.
    pass: u64,
    /// Direction of the pedal that the pointer holds, be it a finger or a mouse.
    by_pointer: Option<PushDirection>,
    fingers: BTreeMap<u64, Finger>,
}

/// A finger on the screen.
#[derive(Debug, Clone, Copy)]
struct Finger {
    /// The pedal that it was put on.
    on: Option<PushDirection>,
    began: Pos2,
    before: Pos2,
    now: Pos2,
}

/// Whether the screen of `ctx` knows touches.
#[must_use]
pub fn are_there(ctx: &Context) -> bool {
    ctx.input(eframe::egui::InputState::has_touch_screen)
}

/// Takes in the touches of a new frame.
pub fn hear(ctx: &Context) {
    if !are_there(ctx) {
        return;
    }
    with(ctx, |thumbs, ctx| {
        if thumbs.pass + 1 < ctx.cumulative_pass_nr() {
            (thumbs.pedals, thumbs.by_pointer) = (Vec::new(), None);
        }
        thumbs.fingers.values_mut().for_each(|finger| finger.before = finger.now);
        ctx.input(|input| input.events.iter().for_each(|event| thumbs.hear(event)));
    });
}

/// Notes that these `pedals` are shown in a picture, of which the pointer holds one or none.
pub fn show(ctx: &Context, pedals: &[Pedal], by_pointer: Option<PushDirection>) {
    with(ctx, |thumbs, ctx| {
        let pass = ctx.cumulative_pass_nr();
        if std::mem::replace(&mut thumbs.pass, pass) != pass {
            (thumbs.pedals, thumbs.by_pointer) = (Vec::new(), None);
        }
        thumbs.pedals.extend_from_slice(pedals);
        thumbs.by_pointer = thumbs.by_pointer.or(by_pointer);
    });
}

/// Returns the direction in which the one pedal that is held pushes.
#[must_use]
pub fn held(ctx: &Context) -> Option<PushDirection> {
    with(ctx, |thumbs, _| thumbs.held())
}

/// Returns from where to where, in this frame, a finger has moved that was put down within `area` beside the
/// pedals, while another holds one.
#[must_use]
pub fn looked(ctx: &Context, area: Rect) -> Option<[Pos2; 2]> {
    with(ctx, |thumbs, _| {
        let is_held = thumbs.fingers.values().any(|finger| finger.on.is_some());
        let moved = |finger: &&Finger| {
            finger.on.is_none() && area.contains(finger.began) && finger.before != finger.now
        };
        let looks = thumbs.fingers.values().find(moved).filter(|_| is_held);
        looks.map(|finger| [finger.before, finger.now])
    })
}

impl Thumbs {
    fn hear(&mut self, event: &Event) {
        let Event::Touch { id, phase, pos: now, .. } = *event else { return };
        match phase {
            TouchPhase::Start => {
                let on = self.pedals.iter().find(|(place, _)| place.contains(now)).map(|(_, push)| *push);
                self.fingers.insert(id.0, Finger { on, began: now, before: now, now });
            }
            TouchPhase::Move => {
                self.fingers.entry(id.0).and_modify(|finger| finger.now = now);
            }
            TouchPhase::End | TouchPhase::Cancel => {
                self.fingers.remove(&id.0);
            }
        }
    }

    fn held(&self) -> Option<PushDirection> {
        if self.pedals.is_empty() {
            return None;
        }
        let mut held: Vec<_> = self.fingers.values().filter_map(|finger| finger.on).collect();
        held.extend(self.by_pointer);
        held.dedup();
        <[PushDirection; 1]>::try_from(held).ok().map(|[push]| push)
    }
}

/// Does something with what is kept of the thumbs on the screen of `ctx`.
fn with<R>(ctx: &Context, then: impl FnOnce(&mut Thumbs, &Context) -> R) -> R {
    let id = Id::unique(("thumbs", ctx.viewport_id()));
    let mut thumbs: Thumbs = ctx.data_mut(|data| data.remove_temp(id)).unwrap_or_default();
    let result = then(&mut thumbs, ctx);
    ctx.data_mut(|data| data.insert_temp(id, thumbs));
    result
}

#[cfg(test)]
mod tests {
    use super::*;
    use eframe::egui::{TouchDeviceId, TouchId, pos2};

    const PEDALS: [Pedal; 2] = [
        (Rect::from_min_max(pos2(0.0, 0.0), pos2(10.0, 10.0)), PushDirection::Backwards),
        (Rect::from_min_max(pos2(90.0, 0.0), pos2(100.0, 10.0)), PushDirection::Forwards),
    ];

    fn touch(finger: u64, phase: TouchPhase, pos: Pos2) -> Event {
        Event::Touch { device_id: TouchDeviceId(0), id: TouchId(finger), phase, pos, force: None }
    }

    fn thumbs(events: &[Event]) -> Thumbs {
        let mut thumbs = Thumbs { pedals: PEDALS.to_vec(), ..Thumbs::default() };
        for event in events {
            thumbs.hear(event);
        }
        thumbs
    }

    #[test]
    fn a_finger_holds_the_pedal_that_it_was_put_on_wherever_it_moves() {
        let right = touch(1, TouchPhase::Start, pos2(95.0, 5.0));
        let away = touch(1, TouchPhase::Move, pos2(50.0, 50.0));
        assert_eq!(thumbs(&[right.clone(), away]).held(), Some(PushDirection::Forwards));
        let up = touch(1, TouchPhase::End, pos2(95.0, 5.0));
        assert_eq!(thumbs(&[right.clone(), up]).held(), None);
        let left = touch(2, TouchPhase::Start, pos2(5.0, 5.0));
        assert_eq!(thumbs(std::slice::from_ref(&left)).held(), Some(PushDirection::Backwards));
        assert_eq!(thumbs(&[right, left]).held(), None, "both at once push nowhere, as both keys do");
    }

    #[test]
    fn a_finger_that_slides_onto_a_pedal_does_not_push_it() {
        let beside = touch(1, TouchPhase::Start, pos2(50.0, 50.0));
        let onto = touch(1, TouchPhase::Move, pos2(95.0, 5.0));
        assert_eq!(thumbs(&[beside, onto]).held(), None);
    }
}
