//! Trees and hedges: a trunk with limbs, and a crown of many uneven lobes.

use super::ground::fallen;
use super::objects::{Chance, Objects, Place};

/// A ball of leaves: its middle, from the foot of the trunk, and its radius.
pub type Lobe = (Place, f64);

/// The great lobes of a tree that is broad, and of one that is tall.
const BROAD: [Lobe; 6] = [
    ([-0.9, 0.3, 5.1], 1.25),
    ([0.95, -0.5, 5.0], 1.2),
    ([0.1, 0.9, 5.6], 1.15),
    ([-0.3, -0.8, 6.1], 1.15),
    ([0.6, 0.3, 6.8], 1.2),
    ([-0.3, 0.1, 7.6], 1.0),
];
const TALL: [Lobe; 5] = [
    ([0.5, 0.3, 4.9], 1.1),
    ([-0.6, -0.2, 5.6], 1.15),
    ([0.4, -0.4, 6.5], 1.1),
    ([-0.2, 0.3, 7.6], 1.1),
    ([0.1, 0.0, 8.7], 0.85),
];
/// Small lobes on each great one.
const SMALL: usize = 7;

/// The lobes of a kind of tree.
pub fn lobes(is_broad: bool, seed: u64) -> Vec<Lobe> {
    let great = if is_broad { &BROAD[..] } else { &TALL[..] };
    let mut chance = Chance::new(seed);
    let mut all = great.to_vec();
    for (middle, radius) in great {
        for _ in 0..SMALL {
            let out: Place = std::array::from_fn(|_| chance.between(-1.0, 1.0));
            let length = out.iter().map(|part| part * part).sum::<f64>().sqrt().max(0.1);
            let reach = radius * chance.between(0.78, 1.0) / length;
            let place = [0, 1, 2].map(|axis| middle[axis] + reach * out[axis]);
            all.push((place, radius * chance.between(0.3, 0.52)));
        }
    }
    all
}

/// Adds a tree of these lobes and its shadow.
pub fn tree(objects: &mut Objects, lobes: &[Lobe]) {
    objects.part = "tree";
    objects.tube("bark", [0.0, 0.0, -0.2], [0.03, 0.02, 3.6], 0.2);
    objects.tube("bark", [0.0, 0.0, -0.2], [0.0, 0.0, 0.25], 0.27);
    for (middle, _) in &lobes[..3] {
        objects.tube("bark", [0.03, 0.02, 3.3], [0.8 * middle[0], 0.8 * middle[1], middle[2] - 0.3], 0.09);
    }
    for (middle, radius) in lobes {
        // What is low, or on the side away from the sun, lies in the shade of the others.
        let towards_sun = middle[2] - 6.2 - 0.9 * middle[0] - 0.4 * middle[1];
        let lit = (0.78 + 0.11 * towards_sun).clamp(0.5, 1.0);
        objects.shaded((20.0 * lit).round() / 20.0, |objects| objects.ball("leaves", *middle, *radius));
    }
    objects.block("earth", [-0.7, -0.55, 0.0], [0.7, 0.55, 0.03]);
}

/// Returns the shadow of a tree of these `lobes` as discs, from the foot of its trunk.
pub fn shade(lobes: &[Lobe]) -> impl Iterator<Item = ([f64; 2], f64)> {
    // The small ones are nearly within the shadows of the great ones: a part of them will do.
    let casts = |number: usize| number < 6 || number.is_multiple_of(3);
    let casting = lobes.iter().enumerate().filter(move |(number, _)| casts(*number));
    casting.map(|(_, lobe)| lobe).map(|(middle, radius)| (fallen(*middle), 1.25 * radius))
}

/// Adds a hedge between two corners, whose top is uneven.
pub fn hedge(objects: &mut Objects, [x, y]: [f64; 2], [far_x, far_y]: [f64; 2], height: f64, seed: u64) {
    let mut chance = Chance::new(seed);
    objects.part = "hedge";
    objects.block("leaves", [x, y, 0.0], [far_x, far_y, height]);
    let (middle, half) = (0.5 * (y + far_y), 0.5 * (far_y - y));
    let count = ((far_x - x) / (0.9 * half)) as usize;
    for number in 0..=count {
        let along = x + (far_x - x) * number as f64 / count as f64;
        let place = [along, middle + chance.between(-0.08, 0.08), height - half * chance.between(0.45, 0.75)];
        objects.ball("leaves", place, half * chance.between(1.02, 1.2));
    }
}
