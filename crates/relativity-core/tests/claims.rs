//! The tests of the crate, but those against high precision, which are in `oracle`.

mod common;
mod conformal;
mod domain;
mod fit;
mod invariants;
mod names;
mod published_numbers;
mod riding;
mod robust;
mod serial;
mod stereo_claims;
#[path = "common/tally.rs"]
mod tally;
mod wheels;
