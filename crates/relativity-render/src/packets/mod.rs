//! The rays on the CPU: a test per pixel, in the rest frame and in f32, eight pixels at a time.
//!
//! The same formulas as in `shaders/`, function by function, so that it is as accurate as [`rays`](crate::rays); it needs
//! no graphics adapter, and is faster than one that is software.
#![expect(
    clippy::inline_always,
    reason = "what runs on wide registers must be inlined into where they are chosen"
)]

mod backdrop;
mod block;
mod body;
mod colour;
mod cylinder;
mod encode;
mod lanes;
mod logarithm;
mod pattern;
mod ray;
mod ring;
mod shape;
mod street;
#[cfg(test)]
mod testing;
#[cfg(test)]
mod tests;
mod tube;
mod turning;
