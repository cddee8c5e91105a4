//! Automatic quality in the window: what each drawing costs, measured in passing, and what draws the next
//! frame.

use std::sync::mpsc::{Receiver, Sender, channel};

use gamow_platform::clock::Instant;
use relativity_render::{EyeTarget, Geometry, Gpu, GpuError, Method, Renderers};

use super::pace::Pace;
use super::request::Request;
use super::slot::{Drawn, DrawnBy};
use crate::accuracy::{Automatic, Choice, Machine, MethodViews, REFERENCE_SAMPLES};
use crate::flags::Goal;

/// Frames in a row in which pictures were drawn, after which they are taken to move: only then others are
/// tried.
const MOVING: u32 = 8;
/// Time up to which the reference draws within a frame, milliseconds; else it draws in the background.
const AT_ONCE_MS: f64 = 100.0;

/// The meter: the automatic choice, and the measurements that guide it.
pub struct Meter {
    automatic: Automatic,
    clock: Instant,
    /// Whether costs are of use: while the choice is automatic.
    is_on: bool,
    /// Drawings when the last frame began, and the frames in a row that had some.
    drawings: u64,
    frames: u32,
    /// Costs that the device reports when it has drawn, and the number of reports that are still to come.
    sender: Sender<Measured>,
    measured: Receiver<Measured>,
    awaited: u32,
    pace: Pace,
    /// Whether a picture on the GPU has as few pixels as there is time for.
    paces_gpu: bool,
}

/// The cost of a drawing: by which method, of which geometry, milliseconds and pixels.
struct Measured {
    method: Method,
    geometry: Geometry,
    ms: f64,
    pixels: f64,
}

/// The automatic choice for the views of one kind in a frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Chosen {
    /// Choice that was made.
    pub choice: Choice,
    /// Method that draws this frame: the chosen one, or one on trial.
    pub method: Method,
}

impl Chosen {
    /// Whether the reference draws within the frame.
    pub fn at_once(&self) -> bool {
        self.method != self.choice.method || self.choice.ms <= AT_ONCE_MS
    }
}

impl Meter {
    /// Nothing is known yet of what `gpu` costs. Where that is software, its rays draw no preset sooner than
    /// the packets, if this machine `has_packets`: trials of them would only make pipelines.
    pub fn new(gpu: &Gpu, has_packets: bool) -> Self {
        let has_rays = !(gpu.is_software() && has_packets);
        let automatic = Automatic::new(Machine::from_gpu(Some(gpu))).with_rays(has_rays);
        let (sender, measured) = channel();
        Self {
            automatic,
            clock: Instant::now(),
            is_on: false,
            drawings: 0,
            frames: 0,
            sender,
            measured,
            awaited: 0,
            pace: Pace::default(),
            paces_gpu: gpu.is_software() && gpu.reads_back(),
        }
    }

    /// Returns this meter, drawing in full on the GPU whatever that takes.
    #[must_use]
    pub fn in_full(self) -> Self {
        Self { paces_gpu: false, ..self }
    }

    /// Returns this meter, which chooses no rays.
    #[must_use]
    pub fn without_rays(self) -> Self {
        Self { automatic: self.automatic.with_rays(false), ..self }
    }

    /// Begins a frame after this number of `drawings`, in which the choice is automatic or not.
    pub fn begin(&mut self, drawings: u64, is_on: bool) {
        self.receive();
        let has_moved = drawings != std::mem::replace(&mut self.drawings, drawings);
        self.frames = if has_moved && is_on { self.frames.saturating_add(1) } else { 0 };
        self.is_on = is_on;
    }

    /// Returns the method that draws `sight` in this frame.
    pub fn choose(&mut self, goal: Goal, sight: MethodViews<'_>) -> Option<Chosen> {
        let choice = self.automatic.choose(goal, sight)?;
        let now_ms = self.clock.elapsed_ms();
        let is_moving = self.frames >= MOVING;
        let trial = is_moving.then(|| self.automatic.trial(&choice, sight, now_ms)).flatten();
        Some(Chosen { choice, method: trial.unwrap_or(choice.method) })
    }

    /// Draws `request` into `target` by the method of `by`. What is measured is waited for where that is
    /// possible, and so is what was begun before it; once a cost is known that is done twice a second at
    /// most, so that it holds nothing up.
    pub fn draw(
        &mut self,
        renderers: &mut Renderers,
        gpu: &Gpu,
        request: &Request,
        by: DrawnBy,
        target: &mut EyeTarget,
    ) -> Result<Drawn, GpuError> {
        if !self.is_on {
            return self.draw_now(renderers, gpu, request, by, target);
        }
        let method = by.method;
        let geometry = request.view.geometry;
        let is_due =
            self.awaited == 0 && self.automatic.costs.is_due(method, geometry, self.clock.elapsed_ms());
        if !is_due {
            let drew = self.draw_now(renderers, gpu, request, by, target)?;
            self.automatic.costs.note(method, geometry, None, self.clock.elapsed_ms());
            return Ok(drew);
        }
        gpu.wait()?;
        let start = Instant::now();
        let drew = self.draw_now(renderers, gpu, request, by, target)?;
        let (sender, [width, height]) = (self.sender.clone(), target.size().map(f64::from));
        let pixels = width * height / f64::from(drew.coarseness * drew.coarseness);
        gpu.when_finished(move || {
            // The window may be gone.
            let _ = sender.send(Measured { method, geometry, ms: start.elapsed_ms(), pixels });
        });
        self.awaited += 1;
        gpu.wait()?;
        self.receive();
        Ok(drew)
    }

    /// Draws `request` into `target` by the method of `by`, on a GPU in software with as many pixels as there
    /// is time for.
    fn draw_now(
        &mut self,
        renderers: &mut Renderers,
        gpu: &Gpu,
        request: &Request,
        DrawnBy { method, at_rest, .. }: DrawnBy,
        target: &mut EyeTarget,
    ) -> Result<Drawn, GpuError> {
        let Request { scene, view, appearance, .. } = request;
        if method == Method::Reference {
            target.write(gpu, &scene.picture(view, appearance, REFERENCE_SAMPLES));
            return Ok(Drawn::in_full(method));
        }
        let method = renderers.drawn_by(method, scene, view)?;
        if method == Method::Packets {
            let coarseness = self.pace.draw(renderers, gpu, request, target);
            return Ok(Drawn { method, coarseness });
        }
        if self.paces_gpu && !method.is_on_cpu() {
            let coarseness = self.pace.draw_on_gpu(renderers, gpu, (request, method, at_rest), target)?;
            return Ok(Drawn { method, coarseness });
        }
        renderers.draw(method, scene, view, appearance, target).map(Drawn::in_full)
    }

    /// Notes the costs that the device has reported.
    fn receive(&mut self) {
        let now_ms = self.clock.elapsed_ms();
        for Measured { method, geometry, ms, pixels } in self.measured.try_iter() {
            self.awaited = self.awaited.saturating_sub(1);
            self.automatic.costs.note(method, geometry, Some((ms, pixels)), now_ms);
        }
    }
}
