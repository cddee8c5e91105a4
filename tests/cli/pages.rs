//! The documentation: commands print what is shown, flags exist, links lead somewhere, and the README stays
//! short.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use pulldown_cmark::{Event, Parser, Tag, TagEnd};

use super::{shell, words};
use crate::documents::{blocks, pages, run_blocks};

#[test]
#[cfg_attr(not(unix), ignore = "the examples are for a Unix shell")]
fn every_example_prints_what_is_shown() {
    let mut examples = 0;
    for (path, page) in pages() {
        for block in page.split("```console\n$ ").skip(1) {
            let (block, _) = block.split_once("```").expect("the block ends");
            let (line, shown) = block.split_once('\n').expect("the output follows");
            let scratch = tempfile::tempdir().expect("there is a folder for temporary files");
            let outcome = shell(line, scratch.path());
            let printed = String::from_utf8_lossy(&outcome.stdout) + outcome.stderr.as_str();
            assert_eq!(printed, shown, "{}: {line}", path.display());
            examples += 1;
        }
    }
    assert!(examples >= 3, "{examples}");
}

/// Pictures of the window are compared where there is a graphics device: in the tests of the window.
#[test]
#[cfg_attr(not(unix), ignore = "the examples are for a Unix shell")]
fn every_block_of_commands_runs_and_gives_the_pictures_shown() {
    let count = run_blocks(|block| !block.contains("--screenshot"));
    assert!(count >= 8, "{count}");
}

/// Commands of `gamow` that the shell blocks of `page` show, each in one line; loops fill in a number.
fn commands(page: &str) -> Vec<String> {
    let blocks = ["sh", "shell"].into_iter().flat_map(|language| blocks(page, language));
    let lines = blocks.map(|block| block.replace("\\\n", " ").replace("$T", "2")).collect::<String>();
    lines.lines().map(str::trim).filter(|line| line.starts_with("gamow ")).map(str::to_owned).collect()
}

/// Help is asked for last, so that the parser has accepted everything before it, and nothing is drawn.
#[test]
#[cfg_attr(not(unix), ignore = "the examples are for a Unix shell")]
fn every_command_shown_is_accepted_by_its_parser() {
    let scratch = tempfile::tempdir().expect("there is a folder for temporary files");
    let mut count = 0;
    for (path, page) in pages() {
        for command in commands(&page) {
            let outcome = shell(&format!("{command} --help"), scratch.path());
            assert_eq!(outcome.stderr.as_str(), "", "{}: {command}", path.display());
            assert!(String::from_utf8_lossy(&outcome.stdout).contains("Usage: gamow"), "{command}");
            count += 1;
        }
    }
    assert!(count >= 12, "{count}");
}

/// The words of `text` that are flags, such as `--size`.
fn flags(text: &str) -> impl Iterator<Item = &str> {
    let ends = |letter: char| !(letter.is_ascii_alphanumeric() || letter == '-');
    text.split(|letter: char| letter.is_whitespace() || "`(['\"".contains(letter)).filter_map(move |word| {
        let flag = word.strip_prefix("--")?;
        let end = flag.find(ends).unwrap_or(flag.len());
        Some(&flag[..end]).filter(|flag| flag.starts_with(|letter: char| letter.is_ascii_lowercase()))
    })
}

#[test]
fn every_flag_of_gamow_that_a_page_names_exists() {
    let commands =
        ["", "render", "curve", "eval", "fit", "measure", "rectify", "lesson", "accuracy", "paper", "man"];
    let help: Vec<String> =
        commands.iter().map(|command| words(&format!("{command} --help")).text()).collect();
    let known: BTreeSet<&str> = help.iter().flat_map(|text| flags(text)).collect();
    assert!(known.len() > 100, "{}", known.len());
    for (path, page) in pages() {
        // Lines of other programs have flags of their own.
        let of_gamow = page.lines().filter(|line| !line.contains("cargo "));
        for flag in of_gamow.flat_map(flags) {
            assert!(known.contains(flag), "{}: --{flag}", path.display());
        }
    }
}

/// The anchor that a heading has on a forge: its words in small letters, joined by hyphens.
fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase().replace(' ', "-");
    kept.chars().filter(|letter| letter.is_alphanumeric() || "-_".contains(*letter)).collect()
}

fn anchors(page: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut heading: Option<String> = None;
    for event in Parser::new(page) {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::Text(text) | Event::Code(text) => heading.iter_mut().for_each(|all| all.push_str(&text)),
            Event::End(TagEnd::Heading(_)) => found.extend(heading.take().map(|all| anchor(&all))),
            _ => {}
        }
    }
    found
}

#[test]
fn every_link_leads_to_a_file_or_a_heading() {
    let mut links = 0;
    for (path, page) in pages() {
        for event in Parser::new(&page) {
            let Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) = event else {
                continue;
            };
            if dest_url.contains("://") || dest_url.starts_with("mailto:") {
                continue;
            }
            let (file, place) = dest_url.split_once('#').unwrap_or((&dest_url, ""));
            let target = if file.is_empty() { path.clone() } else { path.with_file_name("").join(file) };
            assert!(target.exists(), "{}: {dest_url}", path.display());
            if !place.is_empty() {
                let there = anchors(&fs::read_to_string(&target).expect("a page"));
                assert!(there.contains(place), "{}: {dest_url} among {there:?}", path.display());
            }
            links += 1;
        }
    }
    assert!(links > 40, "{links}");
}

#[test]
fn the_index_and_the_site_have_every_page() {
    let index = include_str!("../../docs/README.md");
    let site = include_str!("../../mkdocs.yml");
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/docs"));
    for (path, _) in pages().into_iter().filter(|(path, _)| path.parent() == Some(folder)) {
        let name = path.file_name().expect("a file").to_string_lossy();
        assert!(
            name == "README.md" || index.contains(&format!("({name})")),
            "{name} is not in docs/README.md"
        );
        assert!(site.contains(&format!("- {name}\n")), "{name} is not in mkdocs.yml");
    }
}

#[test]
fn the_readme_is_read_in_minutes() {
    let readme = include_str!("../../README.md");
    let count = readme.split_whitespace().count();
    assert!(count <= 1300, "{count} words");
    for command in ["cargo run --release", "cargo test --workspace"] {
        assert!(readme.lines().any(|line| line == command), "{command}");
    }
}

/// Gamow is cited by the version that there is.
#[test]
fn the_citation_names_this_version() {
    let version = env!("CARGO_PKG_VERSION");
    assert!(include_str!("../../docs/cite.md").contains(&format!("version = {{{version}}}")));
    assert!(include_str!("../../CITATION.cff").lines().any(|line| line == format!("version: {version}")));
}

#[test]
fn the_changelog_is_short() {
    let count = include_str!("../../CHANGELOG.md").split_whitespace().count();
    assert!(count <= 400, "{count} words");
}
