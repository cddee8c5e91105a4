//! A file of measured disparities, and which of its readings are left out.

use std::path::Path;

use anyhow::Context as _;
use gamow_platform::{files, sizes};
use relativity_core::Baseline;
use serde::{Deserialize, Serialize};

use super::data::{AssumedUnits, Data, Eyes};
use super::left_out::{self, LeftOut};

/// A file of measured disparities, as it was read.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DataFile {
    /// Whole name, for error messages.
    place: String,
    /// Name without its folder.
    pub name: String,
    bytes: Vec<u8>,
    /// Whether the file has the standard deviations of its readings.
    pub has_sigmas: bool,
    /// Whether the file contains the separation of the eyes.
    pub has_separation: bool,
    /// The sentence on what was done to the file before it was fitted, if anything was.
    pub treatment: Option<String>,
    /// Readings that are left out of the fit, as somebody wishes.
    pub left_out: Vec<LeftOut>,
}

impl DataFile {
    /// Opens the file at `path`, whose eyes are held like `baseline` where it does not say.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, and what is wrong in it, in one line that names the file and the line.
    pub fn open(path: &Path, baseline: Baseline) -> anyhow::Result<Self> {
        let place = files::shown(path);
        let bytes = files::read(path, sizes::FILE_BYTES).with_context(|| place.clone())?;
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let mut file = Self {
            place,
            name,
            bytes,
            has_sigmas: false,
            has_separation: false,
            treatment: None,
            left_out: Vec::new(),
        };
        let data = file.data(baseline)?;
        (file.has_sigmas, file.has_separation) = (data.has_sigmas, data.has_separation);
        file.treatment = data.treatment;
        Ok(file)
    }

    /// Leaves the reading of this sample and curve out of the fit, or takes it back.
    pub fn leave_out_or_take_back(&mut self, sample: usize, curve: usize, baseline: Baseline) {
        let is_it = |left: &LeftOut| (left.sample, left.curve) == (sample, curve);
        if let Some(place) = self.left_out.iter().position(is_it) {
            self.left_out.remove(place);
        } else if let Ok(data) = self.data(baseline) {
            self.left_out.extend(LeftOut::new(&data, sample, curve));
            self.left_out.sort_by_key(|left| (left.sample, left.curve));
        }
    }

    /// Returns the words on what was done to the file, and on the readings that are left out.
    #[must_use]
    pub fn treatment(&self) -> Option<String> {
        let words: Vec<String> =
            self.treatment.clone().into_iter().chain(left_out::remark(&self.left_out)).collect();
        (!words.is_empty()).then(|| words.join("; "))
    }

    /// The readings, by eyes that are held like `baseline` where the file does not say.
    pub(super) fn data(&self, baseline: Baseline) -> anyhow::Result<Data> {
        let eyes = Eyes::unless_told(baseline);
        Data::read(&self.place, self.bytes.as_slice(), eyes, AssumedUnits::default())
    }
}
