//! Errors of scene files, in one line that an author can act on.

use std::ops::Range;

use gamow_platform::{messages, sizes};
use thiserror::Error;

use super::presets::PRESETS;
use crate::files::syntax;
use crate::similar::did_you_mean;

/// A scene that cannot be had.
#[derive(Debug, Error)]
pub enum SceneError {
    /// The file could not be read.
    #[error("{source_name}: cannot read this scene file: {reason}")]
    Read {
        /// The file, as it was named.
        source_name: String,
        /// Reason why the scene cannot be read.
        reason: std::io::Error,
    },
    /// Neither a preset nor a path.
    #[error("no scene is called `{name}`{near}: there are {list}; for a file, give a name ending in .toml", name = messages::excerpt(.0), near = did_you_mean(PRESETS, .0), list = PRESETS.join(", "))]
    UnknownPreset(String),
    /// A model that cannot be read.
    #[error("{source_name}: {reason}")]
    Model {
        /// The file, as it was named.
        source_name: String,
        /// Reason why the model cannot be read.
        reason: String,
    },
    /// A file that is neither a scene nor a model, by its contents and its ending.
    #[error("{source_name} is no scene: scenes end in .toml, models end in .glb, .gltf or .obj")]
    Other {
        /// The file, as it was named.
        source_name: String,
    },
    /// A file with wrong contents.
    #[error("{source_name}:{line}: {problem}")]
    Content {
        /// The file, as it was named.
        source_name: String,
        /// Line in the file, from 1.
        line: usize,
        /// Problem in that line, and its correction.
        problem: SceneProblem,
    },
}

/// A problem at one place of a scene file. Values are quoted from the file.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum SceneProblem {
    /// Text that is no TOML.
    #[error("column {column}: {message}")]
    Syntax {
        /// Number of the column, from 1.
        column: usize,
        /// Message of the TOML reader.
        message: String,
    },
    /// A key that means nothing here.
    #[error("unknown key `{key}`{near}: {owner} has {known}", key = messages::excerpt(key), near = did_you_mean(known.split(", "), key))]
    UnknownKey {
        /// The unknown key.
        key: String,
        /// Table that contains the key.
        owner: &'static str,
        /// The keys that exist there.
        known: String,
    },
    /// A key that must be there.
    #[error("{owner} needs `{key}`")]
    MissingKey {
        /// The missing key.
        key: &'static str,
        /// Table that needs the key.
        owner: &'static str,
    },
    /// A value of the wrong type, or none of those that there are.
    #[error("{key} = {value} must be {expected}")]
    WrongType {
        /// Key of the value.
        key: &'static str,
        /// Its value, as in the file.
        value: String,
        /// Value that would be right.
        expected: &'static str,
    },
    /// Two kinds of light of one object.
    #[error("{key} = {value} must be left out where there is `{other}`: an object has one light")]
    TwoLights {
        /// Key of the second.
        key: &'static str,
        /// Its value, as in the file.
        value: String,
        /// Key of the first.
        other: &'static str,
    },
    /// A material that has not been measured.
    #[error("material = {value} must be a measured one: the nearest are {nearest}")]
    UnknownMaterial {
        /// The name, as in the file.
        value: String,
        /// The most similar names.
        nearest: String,
    },
    /// A name of more letters than one may have.
    #[error("{key} = {value} must have at most {most} letters", most = sizes::NAME_LETTERS)]
    LongName {
        /// Key of the value.
        key: &'static str,
        /// The first characters of the name.
        value: String,
    },
    /// Two bodies of one name in one group.
    #[error("`{name}` is the name of another body too: give each, or its group, a `name` of its own", name = messages::excerpt(.0))]
    SameName(String),
    /// A scene of more groups than one may have.
    #[error("a scene has at most {most} groups, and this one has {0}", most = sizes::GROUPS)]
    ManyGroups(usize),
    /// A scene of more bodies than one may have.
    #[error("a scene has at most {most} bodies, and here there are more", most = sizes::BODIES)]
    ManyBodies,
    /// A scene of more bodies that turn than one may have.
    #[error("a scene has at most {most} bodies that turn, and here there are more", most = sizes::TURNING_BODIES)]
    ManyTurning,
    /// A coordinate that is not finite, or too far out to draw.
    #[error("{key} = {value} must lie between -1e6 and 1e6")]
    OutOfRange {
        /// Key of the value.
        key: &'static str,
        /// Its value, as in the file.
        value: String,
    },
    /// A radius or wavelength that is not positive.
    #[error("{key} = {value} must be above 0")]
    NotPositive {
        /// Key of the value.
        key: &'static str,
        /// Its value, as in the file.
        value: String,
    },
    /// A positive size that f32 arithmetic on a graphics card would lose or overflow.
    #[error("{key} = {value} must lie between 1e-6 and 1e6")]
    SizeOutOfRange {
        /// Key of the value.
        key: &'static str,
        /// Its value, as in the file.
        value: String,
    },
    /// A group's speed of light or more.
    #[error("beta = {0} must lie between -1 and 1 (0 rests on the ground, below 0 moves towards -x)")]
    NoSpeed(String),
    /// A street whose parts do not lie one behind the other.
    #[error("street = {0} must be the y of the near kerb, then of the far one, then of the house fronts")]
    NoWidth(String),
    /// A ring whose tube leaves no hole.
    #[error("tube_radius = {tube_radius} must be below radius = {radius}")]
    NoHole {
        /// The ring's thickness: the radius of its tube, as in the file.
        tube_radius: String,
        /// Radius of the circle in the middle of the tube, as in the file.
        radius: String,
    },
    /// An axis without a direction.
    #[error("axis = {0} must have a direction, such as [0, 1, 0]")]
    NoDirection(String),
    /// A tube without length.
    #[error("to = {0} must differ from `from`: for a ball write shape = \"sphere\"")]
    NoLength(String),
    /// A cylinder without length.
    #[error("to = {0} must differ from `from`, the middle of the other end")]
    NoHeight(String),
    /// An axis to be turned about, and no angle.
    #[error("axis = {axis} needs `angle`, by how many degrees {what} is turned about it")]
    NoAngle {
        /// The axis, as in the file.
        axis: String,
        /// Name of the body, with its article.
        what: &'static str,
    },
    /// A shape that does not exist.
    #[error("shape = {shape} must be {known}")]
    UnknownShape {
        /// The unknown shape.
        shape: String,
        /// The shapes that exist.
        known: String,
    },
    /// An include of what is not a preset.
    #[error("scene = {name} must be one of {list}", name = .0, list = PRESETS.join(", "))]
    UnknownInclude(String),
    /// Changes to the wheels of a preset that has none.
    #[error(
        "`wheels`: the scene {0} has none that could be changed; leave this out, or include cyclist, mr-tompkins, wheel or tram"
    )]
    NoWheels(String),
    /// A model whose file cannot be read, or is none.
    #[error("path = {path}: {reason}")]
    Model {
        /// The model's path, as in the file.
        path: String,
        /// Reason why there is no model.
        reason: String,
    },
    /// A part of a model that cannot be a wheel.
    #[error("wheels = {value}: {reason}")]
    ModelWheel {
        /// The wheels in the file.
        value: String,
        /// Reason why one of them is none.
        reason: String,
    },
    /// A scene without bodies.
    #[error("a scene needs at least one [[object]], [[model]], [[include]] or [[group]] with one")]
    Empty,
}

/// A problem and where it is: bytes of the text.
pub(super) struct Located {
    pub span: Range<usize>,
    pub problem: SceneProblem,
}

impl Located {
    /// The error as the user reads it.
    pub fn in_source(self, text: &str, source_name: &str) -> SceneError {
        let (line, _) = position(text, self.span.start);
        SceneError::Content { source_name: source_name.to_owned(), line, problem: self.problem }
    }

    /// Returns the problem that the TOML reader found, in one line.
    pub fn syntax(text: &str, error: &toml::de::Error) -> Self {
        let (span, message) = syntax::problem(text, error);
        let (_, column) = position(text, span.start);
        Self { span, problem: SceneProblem::Syntax { column, message } }
    }
}

/// Line and column, from 1, of a byte of the text.
fn position(text: &str, offset: usize) -> (usize, usize) {
    let before = text.get(..offset).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}
