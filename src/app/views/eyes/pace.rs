//! The pace of the packets: what would take them longer than a frame may is drawn with fewer pixels while it
//! moves, and in full in the background once it rests.

use gamow_platform::clock::Instant;
use relativity_render::{EyeTarget, Gpu, Picture, PreparedScene, Renderers, View};

use super::request::Request;

/// Time within which the packets draw an eye in a frame, milliseconds: of a scene that they have drawn in
/// full so far, and of one that they draw coarsely.
const MOST_MS: f64 = 500.0;
const COARSE_MS: f64 = 200.0;
/// Greatest number of pixels, each way, that are drawn as one.
const MOST: u32 = 32;

/// The coarseness at which pictures of a scene are drawn in time.
#[derive(Debug, Default)]
pub struct Pace {
    /// Scene that was drawn last.
    scene: Option<PreparedScene>,
    /// Number of times that the pixels were halved each way.
    halvings: u32,
}

impl Pace {
    /// Draws `request` into `target`, and returns how many pixels are one each way: as many as it takes, from
    /// those of the last picture of the scene on. Those that are not drawn in time by then are missing.
    pub fn draw(
        &mut self,
        renderers: &Renderers,
        gpu: &Gpu,
        request: &Request,
        target: &mut EyeTarget,
    ) -> u32 {
        let Request { scene, view, appearance, .. } = request;
        if self.scene.as_ref() != Some(scene) {
            *self = Self { scene: Some(scene.clone()), halvings: 0 };
        }
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
    fn every_pixel_of_a_coarse_picture_is_a_block_of_a_large_one() {
        let rgba = (0..6).map(|number| [number, 0, 0, 255]).collect();
        let large = enlarged(&Picture { size: [3, 2], rgba }, [11, 8]);
        let red = |column: usize, row: usize| large.rgba[11 * row + column][0];
        assert_eq!([red(0, 0), red(3, 0), red(4, 3), red(7, 3), red(8, 0), red(10, 7)], [0, 0, 1, 1, 2, 5]);
        assert_eq!(large.rgba.len(), 88);
    }
}
