//! The same bits on all registers.

use fearless_simd::Level;

use super::{Found, Random, cases, cases_of_wheels};
use crate::cpu::packets::testing::levels;

fn text(found: &[Found]) -> String {
    format!("{found:?}")
}

#[test]
fn all_registers_give_the_same_bits() {
    let levels = levels();
    assert!(!levels.is_empty());
    let mut random = Random(6);
    for (context, case) in cases().chain(cases_of_wheels()) {
        let pixels = case.pixels(&mut random, 1.3);
        let expected = text(&case.found(Level::new(), &pixels));
        assert!(!expected.contains("NaN"), "{context}: {expected}");
        for &level in &levels {
            assert_eq!(text(&case.found(level, &pixels)), expected, "{context} at {level:?}");
        }
    }
}
