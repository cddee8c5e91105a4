//! Parts that tests of packets share.

use fearless_simd::Level;

/// Every kind of wide registers that this processor has, the narrowest first.
pub fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let wide = [best.as_sse4_2().map(Level::Sse4_2), best.as_avx2().map(Level::Avx2)];
    #[cfg(not(target_arch = "x86_64"))]
    let wide = [Some(best)];
    wide.into_iter().flatten().collect()
}

/// Runs the same on each.
macro_rules! at_every_level {
    ($simd:ident => $body:expr) => {
        for level in $crate::cpu::packets::testing::levels() {
            $crate::simd::registers::on_registers!(level, $simd => $body);
        }
    };
}
pub(crate) use at_every_level;
