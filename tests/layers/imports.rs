//! Which files of a crate import from which, and what they name of other crates.

use std::collections::{BTreeMap, BTreeSet};

use super::modules::{Modules, Path, modules};

/// The imports of a crate.
#[derive(Debug, Default)]
pub struct Imports {
    /// From which file to which other file.
    pub inside: BTreeSet<(String, String)>,
    /// Files, and the paths in other crates that they name.
    pub outside: BTreeSet<(String, String)>,
}

/// Most imports that lead on to another before one is taken for endless.
const LONGEST_CHAIN: usize = 16;

/// The imports among `sources`, the texts of the files of the crate `name` by their paths below `src/`.
pub fn imports(name: &str, sources: &BTreeMap<String, String>) -> Imports {
    let tree = Tree { name: name.replace('-', "_"), modules: modules(sources) };
    let mut imports = Imports::default();
    for (at, module) in &tree.modules {
        for path in module.imports.values().chain(&module.globs).chain(&module.paths) {
            let from = module.file.clone();
            match tree.file(at, path, LONGEST_CHAIN) {
                Some(to) if to == from => {}
                Some(to) => drop(imports.inside.insert((from, to.to_owned()))),
                None => drop(imports.outside.insert((from, path.join("::")))),
            }
        }
    }
    imports
}

struct Tree {
    name: String,
    modules: Modules,
}

impl Tree {
    /// The file that defines what `path` names in the module `at`; `None` if that is not of this crate.
    fn file(&self, at: &Path, path: &[String], chain: usize) -> Option<&str> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => self.within(&Path::new(), rest, chain),
            "self" => self.within(at, rest, chain),
            "super" => match rest.first() {
                Some(next) if next == "super" => self.file(&at[..at.len() - 1].to_vec(), rest, chain),
                _ => self.within(&at[..at.len() - 1].to_vec(), rest, chain),
            },
            name if name == self.name => self.within(&Path::new(), rest, chain),
            _ => self.named(at, path, chain),
        }
    }

    /// The same for a path inside the module `at`, whose own file it is if nothing else is found.
    fn within(&self, at: &Path, path: &[String], chain: usize) -> Option<&str> {
        let own = &self.modules.get(at)?.file;
        Some(self.named(at, path, chain).unwrap_or(own))
    }

    /// The same for a path whose first segment is a name in the module `at`.
    fn named(&self, at: &Path, path: &[String], chain: usize) -> Option<&str> {
        let module = self.modules.get(at).filter(|_| chain > 0)?;
        let (first, rest) = path.split_first()?;
        let child: Path = at.iter().chain([first]).cloned().collect();
        if self.modules.contains_key(&child) {
            return self.within(&child, rest, chain);
        }
        if module.items.contains(first) {
            return Some(&module.file);
        }
        if let Some(source) = module.imports.get(first) {
            let whole: Path = source.iter().chain(rest).cloned().collect();
            // A crate may be called as a name that is imported from it.
            return (whole != path).then(|| self.file(at, &whole, chain - 1)).flatten();
        }
        // An import of all that is in another crate begins with no name of this module. It is not followed:
        // two of them would look for the beginnings of each other.
        let begins_here = |glob: &&Path| {
            let child: Path = at.iter().chain(glob.first()).cloned().collect();
            ["crate", "self", "super", &self.name].contains(&glob[0].as_str())
                || self.modules.contains_key(&child)
                || module.items.contains(&glob[0])
                || module.imports.contains_key(&glob[0])
        };
        let source = |glob: &Path| {
            let whole: Path = glob.iter().chain(path).cloned().collect();
            self.file(at, &whole, chain - 1)
        };
        module.globs.iter().filter(begins_here).find_map(source)
    }
}

/// The circles: of each the files in order. Through every import that is part of one, the shortest.
pub fn circles(inside: &BTreeSet<(String, String)>) -> Vec<Vec<String>> {
    let mut circles: Vec<Vec<String>> = Vec::new();
    let inside = without_ends(inside);
    for (from, to) in &inside {
        let is_known = circles.iter().any(|circle| circle.contains(from) && circle.contains(to));
        if let Some(way) = (!is_known).then(|| shortest_way(&inside, to, from)).flatten() {
            circles.push(way);
        }
    }
    circles
}

/// Returns the imports from which every way goes on, in both directions: those in a circle or between
/// circles.
fn without_ends(inside: &BTreeSet<(String, String)>) -> BTreeSet<(String, String)> {
    let mut left = inside.clone();
    loop {
        let [importing, imported]: [BTreeSet<String>; 2] = [
            left.iter().map(|(from, _)| from.clone()).collect(),
            left.iter().map(|(_, to)| to.clone()).collect(),
        ];
        let count = left.len();
        left.retain(|(from, to)| imported.contains(from) && importing.contains(to));
        if left.len() == count {
            return left;
        }
    }
}

/// The files on the shortest way along `inside` from one file to another.
fn shortest_way(inside: &BTreeSet<(String, String)>, from: &str, to: &str) -> Option<Vec<String>> {
    let mut ways = vec![vec![from.to_owned()]];
    let mut seen = BTreeSet::from([from]);
    while !ways.is_empty() {
        let mut longer = Vec::new();
        for way in ways {
            let last = way.last()?;
            if last == to {
                return Some(way);
            }
            for (_, next) in inside.iter().filter(|(a, _)| a == last) {
                if seen.insert(next) {
                    longer.push(way.iter().chain([next]).cloned().collect());
                }
            }
        }
        ways = longer;
    }
    None
}
