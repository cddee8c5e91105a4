//! What tests of packets share.

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

/// Runs the same on each. Without any, eight numbers are scalars, and a long test takes minutes to compile: that is left
/// out.
#[cfg(target_arch = "x86_64")]
macro_rules! at_every_level {
    ($simd:ident => $body:expr) => {
        for level in $crate::packets::testing::levels() {
            match level {
                fearless_simd::Level::Sse4_2($simd) => fearless_simd::Simd::vectorize(
                    $simd,
                    #[inline(always)]
                    || $body,
                ),
                fearless_simd::Level::Avx2($simd) => fearless_simd::Simd::vectorize(
                    $simd,
                    #[inline(always)]
                    || $body,
                ),
                _ => {}
            }
        }
    };
}
#[cfg(not(target_arch = "x86_64"))]
macro_rules! at_every_level {
    ($simd:ident => $body:expr) => {
        for level in $crate::packets::testing::levels() {
            fearless_simd::dispatch!(level, $simd => $body);
        }
    };
}
pub(crate) use at_every_level;
