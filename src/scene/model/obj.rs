//! Wavefront OBJ: corners, faces, and the colours of corners and materials.
//!
//! Faces are divided from their first corner, as flat convex ones may be. Everything else in a file (normals, textures, lines,
//! smoothing) is passed over.

use std::collections::HashMap;
use std::str::SplitWhitespace;

use relativity_render::Model;
use relativity_render::colour::srgb_decoded;

use super::limits::check_count;

/// Paint of what has none.
const WHITE: [f32; 3] = [1.0; 3];

/// Reads a model; `beside` reads the files that it names.
pub(super) fn model(bytes: &[u8], beside: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> Result<Model, String> {
    let text = text_of(bytes)?;
    let mut reader = Reader::default();
    for (number, line) in text.lines().enumerate() {
        reader.line(line, beside).map_err(|problem| format!("line {} of it: {problem}", number + 1))?;
    }
    Ok(reader.model)
}

fn text_of(bytes: &[u8]) -> Result<&str, String> {
    std::str::from_utf8(bytes).map_err(|_| "it is not text in UTF-8".to_owned())
}

/// The part of a file that was read.
#[derive(Default)]
struct Reader {
    places: Vec<[f64; 3]>,
    colours: Vec<Option<[f32; 3]>>,
    materials: HashMap<String, [f32; 3]>,
    paint: Option<[f32; 3]>,
    /// Numbers of the model's corners, by that in the file and the paint of its material, as bits.
    corners: HashMap<(usize, [u32; 3]), u32>,
    model: Model,
}

impl Reader {
    fn line(&mut self, line: &str, beside: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> Result<(), String> {
        let line = line.split('#').next().unwrap_or_default().trim();
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        match word {
            "v" => self.corner(rest.split_whitespace()),
            "f" => self.face(rest.split_whitespace()),
            "mtllib" => self.library(rest.trim(), beside),
            "usemtl" => {
                self.paint = self.materials.get(rest.trim()).copied();
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// Three coordinates, and three parts of an sRGB colour if there are any.
    fn corner(&mut self, words: SplitWhitespace<'_>) -> Result<(), String> {
        let numbers = numbers(words)?;
        let (&[x, y, z], rest) = numbers.split_first_chunk().ok_or("a corner needs three coordinates")?;
        self.places.push([x, y, z]);
        let colour = <[f64; 3]>::try_from(rest).ok();
        if colour.is_some_and(|colour| colour.iter().any(|part| !(0.0..=1.0).contains(part))) {
            return Err("each part of a colour must lie between 0 and 1".to_owned());
        }
        self.colours.push(colour.map(|colour| colour.map(|part| srgb_decoded(part) as f32)));
        Ok(())
    }

    fn face(&mut self, words: SplitWhitespace<'_>) -> Result<(), String> {
        let mut corners = Vec::new();
        for word in words {
            let number = word.split('/').next().unwrap_or_default();
            corners.push(self.corner_called(number)?);
        }
        let [first, rest @ ..] = &corners[..] else { return Err("a face needs three corners".to_owned()) };
        if rest.len() < 2 {
            return Err("a face needs three corners".to_owned());
        }
        check_count(self.model.triangles.len() + rest.len() - 1)?;
        self.model.triangles.extend(rest.array_windows().map(|&[second, third]| [*first, second, third]));
        Ok(())
    }

    /// Returns the number of the model's corner that a face calls so: from 1, or below 0 from the last one back.
    fn corner_called(&mut self, word: &str) -> Result<u32, String> {
        let count = self.places.len();
        let number = word.parse::<i64>().ok().and_then(|number| match number {
            1.. => usize::try_from(number - 1).ok(),
            0 => None,
            _ => usize::try_from(number.unsigned_abs()).ok().and_then(|back| count.checked_sub(back)),
        });
        let Some(place) = number.filter(|number| *number < count) else {
            return Err(format!("a face names corner {}, and so far there are {count}", shortened(word)));
        };
        let paint = self.colours[place].or(self.paint).unwrap_or(WHITE);
        let model = &mut self.model;
        Ok(*self.corners.entry((place, paint.map(f32::to_bits))).or_insert_with(|| {
            model.corners.push(self.places[place]);
            model.paints.push(paint);
            model.corners.len() as u32 - 1
        }))
    }

    /// Reads the diffuse colours, linear, of the materials in the file called `name`.
    fn library(
        &mut self,
        name: &str,
        beside: &dyn Fn(&str) -> Result<Vec<u8>, String>,
    ) -> Result<(), String> {
        let bytes = beside(name)?;
        let mut material = String::new();
        for line in text_of(&bytes)?.lines() {
            let (word, rest) = line.trim().split_once(char::is_whitespace).unwrap_or((line, ""));
            match word {
                "newmtl" => rest.trim().clone_into(&mut material),
                "Kd" => {
                    let parts = numbers(rest.split_whitespace())?;
                    let colour = parts
                        .first_chunk::<3>()
                        .ok_or_else(|| format!("Kd in {name} needs three numbers"))?;
                    self.materials.insert(material.clone(), colour.map(|part| part.clamp(0.0, 1.0) as f32));
                }
                _ => {}
            }
        }
        Ok(())
    }
}

fn numbers(words: SplitWhitespace<'_>) -> Result<Vec<f64>, String> {
    let number = |word: &str| word.parse().map_err(|_| format!("{} is not a number", shortened(word)));
    words.map(number).collect()
}

/// The beginning of a word, for a message.
fn shortened(word: &str) -> String {
    word.chars().take(20).collect()
}
