//! Every way to draw behind one face: what draws a prepared scene, by the method that is chosen.

use std::fmt;

use crate::camera::Projection;
use crate::cpu::packets::PacketRenderer;
use crate::gpu::canvas::Canvas;
use crate::gpu::device::Gpu;
use crate::gpu::drawing::Drawing;
use crate::gpu::error::{GpuError, Undrawn};
use crate::gpu::mesh::{self, MeshRenderer};
use crate::gpu::preparation::{self, NeededPipeline};
use crate::gpu::rays::{self, Bounds, RayRenderer};
use crate::gpu::target::EyeTarget;
use crate::picture::hit::HitImage;
use crate::picture::pixels::Picture;
use crate::scene::prepared_scene::PreparedScene;
use crate::view::{Appearance, Geometry, View};

/// A way to draw a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Method {
    /// A ray test per pixel on the CPU, in f64.
    ///
    /// # Accuracy
    ///
    /// `tests/reference.rs`: against the core's light cone of each point shown, from rest to gamma = 1e30,
    /// positions are off by less than 1e-11 px, distances and Doppler factors by less than 1e-13 of
    /// themselves; a tracer that walks back along the light, without a boost, sees the same bodies. So it is
    /// with one light cone for both eyes. `tests/oblique_riding.rs`, for a camera that moves in any
    /// direction: places are within 1e-9 of the core's for a moving observer up to gamma = 1000, and a search
    /// back along the light on the ground sees the same bodies at every pixel.
    Reference,
    /// A ray test per pixel on the GPU, in f32.
    ///
    /// # Accuracy
    ///
    /// `tests/gpu_rays.rs`, against the reference from rest to gamma = 1e30: the body differs at fewer than
    /// 0.1 % of covered pixels, all of them within 0.05 px of an outline; D is within 1e-5; hits lie within
    /// 2e-6 of the surfaces of bodies about 1 large. Where tubes share a rounded end, the first of them is
    /// seen. `tests/gpu_pictures.rs`: away from outlines colours are within 2 of 255 levels.
    ///
    /// Of groups that fly apart all but the fastest lose digits as the camera recedes in their frames. Where
    /// two do so 3 units away, bodies a tenth of a unit apart are still told apart up to gamma = 1e5; at 1e6
    /// the slower group (of equally fast ones the second) shows one body for another at up to 3 % of its
    /// pixels, the fastest at none.
    ///
    /// It is as accurate before a camera that moves in any direction: there the tests go to gamma = 1e6 for
    /// the camera and for what it passes, to 100 for each where groups pass each other, and to 0.99 c for
    /// wheels.
    ///
    /// Of wheels that roll (`tests/gpu_wheels.rs`, up to beta = 0.9999, rays in the wheel's plane among them)
    /// no more pixels are wrong. Outlines of what turns are within 0.002 px, and its D within 2e-4 of itself
    /// times gamma: about where a wheel touches the road D falls from 1 within 1/gamma^2 of its radius, and
    /// f32 has the place to 1e-7 of it. Spokes are met where a ray first enters them, also where it runs
    /// along one in the wheel's plane: `tests/spokes.rs` finds no pixel of a thousand views, gamma to 1000,
    /// that shows what is seen nowhere within that many pixels.
    ///
    /// Of models (`tests/gpu_models.rs`, to gamma = 1e30) no ray passes between triangles that share corners;
    /// models of triangles show another triangle at up to 0.01 % of the pixels that a thousand small ones
    /// cover, each within 0.05 px of the one that is seen there. Those that roll
    /// (`tests/gpu_rolling_models.rs`, up to beta = 0.999) show what is not seen within those 0.05 px at up
    /// to 0.01 % of their pixels (at none of 10,172 there); places on them are within 1e-3. Each of a pixel's
    /// four samples looks for itself. On the device a triangle takes 64 bytes, and its share of the boxes 16
    /// to 64.
    Rays,
    /// A ray test per pixel on the CPU, in f32, eight pixels at a time.
    ///
    /// # Accuracy
    ///
    /// That of [`Self::Rays`], whose formulas it shares: the same tests hold it to the same promises. Of
    /// several bodies thinner than a pixel it blends the nearest with what covers the pixel behind, and
    /// leaves out those between.
    ///
    /// On a processor that has not even registers of four numbers, the rays or the reference draw instead.
    Packets,
    /// Triangles on the GPU: a grid over each body, as fine as the body is large in the picture. What stands
    /// still in a view of the published model, or of one light cone for both eyes, is drawn by the rays.
    ///
    /// # Accuracy
    ///
    /// `tests/gpu_mesh.rs`, against the reference from rest to gamma = 1e30: each pixel shows what is seen no
    /// further off than [`Self::MESH_ERROR_PX`], bodies many times as long as they are far among it.
    /// `tests/gpu_pictures.rs`: colours away from outlines are within 6 of 255 levels. Before a camera that
    /// moves in any direction it keeps the bound up to gamma = 1e6 for the camera and for what it passes.
    /// Groups are told apart as by the rays. With one light cone for both eyes, alone or among groups, the
    /// bound is kept, too. A conformal picture has no bound where the line through the eyes meets a body,
    /// infinitely far aside: of a wheel around that line at most 1 % of the pixels show another body than is
    /// seen within the bound, up to 0.99 c and as seen (`tests/gpu_wheels.rs`); contracted at 0.9999 c up to
    /// 12 % did.
    ///
    /// Models keep the bound (`tests/gpu_models.rs`), but for those much longer than they are far; and the
    /// background shows nowhere between triangles.
    Mesh,
}

impl Method {
    /// Greatest distance at which the mesh draws a point from where it is seen, pixels, in pictures with up
    /// to 1,000 pixels per radian. Its finest triangles are the same in every picture, so the distance grows
    /// in proportion in finer ones: [`Self::mesh_error_px`].
    pub const MESH_ERROR_PX: f64 = 0.5;

    /// Pixels per radian up to which the mesh keeps [`Self::MESH_ERROR_PX`].
    const MESH_PX_PER_RADIAN: f64 = 1000.0;

    /// Returns the greatest distance at which the mesh draws a point of `view` from where it is seen, pixels.
    #[must_use]
    pub fn mesh_error_px(view: &View) -> f64 {
        Self::MESH_ERROR_PX * (view.camera.px_per_radian() / Self::MESH_PX_PER_RADIAN).max(1.0)
    }

    /// Whether it draws on the CPU, and so needs no GPU.
    #[must_use]
    pub const fn is_on_cpu(self) -> bool {
        matches!(self, Self::Reference | Self::Packets)
    }

    /// Returns the method that draws `view` where this one is chosen: the published model, which is defined
    /// point by point, is known to the mesh renderer alone; one light cone for both eyes, whose rays are
    /// curved, not to the rays; a picture of half the sky to the reference alone. [`View::drawn`] tells
    /// whether anything draws it.
    #[must_use]
    pub fn of_view(self, view: &View) -> Self {
        if let Projection::Vr180 { .. } = view.camera.projection {
            return Self::Reference;
        }
        match (view.geometry, self) {
            (Geometry::Published, Self::Reference | Self::Rays | Self::Packets)
            | (Geometry::OneCone, Self::Rays | Self::Packets) => Self::Mesh,
            _ => self,
        }
    }

    /// Returns the method that draws `view` on the GPU where this one is chosen: an exact one replaces the
    /// reference. No method draws half of the sky there: that stays with the reference.
    #[must_use]
    pub fn on_gpu(self, view: &View) -> Self {
        let on_gpu = if self == Self::Reference { Self::Rays } else { self };
        on_gpu.of_view(view)
    }
}

impl View {
    /// Whether any renderer draws it.
    ///
    /// # Errors
    ///
    /// Half of the sky in the published model.
    pub fn drawn(&self) -> Result<(), Undrawn> {
        let is_half_of_sky = matches!(self.camera.projection, Projection::Vr180 { .. });
        if is_half_of_sky && self.geometry == Geometry::Published {
            return Err(Undrawn::HalfOfSkyPublished);
        }
        Ok(())
    }

    /// Whether a renderer on the GPU does.
    fn drawn_on_gpu(&self) -> Result<(), Undrawn> {
        match self.camera.projection {
            Projection::Vr180 { .. } => Err(Undrawn::HalfOfSkyOnGpu),
            Projection::Gaze | Projection::Parallel { .. } | Projection::Mercator { .. } => Ok(()),
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Reference => f.write_str("reference f64"),
            Self::Rays => f.write_str("rays f32"),
            Self::Packets => f.write_str("packets f32"),
            Self::Mesh => f.write_str("mesh f32"),
        }
    }
}

/// The renderers, each made when it is first needed.
#[derive(Debug)]
pub struct Renderers {
    gpu: Option<Gpu>,
    bounds: Bounds,
    canvas: Option<Canvas>,
    rays: Option<RayRenderer>,
    mesh: Option<MeshRenderer>,
    packets: Option<PacketRenderer>,
    target: Option<EyeTarget>,
}

impl Default for Renderers {
    /// Renderers without a GPU.
    fn default() -> Self {
        Self::new(None)
    }
}

impl Renderers {
    /// Renderers on `gpu`; without one, only the reference.
    #[must_use]
    pub fn new(gpu: Option<Gpu>) -> Self {
        let bounds = Bounds::default();
        let packets = PacketRenderer::new();
        Self { gpu, bounds, canvas: None, rays: None, mesh: None, packets, target: None }
    }

    /// Renderers of which the rays test every body at every pixel: the same pictures, and what its bounds are
    /// worth.
    #[must_use]
    pub fn brute_force(gpu: Gpu) -> Self {
        Self { bounds: Bounds::None, ..Self::new(Some(gpu)) }
    }

    /// The device, if there is one.
    #[must_use]
    pub const fn gpu(&self) -> Option<&Gpu> {
        self.gpu.as_ref()
    }

    /// Whether the packets draw on this machine.
    #[must_use]
    pub const fn has_packets(&self) -> bool {
        self.packets.is_some()
    }

    /// Returns the pipelines that [`Self::draw`] would have to make first, for this and for similar views:
    /// none where the CPU draws.
    #[must_use]
    pub fn missing(
        &self,
        method: Method,
        scene: &PreparedScene,
        view: &View,
        appearance: &Appearance,
    ) -> Vec<NeededPipeline> {
        let Some(gpu) = &self.gpu else { return Vec::new() };
        match method.on_gpu(view) {
            Method::Rays => preparation::missing(gpu, |_| rays::technique(gpu), scene, view, appearance),
            Method::Mesh => {
                preparation::missing(gpu, |group| mesh::technique(gpu, group), scene, view, appearance)
            }
            Method::Reference | Method::Packets => Vec::new(),
        }
    }

    /// Draws `scene` into `target`, whose size overrides the camera's, by the GPU's substitute for `method`,
    /// and returns the method that drew: the packets stand in for the rays where the device has no room
    /// for the scene's models.
    ///
    /// # Errors
    ///
    /// No device, a view that nothing draws there, or a device that refuses it.
    pub fn draw(
        &mut self,
        method: Method,
        scene: &PreparedScene,
        view: &View,
        appearance: &Appearance,
        target: &mut EyeTarget,
    ) -> Result<Method, GpuError> {
        let method = self.drawn_by(method, scene, view)?;
        let scopes = self.gpu.as_ref().ok_or(GpuError::NoAdapter)?.error_scopes();
        if method == Method::Packets
            && let (Some(gpu), Some(packets)) = (&self.gpu, &self.packets)
        {
            target.write(
                gpu,
                &packets.picture_while(scene, &view.with_size(target.size()), appearance, &|| true),
            );
            return scopes.close().map(|()| method);
        }
        if let (Method::Reference, Some(gpu)) = (method, &self.gpu) {
            target.write(gpu, &scene.picture(&view.with_size(target.size()), appearance, 1));
            return scopes.close().map(|()| method);
        }
        let (gpu, canvas, drawing) = self.drawing(method)?;
        canvas.paint(gpu, drawing, scene, view, appearance, target);
        scopes.close().map(|()| method)
    }

    /// Returns the method that [`Self::draw`] draws `scene` by, for this `method`.
    ///
    /// # Errors
    ///
    /// A view that nothing draws there, or a device that refuses the scene's models.
    pub fn drawn_by(
        &mut self,
        method: Method,
        scene: &PreparedScene,
        view: &View,
    ) -> Result<Method, GpuError> {
        view.drawn_on_gpu()?;
        self.with_room_for_models(method.on_gpu(view), scene, view)
    }

    /// Draws `view` by the packets while `goes_on` is true, which is evaluated before each tile of 8 x 8
    /// pixels: tiles that are not drawn have no opacity. `None` where this machine has no packets.
    #[must_use]
    pub fn by_packets_while(
        &self,
        scene: &PreparedScene,
        view: &View,
        appearance: &Appearance,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Option<Picture> {
        Some(self.packets.as_ref()?.picture_while(scene, view, appearance, goes_on))
    }

    /// Returns `method`, with the models of `scene` on the device if it draws there; or the packets where the
    /// device has no room for them, the reference where the packets do not know `view`.
    fn with_room_for_models(
        &mut self,
        method: Method,
        scene: &PreparedScene,
        view: &View,
    ) -> Result<Method, GpuError> {
        let is_needed = !method.is_on_cpu() && scene.models().next().is_some();
        let Some(gpu) = self.gpu.as_ref().filter(|_| is_needed) else { return Ok(method) };
        let scopes = gpu.error_scopes();
        let has_room = self.canvas.get_or_insert_with(|| Canvas::new(gpu)).load_models(gpu, scene);
        scopes.close()?;
        if has_room {
            return Ok(method);
        }
        let packets = Some(Method::Packets).filter(|_| self.packets.is_some());
        let stands_in =
            packets.into_iter().chain([Method::Reference]).find(|method| method.of_view(view) == *method);
        Ok(stands_in.unwrap_or(method))
    }

    /// The picture of `view` by `method`, the reference with `samples` times `samples` rays per pixel.
    ///
    /// # Errors
    ///
    /// A view that nothing draws, no device where `method` needs one, a size that it cannot draw, or a device
    /// that refuses it or was lost.
    pub fn picture(
        &mut self,
        method: Method,
        scene: &PreparedScene,
        view: &View,
        appearance: &Appearance,
        samples: u32,
    ) -> Result<Picture, GpuError> {
        view.drawn()?;
        let method = self.with_room_for_models(method.of_view(view), scene, view)?;
        if method == Method::Packets
            && let Some(packets) = &self.packets
        {
            return Ok(packets.picture_while(scene, view, appearance, &|| true));
        }
        if method.is_on_cpu() {
            return Ok(scene.picture(view, appearance, samples));
        }
        let size = view.camera.size;
        let scopes = self.gpu.as_ref().ok_or(GpuError::NoAdapter)?.error_scopes();
        let mut target = self.sized_target(size)?;
        let drawn = self.draw(method, scene, view, appearance, &mut target);
        let bytes = target.rgba8(self.gpu.as_ref().ok_or(GpuError::NoAdapter)?);
        scopes.close().and(drawn)?;
        self.target = Some(target);
        let rgba = bytes?.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect();
        Ok(Picture { size, rgba })
    }

    /// Returns the hits at the centre of every pixel of `view` by `method`.
    ///
    /// # Errors
    ///
    /// As [`Self::picture`].
    pub fn hits(&mut self, method: Method, scene: &PreparedScene, view: &View) -> Result<HitImage, GpuError> {
        view.drawn()?;
        let method = self.with_room_for_models(method.of_view(view), scene, view)?;
        if method == Method::Reference {
            return Ok(scene.hit_image(view));
        }
        if method == Method::Packets {
            let packets = self.packets.as_ref();
            return Ok(packets.map_or_else(|| scene.hit_image(view), |packets| packets.hits(scene, view)));
        }
        self.check_size(view.camera.size)?;
        let scopes = self.gpu.as_ref().ok_or(GpuError::NoAdapter)?.error_scopes();
        let (gpu, canvas, drawing) = self.drawing(method)?;
        let hits = canvas.hits(gpu, drawing, scene, view);
        scopes.close().and(hits)
    }

    /// Returns the device, the canvas, and the GPU's substitute for `method`.
    fn drawing(&mut self, method: Method) -> Result<(&Gpu, &Canvas, &mut dyn Drawing), GpuError> {
        let gpu = self.gpu.as_ref().ok_or(GpuError::NoAdapter)?;
        let canvas = &*self.canvas.get_or_insert_with(|| Canvas::new(gpu));
        let drawing: &mut dyn Drawing = match method {
            Method::Reference | Method::Rays | Method::Packets => {
                self.rays.get_or_insert_with(|| RayRenderer::new(gpu, canvas, self.bounds))
            }
            Method::Mesh => self.mesh.get_or_insert_with(|| MeshRenderer::new(gpu, canvas, self.bounds)),
        };
        Ok((gpu, canvas, drawing))
    }

    /// The target of the last picture if it has this `size`, else a new one.
    fn sized_target(&mut self, size: [u32; 2]) -> Result<EyeTarget, GpuError> {
        self.check_size(size)?;
        let gpu = self.gpu.as_ref().ok_or(GpuError::NoAdapter)?;
        let kept = self.target.take().filter(|target| target.size() == size);
        Ok(kept.unwrap_or_else(|| EyeTarget::new(gpu, size)))
    }

    fn check_size(&self, size: [u32; 2]) -> Result<(), GpuError> {
        let gpu = self.gpu.as_ref().ok_or(GpuError::NoAdapter)?;
        let largest = gpu.largest_side();
        if size.into_iter().all(|side| side <= largest) {
            return Ok(());
        }
        Err(GpuError::TooLarge { adapter: gpu.description(), size: size.map(|side| side.min(largest)) })
    }
}
