//! The window as an application of the page: it keeps the address current, and makes way for another, or for
//! a sentence, when its device is lost.

use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{Context, Event, Id, Pos2, RawInput, TouchDeviceId, TouchId, TouchPhase, Ui, Vec2};
use eframe::{CreationContext, WebRunner};
use gamow_platform::clock::Instant;
use gamow_platform::files;
use gamow_platform::web::{page, tasks};

use super::address::{Fragment, Opened, fitted_table, followed_answers, missing_data};
use super::webgpu::{self, FirstPicture};
use crate::app::commands::{FileCommand, WindowCommand};
use crate::app::panels::sentence;
use crate::app::shell::App;
use crate::app::state::State;
use crate::app::state::document::Document;
use crate::app::state::lesson::LessonCommand;
use crate::app::state::overlay::Overlay;

/// Time between a change of the state and its appearance in the address.
const REST: Duration = Duration::from_secs(1);

/// The window, with what ends it.
pub struct PageApp {
    app: App,
    runner: WebRunner,
    ctx: Context,
    address: Address,
    is_stereoscope: bool,
    is_webgpu: bool,
    is_new_to_touch: bool,
    first_picture: FirstPicture,
    has_ended: bool,
}

/// The page's address, with the state in it.
struct Address {
    document: Document,
    fragment: Option<Fragment>,
    opened: Option<Opened>,
    due: Option<Instant>,
}

impl Address {
    fn from_state(state: &State) -> Self {
        Self {
            document: state.document.clone(),
            fragment: Fragment::from_state(state),
            opened: Opened::from_state(state),
            due: None,
        }
    }

    /// Returns the text behind the `#`.
    fn text(&self) -> String {
        self.fragment.as_ref().map(Fragment::to_text).unwrap_or_default()
    }
}

impl PageApp {
    /// Shows `app`, which the `runner` runs, in the window of this `cc`.
    pub fn new(app: App, runner: WebRunner, cc: &CreationContext<'_>) -> Self {
        let address = Address::from_state(app.state());
        Self {
            app,
            runner,
            ctx: cc.egui_ctx.clone(),
            address,
            is_stereoscope: false,
            is_webgpu: webgpu::is_used(cc),
            is_new_to_touch: true,
            first_picture: FirstPicture::default(),
            has_ended: false,
        }
    }

    /// Shows what another `fragment` of the address asks for, and nothing on top of that: the browser has
    /// gone Back or Forward, or somebody has followed a link.
    pub fn follow(&mut self, fragment: &Fragment) {
        if let Some(lesson) = &fragment.lesson {
            self.app.run(LessonCommand::Open(lesson.clone()));
        } else if self.app.state().course().is_some() {
            self.app.run(LessonCommand::Close);
        }
        let overlay = self.app.state().session.overlay;
        if let Some(shown) = overlay.filter(|shown| !(fragment.start && shown.is_page())) {
            self.app.run(WindowCommand::Toggle(shown));
        }
        if fragment.start && !overlay.is_some_and(Overlay::is_page) {
            self.app.run(WindowCommand::Toggle(Overlay::Start));
        }
        if let Some(link) = fragment.link_to_follow() {
            self.app.run(FileCommand::Open(link));
        }
        if fragment.presents != self.app.state().session.stage.is_presented() {
            self.app.run(WindowCommand::TogglePresenting);
        }
        if fragment.stereoscope != self.app.state().session.stage.stereoscope {
            self.app.run(WindowCommand::ToggleStereoscope);
        }
        if let Some(link) = fragment.link_with_answers() {
            self.app.run(FileCommand::Open(link));
        }
        match fragment.wanted_data(self.app.state()) {
            Some(path) if files::is_file(path) => self.app.run(FileCommand::OpenData(path.to_owned())),
            Some(path) => self.app.state.tell(missing_data(path)),
            None => {}
        }
        self.address.opened = Opened::from_state(self.app.state());
        self.address.fragment = Some(fragment.clone());
        self.ctx.request_repaint();
    }

    /// Takes how the device is turned.
    pub fn turn_device(&mut self) {
        if let Some(angles) = page::turned() {
            self.app.turn_device(angles);
            self.ctx.request_repaint();
        }
    }

    /// Leaves the stereoscope, whose whole screen the viewer has left.
    pub fn leave_stereoscope(&mut self) {
        if self.app.state().session.stage.stereoscope {
            self.app.run(WindowCommand::ToggleStereoscope);
            self.ctx.request_repaint();
        }
    }

    /// Tells the page when the stereoscope is entered or left.
    fn tell_stereoscope(&mut self) {
        let is_on = self.app.state().session.stage.stereoscope;
        if is_on != self.is_stereoscope {
            self.is_stereoscope = is_on;
            page::set_stereoscope(is_on);
        }
    }

    /// Writes the state into the page's address: at once, and as a new entry of the browser's history, where
    /// a lesson, a preset or the start page was opened; in place of the present one a while after another
    /// change.
    fn keep_address(&mut self, ctx: &Context) {
        // A link that is being read may still change everything.
        if self.app.is_reading() {
            return;
        }
        let state = self.app.state();
        let opened = Opened::from_state(state);
        if opened != self.address.opened {
            if opened.is_some() {
                // The address that is left may be shorter than its state, such as that of a first visit.
                page::replace_fragment(&self.address.text());
                self.address = Address::from_state(state);
                page::push_fragment(&self.address.text());
                return;
            }
            self.address.opened = None;
        }
        let Address { document, fragment, due, .. } = &mut self.address;
        let Some(since) = due else {
            let is_other = fragment.as_ref().is_some_and(|fragment| {
                fragment.presents != state.session.stage.is_presented()
                    || fragment.stereoscope != state.session.stage.stereoscope
                    || fragment.start != matches!(opened, Some(Opened::Start))
                    || fragment.lesson.is_some() != state.course().is_some()
                    || fragment.answers.as_deref() != followed_answers(state)
                    || fragment.data.as_deref() != fitted_table(state)
            });
            if is_other || *document != state.document {
                *due = Some(Instant::now());
                ctx.request_repaint_after(REST);
            }
            return;
        };
        let rest = REST.saturating_sub(since.elapsed());
        if !rest.is_zero() {
            ctx.request_repaint_after(rest);
            return;
        }
        let now = Address::from_state(state);
        if now.fragment != self.address.fragment {
            page::replace_fragment(&now.text());
        }
        self.address = now;
    }

    /// Ends the window if its device is lost or shows nothing. WebGL 2 takes the place of WebGPU; without
    /// either, a sentence takes the window's.
    fn end_if_broken(&mut self) {
        let is_late = self.first_picture.look(&self.ctx);
        let loss = self.app.loss().map(|loss| format!("its device was lost: {}", loss.trim_end_matches('.')));
        let reason = loss.or_else(|| (is_late && self.is_webgpu).then(|| "it shows nothing".to_owned()));
        let Some(reason) = reason.filter(|_| !self.has_ended) else { return };
        self.has_ended = true;
        eframe::App::on_exit(self);
        if self.is_webgpu && page::reload_without_webgpu(&reason) {
            return;
        }
        page::show_problem(&format!("The graphics have failed ({reason}). What was shown is kept."));
        let runner = self.runner.clone();
        // Not before this frame has ended.
        tasks::spawn(async move {
            tasks::pause().await;
            runner.destroy();
        });
    }
}

/// Has screen readers say the sentence on the moment where it is not written; not in a lesson, which asks for
/// what is in it.
fn say_moment(ctx: &Context, state: &State) {
    if state.course().is_some() || state.session.overlay.is_some() || state.document.settings.window.sentence
    {
        return;
    }
    ctx.accesskit_node_builder(Id::unique("moment"), |node| {
        node.set_role(Role::Label);
        node.set_value(state.moment().sentence());
        node.set_live(sentence::live(state));
    });
}

impl eframe::App for PageApp {
    fn logic(&mut self, ctx: &Context, frame: &mut eframe::Frame) {
        self.end_if_broken();
        self.app.logic(ctx, frame);
        self.keep_address(ctx);
        self.tell_stereoscope();
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut eframe::Frame) {
        self.app.ui(ui, frame);
        say_moment(ui.ctx(), self.app.state());
    }

    fn raw_input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        // The toolkit lets a finger scroll once it knows of a touch screen, which it learns of by a touch:
        // the first swipe would do nothing.
        if self.is_new_to_touch && page::has_coarse_pointer() {
            input.events.push(Event::Touch {
                device_id: TouchDeviceId(0),
                id: TouchId(u64::MAX),
                phase: TouchPhase::Cancel,
                pos: Pos2::ZERO,
                force: None,
            });
        }
        self.is_new_to_touch = false;
        // The windowing library knows nothing of a browser's screen.
        if let (Some(sides), Some(viewport)) =
            (page::screen_sides(), input.viewports.get_mut(&input.viewport_id))
        {
            viewport.monitor_size = Some(Vec2::from(sides) / ctx.zoom_factor());
        }
        self.app.raw_input_hook(ctx, input);
    }

    fn on_exit(&mut self) {
        if let Some(fragment) = Fragment::from_state(self.app.state()).filter(|_| self.address.due.is_some())
        {
            page::replace_fragment(&fragment.to_text());
        }
        self.app.on_exit();
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self)
    }
}
