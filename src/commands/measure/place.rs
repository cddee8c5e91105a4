//! The middle of a set of pixels, and how well it is known.

/// A place in a picture, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PixelPlace {
    /// To the right and down.
    pub at: [f64; 2],
    /// Standard deviation of both.
    pub sigma: [f64; 2],
}

/// Standard deviation of what is rounded to whole units.
pub const ROUNDING: f64 = 0.288_675_134_594_812_9;
/// Share of all pixels that a part must have to count: less is noise.
const LEAST_SHARE: f64 = 0.1;

/// The pixels of a picture that show the target.
pub struct TargetMask {
    /// Row by row from the top left.
    pub shows: Vec<bool>,
    /// Pixels in a row.
    pub width: usize,
}

impl TargetMask {
    /// The middle of the pixels; none if there are none.
    ///
    /// A row of pixels ends within half a pixel of where what it shows does, anywhere there alike. An end
    /// that lies x from the middle of A pixels so moves that by x/A times an error of standard deviation
    /// 1/sqrt(12), and the ends are independent; columns tell the same of the height. For a disc of radius r
    /// that is 0.15/sqrt(r). Errors against the truth are, root mean square, 1.0 to 1.3 times as large (discs
    /// and ellipses of 1.5 to 40 pixels at any offset); one that is a pixel or two in size can be off by
    /// twice as much.
    pub fn middle(&self) -> Option<PixelPlace> {
        let (mut sum, mut count) = ([0.0; 2], 0.0);
        for [column, row] in self.pixels() {
            sum = [sum[0] + column as f64 + 0.5, sum[1] + row as f64 + 0.5];
            count += 1.0;
        }
        if count == 0.0 {
            return None;
        }
        let at = sum.map(|part| part / count);
        let mut squares = [0.0; 2];
        for [column, row] in self.pixels() {
            let (across, down) = (column as f64 - at[0], row as f64 - at[1]);
            let offsets = [across, across + 1.0, down, down + 1.0];
            for (side, beside) in self.beside([column, row]).into_iter().enumerate() {
                let is_shown = beside.is_some_and(|beside| self.shows[beside]);
                squares[side / 2] += if is_shown { 0.0 } else { offsets[side] * offsets[side] };
            }
        }
        Some(PixelPlace { at, sigma: squares.map(|sum| ROUNDING * sum.sqrt() / count) })
    }

    /// Returns the share of the outline beside which something hides more of the target: pixels that are
    /// `nearer` than the target's beside them, these after those, or the end of the picture.
    pub fn hidden_share(&self, nearer: impl Fn(usize, usize) -> bool) -> f64 {
        let (mut hidden, mut all) = (0_u32, 0_u32);
        for [column, row] in self.pixels() {
            let own = row * self.width + column;
            for beside in self.beside([column, row]) {
                if beside.is_none_or(|beside| !self.shows[beside]) {
                    all += 1;
                    hidden += u32::from(beside.is_none_or(|beside| nearer(beside, own)));
                }
            }
        }
        f64::from(hidden) / f64::from(all.max(1))
    }

    /// Returns the number of separate parts: pixels that touch, at a corner at least, belong together.
    pub fn parts(&self) -> usize {
        let mut is_left = self.shows.clone();
        let mut sizes = Vec::new();
        for first in 0..is_left.len() {
            let mut open = Vec::new();
            if std::mem::take(&mut is_left[first]) {
                open.push(first);
            }
            let mut size = 0;
            while let Some(pixel) = open.pop() {
                size += 1;
                for neighbour in self.around(pixel) {
                    if std::mem::take(&mut is_left[neighbour]) {
                        open.push(neighbour);
                    }
                }
            }
            sizes.extend((size > 0).then_some(size));
        }
        let all: usize = sizes.iter().sum();
        sizes.iter().filter(|size| **size as f64 >= LEAST_SHARE * all as f64).count()
    }

    /// Column and row of those shown.
    fn pixels(&self) -> impl Iterator<Item = [usize; 2]> {
        let shown = self.shows.iter().enumerate().filter(|(_, shown)| **shown);
        shown.map(|(pixel, _)| [pixel % self.width, pixel / self.width])
    }

    /// Returns the pixels to the left, to the right, above and below; `None` beyond the picture's end.
    fn beside(&self, [column, row]: [usize; 2]) -> [Option<usize>; 4] {
        let (width, height) = (self.width, self.shows.len() / self.width);
        let own = row * width + column;
        [
            (column > 0).then(|| own - 1),
            (column + 1 < width).then_some(own + 1),
            (row > 0).then(|| own - width),
            (row + 1 < height).then_some(own + width),
        ]
    }

    /// Pixels that touch `pixel`, and itself.
    fn around(&self, pixel: usize) -> impl Iterator<Item = usize> + use<> {
        let (width, height) = (self.width, self.shows.len() / self.width);
        let (column, row) = (pixel % width, pixel / width);
        let near = |at: usize, side: usize| at.saturating_sub(1)..(at + 2).min(side);
        near(row, height).flat_map(move |row| near(column, width).map(move |column| row * width + column))
    }
}

#[cfg(test)]
mod tests {
    use relativity_core::math;

    use super::*;

    const SIDE: usize = 64;

    /// A square of 4 by 4 pixels at the lower edge of the picture, with something nearer to its right.
    #[test]
    fn what_stands_before_an_outline_and_the_end_of_the_picture_hide_more() {
        let shows = (0..64).map(|pixel| (2..6).contains(&(pixel % 8)) && pixel / 8 >= 4).collect();
        let mask = TargetMask { shows, width: 8 };
        assert_eq!(mask.hidden_share(|_, _| false), 4.0 / 16.0);
        assert_eq!(mask.hidden_share(|beside, own| beside == own + 1), 8.0 / 16.0);
        assert_eq!(TargetMask { shows: vec![false; 64], width: 8 }.hidden_share(|_, _| true), 0.0);
    }

    /// The pixels whose centres an ellipse around `middle` covers, turned by `angle`.
    fn ellipse(middle: [f64; 2], radii: [f64; 2], angle: f64) -> TargetMask {
        let (sin, cos) = math::sin_cos(angle);
        let is_inside = |pixel: usize| {
            let [x, y] = [(pixel % SIDE) as f64 + 0.5 - middle[0], (pixel / SIDE) as f64 + 0.5 - middle[1]];
            math::hypot((cos * x + sin * y) / radii[0], (cos * y - sin * x) / radii[1]) < 1.0
        };
        TargetMask { shows: (0..SIDE * SIDE).map(is_inside).collect(), width: SIDE }
    }

    /// Places between 0 and 1 without a pattern: multiples of two irrational numbers.
    fn offset(index: usize) -> [f64; 2] {
        [0.754_877_666_246_693, 0.569_840_290_998_053].map(|step| (index as f64 * step).fract())
    }

    /// The sigmas are derived, not fitted; this is how well they hold.
    #[test]
    fn errors_of_middles_are_as_large_as_their_sigmas_say() {
        for (radius, stretch, angle) in [
            (1.5, 1.0, 0.0),
            (3.0, 1.0, 0.0),
            (6.0, 1.0, 0.0),
            (12.0, 1.0, 0.0),
            (3.0, 2.0, 0.0),
            (6.0, 2.0, 0.5),
            (8.0, 3.0, 1.1),
        ] {
            let count = 400;
            let mut chi_squared = 0.0;
            for index in 0..count {
                let truth = offset(index).map(|part| 0.5 * SIDE as f64 + part);
                let radius = radius * (1.0 + 0.05 * index as f64 / count as f64);
                let found = ellipse(truth, [stretch * radius, radius], angle).middle().expect("it is seen");
                for axis in [0, 1] {
                    chi_squared += ((found.at[axis] - truth[axis]) / found.sigma[axis]).powi(2);
                }
            }
            let per_sample = chi_squared / (2 * count) as f64;
            assert!((0.8..1.7).contains(&per_sample), "radius {radius}, {stretch}: {per_sample}");
        }
    }

    #[test]
    fn the_middle_of_a_large_disc_is_known_as_the_formula_says() {
        let sigma = ellipse([32.0; 2], [20.0; 2], 0.0).middle().expect("it is seen").sigma;
        let expected = 0.15 / 20.0_f64.sqrt();
        assert!(sigma.iter().all(|sigma| (sigma / expected - 1.0).abs() < 0.05), "{sigma:?} {expected}");
    }

    #[test]
    fn separate_parts_are_counted_but_for_specks() {
        let mut two = ellipse([16.0; 2], [6.0; 2], 0.0);
        assert_eq!(two.parts(), 1);
        two.shows[40 * SIDE + 40] = true;
        assert_eq!(two.parts(), 1);
        let other = ellipse([48.0; 2], [4.0; 2], 0.0);
        two.shows.iter_mut().zip(&other.shows).for_each(|(shows, other)| *shows |= other);
        assert_eq!(two.parts(), 2);
        assert_eq!(TargetMask { shows: vec![false; SIDE], width: SIDE }.parts(), 0);
        assert_eq!(TargetMask { shows: vec![false; SIDE], width: SIDE }.middle(), None);
    }
}
