//! Textures of models on a device, against the reference.

use relativity_render::colour::paint::Material;
use relativity_render::{
    Appearance, Colour, Gaze, Geometry, HitImage, Method, PreparedScene, RawModel, Renderers, Texture, View,
    Wrap,
};

use crate::gpu_support::Test;
use crate::models::{HUB, rolling, scene_of, view};

pub const TESTS: &[Test] = &[
    ("textures_are_the_references", textures_are_the_references),
    ("holes_are_the_references", holes_are_the_references),
];

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
    Texture { size: [width, height], texels: (0..width * height).map(texel).collect(), wrap, cutoff: 0 }
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

/// The waves with holes where their third part, as the opacity, is below a half.
fn holes() -> Texture {
    let mut texture = waves([Wrap::Repeat, Wrap::Mirror]);
    texture.texels.iter_mut().for_each(|texel| texel[3] = texel[2]);
    Texture { cutoff: 32768, ..texture }
}

/// Whether the reference finds a hole, or finds none, within this many pixels of the middle of a pixel.
fn is_near(scene: &PreparedScene, view: &View, i: usize, is_hole: bool, bound_px: f64) -> bool {
    let width = view.camera.size[0] as usize;
    let [u, v] = [i % width, i / width].map(|side| side as f64 + 0.5);
    (0..9 * 9).any(|k| {
        let [right, down] = [k % 9, k / 9].map(|step| bound_px * (f64::from(step) - 4.0) / 4.0);
        scene.first_hit(view, view.camera.line_of_sight([u + right, v + down])).is_none() == is_hole
    })
}

/// A model as small as a wheel, about the hub.
fn wheel_of(mut model: RawModel) -> RawModel {
    for corner in &mut model.corners {
        *corner = std::array::from_fn(|axis| HUB[axis] + 0.4 * (corner[axis] - [0.0, 4.0, 0.5][axis]));
    }
    model
}

/// Rays, packets and mesh, of models that stand and that turn, have the reference's holes. A measured
/// material has the holes of its picture, too.
fn holes_are_the_references(renderers: &mut Renderers) {
    let mut model = plate(1.0);
    model.textures[0] = holes().prepared().expect("a texture");
    (model.texture_numbers[1], model.texture_numbers[2]) = (0, 0);
    model.materials = vec![None, None, Material::named("leaves"), None];
    for scene in [scene_of(model.clone()), rolling(wheel_of(model), 0.57)] {
        for (geometry, beta) in [(Geometry::Seen, 0.0), (Geometry::Seen, 0.9), (Geometry::OneCone, 0.6)] {
            let mut view = View { observation_time: 4.0, ..view(beta, geometry, [120, 90]) };
            let middle = view.apparent_position([0.0, 4.0, 0.5]).expect("inside the domain");
            view.camera.gaze = Gaze::along(middle.to_array());
            let truth = scene.hit_image(&view);
            for method in [Method::Rays, Method::Packets, Method::Mesh] {
                if method != Method::Mesh && geometry == Geometry::OneCone {
                    continue;
                }
                let found = renderers.hits(method, &scene, &view).expect("device works").hits;
                let bound_px = if method == Method::Mesh { Method::MESH_ERROR_PX } else { 0.1 };
                let mut counts = [0; 2];
                for (i, (truth, hit)) in truth.hits.iter().zip(&found).enumerate() {
                    counts[usize::from(hit.is_none())] += 1;
                    let is_right = truth.is_none() == hit.is_none()
                        || is_near(&scene, &view, i, hit.is_none(), bound_px);
                    assert!(is_right, "{method}, {geometry:?} at {beta}, pixel {i}: {hit:?} for {truth:?}");
                }
                assert!(counts.iter().all(|&count| count > 200), "{method}, {geometry:?}: {counts:?}");
            }
        }
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
