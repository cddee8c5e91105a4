//! The window in a browser: opened in the page's canvas, or replaced by a sentence with the reason. The
//! page's address holds the state.

mod accessibility;
mod address;
mod copying;
mod page_app;
mod webgpu;

use std::panic;
use std::path::Path;
use std::sync::Arc;

use eframe::{CreationContext, WebOptions, WebRunner};
use gamow_platform::files;
use gamow_platform::web::{instances, page, tasks};

use self::accessibility::Accessibility;
use self::address::{Fragment, missing_data};
pub(in crate::app::shell) use self::copying::Copying;
use self::page_app::PageApp;
use crate::app::commands::saving::SavingStep;
use crate::app::shell::App;
use crate::app::shell::persistence::{Keeper, Loaded, recall};
use crate::app::state::State;
use crate::app::state::files::reader::SceneReading;
use crate::app::state::fitting::FitSteps;
use crate::app::state::notice::Notice;
use crate::app::state::overlay::Overlay;
use crate::app::state::stage::Stage;
use crate::app::tools::painting;
use crate::app::tools::worker::{Work as _, serve as serve_work};
use crate::app::views::{
    corrected::Correction, examination::MethodSteps, picture_steps::PictureSteps, thumbnails::ThumbnailSteps,
};
use crate::estimate::data_file::DataFile;
use crate::settings::Settings;

/// The sentence for a browser without graphics.
const NO_GRAPHICS: &str = "The window cannot be drawn: this browser offers neither WebGPU nor WebGL 2, or they are switched off. \
    A current Firefox, Chrome, Edge or Safari has one of them; in its settings it may be called hardware acceleration.";

/// The page's events about a stereoscope, with what follows them.
const STEREOSCOPE_EVENTS: [(&str, fn(&mut PageApp)); 2] =
    [("gamow-turned", PageApp::turn_device), ("gamow-leave-stereoscope", PageApp::leave_stereoscope)];

/// Opens the window in the page; in an instance beside it, does the work that this is for.
pub fn start() {
    // Errors alone: what libraries warn of is no concern of a user's.
    let _ = eframe::WebLogger::init(log::LevelFilter::Error);
    if let Some(kind) = instances::own_kind() {
        return serve(&kind);
    }
    let runner = WebRunner::new();
    let report = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        report(info);
        page::show_defect();
    }));
    tasks::spawn(open(runner));
}

/// Does work of this kind for the page that has started this instance.
fn serve(kind: &str) {
    panic::set_hook(Box::new(|info| instances::fail(&info.to_string())));
    match kind {
        Correction::NAME => serve_work::<Correction>(),
        FitSteps::NAME => serve_work::<FitSteps>(),
        MethodSteps::NAME => serve_work::<MethodSteps>(),
        PictureSteps::NAME => serve_work::<PictureSteps>(),
        SceneReading::NAME => serve_work::<SceneReading>(),
        SavingStep::NAME => serve_work::<SavingStep>(),
        ThumbnailSteps::NAME => serve_work::<ThumbnailSteps>(),
        _ => instances::fail("there is no such work"),
    }
}

/// Opens the window, and shows a problem in its place if that fails.
async fn open(runner: WebRunner) {
    let Some(canvas) = page::canvas() else { return };
    let options = WebOptions { wgpu_options: webgpu::configuration(), ..WebOptions::default() };
    let own = runner.clone();
    let create = move |cc: &CreationContext<'_>| {
        let keeper = Keeper::in_folder(Path::new(files::KEPT));
        let mut state = first_state(keeper.load(), &Fragment::parse(&page::fragment()))?;
        state.scratch.notice = state.scratch.notice.or_else(webgpu::failure);
        keeper.memory().restore_in(&cc.egui_ctx, false);
        if let Some(render_state) = &cc.wgpu_render_state {
            painting::install(&cc.egui_ctx, render_state);
        }
        Accessibility::begin(&cc.egui_ctx);
        let app = App::new(&cc.egui_ctx, cc.wgpu_render_state.as_ref(), state);
        let app = app.preparing_in_background(&cc.egui_ctx).kept_by(keeper);
        // What was too much for them may have been the rays.
        let app = if page::graphics_were_lost() { app.without_automatic_rays() } else { app };
        Ok(Box::new(PageApp::new(app, own, cc)) as Box<dyn eframe::App>)
    };
    match runner.start(canvas, options, Box::new(create)).await {
        Ok(()) => listen(&runner),
        Err(error) => {
            log::warn!("{error:?}");
            if !page::offers_webgpu() || !page::reload_without_webgpu("it gives no device") {
                page::show_problem(NO_GRAPHICS);
            }
        }
    }
}

/// Has the window follow the address, and keep its state when the page goes.
fn listen(runner: &WebRunner) {
    let follower = runner.clone();
    page::on("hashchange", move || {
        if let Some(mut app) = follower.app_mut::<PageApp>() {
            app.follow(&Fragment::parse(&page::fragment()));
        }
    });
    for (event, then) in STEREOSCOPE_EVENTS {
        let shown = runner.clone();
        page::on(event, move || {
            if let Some(mut app) = shown.app_mut::<PageApp>() {
                then(&mut app);
            }
        });
    }
    let keeper = runner.clone();
    page::on("pagehide", move || {
        if let Some(mut app) = keeper.app_mut::<PageApp>() {
            eframe::App::on_exit(&mut *app);
        }
    });
}

/// The state that the address asks for, and the rest as the last visit left it.
fn first_state(left: Loaded, fragment: &Fragment) -> anyhow::Result<State> {
    let Loaded { settings, memory, answers, notice } = left;
    let (settings, problem) = fragment.settings(settings);
    let mut state = opened(settings)?;
    state.session.recent.extend(memory.recent());
    recall(&mut state, &memory, &answers, fragment.welcomes());
    if let Some(lesson) = &fragment.lesson {
        let begun = state.library().open(lesson).and_then(|lesson| state.begin_lesson(&lesson));
        state.scratch.notice = begun.err().map(Notice::error);
    }
    if fragment.presents {
        state.session.stage = Stage::presented();
    }
    state.session.stage.stereoscope = fragment.stereoscope;
    if fragment.start {
        state.session.overlay = Some(Overlay::Start);
    }
    let data = fragment.wanted_data(&state).map(|path| {
        let Ok(file) = DataFile::open(path, state.document.settings.baseline()) else {
            return missing_data(path);
        };
        let notice = Notice::done(format!("{} is fitted as this browser has kept it.", files::shown(path)));
        state.session.data = Some(Arc::new(file));
        notice
    });
    let problem = problem.map(Notice::error).or(notice).or(data);
    state.scratch.notice = problem.or(state.scratch.notice);
    if let Some(token) = &fragment.answers {
        state.follow_answers(token);
    }
    Ok(state)
}

/// The state of `settings`. Where their scene is no more, as that of a file which was dropped on the last
/// visit, the default one is shown, and why.
fn opened(settings: Settings) -> anyhow::Result<State> {
    let scene = settings.scene.clone();
    let default = settings.clone().with_scene(Settings::default().scene);
    State::open(settings).or_else(|error| {
        let mut state = State::open(default)?;
        state.tell(Notice::error(error).about(Path::new(&scene)));
        Ok(state)
    })
}
