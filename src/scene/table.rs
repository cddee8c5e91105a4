//! Typed, located reading of one table of a scene file.

use std::ops::{Range, RangeInclusive};

use gamow_platform::{messages, sizes};
use glam::DQuat;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::error::{Located, SceneProblem};
use super::model::Models;
use crate::files::syntax::{american, british};

/// Largest magnitude of a coordinate: beyond it, f32 has steps of more than 1/16.
const MAX_COORDINATE: f64 = 1e6;

/// Smallest size and distance: its square is still far from the smallest f32.
const MIN_SIZE: f64 = 1e-6;

/// Range of the number of repetitions of an object.
const COUNT: RangeInclusive<usize> = 1..=1000;

/// A table of a scene file.
pub(super) struct Table<'a> {
    /// Text of the whole file.
    pub text: &'a str,
    /// Keys and values of the table.
    pub entries: &'a DeTable<'a>,
    /// Place of the table, where missing keys are reported.
    pub span: Range<usize>,
    /// Description of the table's object, with its article.
    pub owner: &'static str,
    /// The models in it.
    pub models: Models<'a>,
}

impl<'a> Table<'a> {
    /// Refuses keys other than `known`, and one that is there in both spellings.
    pub fn check_keys(&self, known: &[&str]) -> Result<(), Located> {
        let unknown = self.entries.keys().filter(|key| {
            let name = british(key.get_ref());
            !known.contains(&&*name) || name != *key.get_ref() && self.entries.contains_key(&*name)
        });
        let Some(first) = unknown.min_by_key(|key| key.span().start) else { return Ok(()) };
        let key = first.get_ref().to_string();
        let problem = SceneProblem::UnknownKey { key, owner: self.owner, known: known.join(", ") };
        Err(Located { span: first.span(), problem })
    }

    /// The value that `read` finds at the key, which must be there.
    pub fn needed<T>(
        &self,
        key: &'static str,
        read: impl FnOnce(&Self, &'static str) -> Result<Option<T>, Located>,
    ) -> Result<T, Located> {
        read(self, key)?.ok_or_else(|| self.missing(key))
    }

    /// A coordinate, if the key is there.
    pub fn coordinate(&self, key: &'static str) -> Result<Option<f64>, Located> {
        self.value(key).map(|value| self.coordinate_of(key, value, "a number")).transpose()
    }

    /// A positive size, if the key is there.
    pub fn size(&self, key: &'static str) -> Result<Option<f64>, Located> {
        self.value(key).map(|value| self.size_of(key, value)).transpose()
    }

    /// A point, if the key is there.
    pub fn point(&self, key: &'static str) -> Result<Option<[f64; 3]>, Located> {
        let expected = "three numbers [x, y, z]";
        self.value(key).map(|value| self.coordinates_of(key, value, expected)).transpose()
    }

    /// Returns the number at the key, if that exists.
    pub fn count(&self, key: &'static str) -> Result<Option<usize>, Located> {
        let Some(value) = self.value(key) else { return Ok(None) };
        let count = match value.get_ref() {
            DeValue::Integer(integer) => usize::from_str_radix(integer.as_str(), integer.radix()).ok(),
            _ => None,
        };
        let count = count.filter(|count| COUNT.contains(count));
        count.map(Some).ok_or_else(|| self.wrong_type(key, value, "a whole number between 1 and 1000"))
    }

    /// A truth value, if the key is there.
    pub fn truth(&self, key: &'static str) -> Result<Option<bool>, Located> {
        let Some(value) = self.value(key) else { return Ok(None) };
        let truth = value.get_ref().as_bool();
        truth.map(Some).ok_or_else(|| self.wrong_type(key, value, "true or false"))
    }

    /// A string, if the key is there.
    pub fn string(&self, key: &'static str) -> Result<Option<&'a str>, Located> {
        self.value(key).map(|value| self.text_of(key, value, "a text in double quotes")).transpose()
    }

    /// A list of names, if the key is there.
    pub fn strings(&self, key: &'static str) -> Result<Option<Vec<&'a str>>, Located> {
        const EXPECTED: &str = "names in double quotes, in brackets";
        let Some(value) = self.value(key) else { return Ok(None) };
        let items = value.get_ref().as_array().ok_or_else(|| self.wrong_type(key, value, EXPECTED))?;
        items.iter().map(|item| self.text_of(key, item, EXPECTED)).collect::<Result<_, _>>().map(Some)
    }

    /// Three positive sizes that must be there.
    pub fn needed_sizes(&self, key: &'static str) -> Result<[f64; 3], Located> {
        const EXPECTED: &str = "three sizes [x, y, z]";
        let value = self.value(key).ok_or_else(|| self.missing(key))?;
        let Some([x, y, z]) = value.get_ref().as_array().map(|array| &array[..]) else {
            return Err(self.wrong_type(key, value, EXPECTED));
        };
        Ok([self.size_of(key, x)?, self.size_of(key, y)?, self.size_of(key, z)?])
    }

    /// A unit vector, if the key is there; the file may give it any length.
    pub fn direction(&self, key: &'static str) -> Result<Option<[f64; 3]>, Located> {
        let Some(vector) = self.point(key)? else { return Ok(None) };
        let largest = vector.into_iter().fold(0.0, |largest: f64, v| largest.max(v.abs()));
        if largest == 0.0 {
            return Err(self.problem_at(key, SceneProblem::NoDirection));
        }
        // Scaled first, so that no square underflows.
        let scaled = glam::DVec3::from(vector) / largest;
        Ok(Some((scaled / scaled.length()).to_array()))
    }

    /// Returns the turn about `axis`, which is upright by default, by `angle` degrees; none without an angle.
    pub fn turn(&self, what: &'static str) -> Result<DQuat, Located> {
        let axis = self.direction("axis")?;
        match self.coordinate("angle")? {
            Some(angle) => {
                let axis = axis.unwrap_or([0.0, 0.0, 1.0]);
                Ok(DQuat::from_axis_angle(axis.into(), angle.to_radians()))
            }
            None if axis.is_some() => {
                Err(self.problem_at("axis", |axis| SceneProblem::NoAngle { axis, what }))
            }
            None => Ok(DQuat::IDENTITY),
        }
    }

    /// The table at a key, if the key is there.
    pub fn table(&self, key: &'static str, owner: &'static str) -> Result<Option<Table<'a>>, Located> {
        let Some(value) = self.value(key) else { return Ok(None) };
        match value.get_ref() {
            DeValue::Table(entries) => Ok(Some(Table { entries, span: value.span(), owner, ..*self })),
            _ => Err(self.wrong_type(key, value, "a table: keys and values, headed by its name in brackets")),
        }
    }

    /// The tables of an array of tables; none if the key is not there.
    pub fn tables(&self, key: &'static str, owner: &'static str) -> Result<Vec<Table<'a>>, Located> {
        let Some(value) = self.value(key) else { return Ok(Vec::new()) };
        let expected = "tables, each headed by its name in double brackets";
        let DeValue::Array(items) = value.get_ref() else {
            return Err(self.wrong_type(key, value, expected));
        };
        let table = |item: &'a Spanned<DeValue<'a>>| match item.get_ref() {
            DeValue::Table(entries) => Ok(Table { entries, span: item.span(), owner, ..*self }),
            _ => Err(self.wrong_type(key, item, expected)),
        };
        items.iter().map(table).collect()
    }

    /// Whether the key is there.
    pub fn has(&self, key: &str) -> bool {
        self.value(key).is_some()
    }

    /// The problem with the value of `key`, which quotes that value.
    pub fn problem_at(&self, key: &str, problem: impl FnOnce(String) -> SceneProblem) -> Located {
        let span = self.value(key).map_or(self.span.clone(), Spanned::span);
        Located { problem: problem(self.quoted(&span)), span }
    }

    /// Returns the error that the value of `key` is not what is `expected`.
    pub fn wrong(&self, key: &'static str, expected: &'static str) -> Located {
        self.problem_at(key, |value| SceneProblem::WrongType { key, value, expected })
    }

    /// Returns the value of `key` in the file's spelling.
    pub fn quoted_value(&self, key: &str) -> String {
        self.value(key).map_or_else(String::new, |value| self.quoted(&value.span()))
    }

    fn value(&self, key: &str) -> Option<&'a Spanned<DeValue<'a>>> {
        self.entries.get(key).or_else(|| self.entries.get(american(key)?))
    }

    fn missing(&self, key: &'static str) -> Located {
        let problem = SceneProblem::MissingKey { key, owner: self.owner };
        Located { span: self.span.clone(), problem }
    }

    fn wrong_type(&self, key: &'static str, value: &Spanned<DeValue>, expected: &'static str) -> Located {
        let span = value.span();
        Located { problem: SceneProblem::WrongType { key, value: self.quoted(&span), expected }, span }
    }

    fn text_of(
        &self,
        key: &'static str,
        value: &'a Spanned<DeValue<'a>>,
        expected: &'static str,
    ) -> Result<&'a str, Located> {
        let text = value.get_ref().as_str().ok_or_else(|| self.wrong_type(key, value, expected))?;
        if sizes::is_too_long_for_a_name(text) {
            return Err(self.problem_at(key, |value| SceneProblem::LongName { key, value }));
        }
        Ok(text)
    }

    fn coordinate_of(
        &self,
        key: &'static str,
        value: &Spanned<DeValue>,
        expected: &'static str,
    ) -> Result<f64, Located> {
        let number = number(value.get_ref()).ok_or_else(|| self.wrong_type(key, value, expected))?;
        if number.abs() <= MAX_COORDINATE {
            return Ok(number);
        }
        let span = value.span();
        Err(Located { problem: SceneProblem::OutOfRange { key, value: self.quoted(&span) }, span })
    }

    fn size_of(&self, key: &'static str, value: &Spanned<DeValue>) -> Result<f64, Located> {
        let size = number(value.get_ref()).ok_or_else(|| self.wrong_type(key, value, "a number"))?;
        if (MIN_SIZE..=MAX_COORDINATE).contains(&size) {
            return Ok(size);
        }
        let span = value.span();
        let value = self.quoted(&span);
        let problem = if size <= 0.0 {
            SceneProblem::NotPositive { key, value }
        } else {
            SceneProblem::SizeOutOfRange { key, value }
        };
        Err(Located { span, problem })
    }

    fn coordinates_of<const N: usize>(
        &self,
        key: &'static str,
        value: &Spanned<DeValue>,
        expected: &'static str,
    ) -> Result<[f64; N], Located> {
        let items = value.get_ref().as_array().filter(|items| items.len() == N);
        let items = items.ok_or_else(|| self.wrong_type(key, value, expected))?;
        let mut coordinates = [0.0; N];
        for (coordinate, item) in coordinates.iter_mut().zip(items.iter()) {
            *coordinate = self.coordinate_of(key, item, expected)?;
        }
        Ok(coordinates)
    }

    /// A piece of the file, in one line of bounded length.
    fn quoted(&self, span: &Range<usize>) -> String {
        // A value may be as long as the file.
        let begin: String = self.text[span.clone()].chars().take(1000).collect();
        messages::excerpt(&begin.split_whitespace().collect::<Vec<_>>().join(" "))
    }
}

/// Whether two points are too close for a direction between them.
pub(super) fn coincide(a: [f64; 3], b: [f64; 3]) -> bool {
    glam::DVec3::from(a).distance(b.into()) < MIN_SIZE
}

/// Returns the number in a value: a float or an integer in any base; `None` for other types.
fn number(value: &DeValue) -> Option<f64> {
    match value {
        DeValue::Float(float) => float.as_str().parse().ok(),
        // Larger integers than i128 holds are out of range whatever they are.
        DeValue::Integer(integer) => {
            Some(i128::from_str_radix(integer.as_str(), integer.radix()).map_or(f64::INFINITY, |i| i as f64))
        }
        _ => None,
    }
}
