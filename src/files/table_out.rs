//! Tables out, row by row: as CSV, or as JSON with the units of its columns.

use std::collections::BTreeSet;
use std::io::{self, BufWriter, Write};

use csv::ByteRecord;
use serde::Serializer as _;

use super::csv_in;
use super::csv_out::CsvWriter;

/// Gives the unit of a column by its name; `None` of one that is not known.
pub type UnitOf = fn(&str) -> Option<&'static str>;

/// Writes a table in one of its formats.
pub enum TableWriter<W: Write> {
    /// Comma-separated values below a header.
    Csv(Box<CsvWriter<W>>),
    /// `{"units": {COLUMN: UNIT, ...}, "rows": [{COLUMN: VALUE, ...}, ...]}`, a row in each line. Numbers are
    /// the shortest decimals that read back to the same f64, and null where there is none.
    Json(JsonRows<W>),
}

impl<W: Write> TableWriter<W> {
    /// Writes the header: the names of `given` columns, whose fields are passed through, and of `columns` of
    /// numbers. `given` keeps all of them.
    ///
    /// # Errors
    ///
    /// Those of the writer; in JSON, a name that two columns have.
    pub fn head(&mut self, given: &mut ByteRecord, columns: &[&str]) -> anyhow::Result<()> {
        match self {
            Self::Csv(csv) => {
                given.extend(columns);
                Ok(csv.write(given, &[])?)
            }
            Self::Json(json) => {
                let names = given.iter().map(csv_in::text).chain(columns.iter().map(ToString::to_string));
                json.head(&names.collect::<Vec<_>>())
            }
        }
    }

    /// Writes the fields of `row`, and then `numbers`, which must be finite; NaN stands for none.
    ///
    /// # Errors
    ///
    /// Those of the writer.
    pub fn row(&mut self, row: &mut ByteRecord, numbers: &[f64]) -> io::Result<()> {
        match self {
            Self::Csv(csv) => csv.write(row, numbers),
            Self::Json(json) => json.row(row, numbers),
        }
    }

    /// Pushes all rows so far to the reader at the other end.
    ///
    /// # Errors
    ///
    /// Those of the writer.
    pub fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::Csv(csv) => csv.flush(),
            Self::Json(json) => json.out.flush(),
        }
    }

    /// Writes what closes the table, and flushes the output.
    ///
    /// # Errors
    ///
    /// Those of the writer.
    pub fn finish(&mut self) -> io::Result<()> {
        if let Self::Json(json) = self {
            json.out.write_all(b"\n]}\n")?;
        }
        self.flush()
    }
}

/// Rows of JSON on their way out.
pub struct JsonRows<W: Write> {
    out: BufWriter<W>,
    unit: UnitOf,
    /// Keys with their colons, and whether fields of a column may be numbers.
    keys: Vec<(Vec<u8>, bool)>,
    has_rows: bool,
}

impl<W: Write> JsonRows<W> {
    /// Returns a writer into `writer` of columns whose units `unit` knows.
    pub fn new(writer: W, unit: UnitOf) -> Self {
        Self { out: BufWriter::new(writer), unit, keys: Vec::new(), has_rows: false }
    }

    fn head(&mut self, names: &[String]) -> anyhow::Result<()> {
        let mut known = BTreeSet::new();
        for name in names {
            let shown = gamow_platform::messages::excerpt(name);
            anyhow::ensure!(
                known.insert(name),
                "column {shown} is there twice; in JSON each needs a name of its own"
            );
        }
        let units = names.iter().filter_map(|name| Some((name, (self.unit)(name)?)));
        self.out.write_all(b"{\"units\":")?;
        serde_json::Serializer::new(&mut self.out).collect_map(units)?;
        self.out.write_all(b",\"rows\":[")?;
        let key = |name: &String| {
            Ok((format!("{}:", serde_json::to_string(name)?).into_bytes(), (self.unit)(name).is_some()))
        };
        self.keys = names.iter().map(key).collect::<anyhow::Result<_>>()?;
        Ok(())
    }

    fn row(&mut self, row: &ByteRecord, numbers: &[f64]) -> io::Result<()> {
        self.out.write_all(if self.has_rows { b",\n{" } else { b"\n{" })?;
        self.has_rows = true;
        for (place, (key, is_number)) in self.keys.iter().enumerate() {
            if place > 0 {
                self.out.write_all(b",")?;
            }
            self.out.write_all(key)?;
            let number = match row.get(place) {
                Some(field) if *is_number => csv_in::number(field),
                Some(_) => None,
                // NaN is null.
                None => Some(numbers[place - row.len()]),
            };
            let text = row.get(place).map(csv_in::text).filter(|text| !text.is_empty());
            match number {
                Some(number) => serde_json::to_writer(&mut self.out, &number)?,
                None => serde_json::to_writer(&mut self.out, &text)?,
            }
        }
        self.out.write_all(b"}")
    }
}
