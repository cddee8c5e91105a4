//! Small tools of the window, which know nothing of its state.

pub(in crate::app) mod aids;
pub(in crate::app) mod awake;
pub mod clock;
pub(in crate::app) mod debounce;
pub(in crate::app) mod folded;
pub(in crate::app) mod gpu_errors;
pub mod graphics;
#[cfg(feature = "desktop")]
pub(in crate::app) mod icon;
pub(in crate::app) mod image;
#[cfg(any(test, not(feature = "desktop")))]
pub(in crate::app) mod mirror;
pub(in crate::app) mod page_link;
pub mod painting;
pub(in crate::app) mod preparing;
mod speed_slider;
#[cfg(feature = "desktop")]
pub(in crate::app) mod system_fonts;
pub(in crate::app) mod waker;
pub(in crate::app) mod watch;
pub(in crate::app) mod worker;
