//! The modules of a crate, read from its sources: what each defines, imports and names.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// The segments of a path, such as `super`, `view`, `View`.
pub type Path = Vec<String>;

/// A module: what a file holds, or a part of it.
#[derive(Debug, Default)]
pub struct Module {
    /// The file.
    pub file: String,
    /// Names of items, other than modules.
    pub items: BTreeSet<String>,
    /// The paths that names are imported from.
    pub imports: BTreeMap<String, Path>,
    /// The paths everything is imported from.
    pub globs: BTreeSet<Path>,
    /// The other paths of two segments and more.
    pub paths: BTreeSet<Path>,
}

/// The modules by their paths; that of the crate's root is empty. Those for tests only are left out.
pub type Modules = BTreeMap<Path, Module>;

/// The modules in `sources`, the texts of files by their paths below `src/`.
pub fn modules(sources: &BTreeMap<String, String>) -> Modules {
    let mut modules = Modules::new();
    for (root, path) in [("lib.rs", vec![]), ("main.rs", vec!["main".to_owned()])] {
        if sources.contains_key(root) {
            read_file(sources, root, &path, &mut modules);
        }
    }
    modules
}

fn read_file(sources: &BTreeMap<String, String>, file: &str, path: &Path, modules: &mut Modules) {
    let tokens: TokenStream = sources[file].parse().unwrap_or_else(|error| panic!("{file}: {error}"));
    let declared = read(tokens, file, path, modules);
    for name in declared {
        let child: Path = path.iter().chain([&name]).cloned().collect();
        let stem = child.join("/");
        let candidates = [format!("{stem}.rs"), format!("{stem}/mod.rs")];
        let found = candidates.iter().find(|candidate| sources.contains_key(*candidate));
        let found = found.unwrap_or_else(|| panic!("{file}: there is no file for `mod {name}`"));
        read_file(sources, found, &child, modules);
    }
}

/// Reads `tokens` as the module `path` in `file`; the names of the modules that have files of their own.
fn read(tokens: TokenStream, file: &str, path: &Path, modules: &mut Modules) -> Vec<String> {
    let mut reader =
        Reader { module: Module { file: file.to_owned(), ..Module::default() }, ..Reader::default() };
    reader.items(tokens);
    for (name, body) in reader.inline {
        let child = path.iter().chain([&name]).cloned().collect();
        let nested = read(body, file, &child, modules);
        assert!(nested.is_empty(), "{file}: `mod {name}` declares files, which this reader does not follow");
    }
    modules.insert(path.clone(), reader.module);
    reader.declared
}

#[derive(Default)]
struct Reader {
    module: Module,
    declared: Vec<String>,
    inline: Vec<(String, TokenStream)>,
}

impl Reader {
    /// Reads the items of a module.
    fn items(&mut self, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let (mut at, mut for_tests) = (0, false);
        while at < tokens.len() {
            let length = item_length(&tokens[at..]);
            let item = &tokens[at..at + length];
            if let Some(attribute) = attribute(item) {
                for_tests |= attribute.stream().to_string().replace(' ', "") == "cfg(test)";
            } else {
                if !for_tests {
                    self.item(item);
                }
                for_tests = false;
            }
            at += length;
        }
    }

    fn item(&mut self, item: &[TokenTree]) {
        match (kind_and_name(item), item.last()) {
            (Some(("mod", name)), Some(TokenTree::Group(body))) => self.inline.push((name, body.stream())),
            (Some(("mod", name)), _) => self.declared.push(name),
            (Some(("use" | "impl", _)) | None, _) => self.body(item),
            (Some((_, name)), _) => {
                self.module.items.insert(name);
                self.body(item);
            }
        }
    }

    /// Reads everything inside an item: imports and paths, also those in attributes and macros.
    fn body(&mut self, tokens: &[TokenTree]) {
        let mut at = 0;
        while at < tokens.len() {
            match &tokens[at] {
                TokenTree::Group(group) => {
                    self.body(&group.stream().into_iter().collect::<Vec<_>>());
                    at += 1;
                }
                TokenTree::Ident(word) if word == "use" => {
                    let rest = &tokens[at + 1..];
                    let length = rest.iter().take_while(|token| !is_punct(token, ';')).count();
                    self.import(&Path::new(), &rest[..length]);
                    at += 1 + length;
                }
                // The path in `pub(in path)` is no import.
                TokenTree::Ident(word) if word == "pub" => {
                    let is_limit = matches!(
                        tokens.get(at + 1),
                        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis
                    );
                    at += 1 + usize::from(is_limit);
                }
                TokenTree::Ident(_) => {
                    let (path, length) = leading_path(&tokens[at..]);
                    if path.len() > 1 {
                        self.module.paths.insert(path);
                    }
                    at += length;
                }
                _ => at += 1,
            }
        }
    }

    /// Reads a tree of imports below `prefix`.
    fn import(&mut self, prefix: &Path, tree: &[TokenTree]) {
        let (path, length) = leading_path(tree);
        let whole: Path = prefix.iter().chain(&path).cloned().collect();
        match tree.get(length..) {
            Some([]) => {
                let whole = if path == ["self"] { prefix.clone() } else { whole };
                self.module.imports.extend(whole.last().cloned().map(|name| (name, whole)));
            }
            Some([TokenTree::Ident(_), TokenTree::Ident(name)]) => {
                self.module.imports.insert(name.to_string(), whole);
            }
            Some([.., TokenTree::Group(group)]) => {
                let inside: Vec<TokenTree> = group.stream().into_iter().collect();
                for branch in inside.split(|token| is_punct(token, ',')).filter(|branch| !branch.is_empty()) {
                    self.import(&whole, branch);
                }
            }
            _ => drop(self.module.globs.insert(whole)),
        }
    }
}

/// Words that begin an item, and those that may stand before them.
const KINDS: [&str; 12] = [
    "mod",
    "use",
    "impl",
    "fn",
    "struct",
    "enum",
    "union",
    "trait",
    "type",
    "static",
    "const",
    "macro_rules",
];
const BEFORE: [&str; 4] = ["pub", "unsafe", "async", "extern"];

/// The word that `item` begins with, and the one after that: its name, if it has one.
fn kind_and_name(item: &[TokenTree]) -> Option<(&'static str, String)> {
    let words: Vec<String> = item.iter().take(12).filter_map(word).collect();
    let is_before = |word: &str| BEFORE.contains(&word);
    let is_modifier = |at: usize| {
        let next = words.get(at + 1).map_or("", String::as_str);
        is_before(&words[at]) || words[at] == "const" && (next == "fn" || is_before(next))
    };
    let head = (0..words.len()).find(|&at| !is_modifier(at))?;
    let kind = KINDS.into_iter().find(|kind| *kind == words[head])?;
    Some((kind, words.get(head + 1).cloned().unwrap_or_default()))
}

fn word(token: &TokenTree) -> Option<String> {
    if let TokenTree::Ident(word) = token { Some(word.to_string()) } else { None }
}

/// How many of `tokens` the first item, or attribute, takes.
fn item_length(tokens: &[TokenTree]) -> usize {
    if is_punct(&tokens[0], '#') {
        let bang = usize::from(tokens.get(1).is_some_and(|token| is_punct(token, '!')));
        return (2 + bang).min(tokens.len());
    }
    let ends_with_body = !matches!(kind_and_name(tokens), Some(("use" | "type" | "static" | "const", _)));
    let is_body = |token: &TokenTree| {
        ends_with_body && matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
    };
    let end = tokens.iter().position(|token| is_punct(token, ';') || is_body(token));
    end.map_or(tokens.len(), |end| end + 1)
}

fn attribute(item: &[TokenTree]) -> Option<&Group> {
    match item {
        [first, .., TokenTree::Group(group)] if is_punct(first, '#') => Some(group),
        _ => None,
    }
}

/// The path that `tokens` begin with, and how many of them it takes, a `::` at its end included.
fn leading_path(tokens: &[TokenTree]) -> (Path, usize) {
    let (mut path, mut at) = (Path::new(), 0);
    while let Some(TokenTree::Ident(word)) = tokens.get(at) {
        path.push(word.to_string());
        at += 1;
        let [Some(first), Some(second)] = [at, at + 1].map(|at| tokens.get(at)) else { break };
        if !is_punct(first, ':') || !is_punct(second, ':') {
            break;
        }
        at += 2;
    }
    (path, at)
}

fn is_punct(token: &TokenTree, mark: char) -> bool {
    matches!(token, TokenTree::Punct(punct) if punct.as_char() == mark)
}
