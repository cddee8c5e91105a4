//! Does what the state cannot do itself: writes files, and copies.

use eframe::egui::{Context, Ui};
use gamow_platform::files;
use relativity_render::Picture;

use crate::app::commands::FileCommand;
use crate::app::commands::saving::MOST_FRAMES;
use crate::app::commands::saving::work::{SaveJob, SaveOutcome, SceneSnapshot, name_of};
use crate::app::shell::App;
#[cfg(not(feature = "desktop"))]
use crate::app::shell::web::Copying;
use crate::app::state::files::purpose::Product;
use crate::app::state::notice::Notice;
use crate::app::state::orders::{Copied, Order, Saving};
use crate::app::tools::image;
use crate::app::tools::page_link::link_to;
use crate::files::whole::write_whole;
use crate::flags::choices::{Compare, RendererChoice, Size};
use crate::flags::words::Shell;
use crate::lesson::Lesson;
use crate::scene::is_model;
use crate::settings::{Daylight, Settings};
use crate::studio::film::{FilmKind, loop_times};

/// The message that the picture was copied. A page cannot see what the browser does with it.
const PICTURE_COPIED: &str = if cfg!(feature = "desktop") {
    "Copied the picture."
} else {
    "The browser was given the picture to copy."
};

impl App {
    /// Fulfils the orders, and reports the outcome of earlier ones.
    pub(in crate::app) fn fulfil_orders(&mut self, ui: &Ui) {
        for order in self.state.take_orders() {
            match order {
                Order::Save(saving) => self.save_as(ui, saving),
                Order::Copy(copied) => self.copy(ui, copied),
                Order::Open(path) => self.run_all(ui.ctx(), vec![FileCommand::Open(path).into()]),
                Order::Stop => {
                    if self.saver.stop() {
                        self.tell(ui.ctx(), Notice::done("Stopped: no file was written."));
                    }
                }
            }
        }
        let ctx = ui.ctx();
        #[cfg(not(feature = "desktop"))]
        if let Some(notice) = Copying::take_done(&mut self.copying) {
            self.tell(ctx, notice);
        }
        match self.saver.made() {
            None => {}
            Some(SaveOutcome::File(path, text)) => self.tell(ctx, Notice::done(text).about(&path)),
            Some(SaveOutcome::Picture(Picture { size, rgba })) => {
                self.tell(ctx, Notice::done(PICTURE_COPIED));
                ctx.copy_image(image::of_pixels(size, &rgba));
            }
            Some(SaveOutcome::Nothing(path, problem)) => self.tell(ctx, Notice::error(problem).about(&path)),
        }
    }

    fn tell(&mut self, ctx: &Context, notice: Notice) {
        self.state.tell(notice);
        ctx.request_repaint();
    }

    fn begin(&mut self, ctx: &Context, job: SaveJob, name: String, frames: u32) {
        if self.saver.is_busy() {
            return self.tell(ctx, Notice::error("Something is still being saved: wait for it, or stop it."));
        }
        self.saver.begin(ctx, job, name, frames);
    }

    fn save_as(&mut self, ui: &Ui, Saving { product, path, size }: Saving) {
        // A pipe would keep the window waiting for a reader.
        if let Err(problem) = files::check_replaceable(&path) {
            return self.tell(ui.ctx(), Notice::error(format!("Nothing was saved: {problem}.")).about(&path));
        }
        let name = name_of(&path);
        let mut pictures = 1;
        let job = match product {
            Product::Picture => SaveJob::Picture(self.drawn(ui, size), path),
            Product::Film | Product::TenSeconds => {
                let (range, frames) = self.state.film(product);
                let Some(kind) = FilmKind::from_path(&path).filter(|_| frames <= MOST_FRAMES) else {
                    let text = format!(
                        "A film has {MOST_FRAMES} frames at most, and this would have {frames}: play it faster, or shorten the range of T."
                    );
                    return self.tell(ui.ctx(), Notice::error(text));
                };
                pictures = frames;
                SaveJob::Film(self.drawn(ui, size), loop_times(range, frames), kind, path)
            }
            Product::Fit => SaveJob::Fit(Box::new(self.state.fit_key()), path),
            Product::Report => {
                let Some(course) = self.state.course().cloned() else {
                    return self.tell(ui.ctx(), Notice::error("No lesson is open."));
                };
                let base = Box::new(self.state.lesson_base());
                // The fit that stands in its tab.
                let fit = self.fitting.shown().map(|_| Box::new(self.state.fit_key()));
                let pupil = self.state.session.class.name.clone();
                SaveJob::Report(Box::new(course), base, fit, pupil, path)
            }
            Product::Worksheet | Product::LabSheet | Product::TeachersPage => {
                let lesson = self.state.course().map(|course| Box::new(course.lesson().clone()));
                let Some((lesson, sheet)) = lesson.zip(product.sheet()) else {
                    return self.tell(ui.ctx(), Notice::error("No lesson is open."));
                };
                SaveJob::Sheet(lesson, sheet, path)
            }
            Product::ClassPage => {
                let lessons =
                    self.state.answered_lessons().iter().map(|lesson| Lesson::clone(lesson)).collect();
                SaveJob::Class(lessons, self.state.session.class.text.clone(), path)
            }
            Product::Scene => match self.state.scene_file().filter(|model| is_model(model)) {
                Some(model) => SaveJob::Scene(model.to_owned(), path),
                None => return self.tell(ui.ctx(), Notice::error("No model is open.")),
            },
            Product::PlotsSvg => {
                let text = self.plots_svg();
                return self.write_text(ui.ctx(), &path, &text);
            }
            Product::PlotsCsv => {
                let text = self.plots_csv();
                return self.write_text(ui.ctx(), &path, &text);
            }
            Product::State => {
                let told = self.state.shown().relative_to(&path);
                return self.write_text(ui.ctx(), &path, &told.to_toml());
            }
        };
        self.begin(ui.ctx(), job, name, pictures);
    }

    fn write_text(&mut self, ctx: &Context, path: &std::path::Path, text: &str) {
        let written = write_whole(path, |file| Ok(std::io::Write::write_all(file, text.as_bytes())?));
        let notice = match written {
            Ok(()) => Notice::done(format!("Saved {}.", name_of(path))),
            Err(error) => Notice::error(format!("{error:#}")),
        };
        self.tell(ctx, notice.about(path));
    }

    /// Returns the scene of the views, to be drawn with pictures of this `size` for each eye.
    fn drawn(&self, ui: &Ui, size: [u32; 2]) -> SceneSnapshot {
        let document = &self.state.document;
        SceneSnapshot {
            settings: self.settings_of_picture(ui, size),
            scene: document.scene.clone(),
            tracked: document.points.selected().track,
        }
    }

    /// The settings with which `gamow render` makes the picture that the views show, this `size` for each
    /// eye.
    fn settings_of_picture(&self, ui: &Ui, size: [u32; 2]) -> Settings {
        let mut settings = self.state.shown();
        settings.picture.size = Size(size);
        if self.state.frame.picture.keeps_height && settings.look.set_fov().is_some() {
            settings.look.fov = self.state.look().fov;
        }
        settings.look.geometry = settings.geometry();
        if !settings.is_comparing() {
            settings.look.compare = Compare::Off;
        }
        if settings.light.light == Daylight::Theme {
            settings.light.light = if ui.visuals().dark_mode { Daylight::Off } else { Daylight::On };
        }
        // Not every renderer draws every geometry: the window then takes the one that does.
        let [left, right] = settings.views(self.state.subject(), self.state.document.time, size);
        let method = settings.quality.method();
        if method.is_some_and(|method| [left, right].iter().any(|view| method.of_view(view) != method)) {
            settings.quality.renderer = RendererChoice::Auto;
        }
        settings
    }

    fn copy(&mut self, ui: &Ui, copied: Copied) {
        let ctx = ui.ctx();
        let text = match copied {
            Copied::Picture => {
                let job = SaveJob::Clipboard(self.drawn(ui, self.state.frame.picture.size));
                return self.begin(ctx, job, "the picture".to_owned(), 1);
            }
            Copied::Command => Ok(self.state.shown().window_command(Shell::here())),
            Copied::Link => self.state.shown().link_pairs().map(|pairs| link_to(&pairs)),
            Copied::Answers => {
                let pairs = self.state.own_answers().ok_or_else(|| "Nothing was answered yet.".to_owned());
                pairs.map(|pairs| link_to(&pairs))
            }
            Copied::RenderCommand => {
                Ok(self.settings_of_picture(ui, self.state.frame.picture.size).command(Shell::here()))
            }
            Copied::CurveCommand => self.state.curve_command(),
            Copied::Values => self.state.values_as_table(),
        };
        match text {
            Ok(text) => {
                // What is copied as a line is short enough to be shown.
                let shown = match copied {
                    Copied::Values => "the values at T".to_owned(),
                    Copied::Answers => "the link with your answers".to_owned(),
                    _ => text.clone(),
                };
                let is_link = matches!(copied, Copied::Link | Copied::Answers);
                self.copy_text(ctx, text, is_link, Notice::done(format!("Copied: {shown}")));
            }
            Err(problem) => self.tell(ctx, Notice::error(problem)),
        }
    }

    /// Copies `text`, and shows the `notice` once that is done.
    #[cfg(feature = "desktop")]
    fn copy_text(&mut self, ctx: &Context, text: String, _is_link: bool, notice: Notice) {
        ctx.copy_text(text);
        self.tell(ctx, notice);
    }

    /// Has the browser copy `text`, and shows the `notice` once that is done; on a phone a link is shared.
    #[cfg(not(feature = "desktop"))]
    fn copy_text(&mut self, ctx: &Context, text: String, is_link: bool, notice: Notice) {
        self.copying = Some(Copying::begin(ctx, text, is_link, notice));
    }
}
