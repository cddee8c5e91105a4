//! The columns' names, the cells under them, and what is wrong with either.

use csv::ByteRecord;
use gamow_platform::messages;
use thiserror::Error;

/// The columns' names, and the cells under them.
#[derive(Debug)]
pub struct Names(ByteRecord);

impl Names {
    /// The names in the first row.
    pub fn new(row: ByteRecord) -> Result<Self, HeaderError> {
        if row.is_empty() { Err(HeaderError::Empty) } else { Ok(Self(row)) }
    }

    /// The place of the column `name`, blanks around it aside.
    pub fn place(&self, name: &'static str) -> Result<Option<usize>, HeaderError> {
        let mut places = (0..self.0.len()).filter(|&place| self.0[place].trim_ascii() == name.as_bytes());
        let (first, second) = (places.next(), places.next());
        match (first, second) {
            (Some(first), Some(second)) => {
                Err(HeaderError::Duplicate { name, first: first + 1, second: second + 1 })
            }
            _ => Ok(first),
        }
    }

    /// The names that begin with `prefix`, blanks around them aside; legible.
    pub fn that_begin_with<'a>(&'a self, prefix: &'a str) -> impl Iterator<Item = String> + 'a {
        let names = self.0.iter().map(<[u8]>::trim_ascii);
        names.filter(|name| name.starts_with(prefix.as_bytes())).map(legible)
    }

    /// All names, blanks around them aside: in UTF-8, or in Latin-1 where they are in no UTF-8.
    pub fn texts(&self) -> impl Iterator<Item = String> + '_ {
        self.0.iter().map(text)
    }

    /// The names with an unnamed column before them.
    #[must_use]
    pub fn after_row_names(&self) -> Self {
        Self([b"".as_slice()].into_iter().chain(&self.0).collect())
    }

    /// Number of columns.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is no column, which [`Names::new`] refuses.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The place of the column `name`, one of those `needed`.
    pub fn needed_place(&self, name: &'static str, needed: &'static str) -> Result<usize, HeaderError> {
        self.place(name)?.ok_or_else(|| self.missing(name, needed))
    }

    /// Returns the error for a missing column `name`, one of those `needed`.
    pub fn missing(&self, name: &'static str, needed: &'static str) -> HeaderError {
        let found = self.0.iter().map(legible).collect::<Vec<_>>().join(", ");
        HeaderError::Missing { name, needed, found: messages::excerpt(&found) }
    }

    /// Drops empty fields at the end of `row` that have no name, and refuses a row that has not as many
    /// fields as there are names, the last of these that are empty aside.
    pub fn fit_length(&self, row: &mut ByteRecord) -> Result<(), RowError> {
        while row.len() > self.0.len() && row[row.len() - 1].trim_ascii().is_empty() {
            row.truncate(row.len() - 1);
        }
        let is_named = |name: &[u8]| !name.trim_ascii().is_empty();
        if row.len() < self.0.len() && !self.0.iter().skip(row.len()).any(is_named) {
            return Ok(());
        }
        self.check_length(row)
    }

    /// Refuses a row that has not as many fields as there are names.
    pub fn check_length(&self, row: &ByteRecord) -> Result<(), RowError> {
        let (fields, columns) = (row.len(), self.0.len());
        if fields < columns {
            let column = legible(&self.0[fields]);
            return Err(RowError::TooShort { fields, columns, column });
        }
        if fields > columns {
            let value = legible(&row[columns]);
            return Err(RowError::TooLong { fields, columns, value });
        }
        Ok(())
    }

    /// Returns the error for a number at `place` in `row` that is outside `range`.
    #[must_use]
    pub fn out_of_range(&self, row: &ByteRecord, place: usize, range: &'static str) -> RowError {
        RowError::OutOfRange { column: legible(&self.0[place]), value: legible(&row[place]), range }
    }

    /// The number at `place` in `row`.
    pub fn number(&self, row: &ByteRecord, place: usize) -> Result<f64, RowError> {
        let fault = |problem| RowError::Value {
            column: legible(&self.0[place]),
            value: legible(&row[place]),
            problem,
        };
        let text = row[place].trim_ascii();
        if text.is_empty() {
            return Err(fault("is empty; it should be a number"));
        }
        match number(text) {
            Some(number) if number.is_finite() => Ok(number),
            Some(_) => Err(fault(NOT_FINITE)),
            None => Err(fault("is not a number; it should be one such as 0.9 or 1e-3")),
        }
    }

    /// Returns `number`, a value of the column at `place`, if it is finite.
    #[inline]
    pub fn finite(&self, number: f64, place: usize) -> Result<f64, RowError> {
        if number.is_finite() {
            return Ok(number);
        }
        let (column, value) = (legible(&self.0[place]), number.to_string());
        Err(RowError::Value { column, value, problem: NOT_FINITE })
    }
}

/// The number that a field is, blanks around it aside; `None` if it is none.
#[must_use]
pub fn number(field: &[u8]) -> Option<f64> {
    let text = field.trim_ascii();
    let number = std::str::from_utf8(text).ok().and_then(|text| text.parse::<f64>().ok());
    number.or_else(|| with_minus(text))
}

/// The number in `text` whose minus signs are those of typesetting.
#[cold]
fn with_minus(text: &[u8]) -> Option<f64> {
    std::str::from_utf8(text).ok()?.replace('\u{2212}', "-").parse().ok()
}

/// `field` as text, blanks around it aside: in UTF-8, or in Latin-1 where it is in no UTF-8.
#[must_use]
pub fn text(field: &[u8]) -> String {
    let field = field.trim_ascii();
    let latin = || field.iter().copied().map(char::from).collect();
    std::str::from_utf8(field).map_or_else(|_| latin(), |text| text.trim().to_owned())
}

/// The problem with an infinite number, or with none.
const NOT_FINITE: &str = "is not finite; it should be a number that a 64-bit float can hold";

/// A header that does not say where the inputs are, each of them once.
#[derive(Debug, PartialEq, Error)]
pub enum HeaderError {
    /// There is no row at all.
    #[error("there is no header; it should name the columns, as in beta,d,y,z,T")]
    Empty,
    /// A column is not there.
    #[error("column {name} is missing; the header should name {needed}, and it names {found}")]
    Missing {
        /// The first needed column that the header does not name.
        name: &'static str,
        /// Names of the columns that are needed.
        needed: &'static str,
        /// Names of the columns that exist.
        found: String,
    },
    /// A column is there twice.
    #[error("column {name} is there twice, as fields {first} and {second}; it should be there once")]
    Duplicate {
        /// The name that two fields have.
        name: &'static str,
        /// First place of the column, from 1.
        first: usize,
        /// Second place of the column, from 1.
        second: usize,
    },
}

/// A row that disagrees with its header.
#[derive(Debug, PartialEq, Error)]
pub enum RowError {
    /// Fields are missing at its end.
    #[error("column {column} has no value; the row has {fields} of {columns} fields")]
    TooShort {
        /// Number of fields in the row.
        fields: usize,
        /// Number of fields in the header.
        columns: usize,
        /// The first column without a value.
        column: String,
    },
    /// There are more fields than columns.
    #[error("\"{value}\" belongs to no column; the row has {fields} fields, and should have {columns}")]
    TooLong {
        /// Number of fields in the row.
        fields: usize,
        /// Number of fields in the header.
        columns: usize,
        /// The first value without a column.
        value: String,
    },
    /// The file ends inside a quoted field.
    #[error("the quote that opens \"{value}\" is never closed")]
    Unclosed {
        /// Beginning of the field, after its quote.
        value: String,
    },
    /// A value is a number that it cannot be.
    #[error("column {column}: {value} is out of range: it must be {range}")]
    OutOfRange {
        /// Name of the column.
        column: String,
        /// The field, as it stands in the file.
        value: String,
        /// The values that it may have, in words.
        range: &'static str,
    },
    /// A value is no finite number.
    #[error("column {column}: \"{value}\" {problem}")]
    Value {
        /// Name of the column.
        column: String,
        /// The field, as it stands in the file.
        value: String,
        /// Problem with the value, in words.
        problem: &'static str,
    },
}

/// `field` as it can stand in a message.
pub(super) fn legible(field: &[u8]) -> String {
    messages::excerpt(&String::from_utf8_lossy(field.trim_ascii()).escape_debug().to_string())
}
