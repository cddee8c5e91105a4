//! Parts of a Markdown text: the text below its headings, its blocks between fences, its lists of choices.

use gamow_platform::messages;

use super::wrong::Wrong;
use crate::lesson::plan::{Options, Text};

/// A part: the text below a heading.
#[derive(Debug)]
pub struct Part {
    /// Heading of the part; empty for the text before the first.
    pub title: String,
    /// The number of lines before the part's first.
    pub line: usize,
    /// Text below the heading.
    pub text: String,
}

/// A block between two fences.
#[derive(Debug)]
pub struct FencedBlock {
    /// Kind of the block, from its first fence.
    pub kind: String,
    /// Number of the block's first line in the file, from 1.
    pub line: usize,
    /// Lines of the block.
    pub text: String,
}

const FENCE: &str = "```";
/// At most this many letters of a title are compared with those that are known.
const EXCERPT: usize = 40;

/// Whether each block of `text` after its `first` lines has an end.
///
/// # Errors
/// The line in which one begins that has none.
pub fn check_blocks(text: &str, first: usize) -> Result<(), Wrong> {
    let mut open: Option<(usize, &str)> = None;
    for (number, line) in text.lines().enumerate().skip(first) {
        let Some(kind) = line.strip_prefix(FENCE) else { continue };
        match open {
            None => open = Some((number + 1, kind.trim())),
            Some(_) if kind.trim().is_empty() => open = None,
            Some((begin, kind)) => {
                return Err((begin, endless(kind, &format!(" before line {}", number + 1))));
            }
        }
    }
    open.map_or(Ok(()), |(begin, kind)| Err((begin, endless(kind, ""))))
}

/// Whether every line of `text` after its `first` lines that looks like a heading of a lesson is one, and every block is of a
/// kind in `known`, or of none: such a block is text. A slip would otherwise pass in silence, as text.
///
/// # Errors
/// The line of the first slip.
pub fn check_slips(text: &str, first: usize, titles: &[&str], known: &[&str]) -> Result<(), Wrong> {
    let mut is_block = false;
    for (number, line) in text.lines().enumerate().skip(first) {
        let wrong = |problem: String| Err((number + 1, problem));
        if let Some(kind) = line.strip_prefix(FENCE) {
            is_block = !is_block;
            let kind = kind.trim();
            if is_block && !kind.is_empty() && !known.contains(&kind) {
                let known = known.join(", ```");
                let kind = messages::excerpt(kind);
                return wrong(format!(
                    "unknown block ```{kind}: there are ```{known}, and ``` alone for text"
                ));
            }
            continue;
        }
        let marks = line.trim_start().chars().take_while(|c| *c == '#').count();
        if is_block || marks == 0 || marks > 6 {
            continue;
        }
        let after = &line.trim_start()[marks..];
        let right = format!("{} {}", "#".repeat(marks.clamp(2, 3)), messages::excerpt(after));
        if !after.is_empty() && !after.starts_with([' ', '\t']) {
            return wrong(format!(
                "`{}`: a heading has a space behind its marks: `{right}`",
                messages::excerpt(line)
            ));
        }
        if line.starts_with([' ', '\t']) || !(2..=3).contains(&marks) {
            return wrong(format!(
                "`{}`: a heading begins its line, with `## ` for a step or `### ` for a part of it: `{right}`",
                messages::excerpt(line)
            ));
        }
        let title = after.trim();
        let sought: String = title.to_lowercase().chars().take(EXCERPT).collect();
        let near = titles.iter().find(|known| {
            title != **known && strsim::damerau_levenshtein(&known.to_lowercase(), &sought) <= known.len() / 6
        });
        if let Some(near) = near.filter(|_| marks == 2) {
            return wrong(format!(
                "a heading `## {}`: it would be a step; write `## {near}`",
                messages::excerpt(title)
            ));
        }
    }
    Ok(())
}

fn endless(kind: &str, place: &str) -> String {
    format!("the block ```{} has no end: a line ```{place}", messages::excerpt(kind))
}

/// Returns the parts of `text` below the headings that begin like `mark`; the first has no heading, and begins after `first` lines.
pub fn parts(text: &str, first: usize, mark: &str) -> Vec<Part> {
    let mut all = vec![Part { title: String::new(), line: first, text: String::new() }];
    let mut is_block = false;
    for (number, line) in text.lines().enumerate().skip(first) {
        is_block ^= line.starts_with(FENCE);
        if let Some(title) = line.strip_prefix(mark).filter(|_| !is_block) {
            all.push(Part { title: title.trim().to_owned(), line: number + 1, text: String::new() });
        } else if let Some(part) = all.last_mut() {
            part.text += line;
            part.text.push('\n');
        }
    }
    all
}

impl Part {
    /// The line of its heading, from 1; the first line of all, if it has none.
    pub fn heading_line(&self) -> usize {
        self.line.max(1)
    }

    /// Returns its blocks of the kinds that are `allowed` here, one of each at most, of all that are `known`; and the rest of its
    /// text. Other blocks are text.
    pub fn blocks(&self, allowed: &[&str], known: &[&str]) -> Result<(Vec<FencedBlock>, Text), Wrong> {
        let (mut blocks, mut rest): (Vec<FencedBlock>, Vec<(usize, &str)>) = (Vec::new(), Vec::new());
        let mut lines = self.text.lines().enumerate().map(|(number, line)| (self.line + number + 1, line));
        while let Some((number, line)) = lines.next() {
            let kind = line.strip_prefix(FENCE).map(str::trim).filter(|kind| known.contains(kind));
            let Some(kind) = kind else {
                rest.push((number, line));
                continue;
            };
            if !allowed.contains(&kind) {
                return Err((
                    number,
                    format!("a block ```{kind} cannot stand here; these can: ```{}", allowed.join(", ```")),
                ));
            }
            if blocks.iter().any(|block| block.kind == kind) {
                return Err((number, format!("a second block ```{kind}: there can be one here")));
            }
            let mut text = String::new();
            loop {
                match lines.next() {
                    None => return Err((number, endless(kind, ""))),
                    Some((_, line)) if line.trim_end() == FENCE => break,
                    Some((_, line)) => text = text + line + "\n",
                }
            }
            blocks.push(FencedBlock { kind: kind.to_owned(), line: number + 1, text });
        }
        Ok((blocks, text(&rest)))
    }

    /// Returns its list of choices, if it has one, and the part without it.
    pub fn options(&self) -> Result<(Option<Options>, Self), Wrong> {
        let (mut options, mut right, mut rest) = (Vec::new(), Vec::new(), String::new());
        let mut is_item = false;
        for (number, line) in self.text.lines().enumerate() {
            let place = self.line + number + 1;
            if let Some((item, is_right)) = item(line) {
                if is_right {
                    right.push(options.len());
                }
                options.push(Text { markdown: item.trim().to_owned(), line: place });
                is_item = true;
            } else if let Some(last) = options.last_mut().filter(|_| is_item && is_indented(line)) {
                last.markdown = std::mem::take(&mut last.markdown) + "\n" + line.trim();
            } else {
                is_item = false;
                rest += line;
            }
            // The lines keep their numbers.
            rest.push('\n');
        }
        let rest = Self { title: self.title.clone(), line: self.line, text: rest };
        if options.is_empty() {
            return Ok((None, rest));
        }
        match right[..] {
            [right] if options.len() >= 2 => Ok((Some(Options { texts: options, right }), rest)),
            _ => {
                let problem = "a list of choices has at least two, of which just one is right: `- [x] …`";
                Err((self.heading_line(), problem.to_owned()))
            }
        }
    }
}

/// Returns the choice that begins in this line, and whether it is the right one.
fn item(line: &str) -> Option<(&str, bool)> {
    let item = line.strip_prefix(['-', '*']).filter(|item| item.starts_with([' ', '\t']))?.trim_start();
    let marks = [("[ ]", false), ("[x]", true), ("[X]", true)];
    marks.into_iter().find_map(|(mark, is_right)| Some((item.strip_prefix(mark)?, is_right)))
}

/// Whether a line goes on with the choice that begins before it.
fn is_indented(line: &str) -> bool {
    line.starts_with("  ") || line.starts_with('\t')
}

/// Returns these `lines` as a text, without the empty ones at both ends.
fn text(lines: &[(usize, &str)]) -> Text {
    let is_written = |(_, line): &(usize, &str)| !line.trim().is_empty();
    let Some(first) = lines.iter().position(is_written) else { return Text::default() };
    let last = lines.iter().rposition(is_written).unwrap_or(first);
    let told = &lines[first..=last];
    let markdown = told.iter().map(|(_, line)| *line).collect::<Vec<_>>().join("\n");
    Text { markdown, line: told[0].0 }
}
