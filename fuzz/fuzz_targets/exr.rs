//! EXR files, as `gamow measure` and `gamow rectify` read them.
#![no_main]

use std::io::Cursor;

use gamow::files::exr::Measurements;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(file) = Measurements::decode(Cursor::new(bytes)) {
        let _ = file.command();
    }
});
