//! A pupil's answers as a token: a text of letters, digits, `-` and `_` that every message and address
//! carries as it is.
//!
//! Its bytes, in base64url without padding (RFC 4648), are a version, the answers (by postcard), and their
//! CRC-32, little end first. They are not compressed: the answers to a lesson need 30 to 250 bytes.

use base64::Engine as _;
use base64::prelude::BASE64_URL_SAFE_NO_PAD;
use relativity_render::Gaze;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::drawn_curve::DrawnCurve;
use super::pupil::{PupilAnswers, StepAnswers, is_sound, pupils_name};
use crate::lesson::answer::{Answer, Confidence, Outcome, Record};

/// The word before a token in a link: `gamow:?answers=TOKEN`.
pub const KEY: &str = "answers";

/// Returns the part of a link with this token.
#[must_use]
pub fn link_pair(token: &str) -> String {
    format!("{KEY}={token}")
}

/// Version of the form, the first byte.
const VERSION: u8 = 1;
/// Length of the checksum, bytes.
const SUM: usize = 4;
/// Length of the longest token that is read, letters: ten times that of any lesson of the program.
pub(super) const MOST_LETTERS: usize = 1 << 13;

/// A text that is no token, in one line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum TokenError {
    /// The text is longer than any token.
    #[error("this link is longer than any with answers ({MOST_LETTERS} letters)")]
    TooLong,
    /// Letters are missing or changed.
    #[error("this link is damaged or cut off: ask for it again, or for the report")]
    Damaged,
    /// The token has another version.
    #[error("this link is by another version of Gamow, and cannot be read by this one")]
    OtherVersion,
}

/// The answers as they are written.
#[derive(Serialize, Deserialize)]
struct Sheet {
    lesson: String,
    name: String,
    steps: Vec<Option<SheetStep>>,
}

#[derive(Serialize, Deserialize)]
struct SheetStep {
    asked: [u8; 2],
    answer: SheetAnswer,
    /// The number of the degree; 0 for none.
    confidence: u8,
    /// The number of the observed choice, from 1; 0 for none.
    observed: u8,
}

/// An answer as it is written. New kinds come last, so that older tokens can be read.
#[derive(Serialize, Deserialize)]
enum SheetAnswer {
    None,
    Skipped,
    Choice(u32),
    Votes(Vec<u32>),
    Number(f64),
    Direction(f64, f64),
    Curve(DrawnCurve),
}

impl PupilAnswers {
    /// Returns the token with these answers.
    #[must_use]
    pub fn token(&self) -> String {
        let steps = self.steps.iter().map(|step| step.as_ref().map(SheetStep::new)).collect();
        let sheet = Sheet { lesson: self.lesson.clone(), name: self.name.clone(), steps };
        // Only a value without a length in advance cannot be written, and here is none.
        let mut bytes = postcard::to_extend(&sheet, vec![VERSION]).unwrap_or_default();
        let sum = crc32fast::hash(&bytes);
        bytes.extend(sum.to_le_bytes());
        BASE64_URL_SAFE_NO_PAD.encode(bytes)
    }

    /// Returns the answers that are written in `token`.
    ///
    /// # Errors
    /// A token that is too long, damaged, or of another version.
    pub fn from_token(token: &str) -> Result<Self, TokenError> {
        if token.len() > MOST_LETTERS {
            return Err(TokenError::TooLong);
        }
        let bytes = BASE64_URL_SAFE_NO_PAD.decode(token).map_err(|_| TokenError::Damaged)?;
        let (told, sum) = bytes.split_last_chunk::<SUM>().ok_or(TokenError::Damaged)?;
        if crc32fast::hash(told) != u32::from_le_bytes(*sum) {
            return Err(TokenError::Damaged);
        }
        let (version, told) = told.split_first().ok_or(TokenError::Damaged)?;
        if *version != VERSION {
            return Err(TokenError::OtherVersion);
        }
        // Lists take no more room than a megabyte before their items have been read.
        let (Sheet { lesson, name, steps }, rest) =
            postcard::take_from_bytes(told).map_err(|_| TokenError::Damaged)?;
        let steps = steps.into_iter().map(|step| step.map_or(Some(None), |step| step.read().map(Some)));
        let steps = steps.collect::<Option<Vec<_>>>().filter(|_| rest.is_empty());
        Ok(Self { lesson, name: pupils_name(&name), steps: steps.ok_or(TokenError::Damaged)? })
    }
}

impl SheetStep {
    fn new(StepAnswers { asked, record }: &StepAnswers) -> Self {
        let (answer, confidence) = match &record.outcome {
            None => (SheetAnswer::None, None),
            Some(Outcome::Skipped) => (SheetAnswer::Skipped, None),
            Some(Outcome::Made { answer, confidence }) => (SheetAnswer::new(answer), *confidence),
        };
        Self {
            asked: asked.to_le_bytes(),
            answer,
            confidence: confidence.map_or(0, u8::from),
            observed: record.observed.and_then(|number| u8::try_from(number + 1).ok()).unwrap_or(0),
        }
    }

    /// The answers of a step; `None` if they cannot be.
    fn read(self) -> Option<StepAnswers> {
        let confidence = (self.confidence > 0).then(|| Confidence::from(self.confidence));
        let outcome = match self.answer {
            SheetAnswer::None => None,
            SheetAnswer::Skipped => Some(Outcome::Skipped),
            answer => Some(Outcome::Made { answer: answer.read()?, confidence }),
        };
        let observed = usize::from(self.observed).checked_sub(1);
        Some(StepAnswers { asked: u16::from_le_bytes(self.asked), record: Record { outcome, observed } })
    }
}

impl SheetAnswer {
    fn new(answer: &Answer) -> Self {
        match answer {
            Answer::Choice(choice) => u32::try_from(*choice).map_or(Self::None, Self::Choice),
            Answer::Votes(votes) => Self::Votes(votes.clone()),
            Answer::Number(number) => Self::Number(*number),
            Answer::Direction(Gaze { azimuth, elevation }) => Self::Direction(*azimuth, *elevation),
            Answer::Curve(points) => DrawnCurve::new(points).map_or(Self::None, Self::Curve),
        }
    }

    /// The answer; `None` if it cannot be.
    fn read(self) -> Option<Answer> {
        let answer = match self {
            Self::None | Self::Skipped => return None,
            Self::Choice(choice) => Answer::Choice(choice as usize),
            Self::Votes(votes) => Answer::Votes(votes),
            Self::Number(number) => Answer::Number(number),
            Self::Direction(azimuth, elevation) => Answer::Direction(Gaze { azimuth, elevation }),
            Self::Curve(curve) => Answer::Curve(curve.is_sound().then(|| curve.points())?),
        };
        is_sound(&answer).then_some(answer)
    }
}

#[cfg(test)]
mod tests;
