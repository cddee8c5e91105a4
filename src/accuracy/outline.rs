//! Displacement of outlines: how far from the reference's a renderer draws them, in pixels.
//!
//! Places on outlines are found in the reference's picture by bisection in f64. At each, the renderer draws a
//! strip of the view across the outline, one pixel high and magnified until the displacement shows; where in
//! it the depth jumps is compared with where the reference does, perpendicular to the outline, which is taken
//! as straight between the two.

use glam::DVec2;
use relativity_render::{Camera, Hit, HitImage, PreparedScene, View};

/// Pixels of a strip.
const STRIP: u32 = 256;
/// Magnifications that are tried in turn, until the displaced outline lies on the strip.
const MAGNIFICATIONS: [f64; 3] = [4096.0, 128.0, 8.0];
/// Displacements up to this, half a pixel of the finest strip, count as none.
pub const RESOLUTION_PX: f64 = 0.5 / MAGNIFICATIONS[0];
/// Displacements from this on, half the coarsest strip, count as this.
pub const LARGEST_PX: f64 = 0.5 * STRIP as f64 / MAGNIFICATIONS[2];
/// Depth behind an edge, relative to the distance, below which it is a crease and no outline.
const CREASE: f64 = 1e-2;
/// Distance of the neighbouring place that gives an outline's direction, pixels.
const NEIGHBOUR_PX: f64 = 0.02;
/// Halvings of a pixel in the search for an outline.
const BISECTIONS: u32 = 24;

/// Two neighbouring pixels of a picture, of which only the first shows the body in front.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutlinePixels {
    body: usize,
    inside: DVec2,
    outside: DVec2,
}

/// About `count` pairs, evenly chosen from all along the outlines of the reference's `image`.
#[must_use]
pub fn outline_pixels(image: &HitImage, count: usize) -> Vec<OutlinePixels> {
    let [width, height] = image.size.map(|side| side as usize);
    let pixel = |u: usize, v: usize| {
        let centre = DVec2::new(u as f64 + 0.5, v as f64 + 0.5);
        (image.hits[v * width + u], centre)
    };
    let rows = (0..height).flat_map(|v| (1..width).map(move |u| [pixel(u - 1, v), pixel(u, v)]));
    let columns = (1..height).flat_map(|v| (0..width).map(move |u| [pixel(u, v - 1), pixel(u, v)]));
    let all: Vec<_> = rows.chain(columns).filter_map(across_outline).collect();
    let chosen = count.min(all.len());
    (0..chosen).map(|i| all[i * all.len() / chosen]).collect()
}

fn across_outline([a, b]: [(Option<Hit>, DVec2); 2]) -> Option<OutlinePixels> {
    let distance = |hit: Option<Hit>| hit.map_or(f64::INFINITY, |hit| hit.distance);
    let [front, back] = if distance(a.0) <= distance(b.0) { [a, b] } else { [b, a] };
    let body = front.0?.body;
    let is_edge = back.0.is_none_or(|hit| hit.body != body);
    is_edge.then_some(OutlinePixels { body, inside: front.1, outside: back.1 })
}

/// A place on an outline in the reference's picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OutlinePoint {
    /// Place of the point in the picture.
    pub pixel: DVec2,
    /// Unit vector out of the body, across the outline; right and down.
    pub outward: DVec2,
    /// Distance that divides body and background: what is nearer lies inside the outline, what is farther
    /// behind it.
    pub divide: f64,
}

impl OutlinePoint {
    /// The place between two pixels of `view`; `None` at corners of an outline and at creases.
    #[must_use]
    pub fn between(pixels: &OutlinePixels, scene: &PreparedScene, view: &View) -> Option<Self> {
        let OutlinePixels { body, inside, outside } = *pixels;
        let search = EdgeSearch { scene, view, body };
        let aside = NEIGHBOUR_PX * (outside - inside).perp();
        let [pixel, beyond] = search.edge(inside, outside)?;
        let [neighbour, _] = search.edge(inside + aside, outside + aside)?;
        let divide = search.divide(pixel, beyond)?;
        let across = (neighbour - pixel).perp().try_normalize()?;
        Some(Self { pixel, outward: across * across.dot(outside - inside).signum(), divide })
    }
}

/// A search for the edge of a body in the reference's picture.
struct EdgeSearch<'a> {
    scene: &'a PreparedScene,
    view: &'a View,
    body: usize,
}

impl EdgeSearch<'_> {
    /// The last place that shows the body between one that does and one that does not, and the next place.
    fn edge(&self, inside: DVec2, outside: DVec2) -> Option<[DVec2; 2]> {
        let shows = |place| self.hit(place).is_some_and(|hit| hit.body == self.body);
        if !shows(inside) || shows(outside) {
            return None;
        }
        let halved = |[inside, outside]: [DVec2; 2], _| {
            let middle = 0.5 * (inside + outside);
            if shows(middle) { [middle, outside] } else { [inside, middle] }
        };
        Some((0..BISECTIONS).fold([inside, outside], halved))
    }

    /// A distance between those just inside the outline and just outside; `None` at a crease.
    fn divide(&self, inside: DVec2, outside: DVec2) -> Option<f64> {
        let front = self.hit(inside)?.distance;
        let Some(back) = self.hit(outside) else { return Some(f64::INFINITY) };
        (back.distance > (1.0 + CREASE) * front).then(|| (back.distance * front).sqrt())
    }

    fn hit(&self, pixel: DVec2) -> Option<Hit> {
        self.scene.first_hit(self.view, self.view.camera.line_of_sight(pixel.to_array()))
    }
}

/// Returns the displacement of the outline at `point` of `view` in a renderer's picture, pixels, 0 up to
/// [`RESOLUTION_PX`].
///
/// `hits` gives the renderer's picture of a small part of `view`, magnified. Where it shows no outline up
/// to [`LARGEST_PX`], that stands for more.
///
/// # Errors
///
/// Those of `hits`.
pub fn displacement_px<E>(
    scene: &PreparedScene,
    view: &View,
    point: &OutlinePoint,
    mut hits: impl FnMut(&View) -> Result<HitImage, E>,
) -> Result<f64, E> {
    for magnification in MAGNIFICATIONS {
        let strip = Strip::new(view, point, magnification);
        let shown = hits(&strip.view)?;
        if let Some(end) = strip.end(&scene.hit_image(&strip.view), &shown) {
            return Ok(strip.displacement_px(&view.camera, end));
        }
    }
    Ok(LARGEST_PX)
}

/// A row or column of magnified pixels across an outline, which passes through its middle.
struct Strip {
    view: View,
    point: OutlinePoint,
    /// Picture axis along which the strip runs: 0 right, 1 down.
    axis: usize,
    /// Whether the body lies towards larger pixel numbers.
    reversed: bool,
}

impl Strip {
    fn new(view: &View, point: &OutlinePoint, magnification: f64) -> Self {
        let axis = usize::from(point.outward.y.abs() > point.outward.x.abs());
        let size = [[STRIP, 1], [1, STRIP]][axis];
        let camera = view.camera.magnified(point.pixel.to_array(), size, magnification);
        let mut strip = Self { view: View { camera, ..*view }, point: *point, axis, reversed: false };
        strip.reversed = strip.outward_px(&view.camera, 0.5 * f64::from(STRIP)) < 0.0;
        strip
    }

    /// Returns the end of the body along the strip as the renderer draws it, strip pixels outwards from the
    /// middle; `None` beyond the strip.
    ///
    /// A body that is lost counts as displaced by its width, a gap that is closed by the gap's.
    fn end(&self, reference: &HitImage, shown: &HitImage) -> Option<f64> {
        let middle = STRIP as usize / 2;
        let (reference, shown) = (self.inside(reference), self.inside(shown));
        let width = reference[..middle].iter().rev().take_while(|&&inside| inside).count();
        let gap = reference[middle..].iter().take_while(|&&inside| !inside).count();
        let [inner, outer] = [middle - width, middle + gap];
        // Outwards from the middle of the body, inwards if it is not there.
        let core = middle - width.div_ceil(2);
        let end = if shown[core] {
            core + shown[core..outer].iter().take_while(|&&inside| inside).count()
        } else {
            core - shown[inner..core].iter().rev().take_while(|&&inside| !inside).count()
        };
        (end > 0 && end < STRIP as usize).then_some(end as f64 - middle as f64)
    }

    /// Returns which of the strip's pixels lie inside the outline, outwards.
    fn inside(&self, image: &HitImage) -> Vec<bool> {
        let is_inside = |hit: &Option<Hit>| hit.is_some_and(|hit| hit.distance < self.point.divide);
        let mut inside: Vec<_> = image.hits.iter().map(is_inside).collect();
        if self.reversed {
            inside.reverse();
        }
        inside
    }

    fn displacement_px(&self, camera: &Camera, end: f64) -> f64 {
        let end = if self.reversed { -end } else { end };
        if end == 0.0 { 0.0 } else { self.outward_px(camera, end).abs() }
    }

    /// Returns the distance outwards from the body, in pixels of `camera`, of the place that lies `along`
    /// strip pixels from the middle.
    fn outward_px(&self, camera: &Camera, along: f64) -> f64 {
        let mut place = [0.5, 0.5];
        place[self.axis] = 0.5 * f64::from(STRIP) + along;
        let pixel = camera.pixel(self.view.camera.line_of_sight(place));
        pixel.map_or(0.0, |pixel| (DVec2::from(pixel) - self.point.pixel).dot(self.point.outward))
    }
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use relativity_core::{Aperture, Speed};
    use relativity_render::{Body, Gaze, Geometry, Shape};

    use super::*;

    fn ball(radius: f64) -> PreparedScene {
        let shape = Shape::Sphere { centre: [0.0, 5.0, 0.0], radius };
        PreparedScene::moving(&[Body::new(shape, 600.0)])
    }

    fn view() -> View {
        let camera = Camera::new(Aperture::default(), Gaze::along([0.0, 1.0, 0.0]), 1.0, [160, 120]);
        View { camera, speed: Speed::REST, observation_time: 0.0, geometry: Geometry::Seen }
    }

    /// Displacements of the outline of a ball of radius 1 in the eyes of one who takes it for `radius`.
    fn displacements(radius: f64) -> Vec<f64> {
        let (truth, view) = (ball(1.0), view());
        let pairs = outline_pixels(&truth.hit_image(&view), 50);
        let points: Vec<_> =
            pairs.iter().filter_map(|pair| OutlinePoint::between(pair, &truth, &view)).collect();
        assert!(points.len() > 40, "{} places", points.len());
        let shown = ball(radius);
        let hits = |view: &View| Ok::<_, Infallible>(shown.hit_image(view));
        points.iter().map(|point| displacement_px(&truth, &view, point, hits).expect("cannot fail")).collect()
    }

    /// Radius of the outline of the ball in the picture, where its tangents meet the picture plane.
    fn outline_radius_px(radius: f64) -> f64 {
        view().camera.focal_length_px() * (radius / 5.0).asin().tan()
    }

    #[test]
    fn an_outline_is_found_displaced_by_as_much_as_it_is() {
        for radius in [1.000_002, 0.999_97, 1.000_5, 0.99, 1.02, 0.9, 1.3] {
            let expected = (outline_radius_px(radius) - outline_radius_px(1.0)).abs();
            // Half a pixel of the strip that the displacement fits on.
            let resolution = 0.6 / MAGNIFICATIONS.into_iter().find(|k| expected * k < 80.0).expect("it fits");
            // Between strip and perpendicular, up to 45 degrees apart, the outline bends by this.
            let bend = expected * expected / (2.0 * outline_radius_px(1.0));
            for displacement in displacements(radius) {
                let error = (displacement - expected).abs();
                assert!(
                    error < resolution + bend,
                    "{displacement} px instead of {expected} px at radius {radius}"
                );
            }
        }
    }

    #[test]
    fn the_truth_is_not_displaced_and_a_lost_body_is_displaced_by_the_most() {
        assert!(displacements(1.0).iter().all(|&displacement| displacement == 0.0));
        assert!(displacements(0.01).iter().all(|&displacement| displacement == LARGEST_PX));
    }

    #[test]
    fn a_thin_body_that_is_lost_is_displaced_by_its_width() {
        let thin = Shape::Tube { from: [-2.0, 5.0, 0.0], to: [2.0, 5.0, 0.0], radius: 0.01 };
        let truth = PreparedScene::moving(&[Body::new(thin, 600.0)]);
        let view = view();
        let width_px = 0.02 / 5.0 * view.camera.focal_length_px();
        // 0.01 px above the edge.
        let inside = DVec2::new(80.5, 60.0 + 0.5 * width_px - 0.01);
        let pixels = OutlinePixels { body: 0, inside, outside: inside + DVec2::Y };
        let point = OutlinePoint::between(&pixels, &truth, &view).expect("the edge lies between");
        let nothing = |view: &View| Ok::<_, Infallible>(PreparedScene::moving(&[]).hit_image(view));
        let displacement = displacement_px(&truth, &view, &point, nothing).expect("cannot fail");
        assert!((displacement - width_px).abs() < 0.02 * width_px, "{displacement} px, width {width_px} px");
    }

    #[test]
    fn creases_between_bodies_that_intersect_are_no_outlines() {
        let tube = |to| Shape::Tube { from: [0.0, 5.0, 0.0], to, radius: 0.5 };
        let shapes = [tube([-1.0, 5.0, 0.0]), tube([1.0, 5.0, 0.0])];
        let bodies = shapes.map(|shape| Body::new(shape, 600.0));
        let (scene, view) = (PreparedScene::moving(&bodies), view());
        let pairs = outline_pixels(&scene.hit_image(&view), usize::MAX);
        let points: Vec<_> = pairs.iter().filter_map(|p| OutlinePoint::between(p, &scene, &view)).collect();
        assert!(points.len() < pairs.len());
        let middle = f64::from(view.camera.size[1]) / 2.0;
        let thick_px = outline_radius_px(0.5) * 0.8;
        let at_crease = |point: &&OutlinePoint| {
            (point.pixel.x - 80.0).abs() < 2.0 && (point.pixel.y - middle).abs() < thick_px
        };
        assert_eq!(points.iter().find(at_crease), None);
    }
}
