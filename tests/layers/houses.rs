//! The rules of each crate: its floors, what its folders may not import, and what they may not name of other
//! crates.

/// A crate and the rules of its imports.
pub struct House {
    /// The crate's name.
    pub name: &'static str,
    /// The folder of its sources.
    pub folder: &'static str,
    /// The floors of the crate, and of folders in it.
    pub tables: &'static [Table],
    /// Folders whose files and folders do not know each other.
    pub parts_apart: &'static [&'static str],
    /// Pairs of folders that do not know each other.
    pub strangers: &'static [[&'static str; 2]],
    /// What is named only in files whose paths begin in one way, if at all.
    pub only_in: &'static [(&'static str, &'static [&'static str])],
    /// What is named nowhere.
    pub never: &'static [&'static str],
}

/// The floors of a crate or of a folder in it.
pub struct Table {
    /// The folder, with the slash at its end; empty for the crate.
    pub inside: &'static str,
    /// The rooms, which are files and folders, from the top. A room imports from those below it and beside
    /// it, not upwards, and not in a circle.
    pub floors: &'static [&'static [&'static str]],
}

/// A crate without rules but that files import in no circle.
const PLAIN: House =
    House { name: "", folder: "", tables: &[], parts_apart: &[], strangers: &[], only_in: &[], never: &[] };

/// The numerics.
pub const CORE: House = House {
    name: "relativity-core",
    folder: "crates/relativity-core/src",
    tables: &[Table {
        inside: "",
        floors: &[
            &["lib.rs"],
            &["combined.rs"],
            &["bootstrap.rs", "ride.rs"],
            &["conformal.rs", "fit", "observer"],
            &["model.rs"],
            &["reception.rs", "wheel"],
            &["batch.rs", "passage.rs", "stereo.rs"],
            &["batch_error.rs", "one_cone.rs", "published.rs"],
            &["disparity.rs", "real.rs"],
            &["observation_batch.rs"],
            &["cone_pair.rs"],
            &["apparent.rs", "worldline.rs"],
            &["aberration.rs", "source.rs"],
            &["baseline.rs", "doppler.rs", "speed.rs"],
            &["aperture.rs", "domain.rs", "math.rs", "threads.rs"],
        ],
    }],
    only_in: &[("threads.rs", &["rayon"])],
    never: &["std::fs", "std::time", "std::thread", "glam", "wgpu", "egui", "eframe", "log"],
    ..PLAIN
};

/// The renderers.
pub const RENDERERS: House = House {
    name: "relativity-render",
    folder: "crates/relativity-render/src",
    tables: &[Table {
        inside: "",
        floors: &[
            &["lib.rs"],
            &["renderers.rs"],
            &["gpu", "cpu"],
            &["frame"],
            &["picture"],
            &["street"],
            &["light"],
            &["scene"],
            &["geometry"],
            &["view"],
            &["camera", "colour", "kinematics", "simd", "shaders.rs"],
        ],
    }],
    strangers: &[["gpu/", "cpu/"]],
    only_in: &[("gpu/", &["wgpu"])],
    never: &["std::fs", "std::time", "std::thread", "rayon", "egui", "eframe"],
    ..PLAIN
};

/// What the system provides.
pub const PLATFORM: House = House { name: "gamow-platform", folder: "crates/gamow-platform/src", ..PLAIN };

/// The program.
pub const PROGRAM: House = House {
    name: "gamow",
    folder: "src",
    tables: &[
        Table {
            inside: "",
            floors: &[
                &["main.rs"],
                &["cli"],
                &["commands", "app"],
                &["lesson"],
                &["accuracy", "estimate", "studio"],
                &["caption", "comfort.rs", "map"],
                &["settings"],
                &["scene", "columns", "time_range.rs", "flags", "files", "plot", "quantity.rs", "units.rs"],
                &["eye.rs", "eye_colours.rs", "number_text.rs", "formula"],
                &["markup.rs", "similar.rs"],
            ],
        },
        Table {
            inside: "app/",
            floors: &[
                &["shell"],
                &["panels"],
                &["views"],
                &["commands"],
                &["widgets"],
                &["state"],
                &["tools"],
            ],
        },
    ],
    parts_apart: &["commands/", "app/panels/"],
    strangers: &[["app/", "commands/"]],
    only_in: &[
        ("app/", &["eframe", "egui_plot"]),
        ("formula/", &["ratex_font", "ratex_layout", "ratex_parser", "ratex_types"]),
    ],
    never: &["std::fs", "std::thread", "std::time::Instant", "std::time::SystemTime"],
};

/// The Python package.
pub const PYTHON: House = House { name: "gamow-python", folder: "crates/gamow-python/src", ..PLAIN };
