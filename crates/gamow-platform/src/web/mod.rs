//! The browser in place of an operating system: the page, its storage, downloads, and time between two
//! frames.

pub mod download;
pub mod elements;
pub mod instances;
pub mod locks;
pub mod page;
pub mod storage;
pub mod tasks;
pub mod threads;
