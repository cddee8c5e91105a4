//! Models in scene files: what is read of each format, and what is refused.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use relativity_render::{Material, RawModel, Shape, Triangles};
use serde_json::{Value, json};
use tempfile::TempDir;

mod companions;
mod extensions;
mod once;
mod ridden;
mod sparse;
mod textures;
mod wheels;

use super::companions::Companions;
use super::read_model;
use crate::scene::Scene;

/// A tetrahedron: one face red by its corners, and three of the material.
const OBJ: &str = "# a tetrahedron\nmtllib paint.mtl\nv 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 2\nusemtl grey\n\
                   f 1/1/1 3/2/2 2\nf -4//1 -3//1 -1//1\nf 1 4 3\nf 2 3 4\n";
const MTL: &str = "newmtl grey\nKd 0.25 0.5 0.75\n";

/// A scene file in a folder of its own, with this table and these files.
fn folder_of(table: &str, files: &[(&str, &[u8])]) -> (TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, bytes) in files {
        let place = folder.path().join(name);
        std::fs::create_dir_all(place.parent().expect("a folder")).expect("it is made");
        std::fs::write(place, bytes).expect("it is written");
    }
    let path = folder.path().join("a.toml");
    std::fs::write(&path, format!("name = \"a\"\n[[model]]\n{table}\n")).expect("it is written");
    (folder, path)
}

fn read(table: &str, files: &[(&str, &[u8])]) -> Result<Scene, String> {
    let (folder, path) = folder_of(table, files);
    let around = format!("{}", folder.path().display());
    Scene::load(&path).map_err(|error| error.to_string().replace(&around, "."))
}

fn triangles(scene: &Scene) -> &Triangles {
    scene.bodies[0].triangles.as_ref().expect("a model")
}

/// The middle and half the sides of the box around it.
fn placed(scene: &Scene) -> ([f64; 3], [f64; 3]) {
    let Shape::Box { centre, half, .. } = scene.bodies[0].shape else { panic!("a model has a box") };
    (centre, half.map(|side| (1e9 * side).round() / 1e9))
}

/// The same tetrahedron as glTF, with its data in it.
fn gltf() -> Value {
    let corners: [[f32; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 2.0]];
    let indices: [u16; 12] = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
    let mut data: Vec<u8> = corners.iter().flatten().flat_map(|part| part.to_le_bytes()).collect();
    data.extend(indices.iter().flat_map(|index| index.to_le_bytes()));
    json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [{ "children": [1], "translation": [0, 0, 3] }, { "mesh": 0, "scale": [2, 1, 1] }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1, "material": 0 }] }],
        "materials": [{ "pbrMetallicRoughness": { "baseColorFactor": [0.25, 0.5, 0.75, 1] } }],
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" },
            { "bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR" }
        ],
        "bufferViews": [
            { "buffer": 0, "byteLength": 48 },
            { "buffer": 0, "byteOffset": 48, "byteLength": 24 }
        ],
        "buffers": [{ "byteLength": data.len(), "uri": format!("data:application/octet-stream;base64,{}", STANDARD.encode(&data)) }]
    })
}

/// The same in one piece.
fn glb() -> Vec<u8> {
    let mut document = gltf();
    let uri = document["buffers"][0]["uri"].take();
    document["buffers"][0].as_object_mut().expect("an object").remove("uri");
    let data =
        STANDARD.decode(uri.as_str().expect("a text").split_once(',').expect("data").1).expect("base64");
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let length = 12 + 8 + text.len() + 8 + data.len();
    let word = |number: usize| (number as u32).to_le_bytes();
    [
        &b"glTF"[..],
        &word(2),
        &word(length),
        &word(text.len()),
        b"JSON",
        &text,
        &word(data.len()),
        b"BIN\0",
        &data,
    ]
    .concat()
}

/// The remarks on the models of a scene.
fn remarks(scene: &Scene) -> Vec<&str> {
    scene.models.iter().flat_map(|report| &report.remarks).map(String::as_str).collect()
}

#[test]
fn an_obj_is_read_with_its_colours_scaled_turned_and_placed() {
    let files: [(&str, &[u8]); 2] = [("models/a.obj", OBJ.as_bytes()), ("models/paint.mtl", MTL.as_bytes())];
    let table = "path = \"models/a.obj\"\nup = \"z\"\nscale = 2\nangle = 90\nplace = [1, 5, 0]";
    let scene = read(table, &files).expect("it is right");
    assert_eq!((scene.names[0].as_str(), triangles(&scene).count()), ("a", 4));
    let (centre, half) = placed(&scene);
    assert!((glam::DVec3::from(centre) - glam::DVec3::new(0.0, 6.0, 2.0)).length() < 1e-9, "{centre:?}");
    assert_eq!(half, [1.0, 1.0, 2.0]);
    let paint = |triangle, weights| {
        let point = relativity_render::TrianglePoint { triangle, weights };
        triangles(&scene).paint(point).map(|part| (part * 1e6).round() / 1e6)
    };
    assert_eq!(paint(0, [0.0, 0.0]), [1.0, 0.0, 0.0]);
    assert_eq!(paint(3, [0.5, 0.25]), [0.25, 0.5, 0.75]);
    // The forward-most point is one of its own, not a corner of its box.
    let on_corner = |corner| glam::DVec3::from(scene.tracked).distance(corner) < 1e-6;
    let foremost = [[1.0, 5.0, 0.0], [1.0, 7.0, 0.0], [1.0, 5.0, 4.0]];
    assert!(foremost.into_iter().any(|corner| on_corner(corner.into())), "{:?}", scene.tracked);
    let upright = read("path = \"models/a.obj\"\nname = \"tent\"", &files).expect("it is right");
    assert_eq!((placed(&upright).1, upright.names[0].as_str()), ([0.5, 1.0, 0.5], "tent"));
    assert_ne!(scene.fingerprint(), upright.fingerprint());
}

#[test]
fn a_material_may_be_named_as_a_measured_one() {
    let read = |name: &str| {
        let mtl = format!("newmtl {name}\nKd 0 1 0\nnewmtl leaves\nKd 0 1 0\n");
        let obj = format!(
            "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl {name}\nf 1 2 3\nusemtl leaves\nf 1 3 2\n"
        );
        let library = |_: &str| Ok(mtl.clone().into_bytes());
        super::parsed("obj", obj.as_bytes(), &Companions::new(&library, &|_| None))
            .map(|named| named.model.materials)
    };
    let road = Material::named("asphalt_road").expect("it was measured");
    assert_eq!(read("measured asphalt road"), Ok(vec![Some(road), None]));
    assert_eq!(read("measured asphalt_road"), Ok(vec![Some(road), None]));
    assert_eq!(read("bark"), Ok(Vec::new()));
    let problem = "its material `measured leavs` is none: the nearest are leaves, glass, bark";
    assert_eq!(read("measured leavs"), Err(problem.to_owned()));
    let mut document = gltf();
    document["materials"] = json!([{ "name": "measured asphalt road" }]);
    document["meshes"][0]["primitives"][0]["material"] = json!(0);
    let companions = Companions::new(&|_| unreachable!("it needs no file"), &|_| None);
    let model = super::parsed("gltf", document.to_string().as_bytes(), &companions);
    assert_eq!(model.map(|named| named.model.materials), Ok(vec![Some(road); 4]));
}

#[test]
fn a_gltf_is_read_in_both_its_forms_with_its_nodes() {
    let text = gltf().to_string();
    let [one, other] = [("a.gltf", text.as_bytes()), ("a.glb", &glb())].map(|(name, bytes)| {
        read(&format!("path = \"{name}\"\nname = \"a\"\nup = \"z\""), &[(name, bytes)]).expect("it is right")
    });
    assert_eq!(one.fingerprint(), other.fingerprint());
    assert_eq!(placed(&one), ([1.0, 0.5, 4.0], [1.0, 0.5, 1.0]));
    assert_eq!(triangles(&one).count(), 4);
    let point = relativity_render::TrianglePoint { triangle: 2, weights: [0.2, 0.3] };
    assert!(triangles(&one).paint(point).iter().zip([0.25, 0.5, 0.75]).all(|(a, b)| (a - b).abs() < 1e-6));
}

#[test]
fn what_is_wrong_with_a_model_is_said_in_one_line() {
    let obj = |text: &str| read("path = \"a.obj\"", &[("a.obj", text.as_bytes())]).expect_err("it is wrong");
    let gltf = |change: &dyn Fn(&mut Value)| {
        let mut document = gltf();
        change(&mut document);
        read("path = \"a.gltf\"", &[("a.gltf", document.to_string().as_bytes())]).expect_err("it is wrong")
    };
    let path = |path: &str| {
        read(&format!("path = \"{path}\""), &[("b/a.obj", OBJ.as_bytes())]).expect_err("it is wrong")
    };
    let texts = [
        (obj("v 0 0 0\nv 1 0 0\nf 1 2 3"), "line 3 of it: a face names corner 3, and so far there are 2"),
        (
            obj("v 0 0 0\nf -9223372036854775808 1 1"),
            "line 2 of it: a face names corner -9223372036854775808, and so far there are 1",
        ),
        (obj("v 0 0 0\nv 1 0 0\nf 1 2"), "line 3 of it: a face needs three corners"),
        (obj("v 0 0 x"), "line 1 of it: x is not a number"),
        (obj("v 0 0"), "line 1 of it: a corner needs three coordinates"),
        (obj("v 0 0 0 2 0 0"), "line 1 of it: each part of a colour must lie between 0 and 1"),
        (obj("v 0 0 0\nf 1 1 1"), "the model has no triangle with an area"),
        (
            obj("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3"),
            "corner 0 of the model is at [NaN, NaN, NaN], and coordinates must lie between -1e6 and 1e6",
        ),
        (obj(""), "the model has no triangle with an area"),
        (
            gltf(&|it| it["nodes"][1]["children"] = json!([0])),
            "node 0 is in its tree twice: nodes must not form circles",
        ),
        (
            gltf(&|it| it["nodes"][0]["children"] = json!([7])),
            "nodes[0].children[0] names something that there is not",
        ),
        (
            gltf(&|it| it["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(7)),
            "there is no accessor 7",
        ),
        (gltf(&|it| it["nodes"][1]["mesh"] = json!(3)), "nodes[1].mesh names something that there is not"),
        (
            gltf(&|it| it["accessors"][0]["type"] = json!("VEC2")),
            "accessor 0 must be VEC3 of numbers, as places are",
        ),
        (
            gltf(&|it| it["bufferViews"][0]["byteStride"] = json!(8)),
            "accessor 0 has elements of 12 bytes, one every 8",
        ),
        (gltf(&|it| it["accessors"][0]["count"] = json!(0)), "accessor 0 reaches beyond its data"),
        (gltf(&|it| it["asset"]["version"] = json!("1.0")), "it is glTF \"1.0\", and must be 2.0"),
        (
            gltf(&|it| it["extensionsRequired"] = json!(["KHR_draco_mesh_compression"])),
            "its triangles are compressed (KHR_draco_mesh_compression), which is not read here; `npx @gltf-transform/cli copy compressed.glb plain.glb` decompresses it",
        ),
        (
            gltf(&|it| it["extensionsRequired"] = json!(["EXT_bent_space"])),
            "it needs the extension EXT_bent_space, which is not known here",
        ),
        (gltf(&|it| it["accessors"][0]["count"] = json!(5)), "accessor 0 reaches beyond its data"),
        (gltf(&|it| it["accessors"][1]["count"] = json!(u64::MAX)), "accessor 1 reaches beyond its data"),
        (gltf(&|it| it["bufferViews"][1]["byteOffset"] = json!(50)), "accessor 1 reaches beyond its data"),
        (
            gltf(&|it| it["buffers"][0]["uri"] = json!("../a.bin")),
            "../a.bin must lie in the folder of the scene file, or in a folder there",
        ),
        (gltf(&|it| it["buffers"][0]["uri"] = json!("data:,abc")), "a buffer in it is not base64"),
        (path("../a.obj"), "../a.obj must lie in the folder of the scene file, or in a folder there"),
        (path("/etc/a.obj"), "/etc/a.obj must lie in the folder of the scene file, or in a folder there"),
        (path("b/c.obj"), "cannot read b/c.obj: No such file or directory (os error 2)"),
        (path("b/a.stl"), "it must end in .glb, .gltf or .obj"),
    ];
    for (found, expected) in texts {
        let reason = found.split_once("\": ").map(|(_, reason)| reason);
        assert!(found.starts_with("./a.toml:3: path = \""), "{found}");
        assert_eq!(reason, Some(expected));
    }
    let unplaced =
        Scene::parse("name = \"a\"\n[[model]]\npath = \"a.obj\"", "a.toml").expect_err("no folder");
    assert_eq!(
        unplaced.to_string(),
        "a.toml:3: path = \"a.obj\": a model needs a scene file, in whose folder it is"
    );
}

#[cfg(unix)]
#[test]
fn links_and_devices_do_not_lead_out_of_the_folder() {
    let (folder, path) = folder_of("path = \"link.obj\"", &[]);
    let outside = tempfile::tempdir().expect("a folder");
    let target = outside.path().join("a.obj");
    std::fs::write(&target, OBJ).expect("it is written");
    let link = folder.path().join("link.obj");
    std::os::unix::fs::symlink(&target, &link).expect("links work here");
    let error = |path| Scene::load(path).expect_err("it leaves the folder").to_string();
    assert!(
        error(&path).ends_with("link.obj must lie in the folder of the scene file, or in a folder there")
    );
    std::fs::remove_file(&link).expect("it was there");
    let made = std::process::Command::new("mkfifo").arg(&link).status();
    assert!(made.expect("there is mkfifo").success());
    assert!(error(&path).ends_with("it is a device or a pipe; an ordinary file would be right"));
}

/// Every byte of a file, one at a time, is another: nothing panics, and whatever is read is a scene.
#[test]
fn damaged_files_are_read_or_refused() {
    let glb = glb();
    let text = gltf().to_string();
    let read = |ending: &str, bytes: &[u8]| {
        let _ = read_model(ending, bytes).map(RawModel::prepared);
    };
    let sparse = sparse::moved().to_string();
    let files = [
        ("obj", &OBJ.as_bytes()[30..]),
        ("gltf", text.as_bytes()),
        ("gltf", sparse.as_bytes()),
        ("glb", &glb),
    ];
    for (ending, bytes) in files {
        for place in 0..bytes.len() {
            for byte in [b'9', b'-', b' ', 0, 0xff] {
                let mut damaged = bytes.to_vec();
                damaged[place] = byte;
                read(ending, &damaged);
            }
            read(ending, &bytes[..place]);
        }
    }
}
