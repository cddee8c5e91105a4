//! Writes `LICENSES-THIRD-PARTY.txt`: the licences of all that Gamow is made of, from the sources in cargo's
//! registry.
//!
//! ```text
//! cargo fetch --locked && cargo run --example notices
//! ```
//!
//! Where a library offers a choice, Apache-2.0 is taken, whose text is the same for all; of the others each
//! has its own.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::Context as _;
use toml::Table;

/// The file that is written.
const NOTICES: &str = "LICENSES-THIRD-PARTY.txt";
/// The text of the MIT licence, for libraries that name it without having it.
const MIT: &str = include_str!("../LICENSE-MIT");
const RULE: &str = "--------------------------------------------------------------------------------";

fn main() -> anyhow::Result<()> {
    let lock: Table = fs::read_to_string("Cargo.lock")?.parse()?;
    let packages = lock["package"].as_array().context("Cargo.lock has packages")?;
    let registry = registry()?;
    let mut texts: BTreeMap<String, Vec<String>> = BTreeMap::new();
    let mut under_apache = Vec::new();
    for package in packages.iter().filter(|package| package.get("source").is_some()) {
        let field = |key: &str| package.get(key).and_then(toml::Value::as_str).context("a text");
        let (name, version) = (field("name")?, field("version")?);
        let folder = registry.join(format!("{name}-{version}"));
        let manifest: Table = fs::read_to_string(folder.join("Cargo.toml"))
            .with_context(|| format!("{name} {version}: run `cargo fetch --locked` first"))?
            .parse()?;
        let licence =
            manifest["package"].get("license").and_then(toml::Value::as_str).context("a licence")?;
        let title = format!("{name} {version} ({licence})");
        let is_apache =
            !licence.contains("AND") && licence.split(['/', ' ', '(', ')']).any(|name| name == "Apache-2.0");
        let mut found = Vec::new();
        texts_in(&folder, is_apache, &mut found)?;
        if is_apache {
            under_apache.push(title.clone());
        } else if found.is_empty() {
            let is_standard = ["BSD-2-Clause", "BSL-1.0", "MIT"].contains(&licence);
            anyhow::ensure!(is_standard, "{title} has no text of its licence");
            found.push(standard(name, licence, &manifest, &registry)?);
        }
        for text in found {
            texts.entry(text).or_default().push(title.clone());
        }
    }
    let own = fs::read_to_string("assets/fonts/OFL.txt")?;
    texts.entry(plain(&own)).or_default().push("KaTeX's fonts (OFL-1.1)".to_owned());
    let apache = plain(&fs::read_to_string("LICENSE-APACHE")?);
    let mut out = "Gamow holds or is built with what follows, under these licences.\n".to_owned();
    write!(
        out,
        "\n{RULE}\nUnder the Apache License, Version 2.0:\n\n{}\n\n{apache}\n",
        under_apache.join("\n")
    )?;
    let mut texts: Vec<_> = texts.into_iter().map(|(text, titles)| (titles, text)).collect();
    texts.sort();
    for (titles, text) in texts {
        write!(out, "\n{RULE}\n{}\n\n{text}\n", titles.join("\n"))?;
    }
    fs::write(NOTICES, out)?;
    Ok(())
}

/// The folder of the sources from crates.io.
fn registry() -> anyhow::Result<PathBuf> {
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home.or_else(|| Some(env::home_dir()?.join(".cargo"))).context("a home")?;
    let mut folders = fs::read_dir(home.join("registry/src"))?;
    Ok(folders.next().context("run `cargo fetch --locked` first")??.path())
}

/// Adds the licences and notices in `folder` and in its fonts to `found`; `notices` alone, if that is all
/// that is needed.
fn texts_in(folder: &Path, notices: bool, found: &mut Vec<String>) -> anyhow::Result<()> {
    let mut paths: Vec<_> =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<anyhow::Result<_>>()?;
    paths.sort();
    for path in paths {
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_lowercase();
        let is_text = path.extension().is_none_or(|ending| ending == "txt" || ending == "md")
            || name.contains("license-");
        let is_licence =
            ["licen", "copying", "copyright", "unlicense"].iter().any(|begin| name.starts_with(begin));
        let is_wanted = name.starts_with("notice") || is_licence && !notices;
        if path.is_dir() && name == "fonts" {
            for entry in fs::read_dir(&path)? {
                let path = entry?.path();
                if path.extension().is_some_and(|ending| ending == "txt") {
                    found.push(plain(&fs::read_to_string(path)?));
                }
            }
        } else if path.is_file() && is_text && is_wanted {
            found.push(plain(&String::from_utf8_lossy(&fs::read(&path)?)));
        }
    }
    found.sort();
    Ok(())
}

/// The standard text of a `licence` that the library `name` has without its text.
fn standard(name: &str, licence: &str, manifest: &Table, registry: &Path) -> anyhow::Result<String> {
    let beside = fs::read_dir(registry)?.filter_map(Result::ok).map(|entry| entry.path());
    let texts = |file| beside.filter_map(move |folder| fs::read_to_string(folder.join(file)).ok());
    if licence == "BSL-1.0" {
        return Ok(plain(&texts("LICENSE-BOOST").next().context("the text of BSL-1.0")?));
    }
    let authors = manifest["package"].get("authors").and_then(toml::Value::as_array);
    let authors: Vec<_> = authors.into_iter().flatten().filter_map(toml::Value::as_str).collect();
    let holder = if authors.is_empty() { format!("the authors of {name}") } else { authors.join(", ") };
    if licence == "BSD-2-Clause" {
        let mut texts = texts("LICENSE").filter(|text| text.starts_with("BSD 2-Clause"));
        let text = texts.next().context("the text of BSD-2-Clause")?;
        let (_, terms) = text.split_once("All rights").context("the terms of BSD-2-Clause")?;
        return Ok(plain(&format!("BSD 2-Clause License\n\nCopyright (c) {holder}\nAll rights{terms}")));
    }
    let (_, terms) = MIT.split_once("Permission is").context("the terms of MIT")?;
    Ok(plain(&format!("MIT License\n\nCopyright (c) {holder}\n\nPermission is{terms}")))
}

/// `text` without spaces at the ends of its lines.
fn plain(text: &str) -> String {
    let lines: Vec<_> = text.trim_start_matches('\u{feff}').lines().map(str::trim_end).collect();
    lines.join("\n").trim_matches('\n').to_owned()
}
