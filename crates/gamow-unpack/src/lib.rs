//! Unpacks the program of the page. LZMA makes it smaller than what servers compress with, and a server that
//! does not compress at all serves as well.
#![cfg(target_arch = "wasm32")]

use std::io::Read as _;

use lzma_rust2::LzmaReader;
use wasm_bindgen::prelude::{JsError, wasm_bindgen};

/// Memory for the decoder, KiB: twice that of the dictionary of the preset that web/build packs with.
const MOST_MEMORY: u32 = 16 << 10;

/// Returns the bytes in `packed`, a file of LZMA alone.
///
/// # Errors
///
/// What keeps `packed` from being one.
#[wasm_bindgen]
pub fn unpacked(packed: &[u8]) -> Result<Vec<u8>, JsError> {
    let mut bytes = Vec::new();
    LzmaReader::new_mem_limit(packed, MOST_MEMORY, None)?.read_to_end(&mut bytes)?;
    Ok(bytes)
}
