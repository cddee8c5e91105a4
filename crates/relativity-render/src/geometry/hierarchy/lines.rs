//! Many rays at once: which of them may meet a box.

use glam::{DVec3, Vec3};

use super::beam::{ROUNDING, across};
use crate::geometry::ray::Ray;
use crate::simd::lanes::{F, LANES, Mask, Simd, SimdBase, SimdFloat, bits};

/// Rays of one group, each counted from its point nearest to the middle of that; at most [`RayBundle::MOST`].
#[derive(Debug)]
pub struct RayBundle {
    count: usize,
    /// Two directions across each and each other.
    across: [DirectionParts; 2],
    axis: [[f32; Self::MOST]; 3],
    /// The sides of one ray of each eight that follow each other.
    rows: [RowSide; 2],
}

/// A direction, part by part, and how far along it each ray passes the middle of the group.
#[derive(Debug)]
struct DirectionParts {
    normal: [[f32; RayBundle::MOST]; 3],
    offset: [f32; RayBundle::MOST],
}

/// A direction across one ray of each eight, and by how much the others differ from it at most.
#[derive(Debug, Default)]
struct RowSide {
    normal: [[f32; ROWS]; 3],
    offset: [f32; ROWS],
    /// Rows of the directions.
    turn: [f32; ROWS],
    /// Rows of the offsets, with room for rounding.
    shift: [f32; ROWS],
}

/// Greatest number of rows of eight rays.
const ROWS: usize = RayBundle::MOST / LANES;

impl RayBundle {
    /// Greatest number of rays that are followed at once: those of a tile.
    pub const MOST: usize = 64;

    /// Returns the lines of these rays.
    #[must_use]
    pub fn new(rays: &[Ray], middle: DVec3) -> Self {
        const NONE: [f32; RayBundle::MOST] = [0.0; RayBundle::MOST];
        let side = || DirectionParts { normal: [NONE; 3], offset: NONE };
        let count = rays.len().min(Self::MOST);
        let rows = Default::default();
        let mut lines = Self { count, across: [side(), side()], axis: [NONE; 3], rows };
        for (i, ray) in rays.iter().take(count).enumerate() {
            let place = ray.start - middle;
            for (side, normal) in lines.across.iter_mut().zip(across(ray.direction)) {
                side.offset[i] = normal.dot(place) as f32;
                put(&mut side.normal, i, normal.as_vec3());
            }
            put(&mut lines.axis, i, ray.direction.as_vec3());
        }
        lines.rows = [0, 1].map(|side| RowSide::from_side(&lines.across[side], count));
        lines
    }

    /// A bit for each ray that may meet a box nearer than its `farthest`.
    #[inline(always)]
    #[must_use]
    pub fn meeting<S: Simd>(&self, simd: S, centre: Vec3, half: Vec3, farthest: &[f32; Self::MOST]) -> u64 {
        let reach = half + ROUNDING * centre.abs();
        let distance = centre.length();
        let [u, v] = &self.rows;
        let rows = u.misses(simd, centre, reach, distance) | v.misses(simd, centre, reach, distance);
        let mut meeting = 0;
        let mut left = bits(!rows);
        while left != 0 {
            let first = left.trailing_zeros() as usize % ROWS * LANES;
            left &= left - 1;
            let along = along(simd, &self.axis, first, centre, reach);
            let is_behind = (along.middle - along.size).simd_gt(some(simd, farthest, first));
            let [u, v] = &self.across;
            let misses =
                u.misses(simd, first, centre, reach) | v.misses(simd, first, centre, reach) | is_behind;
            meeting |= u64::from(bits(!misses)) << first;
        }
        meeting & (u64::MAX >> (Self::MOST - self.count))
    }
}

impl DirectionParts {
    /// Returns which rays from the `first` on miss a box on this side or the other.
    #[inline(always)]
    fn misses<S: Simd>(&self, simd: S, first: usize, centre: Vec3, reach: Vec3) -> Mask<S> {
        let along = along(simd, &self.normal, first, centre, reach);
        let offset = some(simd, &self.offset, first);
        ((along.middle - offset).abs() - offset.abs() * ROUNDING).simd_gt(along.size)
    }
}

impl RowSide {
    /// Returns the rows of the rays in `side`; the last of all stand in for those that are missing.
    fn from_side(side: &DirectionParts, count: usize) -> Self {
        let mut rows = Self::default();
        let ray = |i: usize| (Vec3::from(side.normal.map(|part| part[i])), side.offset[i]);
        for row in 0..count.div_ceil(LANES) {
            let all = row * LANES..count.min((row + 1) * LANES);
            let (normal, offset) = ray(usize::midpoint(all.start, all.end));
            let (mut turn, mut shift) = (0.0_f32, 0.0_f32);
            for (other, other_offset) in all.map(ray) {
                turn = turn.max(other.distance(normal));
                shift = shift.max((other_offset - offset).abs());
            }
            put(&mut rows.normal, row, normal);
            rows.offset[row] = offset;
            rows.turn[row] = turn * 1.01 + ROUNDING;
            rows.shift[row] = shift * 1.01 + ROUNDING * offset.abs();
        }
        rows
    }

    /// Returns the rows in which all rays miss a box this far from the middle on this side or the other.
    #[inline(always)]
    fn misses<S: Simd>(&self, simd: S, centre: Vec3, reach: Vec3, distance: f32) -> Mask<S> {
        let along = along(simd, &self.normal, 0, centre, reach);
        let room = some(simd, &self.turn, 0) * (distance + reach.element_sum()) + some(simd, &self.shift, 0);
        ((along.middle - some(simd, &self.offset, 0)).abs() - room).simd_gt(along.size)
    }
}

/// The middle of a box along directions, and half of its size.
struct Along<S: Simd> {
    middle: F<S>,
    size: F<S>,
}

/// Along those from the `first` on.
#[inline(always)]
fn along<S: Simd, const N: usize>(
    simd: S,
    directions: &[[f32; N]; 3],
    first: usize,
    centre: Vec3,
    reach: Vec3,
) -> Along<S> {
    let [x, y, z] = directions;
    let (x, y, z) = (some(simd, x, first), some(simd, y, first), some(simd, z, first));
    Along {
        middle: x * centre.x + y * centre.y + z * centre.z,
        size: x.abs() * reach.x + y.abs() * reach.y + z.abs() * reach.z + ROUNDING * reach.element_sum(),
    }
}

#[inline(always)]
fn some<S: Simd, const N: usize>(simd: S, values: &[f32; N], first: usize) -> F<S> {
    F::from_slice(simd, &values[first..first + LANES])
}

fn put<const N: usize>(parts: &mut [[f32; N]; 3], place: usize, v: Vec3) {
    for (part, value) in parts.iter_mut().zip(v.to_array()) {
        part[place] = value;
    }
}

#[cfg(test)]
mod tests {
    use fearless_simd::{Level, dispatch};

    use super::super::testing::{inside, looks, place};
    use super::*;

    #[test]
    fn rays_are_told_that_meet_a_box_and_hardly_others() {
        let middle = DVec3::new(3.0, -2.0, 1.0);
        for rays in looks(middle) {
            let lines = RayBundle::new(&rays, middle);
            let (mut met, mut told) = (0, 0);
            for number in 0..2000 {
                let (centre, half) = (place(number, 1.5), 0.6 * place(number + 7, 1.0).abs());
                let farthest = 0.5 * place(number, 1.0).x as f32;
                let all = [farthest; RayBundle::MOST];
                let mask = dispatch!(Level::new(), simd => {
                    lines.meeting(simd, centre.as_vec3(), half.as_vec3(), &all)
                });
                assert_eq!(mask >> rays.len(), 0);
                for (i, ray) in rays.iter().enumerate() {
                    let is_told = mask >> i & 1 == 1;
                    let entry = inside(ray, middle + centre, half);
                    let is_met = entry.is_some_and(|[from, _]| from < f64::from(farthest) - 1e-5);
                    assert!(is_told || !is_met, "ray {i} of {:?} meets {centre} {half}", rays[0]);
                    (met, told) = (met + u32::from(is_met), told + u32::from(is_told));
                }
            }
            assert!(met > 500 && told < 3 * met, "{told} told of {met}");
        }
    }
}
