//! PNG files, as `gamow measure` and `gamow rectify` read them.
#![no_main]

use std::io::Cursor;

use gamow::files::png::PngFile;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Ok(file) = PngFile::decode(Cursor::new(bytes)) {
        let _ = file.command();
    }
});
