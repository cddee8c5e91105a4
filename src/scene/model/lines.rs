//! The lines of a Wavefront OBJ file, each checked before it is read: the reader behind them counts none, and
//! trusts some of their numbers.

use std::cell::{Cell, RefCell};
use std::fmt::Write as _;
use std::io::{self, BufRead, Read};
use std::str::SplitWhitespace;

use super::limits::check_count;
use super::text::{Statements, word_and_name};

/// The first problem of a file, and the number of lines that have been read.
#[derive(Default)]
pub struct Problems {
    line: Cell<usize>,
    first: RefCell<Option<String>>,
}

impl Problems {
    /// Keeps a problem of the present line, unless there was one before.
    pub fn add(&self, problem: &str) {
        let problem = self.located(problem);
        self.first.borrow_mut().get_or_insert(problem);
    }

    /// Returns a problem with the present line.
    pub fn located(&self, problem: &str) -> String {
        format!("line {} of it: {problem}", self.line.get())
    }

    /// Returns the first problem as an error, if there is one.
    pub fn first(&self) -> Result<(), String> {
        self.first.borrow().clone().map_or(Ok(()), Err)
    }
}

/// Lines with corners, places in textures, faces, materials and names of parts, and nothing else: corners
/// with six numbers, of which the last three are no numbers where they have no colour; faces with places and
/// places in textures, numbered from 1.
pub struct Lines<'a> {
    statements: Statements<'a>,
    problems: &'a Problems,
    /// The present line, and how much of it has been read.
    line: String,
    read: usize,
    corners: usize,
    in_textures: usize,
    triangles: usize,
}

impl<'a> Lines<'a> {
    /// Returns the lines of `text`; reading ends at the first of the `problems`.
    pub fn new(text: &'a str, problems: &'a Problems) -> Self {
        let (line, read) = (String::new(), 0);
        let statements = Statements::new(text);
        Self { statements, problems, line, read, corners: 0, in_textures: 0, triangles: 0 }
    }

    /// Makes a statement the present line, as far as it is needed.
    fn take(&mut self, statement: &str) -> Result<(), String> {
        let line = statement.split('#').next().unwrap_or_default().trim();
        let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
        match word {
            "v" => self.corner(rest.split_whitespace())?,
            "vt" => self.in_texture(rest.split_whitespace())?,
            "f" => self.face(rest.split_whitespace())?,
            "mtllib" | "usemtl" | "o" | "g" => {
                let (_, name) = word_and_name(statement);
                if name.is_empty() && word.len() > 1 {
                    return Err(format!("{word} needs a name"));
                }
                self.line.extend([word, " ", name]);
            }
            _ => return Ok(()),
        }
        self.line.push('\n');
        Ok(())
    }

    /// Takes a corner: three coordinates, and three parts of an sRGB colour if there are any.
    fn corner(&mut self, words: SplitWhitespace<'_>) -> Result<(), String> {
        let (mut count, mut first, mut is_colour) = (0, [""; 6], true);
        for word in words {
            let number = number(word)?;
            is_colour &= count < 3 || (0.0..=1.0).contains(&number);
            if let Some(place) = first.get_mut(count) {
                *place = word;
            }
            count += 1;
        }
        if count < 3 {
            return Err("a corner needs three coordinates".to_owned());
        }
        let has_colour = count == 6;
        if has_colour && !is_colour {
            return Err("each part of a colour must lie between 0 and 1".to_owned());
        }
        self.corners += 1;
        check_count(self.corners / 3)?;
        let colour = if has_colour { &first[3..] } else { &["nan"; 3] };
        self.put("v", first[..3].iter().chain(colour));
        Ok(())
    }

    /// Takes a place in a texture: one coordinate or more.
    fn in_texture(&mut self, words: SplitWhitespace<'_>) -> Result<(), String> {
        let words: Vec<&str> = words.chain(["0"]).take(2).collect();
        words.iter().try_for_each(|word| number(word).map(drop))?;
        if words.len() < 2 {
            return Err("a place in a texture needs a number".to_owned());
        }
        self.in_textures += 1;
        check_count(self.in_textures / 3)?;
        self.put("vt", words.iter());
        Ok(())
    }

    /// Takes a face: the numbers of three corners or more, with places in a texture if there are any.
    fn face(&mut self, words: SplitWhitespace<'_>) -> Result<(), String> {
        self.line.push('f');
        let mut count: usize = 0;
        for word in words {
            let mut parts = word.split('/');
            self.line.push(' ');
            put_number(&mut self.line, parts.next().unwrap_or_default(), self.corners, "corner")?;
            if let Some(part) = parts.next().filter(|part| !part.is_empty() && self.in_textures > 0) {
                self.line.push('/');
                put_number(&mut self.line, part, self.in_textures, "place in a texture")?;
            }
            count += 1;
        }
        let triangles = count.checked_sub(2).filter(|&triangles| triangles > 0);
        self.triangles += triangles.ok_or("a face needs three corners")?;
        check_count(self.triangles)
    }

    fn put<'w>(&mut self, word: &str, words: impl Iterator<Item = &'w &'w str>) {
        self.line.push_str(word);
        words.for_each(|word| self.line.extend([" ", word]));
    }
}

impl Read for Lines<'_> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(bytes)?;
        self.consume(count);
        Ok(count)
    }
}

impl BufRead for Lines<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        while self.read == self.line.len() && self.problems.first().is_ok() {
            self.line.clear();
            self.read = 0;
            let Some((number, statement)) = self.statements.next() else { break };
            self.problems.line.set(number);
            self.take(&statement).unwrap_or_else(|problem| self.problems.add(&problem));
        }
        self.problems.first().map_err(io::Error::other)?;
        Ok(&self.line.as_bytes()[self.read..])
    }

    fn consume(&mut self, count: usize) {
        self.read += count;
    }
}

fn number(word: &str) -> Result<f64, String> {
    word.parse().map_err(|_| format!("{} is not a number", shortened(word)))
}

/// Adds the number from 1 of what a face calls so: one of `count`, from 1, or below 0 from the last one back.
fn put_number(line: &mut String, word: &str, count: usize, what: &str) -> Result<(), String> {
    let number = word.parse::<i64>().ok().and_then(|number| match number {
        0.. => usize::try_from(number).ok(),
        _ => usize::try_from(number.unsigned_abs()).ok().and_then(|back| (count + 1).checked_sub(back)),
    });
    let named = number.filter(|number| (1..=count).contains(number));
    let missing = || format!("a face names {what} {}, and so far there are {count}", shortened(word));
    let number = named.ok_or_else(missing)?;
    if word.starts_with(|first: char| first.is_ascii_digit()) {
        line.push_str(word);
    } else {
        let _ = write!(line, "{number}");
    }
    Ok(())
}

/// The beginning of a word, for a message.
fn shortened(word: &str) -> String {
    word.chars().take(20).collect()
}
