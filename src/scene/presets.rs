//! The scenes that are compiled in.

/// Defines the names of the presets and their files.
macro_rules! presets {
    ($($name:literal),+) => {
        /// Names of the presets; the first is the default.
        pub const PRESETS: [&str; [$($name),+].len()] = [$($name),+];

        /// The scene file of a preset.
        pub(super) fn text(name: &str) -> Option<&'static str> {
            match name {
                $($name => Some(include_str!(concat!("../../assets/scenes/", $name, ".toml"))),)+
                _ => None,
            }
        }
    };
}

presets! {
    "street", "cyclist", "cube", "globe", "train", "wheel", "rods", "twins", "lattice", "two-balls",
    "post-office", "tunnel", "tram", "mr-tompkins", "town", "town-cyclist"
}

/// The file of a model in a preset.
pub(super) fn model_file(name: &str) -> Option<&'static [u8]> {
    match name {
        "tram.obj" => Some(include_bytes!("../../assets/scenes/tram.obj")),
        "tram.mtl" => Some(include_bytes!("../../assets/scenes/tram.mtl")),
        "tram.png" => Some(include_bytes!("../../assets/scenes/tram.png")),
        _ => None,
    }
}

/// Whether there are wheels in the preset of that name, or in what it includes.
pub(super) fn has_wheels(name: &str) -> bool {
    const TELL: [&str; 2] = ["[[wheel]]", "[include.wheels]"];
    text(name).is_some_and(|text| {
        text.lines().any(|line| TELL.contains(&line.trim()) || line.starts_with("wheels = "))
    })
}

/// Whether `word` reads as a misspelt preset rather than as a path.
#[must_use]
pub fn looks_like_a_name(word: &str) -> bool {
    !word.contains(['/', '\\', '.'])
}
