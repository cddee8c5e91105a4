//! Paint: how a surface reflects light of each wavelength.

use std::fmt;

/// The names of the measured materials, in the order of the columns of `assets/materials.csv`.
const NAMES: [&str; 18] = [
    "white_paint",
    "yellow_paint",
    "red_paint",
    "blue_paint",
    "green_paint",
    "clay_tile",
    "brick_paving",
    "pavement",
    "asphalt_road",
    "weathered_wood",
    "leaves",
    "dry_grass",
    "bark",
    "glass",
    "concrete_roof_tile",
    "gravel",
    "earth",
    "sand",
];

/// The reflectance of a matt surface.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Paint {
    /// Smooth paint, which is known only by its colour at rest in sunlight: linear sRGB, 0 to 1.
    Smooth([f64; 3]),
    /// Paint whose reflectance has been measured.
    Measured(Material),
}

/// A material whose reflectance has been measured from 400 to 2400 nm.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(try_from = "String", into = "String"))]
pub struct Material(u8);

impl Paint {
    /// Paint that reflects all light.
    pub const WHITE: Self = Self::Smooth([1.0; 3]);
}

impl Material {
    /// Number of materials.
    pub const COUNT: usize = NAMES.len();
    /// All materials.
    pub const ALL: [Self; Self::COUNT] = {
        let mut all = [Self(0); Self::COUNT];
        let mut number = 0;
        while number < Self::COUNT {
            all[number] = Self(number as u8);
            number += 1;
        }
        all
    };

    /// Returns the material of this name, such as `asphalt_road`.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|material| material.name() == name)
    }

    /// The name of the material, as scenes write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        NAMES[self.0 as usize]
    }

    /// The place of the material in [`Self::ALL`].
    #[must_use]
    pub const fn number(self) -> usize {
        self.0 as usize
    }
}

impl fmt::Debug for Material {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl From<Material> for String {
    fn from(material: Material) -> Self {
        material.name().to_owned()
    }
}

impl TryFrom<String> for Material {
    type Error = String;

    fn try_from(name: String) -> Result<Self, Self::Error> {
        Self::named(&name).ok_or_else(|| format!("there is no material \"{name}\""))
    }
}
