//! The pace of what draws on the processor, the packets or a GPU in software: what would take longer than a
//! frame may is drawn with fewer pixels while it moves, and by the packets in full in the background once it
//! rests.

use gamow_platform::clock::Instant;
use relativity_render::{EyeTarget, Gpu, GpuError, Method, Picture, PreparedScene, Renderers, View};

use super::request::Request;

/// Time within which the packets draw an eye in a frame, milliseconds: of a scene that they have drawn in
/// full so far, and of one that they draw coarsely.
const MOST_MS: f64 = 500.0;
const COARSE_MS: f64 = 200.0;
/// Time within which a GPU in software draws an eye that rests, which nothing else may draw, milliseconds.
const AT_REST_MS: f64 = 2000.0;
/// Greatest number of pixels, each way, that are drawn as one.
const MOST: u32 = 32;
/// Number of pixels from which a GPU in software begins a scene: it cannot be stopped once it draws.
const FIRST_PIXELS: f64 = 20_000.0;

/// The coarseness at which pictures of a scene are drawn in time.
#[derive(Debug, Default)]
pub struct Pace {
    /// Scene that was drawn last.
    scene: Option<PreparedScene>,
    /// Number of times that the pixels were halved each way.
    halvings: u32,
    /// Time that a pixel of the scene's last picture by a GPU in software took, milliseconds, and its method.
    gpu_ms: Option<(f64, Method)>,
}

impl Pace {
    /// Draws `request` by `method` on a GPU in software into `target`, and returns how many pixels are one
    /// each way: as few as there is time for, `at_rest` more of it, judged by the scene's last picture.
    ///
    /// # Errors
    ///
    /// As [`Renderers::draw`].
    pub fn draw_on_gpu(
        &mut self,
        renderers: &mut Renderers,
        gpu: &Gpu,
        (request, method, at_rest): (&Request, Method, bool),
        target: &mut EyeTarget,
    ) -> Result<u32, GpuError> {
        let Request { scene, view, appearance, .. } = request;
        self.follow(scene);
        let size = target.size();
        let mut ms_a_pixel = |coarseness| {
            let start = Instant::now();
            let view = coarse(view, size, coarseness);
            if coarseness == 1 {
                renderers.draw(method, scene, &view, appearance, target)?;
                gpu.wait()?;
            } else {
                let picture = renderers.picture(method, scene, &view, appearance, 1)?;
                target.write(gpu, &enlarged(&picture, size));
            }
            Ok::<f64, GpuError>(start.elapsed_ms() / pixels(view.camera.size))
        };
        let expected_ms = match self.gpu_ms {
            Some((ms, of)) if of == method => ms,
            _ => {
                // What a scene's first picture takes is mostly to make its pipelines.
                let first = fitting(size, FIRST_PIXELS);
                ms_a_pixel(first)?;
                ms_a_pixel(first)?
            }
        };
        let most_ms = if at_rest { AT_REST_MS } else { COARSE_MS };
        let coarseness = fitting(size, most_ms / expected_ms);
        self.gpu_ms = Some((ms_a_pixel(coarseness)?, method));
        Ok(coarseness)
    }

    /// Forgets what was found of another scene.
    fn follow(&mut self, scene: &PreparedScene) {
        if self.scene.as_ref() != Some(scene) {
            *self = Self { scene: Some(scene.clone()), ..Self::default() };
        }
    }

    /// Draws `request` by the packets into `target`, and returns how many pixels are one each way: as many as
    /// it takes, from those of the last picture of the scene on. Those that are not drawn in time by then are
    /// missing.
    pub fn draw(
        &mut self,
        renderers: &Renderers,
        gpu: &Gpu,
        request: &Request,
        target: &mut EyeTarget,
    ) -> u32 {
        let Request { scene, view, appearance, .. } = request;
        self.follow(scene);
        let size = target.size();
        loop {
            let coarseness = 1 << self.halvings;
            let view = coarse(view, size, coarseness);
            let start = Instant::now();
            let most_ms = if coarseness == 1 { MOST_MS } else { COARSE_MS };
            let in_time = || start.elapsed_ms() < most_ms;
            let Some(picture) = renderers.by_packets_while(scene, &view, appearance, &in_time) else {
                return coarseness;
            };
            if !in_time() && coarseness < MOST {
                self.halvings += 1;
                continue;
            }
            // Twice as many pixels each way are four times as many.
            self.halvings -= u32::from(self.halvings > 0 && 4.0 * start.elapsed_ms() < 0.75 * COARSE_MS);
            target.write(gpu, &if coarseness == 1 { picture } else { enlarged(&picture, size) });
            return coarseness;
        }
    }
}

/// Number of pixels of a picture of this `size`.
pub(super) fn pixels(size: [u32; 2]) -> f64 {
    size.into_iter().map(f64::from).product()
}

/// Returns the least number of pixels, each way, of a picture of this `size` that are one in a picture of at
/// most so many pixels.
fn fitting(size: [u32; 2], most_pixels: f64) -> u32 {
    (0..=MOST.ilog2())
        .map(|halvings| 1 << halvings)
        .find(|side| pixels(size) <= most_pixels * f64::from(side * side))
        .unwrap_or(MOST)
}

/// Returns `view` with this many pixels of the picture as one each way.
fn coarse(view: &View, size: [u32; 2], coarseness: u32) -> View {
    view.with_size(size.map(|side| side.div_ceil(coarseness)))
}

/// Returns `picture` in this larger size: each of its pixels is several.
fn enlarged(picture: &Picture, size: [u32; 2]) -> Picture {
    let [width, height] = size;
    let of = |place: u32, side: usize| {
        (u64::from(place) * u64::from(picture.size[side]) / u64::from(size[side])) as usize
    };
    let columns: Vec<_> = (0..width).map(|column| of(column, 0)).collect();
    let rows = (0..height).flat_map(|row| {
        let own = &picture.rgba[of(row, 1) * picture.size[0] as usize..];
        columns.iter().map(|&column| own[column])
    });
    Picture { size, rgba: rows.collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_drawn_as_one_fits_into_the_time() {
        assert_eq!(
            [400_000.0, 399_999.0, 100_000.0, 99_999.0].map(|most| fitting([800, 500], most)),
            [1, 2, 2, 4]
        );
        assert_eq!([f64::INFINITY, 0.0, f64::NAN].map(|most| fitting([800, 500], most)), [1, MOST, MOST]);
    }

    #[test]
    fn every_pixel_of_a_coarse_picture_is_a_block_of_a_large_one() {
        let rgba = (0..6).map(|number| [number, 0, 0, 255]).collect();
        let large = enlarged(&Picture { size: [3, 2], rgba }, [11, 8]);
        let red = |column: usize, row: usize| large.rgba[11 * row + column][0];
        assert_eq!([red(0, 0), red(3, 0), red(4, 3), red(7, 3), red(8, 0), red(10, 7)], [0, 0, 1, 1, 2, 5]);
        assert_eq!(large.rgba.len(), 88);
    }
}
