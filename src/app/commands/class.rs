//! Answers that are handed in: a pupil's own as a link, and the links of a class.

use std::path::Path;
use std::sync::Arc;

use gamow_platform::messages;
use gamow_platform::sizes::TEXT_BYTES;

use crate::app::state::State;
use crate::app::state::class::ClassCommand;
use crate::app::state::notice::Notice;
use crate::app::state::overlay::Overlay;
use crate::lesson::class::{Collected, KEY, MOST_NAME_LETTERS, PupilAnswers, link_pair, right_of};
use crate::lesson::{Course, Lesson};
use crate::settings::{is_link, link_of_pairs};

impl State {
    /// Performs a command about answers.
    pub(super) fn perform_class(&mut self, command: ClassCommand) {
        match command {
            ClassCommand::Name(name) => {
                self.session.class.name = name.chars().take(MOST_NAME_LETTERS).collect();
            }
            ClassCommand::Text(text) => self.collect(text),
        }
    }

    /// Reads the answers in `text`, or in the beginning of one that is too long.
    fn collect(&mut self, mut text: String) {
        let most = text.floor_char_boundary(TEXT_BYTES as usize);
        text.truncate(most);
        self.session.class.collected = Collected::from_text(&text);
        self.session.class.text = text;
    }

    /// Adds the answers in this `token` of a followed link to those of the class, and leaves a message that
    /// names the pupil.
    pub(in crate::app) fn follow_answers(&mut self, token: &str) {
        let answers = match PupilAnswers::from_token(token) {
            Ok(answers) => answers,
            Err(problem) => return self.tell(Notice::error(format!("No answers: {problem}."))),
        };
        let link = link_of_pairs(&link_pair(token));
        let text = &self.session.class.text;
        if !text.contains(token) {
            let end = if text.is_empty() || text.ends_with('\n') { "" } else { "\n" };
            self.collect(format!("{text}{end}{link}\n"));
        }
        self.session.class.followed = Some(token.to_owned());
        self.session.overlay = Some(Overlay::Class);
        let notice = self.summary(&answers);
        self.tell(notice);
    }

    /// Returns a message with the pupil, the lesson and the number of right ones of these `answers`.
    fn summary(&self, answers: &PupilAnswers) -> Notice {
        let PupilAnswers { lesson: name, name: pupil, .. } = answers;
        let who = if pupil.is_empty() { "a pupil without a name" } else { pupil };
        let Some(lesson) = self.lessons_here().find(|lesson| lesson.name == *name) else {
            let name = messages::excerpt(name);
            return Notice::error(format!("Answers of {who} to a lesson that is not here: {name}."));
        };
        let title = &lesson.title;
        match right_of(&lesson, answers) {
            Ok([_, 0]) => Notice::done(format!("Answers of {who} to “{title}”.")),
            Ok([right, all]) => {
                Notice::done(format!("Answers of {who} to “{title}”: {right} of {all} right."))
            }
            Err(error) => Notice::error(format!("{error:#}")),
        }
    }

    /// Returns the lessons to which there are answers, in their order.
    pub(in crate::app) fn answered_lessons(&self) -> Vec<Arc<Lesson>> {
        let collected = &self.session.class.collected;
        self.lessons_here().filter(|lesson| collected.of(&lesson.name).next().is_some()).collect()
    }

    /// The lessons of the library, and the open one if it is from a file beside that. A name in a link opens
    /// no file.
    fn lessons_here(&self) -> impl Iterator<Item = Arc<Lesson>> {
        let library = self.library();
        let listed: Vec<_> = library.all().iter().filter(|lesson| !lesson.is_a_preset()).cloned().collect();
        let opened = self.course().map(Course::lesson).filter(|lesson| lesson.path.is_some());
        let opened = opened.filter(|opened| listed.iter().all(|lesson| lesson.name != opened.name)).cloned();
        listed.into_iter().chain(opened.map(Arc::new))
    }

    /// Returns the answers in the open lesson as the pair of a link; `None` where nothing was answered.
    pub(in crate::app) fn own_answers(&self) -> Option<String> {
        let course = self.course().filter(|course| !course.lesson().is_a_preset())?;
        let answers = PupilAnswers::new(course.lesson(), course.records(), &self.session.class.name);
        answers.has_any().then(|| link_pair(&answers.token()))
    }
}

/// Returns the token in `path` if that is a link with answers.
pub(in crate::app) fn answers_in(path: &Path) -> Option<&str> {
    let pairs = path.to_str().filter(|_| is_link(path))?.split_once('?')?.1;
    pairs.split('&').find_map(|pair| pair.strip_prefix(KEY)?.strip_prefix('=')).map(str::trim)
}
