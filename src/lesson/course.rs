//! Somebody's way through a lesson: predict, see, compare, explain.

use std::sync::Arc;

use gamow_platform::shared;
use serde::{Deserialize, Serialize};

use super::answer::{Answer, Confidence, Outcome, Record};
use super::answers::LessonProgress;
use super::error::LessonError;
use super::place::{Phase, Place};
use super::plan::{AnswerKind, Lesson, Prediction, Step};

/// Somebody's way through a lesson.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Course {
    #[serde(with = "shared")]
    lesson: Arc<Lesson>,
    place: Place,
    records: Vec<Record>,
    /// Answer that is being entered for the present step.
    pub draft: Option<Answer>,
    /// Confidence in the draft, if chosen.
    pub confidence: Option<Confidence>,
    /// Whether raised hands are counted.
    pub is_class: bool,
    /// Whether the question of what was seen was passed over at the present place.
    is_passed_over: bool,
}

impl Course {
    /// The beginning of `lesson`, as it was read.
    ///
    /// # Errors
    /// What cannot be worked out in it.
    pub fn new(lesson: &Lesson) -> Result<Self, LessonError> {
        let lesson = Arc::new(lesson.worked_out()?);
        let records = vec![Record::default(); lesson.steps.len()];
        Ok(Self {
            lesson,
            place: Place::START,
            records,
            draft: None,
            confidence: None,
            is_class: false,
            is_passed_over: false,
        })
    }

    /// Returns the same course through a rewritten `lesson`: at the present place, if it still exists, with
    /// the records of the steps that are as they were.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn renewed(&self, lesson: &Lesson) -> Result<Self, LessonError> {
        let mut renewed = Self { is_class: self.is_class, ..Self::new(lesson)? };
        let old = self.lesson.steps.iter().zip(&self.records);
        for ((new, kept), (step, record)) in renewed.lesson.steps.iter().zip(&mut renewed.records).zip(old) {
            if new.prediction == step.prediction && new.observation == step.observation {
                *kept = record.clone();
            }
        }
        let last = Place { step: renewed.lesson.steps.len(), phase: Phase::Ask };
        renewed.place = renewed.reached(self.place.min(last));
        Ok(renewed)
    }

    /// Returns how far the course is, to be stored.
    #[must_use]
    pub fn progress(&self) -> LessonProgress {
        LessonProgress::new(&self.lesson, &self.records, self.place, (self.draft.as_ref(), self.confidence))
    }

    /// Restores the `kept` way: the answers to questions that the lesson still has, and the place, if it
    /// still exists.
    pub fn take_up(&mut self, kept: &LessonProgress) {
        for (number, record) in self.records.iter_mut().enumerate() {
            *record = kept.record(&self.lesson, number);
        }
        let last = Place { step: self.lesson.steps.len(), phase: Phase::Ask };
        self.place = self.reached(kept.place().min(last));
        (self.draft, self.confidence) = kept.draft(&self.lesson, self.place);
        if self.draft.is_none() {
            (self.draft, self.confidence) = self.said();
        }
    }

    /// Returns the answer that was given to the question of the present place, and how sure it was.
    fn said(&self) -> (Option<Answer>, Option<Confidence>) {
        match self.asked().and_then(|_| self.record()?.outcome.clone()) {
            Some(Outcome::Made { answer, confidence }) => (Some(answer), confidence),
            Some(Outcome::Skipped) | None => (None, None),
        }
    }

    /// Returns whether nothing was done in the lesson.
    #[must_use]
    pub fn is_untouched(&self) -> bool {
        let is_new = self.place == Place::START && self.draft.is_none();
        is_new && self.records.iter().all(|record| *record == Record::default())
    }

    /// Starts the course again, without the answers that were given.
    pub fn begin_anew(&mut self) {
        self.records.fill(Record::default());
        (self.place, self.draft, self.confidence, self.is_passed_over) = (Place::START, None, None, false);
    }

    /// The lesson, worked out.
    #[must_use]
    pub fn lesson(&self) -> &Lesson {
        &self.lesson
    }

    /// Returns the present place.
    #[must_use]
    pub const fn place(&self) -> Place {
        self.place
    }

    /// The present step; none at the end.
    #[must_use]
    pub fn step(&self) -> Option<&Step> {
        self.lesson.steps.get(self.place.step)
    }

    /// Returns the record of each step.
    #[must_use]
    pub fn records(&self) -> &[Record] {
        &self.records
    }

    /// Returns the record of the present step.
    #[must_use]
    pub fn record(&self) -> Option<&Record> {
        self.records.get(self.place.step)
    }

    /// Returns the open prediction: that of the present step, before its reveal. Whoever comes back to it
    /// finds it open: skipped, it can be made; made, it can be changed.
    #[must_use]
    pub fn asked(&self) -> Option<&Prediction> {
        self.step()?.prediction.as_ref().filter(|_| self.place.phase == Phase::Ask)
    }

    /// Whether the question of the present step was answered before.
    #[must_use]
    pub fn is_answered(&self) -> bool {
        self.record().is_some_and(|record| record.answer().is_some())
    }

    /// Starts or ends counting raised hands.
    pub fn toggle_class(&mut self) {
        (self.is_class, self.draft) = (!self.is_class, None);
    }

    /// Returns whether the reveal of the present step has been opened.
    #[must_use]
    pub const fn is_revealed(&self) -> bool {
        !matches!(self.place.phase, Phase::Ask)
    }

    /// Returns whether the truth is shown beside the prediction: after the reveal, once the question of what
    /// was seen is answered or passed over.
    #[must_use]
    pub fn shows_truth(&self) -> bool {
        self.is_revealed() && !self.waits_for_observation()
    }

    /// Returns whether the question of what was seen is open and the truth comes after it.
    fn waits_for_observation(&self) -> bool {
        let is_asked =
            self.step().is_some_and(|step| step.observation.is_some() && step.prediction.is_some());
        let is_answered = self.record().is_some_and(|record| record.observed.is_some());
        is_asked && !is_answered && !self.is_passed_over && self.place.phase == Phase::Shown
    }

    /// Returns whether the reveal of the step of this number has been opened, or the step has been left
    /// behind.
    #[must_use]
    pub fn is_done(&self, number: usize) -> bool {
        let is_asked_for = self.records.get(number).is_some_and(|record| record.outcome.is_some());
        is_asked_for || number < self.place.step || (number == self.place.step && self.is_revealed())
    }

    /// Takes the answer that is being entered for the present step, if there is one, with its confidence; and
    /// goes on to the reveal.
    pub fn predict(&mut self) {
        let Some(answer) = self.draft.take().filter(Answer::is_entered) else { return };
        self.settle(Outcome::Made { answer, confidence: self.confidence });
    }

    /// Goes on to the reveal without a prediction, which is recorded. One that was made before stays.
    pub fn skip(&mut self) {
        self.settle(Outcome::Skipped);
    }

    fn settle(&mut self, outcome: Outcome) {
        if self.asked().is_none() {
            return;
        }
        let is_kept = outcome == Outcome::Skipped && self.is_answered();
        if let Some(record) = self.records.get_mut(self.place.step).filter(|_| !is_kept) {
            record.outcome = Some(outcome);
        }
        self.go_to(Place { phase: Phase::Shown, ..self.place });
    }

    /// Records what was seen: the answer of this number.
    pub fn observe(&mut self, answer: usize) {
        if let Some(record) = self.records.get_mut(self.place.step) {
            record.observed = Some(answer);
        }
    }

    /// The next place: what is predicted is predicted first, or skipped.
    pub fn forward(&mut self) {
        match self.asked() {
            Some(_) if self.draft.as_ref().is_some_and(Answer::is_entered) => self.predict(),
            Some(_) => self.skip(),
            None if self.waits_for_observation() => self.is_passed_over = true,
            None => self.go_to(self.next(self.place).unwrap_or(self.place)),
        }
    }

    /// Goes back to the place before.
    pub fn back(&mut self) {
        let before = self.before(self.place).unwrap_or(self.place);
        self.go_to(before);
    }

    /// Goes to `place`, or to the nearest before it that can be reached: no reveal without its prediction.
    pub fn go_to(&mut self, place: Place) {
        let reached = self.reached(place);
        if reached != self.place {
            // Whoever comes back from the explanation has been told.
            self.is_passed_over = reached.phase == Phase::Shown && reached < self.place;
            self.place = reached;
            (self.draft, self.confidence) = self.said();
        }
    }

    /// Passes over the questions of the steps before `step` that nobody has answered or skipped, so that it
    /// can be reached.
    pub fn pass_over(&mut self, step: usize) {
        for (earlier, record) in self.lesson.steps.iter().zip(&mut self.records).take(step) {
            if earlier.prediction.is_some() && record.outcome.is_none() {
                record.outcome = Some(Outcome::Skipped);
            }
        }
    }

    /// `place`, or the nearest before it that can be reached.
    fn reached(&self, place: Place) -> Place {
        let mut reached = Place::START;
        while reached < place {
            let is_asked = reached.phase == Phase::Ask
                && self.lesson.steps.get(reached.step).is_some_and(|step| step.prediction.is_some())
                && self.records[reached.step].outcome.is_none();
            match self.next(reached).filter(|next| !is_asked && *next <= place) {
                Some(next) => reached = next,
                None => break,
            }
        }
        reached
    }

    /// Whether one can go to the step of this number; that behind the last is the end.
    #[must_use]
    pub fn can_reach(&self, step: usize) -> bool {
        let place = Place { step, phase: Phase::Ask };
        self.reached(place) == place
    }

    /// The phases that a step has.
    fn phases(step: &Step) -> impl Iterator<Item = Phase> {
        let is_shown = step.reveal.is_some() || step.observation.is_some();
        let phases =
            [(Phase::Ask, true), (Phase::Shown, is_shown), (Phase::Explained, !step.explanation.is_empty())];
        phases.into_iter().filter(|(_, is_there)| *is_there).map(|(phase, _)| phase)
    }

    fn next(&self, Place { step, phase }: Place) -> Option<Place> {
        let present = self.lesson.steps.get(step)?;
        let later = Self::phases(present).find(|later| *later > phase);
        let place = later.map_or(Place { step: step + 1, phase: Phase::Ask }, |phase| Place { step, phase });
        // A state that only shows something has no sentence to end with.
        let is_there = place.step < self.lesson.steps.len() || !self.lesson.sentence.is_empty();
        is_there.then_some(place)
    }

    fn before(&self, Place { step, phase }: Place) -> Option<Place> {
        let phases = |step: usize| self.lesson.steps.get(step).map(Self::phases).into_iter().flatten();
        if let Some(phase) = phases(step).take_while(|earlier| *earlier < phase).last() {
            return Some(Place { step, phase });
        }
        let step = step.checked_sub(1)?;
        Some(Place { step, phase: phases(step).last()? })
    }

    /// Whether there is a place after this one, and one before it.
    #[must_use]
    pub fn can_go(&self) -> [bool; 2] {
        let is_open = self.asked().is_some() || self.waits_for_observation();
        [self.before(self.place).is_some(), is_open || self.next(self.place).is_some()]
    }

    /// Returns the number of raised hands for each of `choices` choices.
    #[must_use]
    pub fn votes(&self, choices: usize) -> Vec<u32> {
        match &self.draft {
            Some(Answer::Votes(votes)) if votes.len() == choices => votes.clone(),
            _ => vec![0; choices],
        }
    }

    /// Returns whether the open prediction is answered by counting votes. An earlier answer keeps its own
    /// form.
    #[must_use]
    pub fn counts_hands(&self) -> bool {
        let counts = match &self.draft {
            Some(Answer::Votes(_)) => true,
            Some(Answer::Choice(_)) => false,
            _ => self.is_class,
        };
        counts && self.asked().is_some_and(|asked| matches!(asked.kind, AnswerKind::Choice(_)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flags::choices::Layout;
    use crate::lesson::Library;
    use crate::settings::{Preset, Settings};

    const ASKED: &str = "---\ntitle: Asked\n---\n\nAbout it.\n\n## One\n\nA step without a question.\n\n## Two\n\nLook.\n\n\
        ### Predict\n\nWhich?\n\n- [ ] this\n- [x] that\n\n### Reveal\n\n```play\ntime = 5\n```\n\n### Explain\n\nSo.\n\n\
        ## In a sentence\n\nThat.\n";

    fn course(text: &str) -> Course {
        Course::new(&Lesson::read("asked", text, "asked.md").expect("a lesson"))
            .expect("it can be worked out")
    }

    fn at(step: usize, phase: Phase) -> Place {
        Place { step, phase }
    }

    #[test]
    fn nothing_is_revealed_without_a_prediction_or_a_skip() {
        let mut course = course(ASKED);
        let end = at(2, Phase::Ask);
        course.go_to(end);
        assert_eq!(course.place(), at(1, Phase::Ask));
        assert!(course.asked().is_some());
        course.predict();
        assert_eq!(course.place(), at(1, Phase::Ask), "nothing was entered");
        course.draft = Some(Answer::Choice(1));
        course.confidence = Some(Confidence::Sure);
        course.predict();
        assert_eq!(course.place(), at(1, Phase::Shown));
        let made = Outcome::Made { answer: Answer::Choice(1), confidence: Some(Confidence::Sure) };
        assert_eq!(course.record().and_then(|record| record.outcome.clone()), Some(made));
        course.go_to(end);
        assert_eq!((course.place(), course.step()), (end, None));
    }

    #[test]
    fn one_goes_through_every_place_and_back_again() {
        let mut course = course(ASKED);
        let mut places = vec![course.place()];
        while course.can_go()[1] {
            course.forward();
            places.push(course.place());
        }
        let expected =
            [(0, Phase::Ask), (1, Phase::Ask), (1, Phase::Shown), (1, Phase::Explained), (2, Phase::Ask)];
        assert_eq!(places, expected.map(|(step, phase)| at(step, phase)));
        assert_eq!(course.records()[1].outcome, Some(Outcome::Skipped));
        for place in places.iter().rev().skip(1) {
            course.back();
            assert_eq!(course.place(), *place);
        }
        assert!(!course.can_go()[0]);
        // What was skipped is asked again, and going on without an answer skips it again.
        course.go_to(at(1, Phase::Ask));
        assert!(course.asked().is_some() && course.draft.is_none());
        course.forward();
        assert_eq!(
            (course.place(), &course.records()[1].outcome),
            (at(1, Phase::Shown), &Some(Outcome::Skipped))
        );
    }

    #[test]
    fn an_answer_is_found_again_and_can_be_changed() {
        let made = |choice| {
            Some(Outcome::Made { answer: Answer::Choice(choice), confidence: Some(Confidence::Guess) })
        };
        let mut course = course(ASKED);
        course.go_to(at(1, Phase::Ask));
        (course.draft, course.confidence) = (Some(Answer::Choice(0)), Some(Confidence::Guess));
        course.predict();
        for come_back in [Course::back, |course: &mut Course| course.go_to(at(1, Phase::Ask))] {
            come_back(&mut course);
            assert!(course.asked().is_some());
            let found = (course.draft.clone(), course.confidence);
            assert_eq!(found, (Some(Answer::Choice(0)), Some(Confidence::Guess)));
            course.forward();
            assert_eq!((course.place(), &course.records()[1].outcome), (at(1, Phase::Shown), &made(0)));
        }
        // Neither an empty answer nor *Skip* takes it away.
        course.back();
        course.draft = None;
        course.forward();
        assert_eq!(course.records()[1].outcome, made(0));
        course.back();
        course.skip();
        assert_eq!(course.records()[1].outcome, made(0));
        course.back();
        course.draft = Some(Answer::Choice(1));
        course.predict();
        assert_eq!(course.records()[1].outcome, made(1));
    }

    #[test]
    fn the_truth_waits_for_what_was_seen() {
        let text = ASKED.replace("### Explain", "### Observe\n\nSeen?\n\n- [x] yes\n- [ ] no\n\n### Explain");
        let mut course = course(&text);
        course.go_to(at(1, Phase::Ask));
        assert!(!course.shows_truth());
        course.draft = Some(Answer::Choice(0));
        course.predict();
        assert_eq!((course.place(), course.shows_truth()), (at(1, Phase::Shown), false));
        // Passed over, the truth comes at the same place.
        course.forward();
        assert_eq!((course.place(), course.shows_truth()), (at(1, Phase::Shown), true));
        course.forward();
        assert_eq!((course.place(), course.shows_truth()), (at(1, Phase::Explained), true));
        course.back();
        assert!(course.shows_truth());
        // Shown again from the question on, it waits again; until what was seen is said.
        course.back();
        course.forward();
        assert_eq!((course.place(), course.shows_truth()), (at(1, Phase::Shown), false));
        course.observe(1);
        assert!(course.shows_truth());
        course.forward();
        assert_eq!(course.place(), at(1, Phase::Explained));
    }

    #[test]
    fn a_lesson_that_is_written_anew_keeps_what_is_still_asked() {
        let mut course = course(ASKED);
        course.go_to(at(1, Phase::Ask));
        course.draft = Some(Answer::Choice(0));
        course.predict();
        let renewed = |text: &str| {
            course.renewed(&Lesson::read("asked", text, "asked.md").expect("a lesson")).expect("it is right")
        };
        let reworded = renewed(&ASKED.replace("Look.", "Look at it."));
        assert_eq!((reworded.place(), &reworded.records()[1]), (course.place(), &course.records()[1]));
        let asked_anew = renewed(&ASKED.replace("- [ ] this", "- [ ] these"));
        assert_eq!((asked_anew.place(), asked_anew.records()[1].outcome.clone()), (at(1, Phase::Ask), None));
    }

    #[test]
    fn a_preset_is_a_lesson_of_one_step() {
        let library = Library::own();
        for preset in Preset::all() {
            let lesson = library.open(preset.name).expect("a lesson");
            assert!(lesson.is_a_preset());
            let course = Course::new(&lesson).expect("it can be worked out");
            assert_eq!(course.can_go(), [false, false]);
            let default = Settings::default();
            assert_eq!(lesson.settings(0, false, &default).expect("settings"), preset.settings);
        }
    }

    #[test]
    fn what_a_lesson_compares_is_seen_in_two_pictures_whatever_the_layout() {
        let library = Library::own();
        let mut base = Settings::default();
        base.picture.layout = Layout::Dubois;
        for name in ["what-gamow-drew", "headlight"] {
            let lesson = library.open(name).expect("a lesson");
            let all = (0..lesson.steps.len()).flat_map(|step| {
                [false, true].map(|shown| lesson.settings(step, shown, &base).expect("settings"))
            });
            let (compared, others): (Vec<_>, Vec<_>) =
                all.partition(|settings| !settings.look.compare.is_off());
            assert!(!compared.is_empty() && compared.iter().all(Settings::is_comparing), "{name}");
            assert!(others.iter().all(|settings| settings.picture.layout == Layout::Dubois), "{name}");
        }
    }

    #[test]
    fn hands_are_counted_for_choices_alone() {
        let mut course = course(ASKED);
        course.toggle_class();
        assert!(!course.counts_hands());
        course.forward();
        assert!(course.counts_hands());
        assert_eq!(course.votes(2), [0, 0]);
        course.draft = Some(Answer::Votes(vec![3, 12]));
        course.forward();
        assert_eq!(course.votes(2), [0, 0]);
        let made = Outcome::Made { answer: Answer::Votes(vec![3, 12]), confidence: None };
        assert_eq!(course.record().and_then(|record| record.outcome.clone()), Some(made));
    }
}
