//! The front matter of a lesson: lines `key: value` between two lines of three dashes.

use gamow_platform::messages;

use super::limits::check_name;
use super::wrong::Wrong;
use crate::lesson::plan::CardPicture;
use crate::settings::Preset;
use crate::similar::did_you_mean;

/// The front matter of a lesson.
pub struct FrontMatter {
    pub title: String,
    pub order: u32,
    pub chapter: String,
    pub card: CardPicture,
    pub concept: String,
    pub minutes: u32,
}

const KEYS: [&str; 6] = ["title", "order", "chapter", "card", "concept", "minutes"];
/// The chapter of a lesson that names none.
const OWN_CHAPTER: &str = "Your own lessons";
/// Line before and after the front matter.
pub const FENCE: &str = "---";
/// A lesson that does not say its place comes after those that do.
const LAST: u32 = 1000;

impl FrontMatter {
    /// Parses the front matter of a lesson's `text`, and returns the number of its lines, too.
    pub fn parse(text: &str) -> Result<(Self, usize), Wrong> {
        let begin = format!("a lesson begins with a line `{FENCE}`, then `title: …`, and again `{FENCE}`");
        let mut lines = text.lines().enumerate();
        if lines.next().is_none_or(|(_, line)| line.trim_end() != FENCE) {
            return Err((1, begin));
        }
        let mut front = Self {
            title: String::new(),
            order: LAST,
            chapter: OWN_CHAPTER.to_owned(),
            card: CardPicture::Step(0),
            concept: String::new(),
            minutes: 10,
        };
        for (number, line) in lines {
            let (line, number) = (line.trim(), number + 1);
            if line == FENCE {
                return if front.title.is_empty() {
                    Err((number, "a lesson needs a title: `title: …`".to_owned()))
                } else {
                    Ok((front, number))
                };
            }
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let Some((key, value)) = line.split_once(':') else {
                return Err((
                    number,
                    format!(
                        "`{}`: must be `key: value`, with one of {}",
                        messages::excerpt(line),
                        KEYS.join(", ")
                    ),
                ));
            };
            front.set(key.trim(), value.trim().trim_matches('"')).map_err(|problem| (number, problem))?;
        }
        Err((1, begin))
    }

    fn set(&mut self, key: &str, value: &str) -> Result<(), String> {
        let whole = |value: &str| {
            let number = value.parse::<u32>().ok().filter(|number| *number < LAST);
            number.ok_or_else(|| {
                format!("{key} = {}: must be a whole number below {LAST}", messages::excerpt(value))
            })
        };
        check_name(key, value)?;
        match key {
            "title" => value.clone_into(&mut self.title),
            "chapter" if value.is_empty() => OWN_CHAPTER.clone_into(&mut self.chapter),
            "chapter" => value.clone_into(&mut self.chapter),
            "card" => {
                self.card = card(value).ok_or_else(|| {
                    format!("{key} = {}: must be the name of a preset, or `step 3`", messages::excerpt(value))
                })?;
            }
            "concept" => value.clone_into(&mut self.concept),
            "order" => self.order = whole(value)?,
            "minutes" => self.minutes = whole(value)?,
            _ => {
                return Err(format!(
                    "unknown key `{}`{}: there are {}",
                    messages::excerpt(key),
                    did_you_mean(KEYS, key),
                    KEYS.join(", ")
                ));
            }
        }
        Ok(())
    }
}

/// Returns the picture that `value` names: a preset, or a step by its number from 1.
fn card(value: &str) -> Option<CardPicture> {
    let Some(number) = value.strip_prefix("step ") else {
        return Preset::named(value).map(|preset| CardPicture::Preset(preset.name.to_owned()));
    };
    number.trim().parse::<usize>().ok()?.checked_sub(1).map(CardPicture::Step)
}
