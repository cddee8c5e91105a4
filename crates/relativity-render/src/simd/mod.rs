//! Registers of the processor, and eight numbers at once in them.

pub mod lanes;
pub mod registers;
