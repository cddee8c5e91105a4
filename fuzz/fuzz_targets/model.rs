//! Models of scenes: the first byte chooses the format of the others.
#![no_main]

use gamow::scene::read_model;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Some((kind, bytes)) = bytes.split_first() else { return };
    let ending = ["glb", "obj", "gltf"][usize::from(kind % 3)];
    if let Ok(model) = read_model(ending, bytes) {
        let _ = model.prepared();
    }
});
