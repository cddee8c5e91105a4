//! The scenes that are compiled in.

/// Names of the presets; the first is the default.
pub const PRESETS: [&str; 16] = [
    "street",
    "cyclist",
    "cube",
    "globe",
    "train",
    "wheel",
    "rods",
    "twins",
    "lattice",
    "two-balls",
    "post-office",
    "tunnel",
    "tram",
    "mr-tompkins",
    "town",
    "town-cyclist",
];

/// The scene file of a preset.
pub(super) fn text(name: &str) -> Option<&'static str> {
    Some(match name {
        "cyclist" => include_str!("../../assets/scenes/cyclist.toml"),
        "street" => include_str!("../../assets/scenes/street.toml"),
        "cube" => include_str!("../../assets/scenes/cube.toml"),
        "globe" => include_str!("../../assets/scenes/globe.toml"),
        "train" => include_str!("../../assets/scenes/train.toml"),
        "wheel" => include_str!("../../assets/scenes/wheel.toml"),
        "rods" => include_str!("../../assets/scenes/rods.toml"),
        "twins" => include_str!("../../assets/scenes/twins.toml"),
        "two-balls" => include_str!("../../assets/scenes/two-balls.toml"),
        "lattice" => include_str!("../../assets/scenes/lattice.toml"),
        "post-office" => include_str!("../../assets/scenes/post-office.toml"),
        "tunnel" => include_str!("../../assets/scenes/tunnel.toml"),
        "tram" => include_str!("../../assets/scenes/tram.toml"),
        "mr-tompkins" => include_str!("../../assets/scenes/mr-tompkins.toml"),
        "town" => include_str!("../../assets/scenes/town.toml"),
        "town-cyclist" => include_str!("../../assets/scenes/town-cyclist.toml"),
        _ => return None,
    })
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
