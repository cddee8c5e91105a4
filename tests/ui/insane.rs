//! Settings that nobody would type: each start with them succeeds, with numbers that are numbers.
//! `GAMOW_INSANE=5000` makes as many of them, else there are a few hundred; `GAMOW_SEED` makes other ones.

use std::collections::BTreeMap;
use std::path::Path;

use gamow::app::shell::persistence::{self, Keeper};
use gamow::app::state::State;
use gamow::settings::{Settings, Subject};

use super::Test;
use super::support::{assert_sane, window};

pub const TESTS: &[Test] =
    trials![insane_settings_open_with_numbers_that_are_numbers, insane_settings_are_drawn,];

/// Settings that have no value as usual, with their sections.
const UNSET: [(&str, &str); 5] =
    [("", "time"), ("", "point"), ("", "points"), ("motion", "gamma"), ("motion", "rapidity")];

/// What no setting should have, and what only some can.
const VALUES: [&str; 70] = [
    "nan",
    "-nan",
    "inf",
    "-inf",
    "1e300",
    "-1e300",
    "1e-300",
    "5e-324",
    "0",
    "-0.0",
    "-1",
    "1",
    "2",
    "0.5",
    "0.001",
    "0.01",
    "16",
    "100",
    "150",
    "179.999",
    "180",
    "-180",
    "720",
    "300",
    "5000",
    "5001",
    "1e-9",
    "1e5",
    "1e6",
    "-1e6",
    "1e12",
    "-1e12",
    "1e11",
    "1e30",
    "1.1e30",
    "69.77",
    "0.9999999999999999",
    "9007199254740992",
    "9223372036854775807",
    "18446744073709551615",
    "99999999999999999999999999999999999999999999",
    "true",
    "false",
    "'on'",
    "'auto'",
    "'point'",
    "'whole'",
    "'nan,nan'",
    "'1e300,0'",
    "[nan, inf]",
    "[-1e12, 1e12]",
    "[1e12, 1e12]",
    "[720, 89.999]",
    "[1e300, -1e300, nan]",
    "[1e6, -1e6, 1e6]",
    "'1e7,1e7,-1e7@0;0,0,0@18446744073709551615'",
    "'coast'",
    "'2@1,3@-1,0@0'",
    "'14@1'",
    "'1e6@1.4e-5'",
    "'1e6@0'",
    "'gamma:-1e6'",
    "'rapidity:14'",
    "'1x1'",
    "'16384x1'",
    "''",
    "'\\u001b[31m'",
    "[[1], {}]",
    "{ x = 1 }",
    "1979-05-27",
];

/// A linear congruential generator (D. E. Knuth's MMIX).
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % count
    }

    fn of<'a, T: ?Sized>(&mut self, all: &[&'a T]) -> &'a T {
        all[self.below(all.len())]
    }

    /// A file of settings with some of all of them, each with any value.
    fn settings(&mut self) -> String {
        let default: toml::Table = Settings::default().to_toml().parse().expect("it is TOML");
        let mut all: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for (name, value) in &default {
            match value.as_table() {
                Some(section) => all.entry(name.clone()).or_default().extend(section.keys().cloned()),
                None => all.entry(String::new()).or_default().push(name.clone()),
            }
        }
        for (section, name) in UNSET {
            all.entry(section.to_owned()).or_default().push(name.to_owned());
        }
        let share = 1 + self.below(10);
        let mut text = String::new();
        for (section, names) in all {
            if !section.is_empty() {
                text = format!("{text}[{section}]\n");
            }
            for name in names {
                if self.below(10) < share {
                    text = format!("{text}{name} = {}\n", self.of(&VALUES));
                }
            }
        }
        text
    }

    /// `text` with a few bytes that were not in it.
    fn mutated(&mut self, text: &str) -> Vec<u8> {
        let mut bytes = text.as_bytes().to_vec();
        for _ in 0..=self.below(6) {
            let at = self.below(bytes.len());
            let end = (at + self.below(8)).min(bytes.len());
            let put =
                [&b"1e300"[..], b"NaN", b"inf", b"-", b"9", b"\"", b"=", b"\xff", b"", b"(", b")", b"\n"];
            bytes.splice(at..end, self.of(&put).iter().copied());
            if bytes.is_empty() {
                bytes.push(b'x');
            }
        }
        bytes
    }

    /// A file of what is remembered beside the settings.
    fn memory(&mut self) -> Vec<u8> {
        let text = format!(
            "clicked = true\nzoom = {}\nfolded = [\"Light\"]\n[place]\nposition = [{}, 0.0]\nsize = [{}, 800.0]\nmaximised = true\n",
            self.number(),
            self.number(),
            self.number()
        );
        if self.below(2) == 0 { text.into_bytes() } else { self.mutated(&text) }
    }

    /// A file of settings as a window keeps it, or nearly.
    fn kept_settings(&mut self) -> Vec<u8> {
        let text = if self.below(4) == 0 { Settings::default().to_toml() } else { self.settings() };
        if text.is_empty() || self.below(2) == 0 { text.into_bytes() } else { self.mutated(&text) }
    }

    fn number(&mut self) -> &'static str {
        self.of(&[
            "0.0",
            "nan",
            "inf",
            "-inf",
            "1e9",
            "1e300",
            "-1.0",
            "1000.0",
            "1.0",
            "18446744073709551615",
        ])
    }
}

/// A number out of the environment.
fn given(name: &str, default: u64) -> u64 {
    std::env::var(name).map_or(default, |text| text.parse().expect("it is a number"))
}

/// The settings of a start with files of these bytes.
fn remembered(folder: &Path, settings: &[u8], memory: &[u8]) -> Settings {
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.join(name), bytes).expect("it is writable");
    write(persistence::SETTINGS, settings);
    write(persistence::MEMORY, memory);
    let loaded = Keeper::in_folder(folder).load();
    let ctx = eframe::egui::Context::default();
    loaded.memory.restore_in(&ctx, true);
    assert!((0.2..=5.0).contains(&ctx.zoom_factor()));
    let window = Keeper::in_folder(folder);
    let again = window.load();
    assert_eq!(again.notice, None, "what was put right is right");
    assert_eq!((&again.settings, &again.memory), (&loaded.settings, &loaded.memory));
    let placed = window.placed(eframe::egui::ViewportBuilder::default());
    assert!(placed.inner_size.is_none_or(|size| size.min_elem() >= 1.0 && size.max_elem() <= 32_767.0));
    for left in std::fs::read_dir(folder).expect("a folder").flatten() {
        std::fs::remove_file(left.path()).expect("it is writable");
    }
    loaded.settings
}

/// The state that `settings` open, in another scene where theirs cannot be had.
fn opened(settings: Settings) -> State {
    let default = settings.clone().with_scene(Settings::default().scene);
    State::open(settings).or_else(|_| State::open(default)).expect("the usual scene")
}

/// As many insane states as the environment says, one of `share`.
fn each(share: u64, mut judge: impl FnMut(State)) {
    let seed = given("GAMOW_SEED", 20_261_122);
    let count = given("GAMOW_INSANE", 300) / share;
    println!("{count} insane settings from GAMOW_SEED={seed}");
    let folder = tempfile::tempdir().expect("there is a place for temporary files");
    let mut random = Random(seed);
    for number in 0..count {
        let settings = match number % 3 {
            0 => Settings::as_far_as_told(&random.settings()).0,
            1 => {
                let bytes = random.mutated(&Settings::default().to_toml());
                Settings::as_far_as_told(&String::from_utf8_lossy(&bytes)).0
            }
            _ => {
                let (settings, memory) = (random.kept_settings(), random.memory());
                remembered(folder.path(), &settings, &memory)
            }
        };
        judge(opened(settings));
    }
}

fn insane_settings_open_with_numbers_that_are_numbers() {
    each(1, |state| {
        assert_sane(&state);
        let State { document, frame, .. } = &state;
        let settings = &document.settings;
        let tracked = document.points.selected().track;
        let subject = Subject { scene: &document.prepared, tracked };
        let views = settings.views(subject, document.time, frame.picture.size);
        let shown = format!(
            "{views:?} {:?} {:?}",
            state.appearance(true),
            settings.automatic_ev(&document.scene, document.time)
        );
        let is_none = |word: &str| ["NaN", "inf"].contains(&word);
        let words = shown.split(|c: char| !c.is_alphanumeric());
        assert!(!words.into_iter().any(is_none), "{shown} of\n{}", settings.to_toml());
    });
}

/// The time of the processor that this thread has used, seconds; `None` where the system does not tell it.
fn processor_time() -> Option<f64> {
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(1e-9 * statistics.split(' ').next()?.parse::<f64>().ok()?)
}

fn insane_settings_are_drawn() {
    // All that a frame waits for is done on this thread, so that its time does not depend on what else the
    // machine does.
    let here = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread().build().expect("a pool");
    here.install(|| {
        each(50, |state| {
            let text = state.document.settings.to_toml();
            let begun = processor_time();
            let harness = window(state);
            assert_sane(harness.state().state());
            let took = processor_time().zip(begun).map(|(now, begun)| now - begun);
            assert!(took.is_none_or(|took| took < 60.0), "{took:?} s for a window with\n{text}");
        });
    });
}
