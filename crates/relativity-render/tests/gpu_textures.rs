//! Textures of models on a device, against the reference.

use relativity_render::{
    Appearance, Colour, Gaze, Geometry, HitImage, Method, RawModel, Renderers, Texture, View, Wrap,
};

use crate::gpu_support::Test;
use crate::models::{scene_of, view};

pub const TESTS: &[Test] = &[("textures_are_the_references", textures_are_the_references)];

/// Levels that change smoothly from column to column and from row to row, on a texture whose sides are no
/// powers of two.
fn waves(wrap: [Wrap; 2]) -> Texture {
    let (width, height) = (45, 26);
    let wave = |i: u32, count: u32| {
        let turn = std::f64::consts::TAU * f64::from(i) / f64::from(count);
        (128.0 + 110.0 * turn.sin()) as u8
    };
    let texel =
        |i: u32| [wave(i % width, width), wave(i / width, height), wave(i % width + i / width, 15), 255];
    Texture { size: [width, height], texels: (0..width * height).map(texel).collect(), wrap }
}

/// A plate of four triangles, two of which have one texture, one another and one none, with this many copies
/// of each across it.
fn plate(copies: f32) -> RawModel {
    let corners = [[-1.0, 4.4, 0.0], [1.0, 3.6, 0.0], [1.0, 3.6, 1.0], [-1.0, 4.4, 1.0], [0.0, 4.0, 0.5]];
    let places = [[-0.3, 1.0], [0.8, 1.1], [1.0, -0.2], [0.0, 0.0], [0.45, 0.5]];
    RawModel {
        corners: corners.to_vec(),
        triangles: vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
        materials: Vec::new(),
        reversed: Vec::new(),
        paints: vec![[1.0, 0.9, 0.8], [0.6, 1.0, 1.0], [1.0; 3], [0.5, 0.5, 1.0], [1.0; 3]],
        textures: [waves([Wrap::Repeat, Wrap::Mirror]), waves([Wrap::Clamp, Wrap::Repeat])]
            .map(|texture| texture.prepared().expect("a texture"))
            .to_vec(),
        texture_numbers: vec![0, 1, RawModel::NO_TEXTURE, 0],
        texture_places: places.map(|place: [f32; 2]| place.map(|part| part * copies)).to_vec(),
        is_two_sided: true,
    }
}

/// Whether the pixel and all within two of it show one triangle.
fn is_inside(hits: &HitImage, i: usize) -> bool {
    let [width, height] = hits.size.map(|side| side as usize);
    let (u, v) = (i % width, i / width);
    let triangle = |u: usize, v: usize| {
        hits.hits[v * width + u].and_then(|hit| hit.triangle).map(|point| point.triangle)
    };
    (2..width - 2).contains(&u)
        && (2..height - 2).contains(&v)
        && triangle(u, v).is_some()
        && (v - 2..=v + 2)
            .all(|other| (u - 2..=u + 2).all(|across| triangle(across, other) == triangle(u, v)))
}

/// Near and far, by the rays with as many samples as the reference, by the mesh with one where the reference
/// has one.
fn textures_are_the_references(renderers: &mut Renderers) {
    // White at rest stays below the shoulder: so the mean of what is seen is that of the texture.
    let appearance = Appearance {
        colour: Colour::White,
        intensity_exponent: None,
        exposure_ev: -1.0,
        sky: false,
        ..Appearance::default()
    };
    for copies in [0.4, 2.0, 1000.0] {
        let scene = scene_of(plate(copies));
        for (geometry, beta) in [
            (Geometry::Seen, 0.0),
            (Geometry::Seen, 0.9),
            (Geometry::Contracted, 0.6),
            (Geometry::OneCone, 0.6),
        ] {
            // When it is seen about abreast.
            let mut view = View {
                observation_time: if geometry == Geometry::Contracted { 0.0 } else { 4.0 },
                ..view(beta, geometry, [120, 90])
            };
            let middle = view.apparent_position([0.0, 4.0, 0.5]).expect("inside the domain");
            view.camera.gaze = Gaze::along(middle.to_array());
            let hits = scene.hit_image(&view);
            for (method, samples, most) in [(Method::Rays, 2, 3), (Method::Mesh, 1, 6)] {
                if method.of_view(&view) != method {
                    continue;
                }
                let [expected, found] = [Method::Reference, method].map(|method| {
                    renderers.picture(method, &scene, &view, &appearance, samples).expect("device works").rgba
                });
                let mut compared = 0;
                for i in (0..found.len()).filter(|&i| is_inside(&hits, i)) {
                    let off = expected[i].iter().zip(found[i]).map(|(a, b)| a.abs_diff(b)).max();
                    let context = format!("{method}, {copies} copies, {geometry:?} at {beta}, pixel {i}");
                    assert!(off <= Some(most), "{context}: {:?} for {:?}", found[i], expected[i]);
                    compared += 1;
                }
                assert!(
                    compared > 100,
                    "{method}, {geometry:?} at {beta}: {compared} of {}",
                    hits.hits.iter().flatten().count()
                );
            }
        }
    }
}
