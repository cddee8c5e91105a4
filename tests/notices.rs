//! The notice of licences names all that the program is made of.

use std::collections::BTreeSet;

#[test]
fn every_library_has_its_notice() {
    let lock: toml::Table = include_str!("../Cargo.lock").parse().expect("it is TOML");
    let packages = lock["package"].as_array().expect("packages").iter();
    let field = |package: &toml::Value, key: &str| package[key].as_str().expect("a text").to_owned();
    let needed: BTreeSet<String> = packages
        .filter(|package| package.get("source").is_some())
        .map(|package| format!("{} {} (", field(package, "name"), field(package, "version")))
        .collect();
    assert!(needed.len() > 100);
    let notices = include_str!("../LICENSES-THIRD-PARTY.txt");
    let lines: BTreeSet<&str> = notices.lines().collect();
    let is_named = |needed: &&String| !lines.iter().any(|line| line.starts_with(needed.as_str()));
    let missing: Vec<_> = needed.iter().filter(is_named).collect();
    assert!(missing.is_empty(), "run `cargo run --example notices`: it lacks {missing:?}");
    for text in
        ["Apache License", "SIL OPEN FONT LICENSE", "Boost Software License", "Permission is hereby granted"]
    {
        assert!(notices.contains(text), "{text}");
    }
}
