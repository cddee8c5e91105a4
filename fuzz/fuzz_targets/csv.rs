//! CSV files of measured disparities, and rows to evaluate.
#![no_main]

use gamow::estimate::data::{AssumedUnits, Data, Eyes};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let _ = Data::read("fuzz.csv", bytes, Eyes::given(None, [None; 2]), AssumedUnits::default());
});
