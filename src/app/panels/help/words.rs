//! Words of the help: what is shown, the glossary, and the source.

use std::sync::LazyLock;

use gamow_platform::shipped::ShippedFile;
use gamow_platform::shipped_file;

use crate::formula::markdown::Markdown;

/// The first paragraphs, about what is on screen.
pub const WHAT: [&str; 8] = [
    "Gamow shows what two eyes see of something that rides past at nearly the speed of light.",
    "Light takes time: each eye sees every point where it was when its light left. So what comes nearly \
        straight at you looks long and blue, and what goes away short and red.",
    "The views are conformal: small things keep their shape. A passing body has the picture that it has at rest, slid back by \
    the rapidity, which the ruler below it measures. Key V changes to a camera's picture, key O outlines the body at rest.",
    "At one moment the two eyes receive light that left at different times. The differences between their \
        views, the disparities, tell how far away something is and how fast it rides.",
    "Lessons, on the start page (key S), ask what you expect, show what is seen, and explain it. Presets there are states \
    to look at and to change.",
    "Drag the speed, click a point in a view to follow it, and read its disparities in the plots and in the readout.",
    "The map shows what happens meanwhile: where things are measured now, where each eye sees them, and \
        where two eyes place them.",
    "Key I puts you on a bicycle: hold the up and down arrow keys to pedal and to brake, and the street \
        rides past you. A screen that knows touches has pedals in the picture. All times are then those of your own \
        clock.",
];

/// Table of terms in the glossary: the same text as in the documentation.
pub static GLOSSARY: LazyLock<Markdown> = LazyLock::new(|| {
    let page = include_str!("../../../../docs/glossary.md");
    let table = page.find("\n|").map_or(page, |start| &page[start + 1..]);
    Markdown::new(table.find("\n\n").map_or(table, |end| &table[..end]))
});

/// The source of it all.
pub const PAPER: [&str; 2] = [
    "E. A. Cryer-Jenkins and P. D. Stevenson, Gamow's cyclist: a new look at relativistic measurements for a binocular \
    observer, Proc. R. Soc. A 476 (2020).",
    "Gamow implements, corrects and goes beyond the paper's model, whose right eye sees what the left one \
        sees at another time, without parallax. Published, among Eyes receive, shows that model; `gamow \
        paper` draws the paper's figures again, beside ours.",
];

/// Address of the paper.
pub const PAPER_ADDRESS: &str = "https://doi.org/10.1098/rspa.2019.0703";

/// The licences of what Gamow is made of.
pub const NOTICES: ShippedFile = shipped_file!("LICENSES-THIRD-PARTY.txt");

/// The licence of Gamow itself.
pub const OWN_LICENCE: &str =
    "Gamow may be used under the MIT licence or the Apache License 2.0, as you prefer.";
