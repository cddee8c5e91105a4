//! A user who does anything at all, by chance: whatever it is, nothing breaks.
//!
//! Each run begins with a printed seed. `GAMOW_SEED=7 GAMOW_ACTIONS=20000 cargo test --test ui -- random`
//! does one again, or a longer one.

mod checks;
mod deeds;
pub mod dice;
mod files;
mod hands;
mod nodes;

use std::collections::VecDeque;

use gamow::app::shell::App;
use gamow::app::state::State;
use gamow::settings::Settings;

use self::deeds::User;
use self::dice::Dice;
use self::files::Files;
use self::hands::Window;
use self::nodes::Coverage;
use super::support::{builder, sweep};
use super::{Test, device};

pub const TESTS: &[Test] =
    trials![a_random_user_breaks_nothing, a_random_user_breaks_nothing_while_all_is_drawn,];

/// Actions of each run, in the usual tests and in the whole sweep: without views, which cost most of the
/// time, and with them.
const ACTIONS: [usize; 2] = [800, 20_000];
const ACTIONS_DRAWN: [usize; 2] = [100, 1000];
/// Actions between two ways back, and those that are told of a run that failed.
const WAY_BACK: usize = 100;
const TOLD: usize = 30;

fn a_random_user_breaks_nothing() {
    run(ACTIONS, false);
}

fn a_random_user_breaks_nothing_while_all_is_drawn() {
    run(ACTIONS_DRAWN, true);
}

/// What was done, told if that breaks something.
struct Story {
    seed: u64,
    step: usize,
    last: VecDeque<String>,
}

impl Story {
    fn note(&mut self, said: &str) {
        if self.last.len() == TOLD {
            self.last.pop_front();
        }
        self.last.push_back(format!("{:6} {said}", self.step));
    }
}

impl Drop for Story {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let Self { seed, step, last } = self;
            let told = last.drain(..).collect::<Vec<_>>().join("\n");
            let again = format!("GAMOW_SEED={seed} GAMOW_ACTIONS={}", *step + 1);
            eprintln!("{told}\n{again}: it broke in step {step}, or in what was told last");
        }
    }
}

fn number(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{variable}={text}: must be a whole number")))
}

fn opened(is_drawn: bool) -> Window {
    let state = State::open(Settings::default()).expect("usual settings");
    let builder = builder([800.0, 600.0]).allow_missing_glyphs();
    let mut window = if is_drawn {
        builder
            .renderer(device::renderer())
            .build_eframe(|cc| App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state))
    } else {
        builder.build_eframe(|cc| App::new(&cc.egui_ctx, None, state))
    };
    window.run_steps(2);
    window
}

fn run(actions: [usize; 2], is_drawn: bool) {
    let seed = number("GAMOW_SEED").unwrap_or(1);
    let actions = number("GAMOW_ACTIONS").map_or(sweep(actions), |number| number as usize);
    eprintln!("GAMOW_SEED={seed} GAMOW_ACTIONS={actions}");
    let files = Files::new();
    let mut window = opened(is_drawn);
    let mut start = window.state().state().clone();
    let (mut coverage, mut checked) = (Coverage::default(), None);
    let mut story = Story { seed, step: 0, last: VecDeque::new() };
    for step in 0..actions {
        story.step = step;
        let dice = Dice::of_step(seed, step);
        let said = User { window: &mut window, dice, files: &files, coverage: &mut coverage }.act();
        story.note(&said);
        checks::of_a_frame(&window, &mut checked);
        if step % 25 == 24 {
            checks::of_plots(&mut window);
        }
        if step % WAY_BACK == WAY_BACK - 1 {
            checks::of_the_way_back(&mut window, &start);
        }
        if step % (2 * WAY_BACK) == 2 * WAY_BACK - 1 {
            // No more steps than are kept.
            checks::undo_all(&mut window);
            start = window.state().state().clone();
        }
    }
    let ([seen, used], unused) = coverage.report();
    eprintln!("{actions} actions; of {seen} kinds of controls {used} were used; not: {unused:#?}");
}
