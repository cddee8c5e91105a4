//! CSV rows out: fields passed through as bytes, and numbers as the shortest decimals that read back
//! to the same f64.

use std::io::{self, Write};

use csv::ByteRecord;

/// Writes rows of fields and numbers.
pub struct CsvWriter<W: Write> {
    csv: csv::Writer<W>,
    decimals: zmij::Buffer,
}

impl<W: Write> CsvWriter<W> {
    /// Returns a writer into `writer`.
    pub fn new(writer: W) -> Self {
        Self { csv: csv::Writer::from_writer(writer), decimals: zmij::Buffer::new() }
    }

    /// Writes the fields of `row`, quoted where necessary, and then `numbers`, which must be finite; NaN
    /// leaves its field empty. `row` keeps all of them.
    pub fn write(&mut self, row: &mut ByteRecord, numbers: &[f64]) -> io::Result<()> {
        for &number in numbers {
            if number.is_nan() {
                row.push_field(b"");
                continue;
            }
            let decimal = self.decimals.format_finite(number);
            if number.abs() < 1e16 {
                row.push_field(decimal.strip_suffix(".0").unwrap_or(decimal).as_bytes());
            } else {
                row.push_field(decimal.replacen('+', "", 1).as_bytes()); // 1e16 is shorter than 1e+16
            }
        }
        self.csv.write_byte_record(row).map_err(io_error)
    }

    /// Pushes all rows so far to the reader at the other end.
    pub fn flush(&mut self) -> io::Result<()> {
        self.csv.flush()
    }
}

impl CsvWriter<Vec<u8>> {
    /// Returns all rows as text; invalid UTF-8 in their fields is replaced.
    #[must_use]
    pub fn into_text(self) -> String {
        // Flushing into memory does not fail.
        let bytes = self.csv.into_inner().unwrap_or_default();
        String::from_utf8(bytes)
            .unwrap_or_else(|error| String::from_utf8_lossy(error.as_bytes()).into_owned())
    }
}

/// The error inside `error`: csv's own conversion would hide its kind, and with it a broken pipe.
#[must_use]
pub fn io_error(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
