//! glTF files whose geometry or materials need more than corners and factors.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::DVec3;
use relativity_render::TrianglePoint;
use serde_json::{Value, json};

use super::{gltf, placed, read, remarks, triangles};
use crate::scene::Scene;

/// The corners of the tetrahedron.
const CORNERS: [DVec3; 4] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(0.0, 0.0, 2.0)];

/// Reads the tetrahedron with a change, its axes as they are.
fn changed(change: impl Fn(&mut Value)) -> Result<Scene, String> {
    let mut document = gltf();
    change(&mut document);
    read("path = \"a.gltf\"\nup = \"z\"", &[("a.gltf", document.to_string().as_bytes())])
}

/// Adds data to a document, and returns the number of its accessor.
pub fn add(document: &mut Value, kind: u32, shape: &str, count: usize, data: &[u8]) -> usize {
    let push = |document: &mut Value, list: &str, item: Value| {
        let items = document[list].as_array_mut().expect("a list");
        items.push(item);
        items.len() - 1
    };
    let uri = format!("data:application/octet-stream;base64,{}", STANDARD.encode(data));
    let buffer = push(document, "buffers", json!({ "byteLength": data.len(), "uri": uri }));
    let view = push(document, "bufferViews", json!({ "buffer": buffer, "byteLength": data.len() }));
    let accessor = json!({ "bufferView": view, "componentType": kind, "count": count, "type": shape });
    push(document, "accessors", accessor)
}

/// The bytes of these numbers.
pub fn bytes(floats: &[f32]) -> Vec<u8> {
    floats.iter().flat_map(|float| float.to_le_bytes()).collect()
}

/// The middle and half the sides of the box around these places.
fn around(places: impl IntoIterator<Item = DVec3>) -> ([f64; 3], [f64; 3]) {
    let far = [DVec3::INFINITY, DVec3::NEG_INFINITY];
    let [low, high] = places.into_iter().fold(far, |[low, high], place| [low.min(place), high.max(place)]);
    ((0.5 * (low + high)).to_array(), (0.5 * (high - low)).to_array())
}

#[test]
fn a_mesh_is_morphed_by_its_default_weights_and_a_node_has_its_own() {
    let morphed = |of_mesh: Value, of_node: Value| {
        let scene = changed(|it| {
            let moves = bytes(&[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
            let target = add(it, 5126, "VEC3", 4, &moves);
            it["meshes"][0]["primitives"][0]["targets"] = json!([{ "POSITION": target }]);
            it["meshes"][0]["weights"] = of_mesh.clone();
            it["nodes"][1]["weights"] = of_node.clone();
        });
        2.0 * placed(&scene.expect("it is right")).1[2]
    };
    assert_eq!(morphed(json!([0.5]), Value::Null), 2.5);
    assert_eq!(morphed(json!([0.5]), json!([1.0])), 3.0);
    assert_eq!(morphed(Value::Null, Value::Null), 2.0);
}

#[test]
fn a_skinned_mesh_stands_where_its_joints_are() {
    let scene = changed(|it| {
        // The last corner goes half with either joint, the others with the first.
        let numbers = add(it, 5121, "VEC4", 4, &[[0, 1, 0, 0]; 4].concat());
        let weights = bytes(&[[1.0, 0.0, 0.0, 0.0]; 3].concat());
        let weights = add(it, 5126, "VEC4", 4, &[weights, bytes(&[0.5, 0.5, 0.0, 0.0])].concat());
        let mut matrices = [[0.0; 16]; 2];
        for (matrix, along) in matrices.iter_mut().zip([-1.0, -3.0]) {
            (0..4).for_each(|side| matrix[5 * side] = 1.0);
            matrix[12] = along;
        }
        let matrices = add(it, 5126, "MAT4", 2, &bytes(&matrices.concat()));
        let attributes = &mut it["meshes"][0]["primitives"][0]["attributes"];
        (attributes["JOINTS_0"], attributes["WEIGHTS_0"]) = (json!(numbers), json!(weights));
        it["skins"] = json!([{ "joints": [2, 3], "inverseBindMatrices": matrices }]);
        it["nodes"][1]["skin"] = json!(0);
        let nodes = it["nodes"].as_array_mut().expect("a list");
        nodes.push(json!({ "translation": [5, 0, 0], "scale": [2, 2, 2], "children": [3] }));
        nodes.push(json!({ "translation": [0, 4, 0] }));
        it["scenes"][0]["nodes"] = json!([0, 2]);
    });
    let first = |corner: DVec3| DVec3::new(5.0, 0.0, 0.0) + 2.0 * (corner - DVec3::X);
    let second = |corner: DVec3| DVec3::new(5.0, 8.0, 0.0) + 2.0 * (corner - 3.0 * DVec3::X);
    let [a, b, c, d] = CORNERS;
    let places = [first(a), first(b), first(c), 0.5 * (first(d) + second(d))];
    assert_eq!(placed(&scene.expect("it is right")), around(places));
}

#[test]
fn hidden_nodes_are_not_drawn_and_instances_are() {
    let hide = |it: &mut Value| {
        it["nodes"][0]["children"] = json!([1, 2]);
        let hidden = json!({ "KHR_node_visibility": { "visible": false } });
        let nodes = it["nodes"].as_array_mut().expect("a list");
        nodes.push(json!({ "children": [3], "extensions": hidden }));
        nodes.push(json!({ "mesh": 0 }));
    };
    let (whole, hidden) = (changed(|_| {}).expect("it is right"), changed(hide).expect("it is right"));
    assert_eq!(whole.fingerprint(), hidden.fingerprint());
    assert_eq!(remarks(&hidden), ["1 mesh is hidden by its nodes"]);
    let scene = changed(|it| {
        let moves = add(it, 5126, "VEC3", 2, &bytes(&[0.0, 0.0, 0.0, 0.0, 10.0, 0.0]));
        let scales = add(it, 5126, "VEC3", 2, &bytes(&[1.0, 1.0, 1.0, 1.0, 1.0, 3.0]));
        let attributes = json!({ "TRANSLATION": moves, "SCALE": scales });
        it["nodes"][1]["extensions"] = json!({ "EXT_mesh_gpu_instancing": { "attributes": attributes } });
        it["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    });
    let scene = scene.expect("it is right");
    let own = |corner: DVec3| corner * DVec3::new(2.0, 1.0, 1.0) + 3.0 * DVec3::Z;
    let other = |corner: DVec3| own(corner * DVec3::new(1.0, 1.0, 3.0) + 10.0 * DVec3::Y);
    assert_eq!(triangles(&scene).count(), 8);
    assert_eq!(placed(&scene), around(CORNERS.into_iter().flat_map(|corner| [own(corner), other(corner)])));
}

#[test]
fn whole_numbers_are_places_too() {
    let whole = placed(&changed(|_| {}).expect("it is right"));
    let words = CORNERS.map(|corner| [corner.x, corner.y, corner.z, 0.0].map(|part| part as i16));
    let words: Vec<u8> = words.concat().into_iter().flat_map(i16::to_le_bytes).collect();
    let parts = CORNERS
        .map(|corner| [corner.x, corner.y, 0.5 * corner.z, 0.0].map(|part| (127.0 * part) as i8 as u8));
    for (kind, data, is_part) in [(5122, words, false), (5120, parts.concat(), true)] {
        let scene = changed(|it| {
            let places = add(it, kind, "VEC3", 4, &data);
            let view = it["accessors"][places]["bufferView"].as_u64().expect("a number") as usize;
            it["bufferViews"][view]["byteStride"] = json!(data.len() / 4);
            it["accessors"][places]["normalized"] = json!(is_part);
            it["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(places);
            it["nodes"][1]["scale"] = json!([2, 1, if is_part { 2 } else { 1 }]);
            it["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
        });
        assert_eq!(placed(&scene.expect("it is right")), whole);
    }
}

#[test]
fn materials_of_other_models_are_read_or_named() {
    let paint = |material: Value| {
        let scene = changed(|it| it["materials"][0] = material.clone()).expect("it is drawn");
        let point = TrianglePoint { triangle: 0, weights: [0.25; 2] };
        let paint = triangles(&scene).paint(point).map(|part| (100.0 * part).round());
        (paint, remarks(&scene).concat())
    };
    let glossy = json!({ "KHR_materials_pbrSpecularGlossiness": { "diffuseFactor": [1, 0.5, 0, 1] } });
    assert_eq!(paint(json!({ "extensions": glossy })), ([100.0, 50.0, 0.0], String::new()));
    let black = json!({ "baseColorFactor": [0, 0, 0, 1] });
    let light = json!({ "emissiveFactor": [0, 0.5, 0], "pbrMetallicRoughness": black });
    let told = "materials that give light are drawn as paint";
    assert_eq!(paint(light), ([0.0, 50.0, 0.0], told.to_owned()));
    let told = "light of materials that have a colour, too, is left out";
    assert_eq!(paint(json!({ "emissiveFactor": [0, 0.5, 0] })), ([100.0; 3], told.to_owned()));
    assert_eq!(paint(json!({ "alphaMode": "MASK" })), ([100.0; 3], String::new()));
    let told = "transparency is left out: a surface is drawn where its picture is at least half opaque";
    assert_eq!(paint(json!({ "alphaMode": "BLEND" })), ([100.0; 3], told.to_owned()));
    let unseen =
        json!({ "alphaMode": "MASK", "pbrMetallicRoughness": { "baseColorFactor": [1, 1, 1, 0.4] } });
    let error = changed(|it| it["materials"][0] = unseen.clone()).expect_err("nothing is seen");
    assert!(error.ends_with("the model has no triangle with an area"), "{error}");
}

#[test]
fn extensions_that_may_change_geometry_are_named_and_compressed_files_have_a_way_out() {
    let used = |name: &str| changed(|it| it["extensionsUsed"] = json!([name]));
    assert_eq!(
        remarks(&used("EXT_bent_space").expect("it is drawn")),
        ["the extension EXT_bent_space is left out"]
    );
    assert_eq!(remarks(&used("KHR_materials_ior").expect("it is drawn")), [""; 0]);
    // The plain triangles stand beside the compressed ones.
    assert!(used("KHR_draco_mesh_compression").is_ok());
    for (name, list) in
        [("KHR_draco_mesh_compression", "extensionsUsed"), ("EXT_meshopt_compression", "extensionsRequired")]
    {
        let error = changed(|it| {
            it[list] = json!([name]);
            it["accessors"][0].as_object_mut().expect("an object").remove("bufferView");
        });
        let error = error.expect_err("it is compressed");
        let told = format!(
            "its triangles are compressed ({name}), which is not read here; `npx @gltf-transform/cli copy compressed.glb plain.glb` decompresses it"
        );
        assert!(error.ends_with(&told), "{error}");
    }
}

#[test]
fn names_in_another_encoding_and_a_mark_do_not_matter() {
    let plain = changed(|_| {}).expect("it is right");
    let text = gltf().to_string().replacen('{', "{\"extras\":\"Gr\u{fc}n\",", 1);
    let latin: Vec<u8> = text.chars().map(|letter| u32::from(letter) as u8).collect();
    for file in [latin, [b"\xef\xbb\xbf", text.as_bytes()].concat()] {
        let scene = read("path = \"a.gltf\"\nup = \"z\"", &[("a.gltf", &file)]).expect("it is right");
        assert_eq!(scene.fingerprint(), plain.fingerprint());
    }
}

/// The place that weights mean is the same in the file's order of corners and in the model's own.
#[test]
fn weights_of_corners_follow_the_order_of_the_file() {
    for (mode, order) in [
        (4, vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]),
        (5, (0..10).map(|n| [n, n + 1, n + 2]).collect()),
        (6, (0..10).map(|n| [0, n + 1, n + 2]).collect()),
    ] {
        for scale in [1.0, -1.0] {
            let scene = changed(|it| {
                it["meshes"][0]["primitives"][0]["mode"] = json!(mode);
                it["nodes"] = json!([{ "mesh": 0, "scale": [scale, 1, 1] }]);
            });
            let scene = scene.expect("it is right");
            let named = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3].map(|corner: usize| CORNERS[corner]);
            let model = triangles(&scene);
            let own: Vec<DVec3> = model.corners().map(|corner| corner + model.middle()).collect();
            for (triangle, corners) in order.iter().enumerate() {
                let of_file = corners.map(|at| if mode == 4 { CORNERS[at] } else { named[at] });
                let of_file = of_file.map(|corner| corner * DVec3::new(scale, 1.0, 1.0));
                let place = |[a, b, c]: [DVec3; 3], [second, third]: [f32; 2]| {
                    a + (b - a) * f64::from(second) + (c - a) * f64::from(third)
                };
                let point = TrianglePoint { triangle: triangle as u32, weights: [0.5, 0.125] };
                let own = [own[3 * triangle], own[3 * triangle + 1], own[3 * triangle + 2]];
                let off = place(own, point.weights) - place(of_file, model.weights_in_file(point));
                assert!(off.length() < 1e-6, "{mode}, {scale}, {triangle}: {off}");
            }
        }
    }
}
