//! The parts of a model that its file names: nodes of glTF, objects and groups of OBJ.

use std::ops::Range;

use gamow_platform::messages;
use relativity_render::RawModel;

use crate::similar::nearest;

/// A model, and the named parts of its file.
#[derive(Default)]
pub(super) struct NamedModel {
    pub model: RawModel,
    pub parts: Vec<NamedPart>,
    /// Number of its materials.
    pub materials: usize,
}

/// A part of a model.
pub(super) struct NamedPart {
    pub name: String,
    /// Ranges of its triangles in the model.
    pub triangles: Vec<Range<usize>>,
}

/// A model, and parts that were taken out of it.
pub(super) struct Split {
    /// The rest, if there is any.
    pub rest: Option<RawModel>,
    /// The parts, as they were named.
    pub parts: Vec<RawModel>,
}

impl NamedModel {
    /// Returns the parts with these names, and the model without them.
    ///
    /// # Errors
    ///
    /// A name of no part, or of several; a part without triangles; two parts with triangles in common. In one
    /// line.
    pub fn split(&self, names: &[&str]) -> Result<Split, String> {
        if names.is_empty() {
            return Ok(Split { rest: Some(self.model.clone()), parts: Vec::new() });
        }
        let mut owners: Vec<Option<usize>> = vec![None; self.model.triangles.len()];
        for (number, name) in names.iter().enumerate() {
            for triangle in self.part(name)?.triangles.iter().cloned().flatten() {
                if let Some(other) = owners[triangle].replace(number) {
                    let [one, other] = [name, names[other]].map(messages::excerpt);
                    return Err(format!("`{one}` and `{other}` have triangles in common"));
                }
            }
        }
        let of = |owner| taken(&self.model, owners.iter().enumerate().filter(|(_, own)| **own == owner));
        let rest = Some(of(None)).filter(|rest| !rest.triangles.is_empty());
        Ok(Split { rest, parts: (0..names.len()).map(|number| of(Some(number))).collect() })
    }

    /// Returns the only part of this name, which must have triangles.
    fn part(&self, name: &str) -> Result<&NamedPart, String> {
        let shown = messages::excerpt(name);
        let mut called = self.parts.iter().filter(|part| part.name == name);
        match (called.next(), called.next()) {
            (Some(part), None) if part.triangles.iter().all(Range::is_empty) => {
                Err(format!("`{shown}` has no triangles"))
            }
            (Some(part), None) => Ok(part),
            (Some(_), Some(_)) => {
                Err(format!("several parts are called `{shown}`: give each a name of its own"))
            }
            (None, _) if self.parts.is_empty() => {
                Err(format!("no part is called `{shown}`: the model has no named parts"))
            }
            (None, _) => {
                let known = nearest(self.parts.iter().map(|part| part.name.as_str()), name);
                Err(format!("no part is called `{shown}`: the nearest are {known}"))
            }
        }
    }
}

/// Returns these triangles of `model`, with their corners and textures alone.
fn taken<'a>(model: &RawModel, triangles: impl Iterator<Item = (usize, &'a Option<usize>)>) -> RawModel {
    let mut taken = RawModel { is_two_sided: model.is_two_sided, ..RawModel::default() };
    let mut corners = vec![u32::MAX; model.corners.len()];
    let mut textures = vec![u32::MAX; model.textures.len()];
    for (triangle, _) in triangles {
        let numbers = model.triangles[triangle].map(|corner| {
            let (number, old) = (&mut corners[corner as usize], corner as usize);
            if *number == u32::MAX {
                *number = taken.corners.len() as u32;
                taken.corners.push(model.corners[old]);
                taken.paints.extend(model.paints.get(old));
                taken.texture_places.extend(model.texture_places.get(old));
            }
            *number
        });
        taken.triangles.push(numbers);
        taken.reversed.extend(model.reversed.get(triangle));
        taken.materials.extend(model.materials.get(triangle));
        let Some(&texture) = model.texture_numbers.get(triangle) else { continue };
        let number = textures.get_mut(texture as usize).map_or(RawModel::NO_TEXTURE, |number| {
            if *number == u32::MAX {
                *number = taken.textures.len() as u32;
                taken.textures.push(model.textures[texture as usize].clone());
            }
            *number
        });
        taken.texture_numbers.push(number);
    }
    taken
}
