//! Textures on triangles: where their texels are seen, against the geometry of rays, and what they are from
//! afar.

use std::sync::Arc;

use glam::DVec3;
use relativity_core::{Aperture, Speed};
use relativity_render::colour::{srgb_decoded, srgb_encoded};
use relativity_render::{
    Appearance, Body, Camera, Colour, Gaze, Geometry, Method, PreparedScene, RawModel, Renderers, Texture,
    TrianglesError, View, Wrap,
};

const SIZE: [u32; 2] = [80, 60];
/// A plate of this width and height in the plane y = 4, from (-1, 4, 0.25).
const PLATE: [f64; 2] = [2.0, 1.0];

fn view(beta: f64, geometry: Geometry) -> View {
    let speed = Speed::from_beta(beta).expect("a speed");
    let camera = Camera::new(Aperture::pair(0.1)[1], Gaze::STRAIGHT_AHEAD, 0.6, SIZE);
    let mut view = View { camera, speed, observation_time: 4.5, geometry };
    let centre = view.apparent_position([0.0, 4.0, 0.75]).expect("inside the domain");
    view.camera.gaze = Gaze::along(centre.to_array());
    view
}

/// An appearance in white light that no motion changes: levels of the picture are those of the paint.
fn appearance() -> Appearance {
    Appearance {
        colour: Colour::White,
        doppler_shift: false,
        intensity_exponent: None,
        exposure_ev: -1.0,
        sky: false,
        ..Appearance::default()
    }
}

/// The plate, turned about y and moved, with `copies` of this texture in its width and in its height.
fn plate(texture: Texture, copies: f32) -> RawModel {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
        .map(|[u, v]: [f64; 2]| (corner(u, v), [u as f32, v as f32]));
    RawModel {
        corners: corners.map(|(corner, _)| corner).to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        texture_numbers: vec![0, 0],
        texture_places: corners.map(|(_, place)| place.map(|part| part * copies)).to_vec(),
        textures: vec![texture.prepared().expect("a texture")],
        is_two_sided: true,
        ..RawModel::default()
    }
}

/// A place of the plate: from its top left, to the right and down.
fn corner(u: f64, v: f64) -> [f64; 3] {
    [-1.0 + PLATE[0] * u, 4.0, 1.25 - PLATE[1] * v]
}

/// Levels that grow with the column in red, and with the row in green.
fn graded(wrap: Wrap) -> Texture {
    let texel = |i: u32| [4 * (i % 64) as u8 + 2, 4 * (i / 64) as u8 + 2, 255, 255];
    Texture { size: [64, 64], texels: (0..64 * 64).map(texel).collect(), wrap: [wrap; 2], cutoff: 0 }
}

fn scene_of(model: RawModel) -> PreparedScene {
    PreparedScene::moving(&[Body::of_triangles(model.prepared().expect("a model"))])
}

/// The place on the plate that each pixel's ray passes, if it is on the plate.
fn places(view: &View) -> Vec<Option<[f64; 2]>> {
    let of_group = view.of_group(relativity_render::Motion::Scene);
    let place = |i: u32| {
        let pixel = [f64::from(i % SIZE[0]) + 0.5, f64::from(i / SIZE[0]) + 0.5];
        let ray = of_group.rest_ray(view.camera.line_of_sight(pixel));
        let there: DVec3 = ray.origin + ray.direction * ((4.0 - ray.origin.y) / ray.direction.y);
        let [u, v] = [(there.x + 1.0) / PLATE[0], (1.25 - there.z) / PLATE[1]];
        ([u, v].iter().all(|part| (0.02..0.98).contains(part))).then_some([u, v])
    };
    (0..SIZE[0] * SIZE[1]).map(place).collect()
}

/// The numbers of pixels around which all are on the plate.
fn inner(places: &[Option<[f64; 2]>]) -> impl Iterator<Item = usize> {
    let (width, count) = (SIZE[0] as usize, places.len());
    let is_inner = move |&i: &usize| {
        let around = [width + 1, width, width - 1, 1].into_iter().flat_map(|step| [i - step, i + step]);
        around.chain([i]).all(|i| places[i].is_some())
    };
    (width + 1..count - width - 1).filter(is_inner)
}

/// The level of sRGB of the paint, 0 to 255: of this pixel, of which white paint has another.
fn paint_level(painted: u8, white: u8) -> f64 {
    let [painted, white] = [painted, white].map(|level| srgb_decoded(f64::from(level) / 255.0));
    255.0 * srgb_encoded((painted / white).min(1.0))
}

/// Whether the pixel of this number covers two texels at most, both ways, of as many as `graded` has.
fn is_near(places: &[Option<[f64; 2]>], pixel: usize) -> bool {
    [1, SIZE[0] as usize].into_iter().all(|step| {
        let (Some(here), Some(Some(next))) = (places[pixel], places.get(pixel + step)) else { return false };
        here.iter().zip(next).all(|(a, b)| (a - b).abs() < 2.0 / 64.0)
    })
}

#[test]
fn each_texel_is_seen_where_rays_pass_it() {
    let mut seen = 0;
    for geometry in [Geometry::Seen, Geometry::Contracted, Geometry::Rest] {
        for beta in [0.0, 0.6, 0.9] {
            let view = view(beta, geometry);
            let mut white = plate(graded(Wrap::Clamp), 1.0);
            white.texture_numbers = vec![RawModel::NO_TEXTURE; 2];
            let [white, painted] = [white, plate(graded(Wrap::Clamp), 1.0)]
                .map(|model| scene_of(model).picture(&view, &appearance(), 1));
            let places = places(&view);
            for (i, place) in places.iter().enumerate() {
                // Near black, averages in linear light are lighter than the middle.
                let Some([u, v]) = place.filter(|place| place.iter().all(|part| *part > 0.1)) else {
                    continue;
                };
                if !is_near(&places, i) {
                    continue;
                }
                let level = |part: usize| paint_level(painted.rgba[i][part], white.rgba[i][part]);
                // A texel is 4 levels wide, and the picture's own levels are rounded.
                let context = format!("{geometry:?} at {beta}: {:?} at {u}, {v}", painted.rgba[i]);
                assert!(
                    (level(0) - 256.0 * u).abs() < 6.0 && (level(1) - 256.0 * v).abs() < 6.0,
                    "{context}"
                );
                seen += 1;
            }
        }
    }
    assert!(seen > 1000, "{seen}");
}

/// Opacity that grows from column to column is linear between their middles: the edge of what is there is
/// straight, and behind it the ground is seen.
#[test]
fn a_masked_texture_ends_where_its_opacity_is_the_cutoff() {
    for (share, beta) in [(0.25, 0.0), (0.5, 0.6), (0.7, 0.9)] {
        let texels = (0..64 * 64).map(|i: u32| [255, 255, 255, 4 * (i % 64) as u8]).collect();
        let cutoff = (65535.0 * share) as u16;
        let masked = Texture { size: [64, 64], texels, wrap: [Wrap::Clamp; 2], cutoff };
        let edge = (255.0 * share / 4.0 + 0.5) / 64.0;
        let view = view(beta, Geometry::Seen);
        let hits = scene_of(plate(masked, 1.0)).hit_image(&view).hits;
        let mut seen = [0; 2];
        for (place, hit) in places(&view).iter().zip(&hits) {
            let Some([u, _]) = place.filter(|[u, _]| (u - edge).abs() > 1e-3) else { continue };
            assert_eq!(hit.is_some(), u > edge, "at {u}, with the edge at {edge}");
            seen[usize::from(u > edge)] += 1;
        }
        assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
    }
}

#[test]
fn wrapped_textures_go_on_as_they_say() {
    let view = view(0.3, Geometry::Seen);
    let places = places(&view);
    for (wrap, expected) in [
        (Wrap::Repeat, &(|at: f64| at.fract()) as &dyn Fn(f64) -> f64),
        (Wrap::Mirror, &|at: f64| 1.0 - (at % 2.0 - 1.0).abs()),
        (Wrap::Clamp, &|at: f64| at.min(1.0)),
    ] {
        let triangles = plate(graded(wrap), 3.0).prepared().expect("a model");
        let hits = PreparedScene::moving(&[Body::of_triangles(triangles.clone())]).hit_image(&view).hits;
        for (place, hit) in places.iter().zip(&hits) {
            let (Some([u, _]), Some(hit)) = (place, hit) else { continue };
            let red = 255.0 * srgb_encoded(triangles.paint(hit.triangle.expect("of triangles"))[0]);
            let (at, is_at_a_seam) = (3.0 * u, (3.0 * u - (3.0 * u).round()).abs() < 0.02);
            assert!(is_at_a_seam || (red - 256.0 * expected(at)).abs() < 4.0, "{wrap:?}: {red} at {at}");
        }
    }
}

/// Texels that no pixel can show one by one are seen as their average, in linear light.
#[test]
fn from_afar_a_texture_is_its_average() {
    let chequer = |size: u32| {
        let texel = |i: u32| if (i % size + i / size).is_multiple_of(2) { [255; 4] } else { [0, 0, 0, 255] };
        Texture {
            size: [size; 2],
            texels: (0..size * size).map(texel).collect(),
            wrap: [Wrap::Repeat; 2],
            cutoff: 0,
        }
    };
    for beta in [0.0, 0.9] {
        let view = view(beta, Geometry::Seen);
        let mut white = plate(chequer(2), 1.0);
        white.texture_numbers = vec![RawModel::NO_TEXTURE; 2];
        let [white, painted] =
            [white, plate(chequer(256), 2.0)].map(|model| scene_of(model).picture(&view, &appearance(), 1));
        for (i, _) in places(&view).iter().enumerate().filter(|(_, place)| place.is_some()) {
            let [white, painted] =
                [&white, &painted].map(|picture| srgb_decoded(f64::from(picture.rgba[i][1]) / 255.0));
            assert!((painted / white - 0.5).abs() < 0.02, "{beta}: {painted} of {white}");
        }
    }
}

/// Near to a texture, and so far from it that only its average is left, the packets draw what the reference
/// draws. Between, their samples lie elsewhere in a pixel.
#[test]
fn packets_draw_the_textures_of_the_reference() {
    let mut renderers = Renderers::new(None);
    for copies in [0.5, 3.0, 200.0] {
        let scene = scene_of(plate(graded(Wrap::Mirror), copies));
        for geometry in [Geometry::Seen, Geometry::Contracted, Geometry::Rest] {
            for beta in [0.0, 0.6, 0.9] {
                let view = view(beta, geometry);
                let expected = scene.picture(&view, &appearance(), 2);
                let found = renderers
                    .picture(Method::Packets, &scene, &view, &appearance(), 2)
                    .expect("it needs no device");
                let mut compared = 0;
                for i in inner(&places(&view)) {
                    let (expected, found) = (expected.rgba[i], found.rgba[i]);
                    let levels = expected.iter().zip(found).map(|(a, b)| a.abs_diff(b)).max();
                    assert!(
                        levels <= Some(2),
                        "{copies} {geometry:?} {beta}, pixel {i}: {found:?} for {expected:?}"
                    );
                    compared += 1;
                }
                assert!(compared > 30, "{compared}");
            }
        }
    }
}

#[test]
fn what_is_no_texture_is_refused() {
    let refused = |change: &dyn Fn(&mut RawModel)| {
        let mut model = plate(graded(Wrap::Repeat), 1.0);
        change(&mut model);
        model.prepared().expect_err("it is wrong").to_string()
    };
    let each =
        "each triangle of the model must name one of its textures or none, and each corner a place in it";
    let texts = [
        (refused(&|model| model.texture_numbers[0] = 1), each),
        (refused(&|model| model.texture_numbers.truncate(1)), each),
        (refused(&|model| model.texture_places.truncate(3)), each),
        (refused(&|model| model.texture_numbers.clear()), each),
        (
            refused(&|model| Arc::make_mut(&mut model.textures[0]).levels[0].size = [1 << 31, 1 << 31]),
            "the textures of the model have 4611686018427387904 texels, and 67108864 are the most",
        ),
        (
            refused(&|model| model.texture_places[2][1] = f32::NAN),
            "corner 2 of the model is at [1.0, NaN] in its texture, and places must lie between -1e4 and 1e4",
        ),
    ];
    for (found, expected) in texts {
        assert_eq!(found, expected);
    }
    for size in [[64, 63], [0, 64], [1 << 31, 1 << 31]] {
        let refused = Texture { size, ..graded(Wrap::Repeat) }.prepared();
        assert_eq!(refused.expect_err("it is wrong"), TrianglesError::Texture);
    }
}
