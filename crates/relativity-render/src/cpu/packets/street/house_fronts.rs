//! House fronts beside a road, as `shaders/street.wgsl` has them.

use crate::frame::uniform::FrameUniform;
use crate::simd::lanes::{F, Mask, Simd, SimdFloat as _, V2, V3, all, clamp, select};
use crate::street::house_fronts::{CORNICE, COURSE, FRAME, HOUSE_WIDTH};

/// The range that a pixel covers along one axis.
#[derive(Debug, Clone, Copy)]
pub struct CoveredRange<S: Simd> {
    half: F<S>,
    share_per_length: F<S>,
}

/// Colour, and the share of the pixel that is covered.
pub struct FrontPixels<S: Simd> {
    pub colour: V3<S>,
    pub cover: F<S>,
}

/// The area that a pixel covers.
#[derive(Debug, Clone, Copy)]
struct Pixel<S: Simd> {
    place: V2<S>,
    size: V2<S>,
    along: CoveredRange<S>,
    upwards: CoveredRange<S>,
}

impl<S: Simd> CoveredRange<S> {
    /// Returns the coverage of a pixel of this size.
    #[inline(always)]
    pub fn new(pixel: F<S>) -> Self {
        let half = (pixel * 0.5).max(1e-6);
        Self { half, share_per_length: 0.5 / half }
    }

    #[inline(always)]
    pub fn band_cover(self, coordinate: F<S>, lowest: F<S>, highest: F<S>) -> F<S> {
        let covered = (coordinate + self.half).min(highest) - (coordinate - self.half).max(lowest);
        (covered * self.share_per_length).max(0.0).min(1.0)
    }

    #[inline(always)]
    pub fn repeated_cover(self, coordinate: F<S>, length: f32, period: f32) -> F<S> {
        let (from, to) = (coordinate - self.half, coordinate + self.half);
        let (before_from, before_to) = ((from * (1.0 / period)).floor(), (to * (1.0 / period)).floor());
        let within_from = (from - before_from * period).min(length);
        let within_to = (to - before_to * period).min(length);
        ((before_to - before_from) * length + (within_to - within_from)) * self.share_per_length
    }
}

impl<S: Simd> Pixel<S> {
    /// Returns what a pixel shows of a house of this height and shade: shade, share below the roof, share
    /// within the cornice.
    #[inline(always)]
    fn of_house(&self, height: F<S>, shade: F<S>) -> V3<S> {
        let low = all(self.place.y.simd, 0.0);
        let cover = self.upwards.band_cover(self.place.y, low, height);
        V3::new(shade, cover, self.upwards.band_cover(self.place.y, height - CORNICE as f32, height))
    }

    #[inline(always)]
    fn houses(&self, frame: &FrameUniform) -> V3<S> {
        const WIDTH: f32 = HOUSE_WIDTH as f32;
        let simd = self.place.x.simd;
        let end = self.place.x + self.size.x * 0.5;
        let right = (end / WIDTH).floor();
        let left = ((self.place.x - self.size.x * 0.5) / WIDTH).floor();
        let share = clamp((end - right * WIDTH) / self.size.x.max(1e-6), all(simd, 0.0), all(simd, 1.0));
        let fine = clamp(self.size.x / WIDTH - 0.5, all(simd, 0.0), all(simd, 1.0));
        let at_right = self.house_in_turn(frame, right);
        let coarse = V3::mix(self.house_in_turn(frame, left), at_right, share);
        let [height, shade, ..] = frame.houses[3];
        V3::mix(coarse, self.of_house(all(simd, height), all(simd, shade)), fine)
    }

    #[inline(always)]
    fn house_in_turn(&self, frame: &FrameUniform, number: F<S>) -> V3<S> {
        let simd = number.simd;
        let turn = number - (number / 3.0).floor() * 3.0;
        let (is_first, is_second): (Mask<S>, Mask<S>) = (turn.simd_lt(0.5), turn.simd_lt(1.5));
        let [first, second, third, _] = frame.houses;
        let height = select(is_second, all(simd, second[0]), all(simd, third[0]));
        let shade = select(is_second, all(simd, second[1]), all(simd, third[1]));
        let height = select(is_first, all(simd, first[0]), height);
        self.of_house(height, select(is_first, all(simd, first[1]), shade))
    }

    /// Share of the pixel along the fronts that openings of this number cover, with a `margin` around them.
    #[inline(always)]
    fn along_openings(&self, frame: &FrameUniform, number: usize, period: f64, margin: f32) -> F<S> {
        let [from, length, ..] = frame.openings[number];
        let place = self.place.x - from + margin;
        self.along.repeated_cover(place, length + 2.0 * margin, period as f32)
    }

    /// Returns the coverage of openings upwards.
    #[inline(always)]
    fn up_openings(&self, frame: &FrameUniform, number: usize, margin: f32) -> F<S> {
        let simd = self.place.y.simd;
        let [_, _, lowest, highest] = frame.openings[number];
        self.upwards.band_cover(self.place.y, all(simd, lowest - margin), all(simd, highest + margin))
    }

    #[inline(always)]
    fn openings_cover(&self, frame: &FrameUniform, margin: f32) -> V3<S> {
        let windows = self.up_openings(frame, 0, margin) + self.up_openings(frame, 1, margin);
        let [doors, shops] = [self.up_openings(frame, 2, margin), self.up_openings(frame, 3, margin)];
        V3::new(
            self.along_openings(frame, 0, 0.5 * HOUSE_WIDTH, margin) * windows,
            self.along_openings(frame, 2, HOUSE_WIDTH, margin) * doors,
            self.along_openings(frame, 3, HOUSE_WIDTH, margin) * shops,
        )
    }
}

/// Returns what a pixel of this size shows of the fronts at this place.
#[inline(always)]
pub fn front<S: Simd>(frame: &FrameUniform, place: V2<S>, size: V2<S>) -> FrontPixels<S> {
    let simd = place.x.simd;
    let [.., wall, stone, glass, door, shop] = frame.backdrop;
    let pixel = Pixel { place, size, along: CoveredRange::new(size.x), upwards: CoveredRange::new(size.y) };
    let house = pixel.houses(frame);
    let openings = pixel.openings_cover(frame, 0.0);
    let framed = pixel.openings_cover(frame, FRAME as f32);
    let frames = framed.x + framed.y + framed.z;
    let [course_from, course_to] = COURSE;
    let course =
        pixel.upwards.band_cover(place.y, all(simd, course_from as f32), all(simd, course_to as f32));
    let stones = (course + house.z + frames).min(1.0);
    let walls = V3::mix(V3::of_four(simd, wall) * house.x, V3::of_four(simd, stone), stones);
    let glazed = V3::mix(walls, V3::of_four(simd, glass), openings.x);
    let with_doors = V3::mix(glazed, V3::of_four(simd, door), openings.y);
    FrontPixels { colour: V3::mix(with_doors, V3::of_four(simd, shop), openings.z), cover: house.y }
}
