//! The application: the window as a whole, which panels read and commands change.

#[cfg(feature = "desktop")]
pub mod args;
mod audience_page;
mod automatic;
mod dropped;
mod full_screen;
#[cfg(feature = "desktop")]
pub mod launch;
mod orders;
mod other_screen;
mod page;
mod panes;
pub mod persistence;
mod projector;
#[cfg(feature = "desktop")]
mod recovery;
#[cfg(feature = "desktop")]
mod screenshot;
mod stereoscope;
#[cfg(not(feature = "desktop"))]
pub mod web;
mod window;
mod window_state;

#[cfg(feature = "desktop")]
use std::sync::Arc;

use eframe::egui::{self, Ui};
use eframe::egui_wgpu::RenderState;
use relativity_render::Geometry;

use crate::app::commands::file_dialog::Chooser;
use crate::app::commands::riding::keys;
use crate::app::commands::saving::Saver;
use crate::app::commands::{Command, FileCommand};
use crate::app::panels;
use crate::app::panels::plots::Plotted;
use crate::app::shell::full_screen::FullScreen;
use crate::app::shell::other_screen::Screen;
use crate::app::shell::persistence::Keeper;
use crate::app::shell::window_state::WindowState;
use crate::app::state::State;
use crate::app::state::files::reader::Reader;
use crate::app::state::fitting::Fitting;
use crate::app::state::frame::Looked;
use crate::app::state::plots::curves::QuantityCurves;
use crate::app::state::riding::saddle::RideCommand;
use crate::app::tools::aids;
use crate::app::tools::gpu_errors::GpuErrors;
#[cfg(feature = "desktop")]
use crate::app::tools::system_fonts::SystemFonts;
use crate::app::tools::watch::Watch;
use crate::app::views::corrected::Corrected;
use crate::app::views::examination::Examination;
use crate::app::views::eyes::{Chosen, EyePictures};
use crate::app::views::fade::Fade;
use crate::app::views::start_picture::StartPicture;
use crate::app::views::stereoscope::viewer::Stereoscope;
use crate::app::views::thumbnails::Thumbnails;
use crate::app::widgets::theme;
use crate::settings::PlotTab;

/// The application: the whole window.
pub struct App {
    state: WindowState,
    curves: Vec<QuantityCurves>,
    fitting: Fitting,
    corrected: Option<Corrected>,
    examination: Option<Examination>,
    eyes: Option<EyePictures>,
    /// Automatic choice for views of each geometry that is shown in this frame.
    chosen: Vec<(Geometry, Chosen)>,
    /// Whether pictures may get smoother while nothing changes.
    refines: bool,
    gpu_errors: GpuErrors,
    /// Fonts for what the program's own lack; in a page the browser draws that.
    #[cfg(feature = "desktop")]
    system_fonts: Arc<SystemFonts>,
    /// Pictures in the projector's window, once there was one.
    projected: Option<EyePictures>,
    /// The looks of the eyes in the projector's window: its pictures have a size of their own.
    projected_looks: [Option<Looked>; 2],
    /// On which screen the projector's window is.
    screen: Screen,
    full_screen: FullScreen,
    fade: Fade,
    /// The stereoscope, while the window is its screen.
    stereoscope: Option<Stereoscope>,
    text_scale: f32,
    chooser: Chooser,
    reader: Reader,
    saver: Saver,
    /// The text that the browser is copying.
    #[cfg(not(feature = "desktop"))]
    copying: Option<web::Copying>,
    thumbnails: Thumbnails,
    /// The moving picture of the start page, while that is shown.
    start_picture: Option<StartPicture>,
    watch: Option<Watch>,
    /// Commands of a clicker, held back until the picture of the last one is shown.
    waiting: Vec<Command>,
    /// Writes what outlasts the window; none where nothing does.
    keeper: Option<Keeper>,
}

/// The name of the window.
const TITLE: &str = "Gamow";
/// Greatest step of T in one frame, seconds of the wall clock.
const LONGEST_STEP: f64 = 0.25;
/// Margin around the bar, the controls and the readout, points.
const INSET: egui::Vec2 = egui::vec2(theme::GAP, theme::GAP / 2.0);

impl App {
    /// The window's content in `state`; without `render_state` there are no views.
    #[must_use]
    pub fn new(ctx: &egui::Context, render_state: Option<&RenderState>, state: State) -> Self {
        theme::install(ctx);
        #[cfg(feature = "desktop")]
        let system_fonts = Arc::new(SystemFonts::default());
        #[cfg(feature = "desktop")]
        ctx.add_font_provider(system_fonts.clone());
        Self {
            #[cfg(feature = "desktop")]
            system_fonts,
            state: WindowState::new(state),
            curves: Vec::new(),
            fitting: Fitting::default(),
            corrected: None,
            examination: None,
            eyes: render_state.map(EyePictures::new),
            chosen: Vec::new(),
            refines: true,
            gpu_errors: GpuErrors::new(ctx, render_state),
            projected: None,
            projected_looks: [None, None],
            screen: Screen::default(),
            full_screen: FullScreen::default(),
            fade: Fade::default(),
            stereoscope: None,
            text_scale: 1.0,
            chooser: Chooser::default(),
            reader: Reader::new(ctx.clone()),
            saver: Saver::default(),
            #[cfg(not(feature = "desktop"))]
            copying: None,
            thumbnails: Thumbnails::default(),
            start_picture: None,
            watch: None,
            waiting: Vec::new(),
            keeper: None,
        }
    }

    /// Has the pipelines of pictures made in the background, so that the window never waits for them.
    #[must_use]
    pub fn preparing_in_background(mut self, ctx: &egui::Context) -> Self {
        self.eyes.iter_mut().for_each(|eyes| eyes.prepare_in_background(ctx));
        self
    }

    /// Has the `keeper` write what outlasts the window.
    #[must_use]
    pub fn kept_by(self, keeper: Keeper) -> Self {
        Self { keeper: Some(keeper), ..self }
    }

    /// Returns the state that the window shows.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// The fit of the selected point.
    #[must_use]
    pub const fn fitting(&self) -> &Fitting {
        &self.fitting
    }

    /// The corrected picture, while there is one.
    #[must_use]
    pub const fn corrected(&self) -> Option<&Corrected> {
        self.corrected.as_ref()
    }

    /// Returns the examination of the present views, once the Accuracy tab was shown.
    #[must_use]
    pub const fn examination(&self) -> Option<&Examination> {
        self.examination.as_ref()
    }

    /// The thumbnails of the start page.
    #[must_use]
    pub const fn thumbnails(&self) -> &Thumbnails {
        &self.thumbnails
    }

    /// Returns the number of pictures of the start page drawn since that was opened.
    #[must_use]
    pub fn start_picture_drawings(&self) -> u64 {
        self.start_picture.as_ref().map_or(0, StartPicture::drawings)
    }

    /// Returns the contents of the shown plot tab as SVG.
    #[must_use]
    pub fn plots_svg(&mut self) -> String {
        self.update_curves();
        panels::plots::svg(&self.state, self.plotted())
    }

    /// Returns the contents of the shown plot tab as CSV.
    #[must_use]
    pub fn plots_csv(&mut self) -> String {
        self.update_curves();
        panels::plots::csv(&self.state, self.plotted())
    }

    /// Returns the data of the plots.
    const fn plotted(&self) -> Plotted<'_> {
        Plotted {
            curves: self.curves.as_slice(),
            fitting: &self.fitting,
            examination: self.examination.as_ref(),
        }
    }

    /// Whether everything is as it stays while nothing changes: no work in the background is left.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        !self.fitting.is_pending()
            && !self.reader.is_busy()
            && !self.saver.is_busy()
            && self.thumbnails.is_settled()
            && self.corrected.as_ref().is_none_or(Corrected::is_up_to_date)
            && !self.examination.as_ref().is_some_and(Examination::is_pending)
            && self.eyes.as_ref().is_none_or(EyePictures::is_settled)
            && self.fade.is_settled()
    }

    /// Whether pictures of before are still on their way out.
    #[must_use]
    pub const fn is_fading(&self) -> bool {
        !self.fade.is_settled()
    }

    /// Whether a file is being read that will be shown.
    #[must_use]
    pub const fn is_reading(&self) -> bool {
        self.reader.is_busy()
    }

    /// Runs `command` as if the user had given it; a file that it needs is read first, in the background.
    pub fn run(&mut self, command: impl Into<Command>) {
        let command = command.into();
        if let Command::File(file) = &command {
            if *file == FileCommand::StopReading {
                return self.reader.stop();
            }
            if let Some(errand) = self.state.errand(file) {
                self.state.close_chooser();
                self.reader.begin(errand);
                return;
            }
        }
        self.state.run(command);
        if let Some(keeper) = &self.keeper {
            self.state.note_in(keeper);
        }
    }

    /// Brings the curves up to date; those that still hold are kept.
    fn update_curves(&mut self) {
        self.curves = self
            .state
            .plotted_keys()
            .into_iter()
            .map(|key| match self.curves.iter().position(|curves| curves.key == key) {
                Some(kept) => self.curves.swap_remove(kept),
                None => QuantityCurves::new(key),
            })
            .collect();
    }

    /// Has the fit of the selected point made while it is in view.
    fn update_fit(&mut self, ctx: &egui::Context, plots_are_shown: bool) {
        if plots_are_shown && self.state.document.settings.plots.plot == PlotTab::Fit {
            self.fitting.update(ctx, self.state.fit_key());
        } else {
            self.fitting.rest();
        }
    }

    /// Why the graphics device is lost, if it is: then the window cannot be drawn.
    #[must_use]
    pub fn loss(&self) -> Option<String> {
        self.gpu_errors.loss()
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        if let Some(keeper) = &self.keeper {
            self.state.keep_in(keeper, ctx);
        }
        // T waits with a picture; and what took longer than this was not seen.
        let longest = if self.state.frame.is_getting_ready { 0.0 } else { LONGEST_STEP };
        let step = f64::from(ctx.input(|input| input.stable_dt)).min(longest);
        let pushed = keys::held(ctx, &self.state);
        self.state.advance(step, pushed.is_some());
        if let Some(direction) = pushed {
            self.run(RideCommand::Push(direction, self.state.frame.step));
        }
        if self.state.follow_for_comfort(step) {
            ctx.request_repaint();
        }
        log::trace!("a frame took {:.3} ms", 1e3 * ctx.input(|input| input.unstable_dt));
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        self.choose_screen(frame);
        self.show(ui);
    }

    fn raw_input_hook(&mut self, _ctx: &egui::Context, input: &mut egui::RawInput) {
        aids::drop_what_is_no_number(input);
    }

    fn on_exit(&mut self) {
        if let Some(keeper) = &self.keeper
            && let Err(failure) = keeper.keep(&self.state)
        {
            // It is told once more when the program ends.
            log::warn!("{failure}");
        }
    }
}
