//! The lessons are right: every number and claim in them is held against the core, called directly.

mod documented;
mod first;
mod fitted;
mod riding;
mod second;
mod slide;
mod sunlit;
mod support;
mod third;
mod told;
