//! A lesson on paper: the pupils' sheet, its answers, the lab and the teacher's page.

mod answers;
mod common;
mod lab;
mod pupil;
mod teacher;

use serde::{Deserialize, Serialize};

use super::plan::Lesson;
use crate::files::html::{HtmlPage, PageStyle};

/// A kind of sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum SheetKind {
    /// Questions, with room for answers.
    Questions,
    /// The right answers to the questions, on a sheet of their own.
    Answers,
    /// The task of the lab, with its data.
    Lab,
    /// The plan and the answers, for whoever teaches.
    Teacher,
}

/// The page of this kind of `lesson`, which is worked out. `on_step` is called after each step of it.
///
/// # Errors
/// A lab where there is none, those of the renderer, and of what is fitted in the lab.
pub fn page(lesson: &Lesson, sheet: SheetKind, on_step: impl FnMut()) -> anyhow::Result<String> {
    let mut page = HtmlPage::new(&lesson.title, PageStyle::Print);
    page.html("<div class=\"sheet\">\n");
    match sheet {
        SheetKind::Questions => pupil::write(&mut page, lesson, on_step)?,
        SheetKind::Answers => answers::write(&mut page, lesson, on_step)?,
        SheetKind::Teacher => teacher::write(&mut page, lesson)?,
        SheetKind::Lab => {
            let Some(done) = &lesson.lab else {
                anyhow::bail!("{}: this lesson has no lab: a heading `## Lab`", lesson.source_name);
            };
            lab::write(&mut page, lesson, done)?;
        }
    }
    page.html("</div>\n");
    Ok(page.finish())
}
