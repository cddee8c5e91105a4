//! In which order bodies are drawn: in their own where surfaces coincide, so that the first of them stays, and else
//! those of one division together, which saves a draw for each.

use std::collections::HashMap;

use super::Part;

/// A rounded end, or the whole of a ring: centre and radius, as bits.
type End = [u32; 4];

/// Sorts `parts`, which come in the order of the bodies. Faded ones are drawn last.
pub fn sort(parts: &mut [Part]) {
    let mut bodies_at = HashMap::<End, u32>::new();
    for end in parts.iter().flat_map(ends) {
        *bodies_at.entry(end).or_default() += 1;
    }
    let is_joined = |part: &Part| ends(part).any(|end| bodies_at[&end] > 1);
    parts.sort_by_cached_key(|part| (part.is_thin(), (!is_joined(part)).then_some(part.division)));
}

/// The ends of a tube, the centre of a ball or ring.
fn ends(part: &Part) -> impl Iterator<Item = End> + use<> {
    let [x, y, z, radius] = part.instance.place_radius;
    let first = [x, y, z, radius];
    let [x, y, z, _] = part.instance.form;
    let second = [x, y, z, radius];
    let has_two = !part.is_ring() && first != second;
    [Some(first), has_two.then_some(second)].into_iter().flatten().map(|end| end.map(f32::to_bits))
}
