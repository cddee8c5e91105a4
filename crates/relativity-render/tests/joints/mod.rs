//! Bodies that share surfaces, and which of them a picture shows there.

use relativity_render::{Body, HitImage, PreparedScene, Shape, View};

/// A bent rod of two tubes with a knob at either end and two rings around it, one in the other's place, near
/// (-0.3, 3, 0.6): surfaces that are the same in part or as a whole.
#[must_use]
pub fn joints() -> Vec<Body> {
    let [left, bend, right] = [[-0.9, 3.0, 0.3], [-0.3, 2.9, 0.9], [0.3, 3.1, 0.5]];
    let ring = Shape::Ring { centre: bend, axis: [0.6, 0.0, 0.8], radius: 0.25, tube_radius: 0.05 };
    let shapes = [
        Shape::Sphere { centre: left, radius: 0.1 },
        Shape::Tube { from: left, to: bend, radius: 0.1 },
        Shape::Tube { from: right, to: bend, radius: 0.1 },
        Shape::Sphere { centre: right, radius: 0.1 },
        ring,
        ring,
    ];
    shapes.map(|shape| Body::new(shape, 600.0)).to_vec()
}

/// In how many pixels of `view` the body shown has its surface in the same place as another of `bodies`, and
/// in how many of them that one comes before it.
#[must_use]
pub fn shared_pixels(image: &HitImage, bodies: &[Body], view: &View) -> [usize; 2] {
    let alone: Vec<_> = bodies
        .iter()
        .map(|body| PreparedScene::moving(std::slice::from_ref(body)).hit_image(view).hits)
        .collect();
    let [mut shared, mut not_first] = [0; 2];
    for (i, shown) in image.hits.iter().enumerate().filter_map(|(i, hit)| Some((i, (*hit)?.body))) {
        // At an outline a renderer in f32 may show what f64 does not.
        let Some(place) = alone[shown][i].map(|hit| hit.rest_position) else { continue };
        let is_there =
            |body: usize| alone[body][i].is_some_and(|hit| hit.rest_position.distance(place) < 1e-11);
        let others = (0..bodies.len()).filter(|&body| body != shown && is_there(body));
        let Some(first) = others.min() else { continue };
        shared += 1;
        not_first += usize::from(first < shown);
    }
    [shared, not_first]
}
