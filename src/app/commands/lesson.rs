//! The lesson under way in the window: its states are shown, its reveals played.

use std::path::Path;

use relativity_render::Gaze;

use crate::app::state::State;
use crate::app::state::lesson::{LessonCommand, LessonSettings, Running, RunningAnimation};
use crate::app::state::notice::Notice;
use crate::app::state::pointer::Pick;
use crate::app::state::queries::audience::panel_of_step;
use crate::app::tools::clock;
use crate::lesson::{Animated, Answer, AnswerKind, Answers, Course, Lesson, LessonError, Phase, Prediction};
use crate::settings::Settings;

/// Entries in a lesson are noted at once: whoever opens it again goes on where it was. Answers are no steps
/// of the way back: undoing leads back to settings and to places, never to a lesson without an answer that
/// was given.
impl State {
    /// Begins `lesson`, or takes it up where it was left.
    ///
    /// # Errors
    /// What cannot be worked out or shown of it.
    pub fn begin_lesson(&mut self, lesson: &Lesson) -> Result<(), LessonError> {
        let mut course = Course::new(lesson)?;
        if let Some(way) = self.session.answers.progress(lesson) {
            course.take_up(way);
        }
        let before =
            self.session.lesson.as_ref().map_or(self.document.settings.window, |running| running.before);
        self.note_layout();
        let layout = self.lesson_base().picture.layout;
        self.session.lesson = Some(Running {
            course,
            is_folded: false,
            before,
            layout,
            plots_in: None,
            run: None,
            told: None,
            score: None,
        });
        (self.session.overlay, self.session.stage.audience.panel) = (None, None);
        if !lesson.is_a_preset() {
            self.session.next_lesson = Some(lesson.name.clone());
        }
        self.set_up();
        self.follow_lesson();
        Ok(())
    }

    /// Begins `lesson`, which is in the file at `path`.
    pub(in crate::app) fn open_lesson(&mut self, lesson: &Lesson, path: &Path) {
        match self.begin_lesson(lesson) {
            Ok(()) => self.session.recent.add(path),
            Err(error) => self.tell(Notice::error(error).about(path)),
        }
    }

    /// Continues the running lesson as `lesson`, the new contents of its file at `path`.
    pub(in crate::app) fn renew_lesson(&mut self, lesson: &Lesson, path: &Path) {
        let Some(running) = &mut self.session.lesson else { return };
        match running.course.renewed(lesson) {
            Ok(course) => {
                (running.course, running.told) = (course, None);
                self.set_up();
            }
            Err(error) => self.tell(Notice::error(error).about(path)),
        }
    }

    /// Performs a command of the lesson.
    pub(super) fn perform_lesson(&mut self, command: LessonCommand) {
        if let LessonCommand::Open(name) = command {
            let opened = self.library().open(&name).and_then(|lesson| self.begin_lesson(&lesson));
            if let Err(error) = opened {
                self.tell(Notice::error(error));
            }
            return;
        }
        let Some(running) = &mut self.session.lesson else { return };
        let was = running.course.place();
        let course = &mut running.course;
        match command {
            LessonCommand::Open(_) => {}
            LessonCommand::Draft(draft) => course.draft = draft,
            LessonCommand::Confidence(confidence) => course.confidence = confidence,
            LessonCommand::Predict => course.predict(),
            LessonCommand::Skip => course.skip(),
            LessonCommand::Observe(answer) => course.observe(answer),
            LessonCommand::Forward if running.run.is_some() => self.finish_run(),
            LessonCommand::Forward => course.forward(),
            LessonCommand::Back => course.back(),
            LessonCommand::GoTo(place) => course.go_to(place),
            LessonCommand::ToggleClass => course.toggle_class(),
            LessonCommand::ShowPlots(is_wanted) => running.plots_in = is_wanted.then_some(was.step),
            LessonCommand::ToggleFolded => running.is_folded = !running.is_folded,
            LessonCommand::SetUp => self.set_up(),
            LessonCommand::BeginAnew => {
                course.begin_anew();
                self.set_up();
            }
            LessonCommand::Close => self.close_lesson(),
        }
        let Some(now) = self.course().map(Course::place).filter(|now| *now != was) else { return };
        if now.step != was.step {
            self.session.stage.audience.panel = None;
        }
        let is_same_state = now.step == was.step && (now.phase == Phase::Ask) == (was.phase == Phase::Ask);
        if is_same_state {
            self.finish_run();
        } else if now.step < self.course().map_or(0, |course| course.lesson().steps.len()) {
            self.set_up();
        } else {
            self.note_end();
        }
    }

    /// Notes what was entered in the open lesson since it was as `before`.
    pub(in crate::app) fn note_answers(&mut self, before: &Course) {
        if let Some(running) = &self.session.lesson {
            self.session.answers.note(before, &running.course);
        }
    }

    /// Takes the `answers` that an earlier window has kept. Some may be of the lesson that is open: it takes
    /// them up if nothing has been done in it yet.
    pub fn recall_answers(&mut self, answers: &Answers) {
        self.session.answers.clone_from(answers);
        let Some(running) = &mut self.session.lesson else { return };
        let way = self.session.answers.progress(running.course.lesson());
        if let Some(way) = way.filter(|_| running.course.is_untouched()) {
            running.course.take_up(way);
            self.set_up();
        }
    }

    /// Notes that the lesson is over: the one after it comes next.
    fn note_end(&mut self) {
        if let Some(after) = self.lesson_after() {
            self.session.next_lesson = Some(after.name.clone());
        }
    }

    /// Has the state of the lesson's present place; its reveal runs, where there is one.
    fn set_up(&mut self) {
        self.follow_lesson();
        let Some(Running { course, told: Some(told), .. }) = &self.session.lesson else { return };
        let place = course.place();
        let animation = course.step().and_then(|step| step.reveal.as_ref()?.animation);
        let animation = animation.filter(|_| place.phase == Phase::Shown);
        let before = animation.and_then(|_| course.lesson().settings(place.step, false, &told.base).ok());
        let mut settings = told.settings.clone();
        if let Some((animation, before)) = animation.zip(before) {
            match animation.to {
                Animated::Time(_) => settings.time = before.time,
                Animated::Speed(_) => settings.motion.speed = before.motion.speed,
            }
        }
        self.show(settings);
        self.scratch.playing = false;
        let run = animation.map(|animation| {
            let from = match animation.to {
                Animated::Time(_) => Animated::Time(self.document.time),
                Animated::Speed(_) => Animated::Speed(self.document.settings.motion.speed),
            };
            RunningAnimation { from, animation, passed: 0.0 }
        });
        if let Some(running) = &mut self.session.lesson {
            running.run = run;
        }
    }

    /// Works out what the lesson has at its present place, if that or the window has changed.
    pub(in crate::app) fn follow_lesson(&mut self) {
        self.note_layout();
        let Some(running) = &self.session.lesson else { return };
        let (place, base) = (running.course.place(), self.lesson_base());
        if running.told.as_ref().is_some_and(|told| told.place == place && told.base == base) {
            return;
        }
        let lesson = running.course.lesson();
        let count = lesson.steps.len();
        let step = place.step.min(count.saturating_sub(1));
        let is_revealed = running.course.is_revealed() || place.step > step;
        let phase = |is_revealed| lesson.settings(step, is_revealed, &base);
        let told = phase(false).and_then(|before| {
            let phases = [before, phase(true)?];
            let panel = panel_of_step(&phases);
            let [before, after] = phases;
            let settings = if is_revealed { after } else { before };
            Ok(LessonSettings { place, base: base.clone(), settings, panel })
        });
        if let Err(error) = &told {
            self.tell(Notice::error(error));
        }
        if let Some(running) = &mut self.session.lesson {
            // The scenes are opened for it, which takes too long for every frame.
            running.score = (place.step >= count).then(|| running.course.score(&base));
            running.told = told.ok();
        }
    }

    fn close_lesson(&mut self) {
        self.note_layout();
        let Settings { window, picture, .. } = self.lesson_base();
        (self.document.settings.window, self.document.settings.picture.layout) = (window, picture.layout);
        self.session.lesson = None;
    }

    /// Notes a layout that is not the one that the lesson set: somebody has chosen it, and keeps it.
    fn note_layout(&mut self) {
        let layout = self.document.settings.picture.layout;
        if let Some(running) = &mut self.session.lesson
            && running.told.as_ref().is_some_and(|told| told.settings.picture.layout != layout)
        {
            running.layout = layout;
        }
    }

    /// Lets what runs run by a `step` of the wall clock, seconds.
    pub(in crate::app) fn run_lesson(&mut self, step: f64) {
        let Some(run) = self.session.lesson.as_mut().and_then(|running| running.run.as_mut()) else { return };
        run.passed += step;
        let (now, is_over) = run.now();
        self.reach(now);
        if is_over {
            self.stop_run();
        }
    }

    /// Takes a running reveal to its end.
    fn finish_run(&mut self) {
        let run = self.session.lesson.as_mut().and_then(|running| running.run.take());
        if let Some(run) = run {
            self.reach(run.animation.to);
        }
    }

    /// Stops a running reveal at the point that it has reached.
    pub(in crate::app) fn stop_run(&mut self) {
        if let Some(running) = &mut self.session.lesson {
            running.run = None;
        }
    }

    fn reach(&mut self, now: Animated) {
        match now {
            Animated::Time(time) => self.document.time = clock::bounded(time),
            Animated::Speed(speed) => self.document.settings.motion.speed = speed,
        }
    }

    /// Whether a click into a view answers the lesson; then it does.
    pub(in crate::app) fn predicts_by(&mut self, pick: &Pick) -> bool {
        let is_asked = matches!(
            self.course().and_then(Course::asked),
            Some(Prediction { kind: AnswerKind::Point(_), .. })
        );
        if is_asked {
            let direction = self.view(pick.eye, pick.size).camera.line_of_sight(pick.pixel);
            let answer = Answer::Direction(Gaze::along(direction.into()));
            if let Some(running) = &mut self.session.lesson {
                running.course.draft = Some(answer);
            }
        }
        is_asked
    }
}
