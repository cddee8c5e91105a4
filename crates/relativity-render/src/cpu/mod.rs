//! Drawing on the CPU: by the reference in f64, and by packets of rays in f32.

pub mod packets;
mod reference;
