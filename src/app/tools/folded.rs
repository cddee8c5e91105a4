//! The folded sections of the controls: noted while they are shown, and restored in the next window.

use std::collections::BTreeSet;

use eframe::egui::{Context, Id};

type Folded = BTreeSet<String>;

fn id() -> Id {
    Id::unique("folded sections")
}

/// Whether the section of this `title` was folded when the last window was closed.
#[must_use]
pub fn is_folded(ctx: &Context, title: &str) -> bool {
    ctx.data(|data| data.get_temp::<Folded>(id())).is_some_and(|folded| folded.contains(title))
}

/// Notes whether the section of this `title` `is` folded.
pub fn note(ctx: &Context, title: &str, is: bool) {
    if is != is_folded(ctx, title) {
        ctx.data_mut(|data| {
            let folded = data.get_temp_mut_or_default::<Folded>(id());
            if is {
                folded.insert(title.to_owned())
            } else {
                folded.remove(title)
            };
        });
    }
}

/// The titles of those that are folded, once one was.
#[must_use]
pub fn noted(ctx: &Context) -> Option<Folded> {
    ctx.data(|data| data.get_temp(id()))
}

/// Has the sections of these titles folded in a new window.
pub fn set(ctx: &Context, folded: Folded) {
    ctx.data_mut(|data| data.insert_temp(id(), folded));
}
