//! Purposes of a file dialog, and the products that can be saved.

use std::path::{Path, PathBuf};

use crate::lesson::worksheet::SheetKind;
use crate::studio::film::FilmKind;

/// The purpose for which a file is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To show the contents of the file.
    Open,
    /// To fit the measured disparities in the file.
    OpenData,
    /// Saving this product.
    Save(Product),
}

/// A product that can be written to a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Product {
    /// The views, as a picture that records its state.
    Picture,
    /// The shown plots, as SVG.
    PlotsSvg,
    /// Data of the shown plots, as CSV.
    PlotsCsv,
    /// The state, as TOML.
    State,
    /// The scene in which a model rides, as TOML.
    Scene,
    /// T running through its range once.
    Film,
    /// The passage just shown, in ten seconds.
    TenSeconds,
    /// The fit, as JSON.
    Fit,
    /// Report of the lesson, as a page.
    Report,
    /// The questions of the lesson, to print.
    Worksheet,
    /// The lab of the lesson, to print.
    LabSheet,
    /// The page for whoever teaches the lesson.
    TeachersPage,
    /// The page of a class: how it has answered.
    ClassPage,
}

/// The words for a product.
struct ProductRow {
    name: &'static str,
    /// Title of the dialog that saves it.
    title: &'static str,
    /// End of the default name of its file, before the ending.
    mark: &'static str,
    endings: &'static [&'static str],
}

const fn row(
    name: &'static str,
    title: &'static str,
    mark: &'static str,
    endings: &'static [&'static str],
) -> ProductRow {
    ProductRow { name, title, mark, endings }
}

impl Product {
    /// Returns the name of the product, for use after "the".
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.row().name
    }

    const fn row(self) -> ProductRow {
        const HTML: &[&str] = &["html"];
        match self {
            Self::Picture => row("picture", "Save the picture", "", &["png"]),
            Self::PlotsSvg => row("plots", "Save the plots as SVG", "-plots", &["svg"]),
            Self::PlotsCsv => row("plots", "Save the plots as CSV", "-plots", &["csv"]),
            Self::State => row("state", "Save the state", "-state", &["toml"]),
            Self::Scene => row("scene", "Save the scene of the model", "-scene", &["toml"]),
            Self::Film => row("film", "Save a film", "-film", &FilmKind::ENDINGS),
            Self::TenSeconds => row("film of 10 s", "Save a film of 10 s", "-10s", &FilmKind::ENDINGS),
            Self::Fit => row("fit", "Save the fit", "-fit", &["json"]),
            Self::Report => row("report", "Save the report of the lesson", "-report", HTML),
            Self::Worksheet => row("worksheet", "Save the worksheet of the lesson", "-worksheet", HTML),
            Self::LabSheet => row("lab", "Save the lab of the lesson", "-lab", HTML),
            Self::TeachersPage => {
                row("teacher’s page", "Save the teacher’s page of the lesson", "-teacher", HTML)
            }
            Self::ClassPage => row("class’s page", "Save the page of the class", "-class", HTML),
        }
    }

    /// Returns what saving it does, for tooltips.
    #[must_use]
    pub const fn tip(self) -> &'static str {
        match self {
            Self::Picture => "Saves the views as they are, as PNG, with the state that they show.",
            Self::PlotsSvg => "Saves the curves of the shown tab, as a drawing.",
            Self::PlotsCsv => "Saves the curves of the shown tab, as a table.",
            Self::State => "Saves all settings, as TOML.",
            Self::Scene => "Saves the scene in which the opened model rides, to move it or to add to it.",
            Self::Film => {
                "Saves T running through its range once: a GIF, an MP4, an animated PNG, or a folder of pictures."
            }
            Self::TenSeconds => "Saves the passage just shown as a GIF or an MP4 of 10 s, to put in slides.",
            Self::Fit => "Saves the numbers of the Fit tab, as JSON.",
            Self::Report => "Saves what was predicted and seen in each step, as a page to keep or to print.",
            Self::Worksheet => "Saves the questions with room for answers, as a page to print.",
            Self::LabSheet => "Saves the task to measure by hand, with its data, as a page to print.",
            Self::TeachersPage => "Saves aim, minutes, what to say and the answers, as a page to print.",
            Self::ClassPage => "Saves how the class has answered each question, as a page to print.",
        }
    }

    /// The sheet of a lesson that it is, if it is one.
    #[must_use]
    pub const fn sheet(self) -> Option<SheetKind> {
        match self {
            Self::Worksheet => Some(SheetKind::Questions),
            Self::LabSheet => Some(SheetKind::Lab),
            Self::TeachersPage => Some(SheetKind::Teacher),
            _ => None,
        }
    }

    /// Whether the product is made of pictures, which can be of any size.
    #[must_use]
    pub const fn has_size(self) -> bool {
        matches!(self, Self::Picture | Self::Film | Self::TenSeconds)
    }

    /// Whether the product can be a folder of files, which has no ending.
    #[must_use]
    pub const fn can_be_a_folder(self) -> bool {
        matches!(self, Self::Film)
    }

    /// Returns the endings of the product's files, the default first.
    #[must_use]
    pub const fn endings(self) -> &'static [&'static str] {
        self.row().endings
    }

    /// Returns the default name of its file, for this `subject`: a scene, or a lesson.
    #[must_use]
    pub fn file_name(self, subject: &str) -> String {
        let ProductRow { mark, endings, .. } = self.row();
        format!("{subject}{mark}.{}", endings[0])
    }

    /// `path` with the usual ending where it has none.
    ///
    /// # Errors
    ///
    /// Another ending.
    pub fn with_ending(self, path: &Path) -> Result<PathBuf, String> {
        let Some(extension) = path.extension().map(|extension| extension.to_string_lossy().to_lowercase())
        else {
            return Ok(if self.can_be_a_folder() {
                path.to_owned()
            } else {
                path.with_extension(self.endings()[0])
            });
        };
        if self.endings().contains(&extension.as_str()) {
            return Ok(path.to_owned());
        }
        Err(match self {
            Self::Film => format!(
                "The name of a film ends in {}; a folder of pictures has no ending.",
                FilmKind::NAMED_ENDINGS
            ),
            Self::TenSeconds => format!("The name of a film ends in {}.", FilmKind::NAMED_ENDINGS),
            _ => format!("The name of such a file ends in .{}.", self.endings()[0]),
        })
    }
}

impl Purpose {
    /// Returns the title of the dialog.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Open => "Open a scene, a model, a state, a picture or data",
            Self::OpenData => "Fit own data",
            Self::Save(product) => product.row().title,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_get_the_ending_of_what_is_in_the_file() {
        let named = |product: Product, name| product.with_ending(Path::new(name));
        assert_eq!(named(Product::Picture, "a/ride"), Ok(PathBuf::from("a/ride.png")));
        assert_eq!(named(Product::Picture, "ride.PNG"), Ok(PathBuf::from("ride.PNG")));
        assert_eq!(named(Product::Film, "ride"), Ok(PathBuf::from("ride")));
        assert!(named(Product::Film, "ride.avi").expect_err("no film").contains(".gif, .mp4 or .png"));
        assert_eq!(
            named(Product::State, "ride.png"),
            Err("The name of such a file ends in .toml.".to_owned())
        );
    }
}
