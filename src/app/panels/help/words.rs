//! Words of the help: what is shown, the terms and letters, and the source.

/// The first paragraphs, about what is on screen.
pub const WHAT: [&str; 8] = [
    "Gamow shows what two eyes see of something that rides past at nearly the speed of light.",
    "Light takes time: each eye sees every point where it was when its light left. So what comes nearly \
    straight at you looks long and blue, and what goes short and red.",
    "The views are conformal: small things keep their shape. A passing body has the picture that it has at rest, slid back by \
    the rapidity, which the ruler below it measures. Key V changes to a camera's picture, key O outlines the body at rest.",
    "At one moment the two eyes receive light that left at different times. How their views differ, the disparities, \
    tells how far off something is and how fast it rides.",
    "Lessons, on the start page (key S), ask what you expect, show what is seen, and explain it. Presets there are states \
    to look at and to change.",
    "Drag the speed, click a point in a view to follow it, and read its disparities in the plots and in the readout.",
    "The map shows what happens meanwhile: where things are measured now, where each eye sees them, and where two eyes \
    take them to be.",
    "Key I seats you on a bicycle yourself: hold the arrow keys up and down to pedal and to brake, and the street rides past \
    you. Everything is told by your own clock then.",
];

/// Terms and letters with their meanings, beside the three times.
pub const WORDS: [(&str, &str); 17] = [
    ("β, γ, η", "the speed in parts of that of light, v/c; γ = 1/√(1 − β²); the rapidity η = artanh β"),
    ("d", "how far apart the eyes are"),
    ("Doppler factor D", "received over rest frequency: above 1 is bluer. So fast is a clock seen to run"),
    (
        "disparity Δφ, Δθ",
        "how differently the eyes see a point: azimuth φ and elevation θ, left minus right, in radians",
    ),
    (
        "u, v",
        "column and row of a point in a conformal picture; motion along the eyes' line takes η from u and keeps v",
    ),
    ("T₀", "the T at which both eyes see the point equally far, so that both receive the same event"),
    ("measured abreast", "beside the eyes now, at x = 0, by the ground’s clocks; nobody sees it there yet"),
    ("seen abreast", "seen beside the eyes, with D = 1/γ and 1/γ as long"),
    ("s", "the clock on the handlebar of whoever rides"),
    (
        "proper acceleration",
        "what a balance on the bicycle shows: rapidity gained per unit of one's own time",
    ),
    ("light cone", "all events whose light arrives at one place at one time. Each eye has its own"),
    ("as seen", "each point where it was when its light left"),
    ("contracted", "where everything is at one time on the ground, shorter by 1/γ: what Gamow drew"),
    ("at rest", "what a camera that rides along photographs"),
    (
        "stereo gain",
        "how many times as far apart the eyes would have to be to see a resting point as differently",
    ),
    ("stereo at", "where two eyes take the point to be: where their lines of sight meet"),
    ("published", "the paper's approximate model of the right eye, beside the exact one"),
];

/// The source of it all.
pub const PAPER: [&str; 2] = [
    "E. A. Cryer-Jenkins and P. D. Stevenson, Gamow's cyclist: a new look at relativistic measurements for a binocular \
    observer, Proc. R. Soc. A 476 (2020).",
    "Gamow implements, corrects and goes beyond it: its right eye is the left one at another time, and leaves out \
    parallax. Eyes receive, Published shows that model; `gamow paper` redoes its figures beside ours.",
];

/// Address of the paper.
pub const PAPER_ADDRESS: &str = "https://doi.org/10.1098/rspa.2019.0703";

/// The licence of Gamow itself.
pub const OWN_LICENCE: &str =
    "Gamow may be used under the MIT licence or the Apache License 2.0, as you prefer.";
