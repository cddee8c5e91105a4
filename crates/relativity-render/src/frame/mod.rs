//! A frame as the two renderers in f32 share it, the shaders and the packets: the uniform block that they
//! read, the keys of their variants, and the numbers that they write.

pub mod hit_numbers;
pub mod pipeline_key;
pub mod uniform;
