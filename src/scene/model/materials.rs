//! The materials of an OBJ file: diffuse colours and pictures, from the libraries (`.mtl`) that it names.

use std::collections::{HashMap, HashSet};

use gamow_platform::{messages, sizes};
use relativity_render::Wrap;
use tobj::MTLLoadResult;

use super::companions::Companions;
use super::text::{Statements, text_of, word_and_name};

/// Largest number of libraries of a model.
const MOST_LIBRARIES: usize = 1000;
/// Largest number of materials in all libraries of a model.
const MOST_MATERIALS: usize = 100_000;

/// A material of a library.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Material {
    /// The name by which faces use it.
    pub name: String,
    /// The diffuse colour, linear sRGB.
    pub diffuse: Option<[f32; 3]>,
    /// The picture that multiplies it.
    pub picture: Option<Map>,
    /// The picture whose opacity is its own.
    pub mask: Option<Map>,
}

/// A picture of a material.
#[derive(Debug, Clone, PartialEq)]
pub struct Map {
    /// The file's name, from the model's folder or from that of its library.
    pub file: String,
    /// The folder of its library from the model's, with a stroke behind it unless it is the same.
    pub folder: String,
    /// Scale of places in it, and what is added to them then.
    pub scale: [f64; 2],
    pub offset: [f64; 2],
    /// Continuation beyond its edges.
    pub wrap: Wrap,
}

/// The materials so far.
#[derive(Default)]
pub struct Materials {
    /// The materials, as the reader numbers them.
    pub all: Vec<Material>,
    libraries: HashSet<String>,
    bytes: u64,
}

impl Materials {
    /// Reads the libraries that a line calls `names`, each once, and returns the numbers of their materials.
    /// A missing one is remarked.
    ///
    /// # Errors
    ///
    /// More libraries, bytes or materials than a model may have.
    pub fn load(&mut self, names: &str, companions: &Companions<'_>) -> Result<MTLLoadResult, String> {
        let first = self.all.len();
        let names = if companions.is_one(names) { vec![names] } else { split(names) };
        names.into_iter().try_for_each(|name| self.load_one(name, companions))?;
        let numbers: HashMap<_, _> =
            self.all.iter().enumerate().skip(first).map(|(number, it)| (it.name.clone(), number)).collect();
        // The reader counts from the materials that it was given, which are none.
        Ok(Ok((Vec::new(), numbers.into_iter().collect())))
    }

    fn load_one(&mut self, name: &str, companions: &Companions<'_>) -> Result<(), String> {
        if !self.libraries.insert(name.to_owned()) {
            return Ok(());
        }
        if self.libraries.len() > MOST_LIBRARIES {
            return Err(format!("it has more than {MOST_LIBRARIES} material libraries"));
        }
        match companions.find(name, &[""]) {
            Ok(bytes) => self.read(name, &bytes, companions),
            Err(problem) => {
                companions.remark(format!("its materials are left out: {problem}"));
                Ok(())
            }
        }
    }

    /// Reads the library called `name`.
    fn read(&mut self, name: &str, bytes: &[u8], companions: &Companions<'_>) -> Result<(), String> {
        self.bytes += bytes.len() as u64;
        if self.bytes > sizes::MODEL_BYTES {
            let most = sizes::MODEL_BYTES;
            return Err(format!("its material libraries have more than {most} bytes, the most of a model"));
        }
        let folder = name.rfind(['/', '\\']).map_or("", |end| &name[..=end]).replace('\\', "/");
        let first = self.all.len();
        for (_, statement) in Statements::new(&text_of(bytes)) {
            let (word, rest) = word_and_name(&statement);
            if word == "newmtl" {
                self.all.push(Material { name: rest.to_owned(), ..Material::default() });
                if self.all.len() > MOST_MATERIALS {
                    return Err(format!("it has more than {MOST_MATERIALS} materials, the most of a model"));
                }
            }
            let Some(material) = self.all[first..].last_mut() else { continue };
            let needed = match word {
                "Kd" => {
                    material.diffuse = colour(rest);
                    material.diffuse.is_none().then_some("three numbers")
                }
                "map_Kd" | "map_d" => {
                    let map = Map::parse(word, rest, &folder, companions);
                    let needed = map.is_none().then_some("a file");
                    *(if word == "map_d" { &mut material.mask } else { &mut material.picture }) = map;
                    needed
                }
                _ => None,
            };
            if let Some(needed) = needed {
                let name = messages::excerpt(name);
                companions.remark(format!("{word} in {name} is left out, as it has not {needed}"));
            }
        }
        Ok(())
    }
}

/// Returns the names in a line of several libraries: each ends in `.mtl`.
fn split(names: &str) -> Vec<&str> {
    const ENDING: &str = ".mtl ";
    let lower = names.to_ascii_lowercase();
    let (mut all, mut start) = (Vec::new(), 0);
    for (place, _) in lower.match_indices(ENDING) {
        all.push(names[start..place + ENDING.len()].trim());
        start = place + ENDING.len();
    }
    all.push(names[start..].trim());
    all
}

/// Returns the colour in three numbers, or of all parts in one.
fn colour(text: &str) -> Option<[f32; 3]> {
    let numbers: Vec<f64> = text.split_whitespace().map_while(|word| word.parse().ok()).collect();
    let colour = match numbers[..] {
        [red, green, blue, ..] => [red, green, blue],
        [grey] => [grey; 3],
        _ => return None,
    };
    // What is no number is black.
    Some(colour.map(|part| if part.is_nan() { 0.0 } else { part.clamp(0.0, 1.0) as f32 }))
}

impl Map {
    /// Returns the picture of a statement that begins with `word`, after its options; those that are not
    /// known here are remarked.
    fn parse(word: &str, text: &str, folder: &str, companions: &Companions<'_>) -> Option<Self> {
        let folder = folder.to_owned();
        let mut map =
            Self { file: String::new(), folder, scale: [1.0; 2], offset: [0.0; 2], wrap: Wrap::Repeat };
        let mut rest = text.trim();
        while let Some((option, values)) = option(rest) {
            let (known, after) = match option {
                "-s" | "-o" | "-t" => {
                    let (numbers, after) = numbers(values);
                    match option {
                        "-s" => fill(&mut map.scale, &numbers),
                        "-o" => fill(&mut map.offset, &numbers),
                        _ => {}
                    }
                    (option != "-t", after)
                }
                "-mm" => (false, cut(cut(values).1).1),
                "-clamp" => {
                    let (value, after) = cut(values);
                    map.wrap = if value == "on" { Wrap::Clamp } else { Wrap::Repeat };
                    (true, after)
                }
                _ => (matches!(option, "-blendu" | "-blendv" | "-type"), cut(values).1),
            };
            if !known {
                companions.remark(format!("the option {option} of {word} is left out"));
            }
            rest = after;
        }
        rest.clone_into(&mut map.file);
        (!rest.is_empty()).then_some(map)
    }

    /// Returns a place of the file, from the bottom left, as it is in the picture, from the top left.
    pub fn placed(&self, [u, v]: [f64; 2]) -> [f32; 2] {
        let [u, v] = [u * self.scale[0] + self.offset[0], v * self.scale[1] + self.offset[1]];
        [u as f32, (1.0 - v) as f32]
    }
}

/// Returns the option that `text` begins with, if it does, and what is after it.
fn option(text: &str) -> Option<(&str, &str)> {
    const OPTIONS: [&str; 13] = [
        "-s", "-o", "-t", "-mm", "-clamp", "-blendu", "-blendv", "-cc", "-texres", "-imfchan", "-bm",
        "-boost", "-type",
    ];
    let (word, rest) = cut(text);
    OPTIONS.contains(&word).then_some((word, rest))
}

/// Returns up to three numbers at the beginning of `text`, and what is after them.
fn numbers(mut text: &str) -> (Vec<f64>, &str) {
    let mut numbers = Vec::new();
    while numbers.len() < 3 {
        let (word, rest) = cut(text);
        let Some(number) = word.parse().ok().filter(|number: &f64| number.is_finite()) else { break };
        numbers.push(number);
        text = rest;
    }
    (numbers, text)
}

fn fill(sides: &mut [f64; 2], numbers: &[f64]) {
    sides.iter_mut().zip(numbers).for_each(|(side, number)| *side = *number);
}

/// Returns the first word of `text`, and the rest.
fn cut(text: &str) -> (&str, &str) {
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    (word, rest.trim_start())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn loaded(names: &str, read: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> (Vec<Material>, Vec<String>) {
        let companions = Companions::new(read, &|_| None);
        let mut materials = Materials::default();
        for _ in 0..100 {
            materials.load(names, &companions).expect("few enough").expect("it is read");
        }
        (materials.all, companions.into_remarks())
    }

    #[test]
    fn libraries_may_be_several_with_blanks_in_their_names_and_are_read_once() {
        let read = |name: &str| match name {
            "a.mtl" | "my b.MTL" | "c d.mat" => Ok(format!("newmtl {name}\nKd 1 0 0").into_bytes()),
            _ => Err(format!("there is no {name}")),
        };
        let named = |names: &str| {
            let (materials, remarks) = loaded(names, &read);
            (materials.into_iter().map(|it| it.name).collect::<Vec<_>>(), remarks.len())
        };
        assert_eq!(named("a.mtl my b.MTL"), (vec!["a.mtl".to_owned(), "my b.MTL".to_owned()], 0));
        assert_eq!(named("none.mtl a.mtl"), (vec!["a.mtl".to_owned()], 1));
        assert_eq!(named("c d.mat"), (vec!["c d.mat".to_owned()], 0));
    }

    #[test]
    fn options_of_a_picture_come_before_its_name() {
        let picture = |text: &str| {
            let text = format!("newmtl a\nmap_Kd {text}\n").into_bytes();
            let (materials, remarks) = loaded("maps/a.mtl", &|_| Ok(text.clone()));
            (materials[0].picture.clone(), remarks)
        };
        let map = |file: &str, scale, offset, wrap| {
            Some(Map { file: file.to_owned(), folder: "maps/".to_owned(), scale, offset, wrap })
        };
        let plain = map("my wood.png", [1.0; 2], [0.0; 2], Wrap::Repeat);
        assert_eq!(picture("my wood.png"), (plain.clone(), Vec::new()));
        assert_eq!(picture("-blendu on -cc off my wood.png").0, plain);
        assert_eq!(
            picture("-bm 0.5 my wood.png"),
            (plain, vec!["the option -bm of map_Kd is left out".to_owned()])
        );
        let moved = map("-x.png", [2.0, 3.0], [0.5, 0.0], Wrap::Clamp);
        assert_eq!(picture("-s 2 3 1 -o 0.5 -clamp on -x.png"), (moved.clone(), Vec::new()));
        // Twice to the right, three times upwards, and half to the right.
        assert_eq!(moved.expect("it is there").placed([0.25, 0.25]), [1.0, 0.25]);
        let none = "map_Kd in maps/a.mtl is left out, as it has not a file";
        assert_eq!(picture("-s 1 1"), (None, vec![none.to_owned()]));
    }

    #[test]
    fn materials_are_bounded() {
        let text = (0..400).map(|number| format!("newmtl {number}")).collect::<Vec<_>>().join("\n");
        let read = |_: &str| Ok(text.clone().into_bytes());
        let companions = Companions::new(&read, &|_| None);
        let mut materials = Materials::default();
        let refused = (0..).find_map(|number| materials.load(&format!("{number}.mtl"), &companions).err());
        assert_eq!(refused.as_deref(), Some("it has more than 100000 materials, the most of a model"));
    }
}
