//! The convex hull of places in a plane.

use glam::DVec2;

/// Returns the corners of the convex hull of `places`, counter-clockwise, by the monotone chain.
///
/// Reference: A. M. Andrew, *Another efficient algorithm for convex hulls in two dimensions* (1979).
#[must_use]
pub fn convex_hull(mut places: Vec<DVec2>) -> Vec<DVec2> {
    places.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    places.dedup();
    let chain = |places: &mut dyn Iterator<Item = &DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for &place in places {
            while let [.., a, b] = chain[..]
                && (b - a).perp_dot(place - a) <= 0.0
            {
                chain.pop();
            }
            chain.push(place);
        }
        chain.pop();
        chain
    };
    if places.len() < 3 {
        return places;
    }
    let [mut hull, above] = [chain(&mut places.iter()), chain(&mut places.iter().rev())];
    hull.extend(above);
    hull
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tests::random;

    #[test]
    fn all_places_lie_to_the_left_of_each_side() {
        let mut random = random();
        for count in [0, 1, 2, 3, 4, 50, 3000] {
            let places: Vec<_> = (0..count).map(|_| DVec2::new(random(), random())).collect();
            let hull = convex_hull(places.clone());
            assert!(
                hull.iter().all(|corner| places.contains(corner)) && hull.is_empty() == places.is_empty()
            );
            let ends = hull.iter().zip(hull.iter().cycle().skip(1));
            for (a, b) in ends.filter(|_| hull.len() > 2) {
                assert!(places.iter().all(|place| (b - a).perp_dot(place - a) >= 0.0), "{a} {b}");
            }
        }
        // Those on a line leave its ends, and those inside a square its corners.
        let line = (0..9).map(|i| DVec2::splat(f64::from(i))).collect();
        assert_eq!(convex_hull(line), [DVec2::ZERO, DVec2::splat(8.0)]);
        let grid = (0..25).map(|i| DVec2::new(f64::from(i % 5), f64::from(i / 5))).collect();
        let corners = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0]].map(DVec2::from);
        assert_eq!(convex_hull(grid), corners);
    }
}
