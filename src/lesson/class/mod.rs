//! The answers of a class, without a server: each pupil's to one lesson as a text that a link or a QR code
//! carries, and all of them on one page.
//!
//! The program sends nothing. A pupil copies a link; who teaches collects links in any text, such as the
//! column of a table or a folder of reports, and has it read.

mod collected;
mod distribution;
mod drawn_curve;
mod number_strip;
mod page;
mod pupil;
mod qr_code;
mod tally;
mod token;

pub use collected::{Collected, Unread};
pub use page::{page, right_of};
pub use pupil::{MOST_NAME_LETTERS, PupilAnswers, pupils_name};
pub use qr_code::QrCode;
pub use token::{KEY, TokenError, link_pair};
