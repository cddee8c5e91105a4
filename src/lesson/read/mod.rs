//! From a Markdown file to a lesson. What is wrong is named with its line.

mod front;
mod limits;
mod parts;
mod wrong;

use std::io::ErrorKind;
use std::path::Path;

use gamow_platform::{files, messages, sizes};
use pulldown_cmark::HeadingLevel;

use self::front::FrontMatter;
use self::parts::{BLOCKS, FencedBlock, Outline, Part};
use self::wrong::Wrong;
use super::error::LessonError;
use super::plan::{
    Animated, Animation, AnswerKind, CardPicture, Choices, CurveAnswer, Lab, Lesson, Number, PointAt,
    Prediction, Reveal, StateBlock, Step, Text, line_giving,
};
use super::values;
use crate::files::syntax;
use crate::flags::{MAX_TIME, SpeedParameter, SpeedSetting};
use crate::quantity::Quantity;
use crate::similar::did_you_mean;
use serde::Deserialize;
use serde::de::DeserializeOwned;

/// The headings that are no steps.
const SENTENCE: &str = "In a sentence";
const LAB: &str = "Lab";
/// The headings below that of a step.
const PARTS: [&str; 5] = ["Predict", "Reveal", "Observe", "Explain", "Teach"];
/// Default duration of an animation, and the longest, seconds.
const SECONDS: f64 = 4.0;
const MOST_SECONDS: f64 = 120.0;
/// Correct contents of blocks, for error messages.
const NUMBER: &str = "`truth = \"gain\"` (the name of a value), and optionally `unit = \"times\"`, \
    `decimals = 2`, `within = 0.1`";
const POINT: &str = "`body = \"front tyre\"`";
const CURVE: &str = "`of = \"doppler\"`, `from = 0` and `to = 3`";
const PLAY: &str = "`time = 5` or `beta = 0.9`, and optionally `seconds = 4`";
/// Default tolerance of a number, as a part of the truth.
const WITHIN: f64 = 0.1;

impl Lesson {
    /// The lesson called `name` that `text` is, which errors call `source_name`.
    ///
    /// # Errors
    /// What is wrong in it, with file and line.
    pub fn read(name: &str, text: &str, source_name: &str) -> Result<Self, LessonError> {
        // Some editors begin a file with a mark of its encoding.
        let text = text.trim_start_matches('\u{feff}');
        lesson(name, text, source_name).map_err(|(line, problem)| LessonError::Content {
            source_name: source_name.to_owned(),
            line,
            problem,
        })
    }

    /// Whether `text` begins as a lesson does; other Markdown is none.
    #[must_use]
    pub fn begins(text: &str) -> bool {
        text.trim_start_matches('\u{feff}').lines().next().is_some_and(|line| line.trim_end() == front::FENCE)
    }

    /// The lesson in the file at `path`.
    ///
    /// # Errors
    /// A file that cannot be read, and what is wrong in it.
    pub fn load(path: &Path) -> Result<Self, LessonError> {
        let source_name = files::shown(path);
        let text = files::read_to_string(path).map_err(|reason| LessonError::Read {
            what: "lesson",
            source_name: source_name.clone(),
            reason: match reason.kind() {
                ErrorKind::InvalidData => "it is not text in UTF-8, as a lesson must be".to_owned(),
                _ if files::is_folder(path) => {
                    "it is a folder; a lesson is a file of Markdown (.md)".to_owned()
                }
                _ => reason.to_string(),
            },
        })?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        Ok(Self { path: Some(path.to_owned()), ..Self::read(&name, &text, &source_name)? })
    }
}

fn lesson(name: &str, text: &str, source_name: &str) -> Result<Lesson, Wrong> {
    limits::check_length(text)?;
    let (front, first) = FrontMatter::parse(text)?;
    let outline = Outline::parse(text, first, &[SENTENCE, LAB])?;
    let mut sections = outline.parts().into_iter();
    let introduction =
        sections.next().map(|part| part.only_text("before the first step (a line that begins with `## `)"));
    let introduction = introduction.transpose()?.unwrap_or_default();
    let (mut steps, mut sentence, mut lab) = (Vec::new(), Text::default(), None);
    for section in sections {
        match section.title {
            SENTENCE => sentence = section.only_text("in the sentence to take away")?,
            LAB => {
                let (mut blocks, text) = section.blocks(&["state"])?;
                lab = Some(Lab { text, state: state_block(&mut blocks) });
            }
            title if sizes::is_too_long_for_a_name(title) => {
                let most = sizes::NAME_LETTERS;
                return Err((section.line, format!("a title has at most {most} letters")));
            }
            _ => steps.push(step(section)?),
        }
    }
    if steps.is_empty() {
        return Err((1, "a lesson has at least one step: a line that begins with `## `".to_owned()));
    }
    let FrontMatter { title, order, chapter, card, concept, minutes } = front;
    if let CardPicture::Step(step) = card
        && step >= steps.len()
    {
        return Err((1, format!("card = step {}: there are {} steps", step + 1, steps.len())));
    }
    let (name, source_name) = (name.to_owned(), source_name.to_owned());
    let lesson = Lesson {
        name,
        source_name,
        path: None,
        title,
        order,
        chapter,
        card,
        concept,
        minutes,
        introduction,
        steps,
        sentence,
        lab,
    };
    limits::check(&lesson)?;
    Ok(lesson)
}

fn step(section: Part<'_>) -> Result<Step, Wrong> {
    let parts = section.parts(HeadingLevel::H3);
    let (said, below) = parts.split_first().unwrap_or((&section, &[]));
    let (mut blocks, text) = said.blocks(&["state"])?;
    let mut step = Step {
        title: section.title.to_owned(),
        state: state_block(&mut blocks),
        text,
        prediction: None,
        reveal: None,
        observation: None,
        explanation: Text::default(),
        teaching: Text::default(),
    };
    for (number, part) in below.iter().enumerate() {
        if let Some(first) = below[..number].iter().find(|first| first.title == part.title) {
            let (title, line) = (&part.title, first.line);
            let problem = format!("a second `{title}` in this step: the first is in line {line}");
            return Err((part.line, problem));
        }
        match part.title {
            "Predict" => step.prediction = Some(prediction(*part)?),
            "Reveal" => step.reveal = Some(reveal(*part)?),
            "Observe" => step.observation = Some(choices(*part)?),
            "Explain" => step.explanation = part.only_text("in an explanation")?,
            "Teach" => step.teaching = part.only_text("in advice for whoever teaches")?,
            other => {
                let (near, known) = (did_you_mean(PARTS, other), PARTS.join(", "));
                let other = messages::excerpt(other);
                return Err((
                    part.line,
                    format!("unknown part `{other}`{near} of a step: there are {known}"),
                ));
            }
        }
    }
    if step.prediction.is_some() && step.reveal.is_none() {
        let problem =
            "a step with a prediction needs a reveal: a line `### Reveal` and below it what happens";
        return Err((section.line, problem.to_owned()));
    }
    Ok(step)
}

/// The settings that differ, taken out of `blocks`.
fn state_block(blocks: &mut Vec<FencedBlock>) -> Option<StateBlock> {
    let FencedBlock { text: toml, line, .. } = take(blocks, "state")?;
    Some(StateBlock { toml, line })
}

fn take(blocks: &mut Vec<FencedBlock>, kind: &str) -> Option<FencedBlock> {
    let found = blocks.iter().position(|block| block.kind == kind)?;
    Some(blocks.remove(found))
}

fn prediction(part: Part<'_>) -> Result<Prediction, Wrong> {
    let (options, part) = part.options()?;
    let (mut blocks, question) = part.blocks(&["number", "point", "curve"])?;
    let mut kinds = Vec::new();
    if let Some(options) = options {
        kinds.push(AnswerKind::Choice(options));
    }
    if let Some(block) = take(&mut blocks, "number") {
        kinds.push(AnswerKind::Number(number(&block)?));
    }
    if let Some(block) = take(&mut blocks, "point") {
        let PointTable { body } = block.table(POINT)?;
        check_name(&block, "body", &body)?;
        kinds.push(AnswerKind::Point(PointAt { body, line: block.line }));
    }
    if let Some(block) = take(&mut blocks, "curve") {
        kinds.push(AnswerKind::Curve(curve(&block)?));
    }
    let (first, others) = (kinds.pop(), kinds);
    let kind = first.filter(|_| others.is_empty()).ok_or_else(|| {
        let right = "a prediction is one of: a list of choices (`- [ ] …`, the right one `- [x] …`), or a block \
                     ```number, ```point or ```curve";
        (part.line, right.to_owned())
    })?;
    Ok(Prediction { question, kind })
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct NumberTable {
    truth: String,
    #[serde(default)]
    unit: String,
    decimals: Option<u8>,
    within: Option<f64>,
}

/// Checks the length of the `name` given as `key` in `block`.
fn check_name(block: &FencedBlock, key: &str, name: &str) -> Result<(), Wrong> {
    limits::check_name(key, name).map_err(|problem| (block.line_of(key), problem))
}

fn number(block: &FencedBlock) -> Result<Number, Wrong> {
    let NumberTable { truth, unit, decimals, within } = block.table(NUMBER)?;
    check_name(block, "unit", &unit)?;
    let line = block.line_of("truth");
    values::check(&truth).map_err(|problem| (line, problem))?;
    let within = within.unwrap_or(WITHIN);
    if !(within > 0.0 && within <= 1.0) {
        return Err((block.line_of("within"), format!("within = {within}: must be above 0 and at most 1")));
    }
    Ok(Number { value: truth, line, unit, decimals: decimals.unwrap_or(2).min(9), within, truth: None })
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PointTable {
    body: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CurveTable {
    of: String,
    from: f64,
    to: f64,
}

fn curve(block: &FencedBlock) -> Result<CurveAnswer, Wrong> {
    let CurveTable { of, from, to } = block.table(CURVE)?;
    let Some(quantity) = Quantity::DRAWN.into_iter().find(|quantity| quantity.row().id == of) else {
        let known = Quantity::DRAWN.map(|quantity| quantity.row().id).join(", ");
        return Err((
            block.line_of("of"),
            format!("of = {}: must be one of {known}", messages::excerpt(&of)),
        ));
    };
    if !(from.is_finite() && to.is_finite() && from < to) {
        return Err((
            block.line_of("from"),
            format!("from = {from}, to = {to}: must be two numbers that rise"),
        ));
    }
    Ok(CurveAnswer { quantity, range: [from, to] })
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PlayTable {
    time: Option<f64>,
    beta: Option<f64>,
    gamma: Option<f64>,
    rapidity: Option<f64>,
    seconds: Option<f64>,
}

fn reveal(part: Part<'_>) -> Result<Reveal, Wrong> {
    let (mut blocks, text) = part.blocks(&["state", "play"])?;
    let state = state_block(&mut blocks);
    let animation = take(&mut blocks, "play").map(|block| animation(&block)).transpose()?;
    Ok(Reveal { state, animation, text })
}

fn animation(block: &FencedBlock) -> Result<Animation, Wrong> {
    let PlayTable { time, beta, gamma, rapidity, seconds } = block.table(PLAY)?;
    let seconds = seconds.unwrap_or(SECONDS);
    if !(seconds > 0.0 && seconds <= MOST_SECONDS) {
        let problem = format!("seconds = {seconds}: must be above 0 and at most {MOST_SECONDS}");
        return Err((block.line_of("seconds"), problem));
    }
    let speeds = SpeedParameter::ALL.into_iter().zip([beta, gamma, rapidity]);
    let mut ends = Vec::new();
    for (parameter, value) in speeds.filter_map(|(parameter, value)| Some((parameter, value?))) {
        let speed = SpeedSetting::new(parameter, value);
        ends.push(Animated::Speed(
            speed.map_err(|error| (block.line_of(parameter.name()), error.to_string()))?,
        ));
    }
    if let Some(time) = time {
        if time.is_nan() || time.abs() > MAX_TIME {
            let problem = format!("time = {time:e}: must be between {:e} and {MAX_TIME:e}", -MAX_TIME);
            return Err((block.line_of("time"), problem));
        }
        ends.push(Animated::Time(time));
    }
    match ends[..] {
        [to] => Ok(Animation { to, seconds }),
        _ => Err((block.line, "a block ```play sets one of: time, beta, gamma, rapidity".to_owned())),
    }
}

fn choices(part: Part<'_>) -> Result<Choices, Wrong> {
    let (options, part) = part.options()?;
    let question = part.only_text("in a question about what was seen")?;
    let problem = "what was seen is asked by a list of choices: `- [ ] …`, the right one `- [x] …`";
    let options = options.ok_or_else(|| (part.line, problem.to_owned()))?;
    Ok(Choices { question, options })
}

impl Part<'_> {
    /// Returns its text, in which no block may occur; `place` describes where it is.
    fn only_text(&self, place: &str) -> Result<Text, Wrong> {
        let (found, text) = self.blocks(&BLOCKS)?;
        match found.first() {
            None => Ok(text),
            Some(block) => Err((block.line - 1, format!("a block ```{} cannot stand {place}", block.kind))),
        }
    }
}

impl FencedBlock {
    /// Parses its text as TOML; in an error, `right` gives the correction.
    fn table<T: DeserializeOwned>(&self, right: &str) -> Result<T, Wrong> {
        toml::from_str(&self.text).map_err(|error| {
            let (span, message) = syntax::problem(&self.text, &error);
            let before = self.text.get(..span.start).unwrap_or_default();
            (self.line + before.matches('\n').count(), format!("{message}; such a block says {right}"))
        })
    }

    /// The line in which it gives `key`; its first, if it does not.
    fn line_of(&self, key: &str) -> usize {
        self.line + line_giving(key, &self.text).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests;
