//! Contact shadows on a road, the same way as `shaders/backdrop.wgsl`. [`crate::street::contact`] describes
//! them.

use crate::frame::uniform::FrameUniform;
use crate::simd::lanes::{F, Simd, SimdFloat as _, SimdMask as _, V2, all, select};
use crate::street::contact::{DARKEST, FARTHEST};

/// Share of a road's light that they leave at `foot` from the camera, of pixels of this width and depth
/// there, `distance` away.
#[inline(always)]
pub fn left_by_contacts<S: Simd>(simd: S, frame: &FrameUniform, foot: V2<S>, pixel: V2<S>) -> F<S> {
    let [x, y, z, count] = frame.contact_eye;
    let mut left = all(simd, 1.0);
    if count <= 0.0 {
        return left;
    }
    let from_middle = V2::new(foot.x + x, foot.y + y);
    let height = frame.ground[2] + z;
    let distance = (from_middle.dot(from_middle) + height * height).sqrt();
    let is_near = distance.simd_le(FARTHEST as f32);
    for [[place_x, place_y, late, rapid], [long, wide, gamma, _]] in
        frame.contacts.into_iter().take(count as usize)
    {
        let off = V2::new(foot.x - place_x, foot.y - place_y);
        let wider = pixel.y * pixel.y + wide;
        let is_beside = is_near & (off.y * off.y).simd_lt(wider);
        if !is_beside.any_true() {
            continue;
        }
        let lean = rapid / (distance + late);
        let (mean_x, mean_y) = (from_middle.x * 2.0 - off.x, from_middle.y * 2.0 - off.y);
        let stretch = V2::new(mean_x * lean + gamma, mean_y * lean);
        let along = stretch.dot(off);
        let blur = V2::new(stretch.x * pixel.x, stretch.y * pixel.y);
        let longer = blur.dot(blur) + long;
        let inside = (1.0 - along * along / longer - off.y * off.y / wider).max(0.0);
        let thin = (long / longer * (wide / wider)).sqrt();
        let taken = thin * inside * inside * DARKEST as f32;
        left *= 1.0 - select(is_beside, taken, all(simd, 0.0));
    }
    left
}
