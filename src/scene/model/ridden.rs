//! The scene of a model that is opened by itself: it rides on Gamow's street, in place of the cyclist.

use std::path::{Path, PathBuf};

use gamow_platform::{files, sizes};
use glam::DVec3;
use relativity_render::RawModel;

use super::limits::Room;
use super::{ModelFiles, one_line, read, stem, upright_axes};
use crate::scene::presets;

/// Height of the model, units of the street: that of the cyclist.
const HEIGHT: f64 = 2.55;
/// Greatest length and width of the model, for which one that is flat is made lower.
const LENGTH: f64 = 16.0;
/// y of the middle of the model, as of the cyclist, and the least y of its near side: the kerb is at 2.
const LANE: f64 = 4.0;
const LEAST_LANE: f64 = 2.2;
/// Height of the road.
const ROAD: f64 = -2.5;

/// Returns the text of the scene in which the model at `path` rides, for a scene file in `folder`, which has
/// the model in it or in a folder there.
///
/// # Errors
///
/// A model outside the folder, or that cannot be read, in one line.
pub fn text(path: &Path, folder: &Path) -> Result<String, String> {
    let name = path_within(path, folder)?;
    let model = read(&ModelFiles::Folder(folder), &name, &Room::default())
        .map_err(|reason| one_line(&reason))?
        .0
        .model;
    let street = presets::text("street").and_then(|text| Some(&text[text.find("[[group]]")?..]));
    let title: String = stem(&name).chars().take(sizes::NAME_LETTERS).collect();
    let quoted = |text: &str| toml::Value::from(text).to_string();
    let Stand { scale, angle, place } = Stand::of(&model);
    let [x, y, z] = place.map(|part| part as f32);
    Ok(format!(
        "# A model on Gamow's street, as tall as the cyclist: one unit is 0.65 m.\n\n\
         name = {title}\nrider = \"model\"\nmetres = 0.65\nground_z = {ROAD}\nstreet = [2.0, 9.0, 13.0]\n\n\
         [[model]]\npath = {name}\nname = {title}\nscale = {scale}\nangle = {angle}\nplace = [{x:?}, {y:?}, {z:?}]\n\n{street}",
        title = quoted(&title),
        name = quoted(&name),
        scale = scale as f32,
        street = street.unwrap_or_default(),
    ))
}

/// Returns the path of a file from a folder that it is in, or in a folder there.
fn path_within(path: &Path, folder: &Path) -> Result<String, String> {
    let real = |path: &Path| {
        files::canonical(path).map_err(|error| format!("cannot read {}: {error}", files::shown(path)))
    };
    let (own, around) = (real(path)?, if files::HAS_FOLDERS { real(folder)? } else { PathBuf::new() });
    let within = own.strip_prefix(&around).map_err(|_| {
        format!("{} must lie in the folder of the scene file, or in a folder there", files::shown(path))
    })?;
    let parts: Option<Vec<&str>> = within.iter().map(|part| part.to_str()).collect();
    parts.map(|parts| parts.join("/")).ok_or_else(|| "its name is not UTF-8 text".to_owned())
}

/// The placement of a model on the road.
struct Stand {
    scale: f64,
    /// The turn about the upright axis, degrees.
    angle: i32,
    /// Place of the file's origin.
    place: [f64; 3],
}

impl Stand {
    /// Returns that of `model`: its front along the road, at x = 0.
    ///
    /// The front of a glTF looks along its z axis, and so what OBJ files from most programs show. A vehicle,
    /// longer than it is high, is turned so that its longer side is along the road.
    fn of(model: &RawModel) -> Self {
        let upright = upright_axes();
        let used = model.triangles.iter().flatten().filter_map(|&corner| model.corners.get(corner as usize));
        let [low, high] = used.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], &corner| {
            let corner = upright * DVec3::from(corner);
            [low.min(corner), high.max(corner)]
        });
        let size = high - low;
        let scale = (HEIGHT / size.z).min(LENGTH / size.x.max(size.y));
        if !(1e-6..=1e6).contains(&scale) {
            // Reading the scene says what is wrong with it.
            return Self { scale: 1.0, angle: 0, place: [0.0, LANE, ROAD] };
        }
        let is_along = size.x > size.y && size.x > size.z;
        // By a quarter turn, x becomes y and -y becomes x.
        let [front, left, right] = if is_along { [high.x, low.y, high.y] } else { [-low.y, low.x, high.x] };
        let half_width = 0.5 * scale * (right - left);
        let y = (LEAST_LANE + half_width).max(LANE) - 0.5 * scale * (left + right);
        let place = [-scale * front, y, ROAD - scale * low.z];
        Self { scale, angle: if is_along { 0 } else { 90 }, place }
    }
}
