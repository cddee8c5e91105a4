//! Registers of the processor.

use fearless_simd::Level;

/// Runs `$body` with the widest registers that there are; `None` on a processor that has not even four
/// numbers in one, for which it is not worth to compile it.
macro_rules! on_registers {
    ($level:expr, $simd:ident => $body:expr) => {
        match $level {
            #[cfg(target_arch = "x86_64")]
            fearless_simd::Level::Avx2($simd) => Some(fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $body,
            )),
            #[cfg(target_arch = "x86_64")]
            fearless_simd::Level::Sse4_2($simd) => Some(fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $body,
            )),
            #[cfg(target_arch = "aarch64")]
            fearless_simd::Level::Neon($simd) => Some(fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $body,
            )),
            #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
            fearless_simd::Level::WasmSimd128($simd) => Some(fearless_simd::Simd::vectorize(
                $simd,
                #[inline(always)]
                || $body,
            )),
            _ => None,
        }
    };
}
pub(crate) use on_registers;

/// The widest that there are, if they are wide enough.
pub fn widest() -> Option<Level> {
    let level = Level::new();
    on_registers!(level, _simd => level)
}
