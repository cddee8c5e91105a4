//! Files that are shown: what they are chosen for, how they are read, and which were opened.

pub mod purpose;
pub mod reader;
pub mod recent;
