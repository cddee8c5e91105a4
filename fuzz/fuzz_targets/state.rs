//! State files, and the commands that pictures record.
#![no_main]

use gamow::settings::Settings;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    if let Ok(settings) = Settings::default().with_toml(text, "fuzz.toml") {
        // What was taken is written so that it is read again.
        let toml = settings.to_toml();
        let again = Settings::default().with_toml(&toml, "again.toml").expect("it was written by itself");
        assert_eq!(settings, again);
    }
    let _ = Settings::of_picture(text, "fuzz.png");
});
