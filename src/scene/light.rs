//! The light of an object: the keys of a scene file, and the names of measured materials in models.

use relativity_render::colour::srgb_decoded;
use relativity_render::{Emission, Material, Paint};

use super::error::{Located, SceneProblem};
use super::table::Table;
use crate::similar::nearest;

/// Red, as in the paper.
const DEFAULT_WAVELENGTH_NM: f64 = 700.0;
/// Keys that say which light an object sends, of which it has one; and how bright that is.
pub(super) const KEYS: [&str; 6] = ["wavelength_nm", "light", "material", "paint", "glow_k", "brightness"];
/// Start of the name of a model's material that is a measured one.
const MEASURED: &str = "measured ";

/// Parses the light of an object: one wavelength by default.
pub(super) fn emission(object: &Table) -> Result<Emission, Located> {
    let mut given = KEYS.into_iter().filter(|&key| key != "brightness" && object.has(key));
    let first = given.next();
    if let (Some(other), Some(key)) = (first, given.next()) {
        return Err(object.problem_at(key, |value| SceneProblem::TwoLights { key, value, other }));
    }
    Ok(match first {
        Some("light") if object.string("light")? == Some("white") => Emission::WHITE,
        Some("light") => {
            return Err(object.wrong("light", "\"white\", or left out for light of one wavelength"));
        }
        Some("material") => Emission::Painted(Paint::Measured(material(object)?)),
        Some("paint") => Emission::Painted(Paint::Smooth(paint(object, "paint")?)),
        Some("glow_k") => Emission::Glowing(object.needed("glow_k", Table::size)?),
        _ => Emission::Wavelength(object.size("wavelength_nm")?.unwrap_or(DEFAULT_WAVELENGTH_NM)),
    })
}

/// Parses the brightness of an object relative to others: the greatest by default.
pub(super) fn brightness(object: &Table) -> Result<f64, Located> {
    let Some(brightness) = object.coordinate("brightness")? else { return Ok(1.0) };
    if brightness > 0.0 && brightness <= 1.0 {
        return Ok(brightness);
    }
    Err(object.wrong("brightness", "above 0 and at most 1"))
}

/// Returns the measured material that a model's material of this name is, if it begins with "measured "; else
/// it is paint.
pub(super) fn measured(name: &str) -> Result<Option<Material>, String> {
    let Some(name) = name.strip_prefix(MEASURED) else { return Ok(None) };
    let known = || format!("its material `{MEASURED}{name}` is none: the nearest are {}", nearest_to(name));
    Material::named(&name.replace(' ', "_")).map(Some).ok_or_else(known)
}

fn material(object: &Table) -> Result<Material, Located> {
    let name = object.needed("material", Table::string)?;
    Material::named(name).ok_or_else(|| {
        let nearest = nearest_to(name);
        object.problem_at("material", |value| SceneProblem::UnknownMaterial { value, nearest })
    })
}

fn nearest_to(name: &str) -> String {
    nearest(Material::ALL.map(Material::name), name)
}

/// Parses a colour in sRGB, as web pages write it, to linear parts.
pub(super) fn paint(object: &Table, key: &'static str) -> Result<[f64; 3], Located> {
    let text = object.needed(key, Table::string)?;
    let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6);
    let is_hexadecimal = |digits: &&str| digits.bytes().all(|digit| digit.is_ascii_hexdigit());
    let colour = digits.filter(is_hexadecimal).and_then(|digits| u32::from_str_radix(digits, 16).ok());
    let Some(colour) = colour else {
        return Err(object.wrong(key, "a colour in sRGB, such as \"#b3202a\""));
    };
    let [_, red, green, blue] = colour.to_be_bytes();
    Ok([red, green, blue].map(|part| srgb_decoded(f64::from(part) / 255.0)))
}
