//! Textures of models: where they are, and what is refused.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use relativity_render::{Picture, TrianglePoint, Triangles};
use serde_json::{Value, json};

use super::{gltf, read, remarks, triangles};
use crate::files::png;
use crate::scene::Scene;
use crate::scene::model::companions::Companions;
use crate::scene::model::parsed;

/// Sixteen columns and eight rows as JPEG: red on the left, blue on the right.
const JPEG: &str = "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAMCAgMCAgMDAwMEAwMEBQgFBQQEBQoHBwYIDAoMDAsKCwsNDhIQDQ4RDgsLEBYQERMUFRUVDA8XGBYUGBIUFRT/2wBDAQMEBAUEBQkFBQkUDQsNFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBT/wAARCAAIABADAREAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAABgf/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/8QAFgEBAQEAAAAAAAAAAAAAAAAACQcI/8QAFBEBAAAAAAAAAAAAAAAAAAAAAP/aAAwDAQACEQMRAD8AiibtqipJR2v/2Q==";
/// A square as OBJ: its places in the texture are its own.
pub const SQUARE: &str = "mtllib a.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n\
                      f 1/1 2/2 3/3 4/4\n";
/// The four texels of a picture, from the top left.
const TEXELS: [[u8; 4]; 4] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255; 4]];

/// A picture of these texels as PNG.
pub fn picture() -> Vec<u8> {
    let mut bytes = Vec::new();
    png::write(&Picture { size: [2, 2], rgba: TEXELS.to_vec() }, &[], &mut bytes).expect("it is written");
    bytes
}

/// The paint of the square of two triangles at this place of its first three corners' axes, as bytes.
fn paint(triangles: &Triangles, triangle: u32, weights: [f32; 2]) -> [u8; 3] {
    triangles.paint(TrianglePoint { triangle, weights }).map(|part| (255.0 * part).round() as u8)
}

fn obj(mtl: &str, picture: &[u8]) -> Result<Scene, String> {
    let files = [("a.obj", SQUARE.as_bytes()), ("a.mtl", mtl.as_bytes()), ("maps/a.png", picture)];
    read("path = \"a.obj\"", &files)
}

#[test]
fn textures_of_obj_begin_at_the_bottom_and_multiply_the_diffuse_colour() {
    let scene = obj("newmtl wood\nKd 1 1 0.5\nmap_Kd maps\\a.png\n", &picture()).expect("it is right");
    let square = triangles(&scene);
    // Quarters of the way along the sides, in the triangles 1 2 3 and 1 3 4: the middles of texels.
    assert_eq!(paint(square, 0, [0.5, 0.25]), [255, 255, 128], "bottom right");
    assert_eq!(paint(square, 0, [0.0, 0.75]), [0, 255, 0], "top right");
    assert_eq!(paint(square, 1, [0.25, 0.5]), [255, 0, 0], "top left");
    assert_eq!(paint(square, 1, [0.25, 0.0]), [0, 0, 128], "bottom left");
    let black = obj("newmtl wood\nKd 0 0 0\nmap_Kd maps/a.png\n", &picture()).expect("it is right");
    assert_eq!(paint(triangles(&black), 0, [0.5, 0.25]), [255; 3]);
    let other = obj("newmtl wood\nmap_Kd maps/a.png\n", &STANDARD.decode(JPEG).expect("base64"));
    let other = other.expect("it is JPEG, whatever it is called");
    assert_ne!(scene.fingerprint(), other.fingerprint());
    for (weights, expected) in [([0.2, 0.1], [0.58, 0.02, 0.02]), ([0.6, 0.3], [0.02, 0.04, 0.72])] {
        let found = triangles(&other).paint(TrianglePoint { triangle: 0, weights });
        assert!(
            found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 0.05),
            "{found:?}"
        );
    }
}

#[test]
fn masks_have_the_cutoff_of_their_material() {
    let cutoff = |scene: Result<Scene, String>| triangles(&scene.expect("it is right")).textures()[0].cutoff;
    let gltf = |mode: &str, opacity: f32, least: Value| {
        cutoff(read_textured(&|it| {
            let material = &mut it["materials"][0];
            material["alphaMode"] = json!(mode);
            material["pbrMetallicRoughness"]["baseColorFactor"] = json!([1, 1, 1, opacity]);
            if least != Value::Null {
                material["alphaCutoff"] = least.clone();
            }
        }))
    };
    assert_eq!(gltf("OPAQUE", 0.5, Value::Null), 0);
    assert_eq!(gltf("MASK", 1.0, Value::Null), 32768);
    assert_eq!(gltf("MASK", 0.5, json!(0.2)), 26214);
    assert_eq!(gltf("BLEND", 0.4, Value::Null), 32768);
    let with = |mask: &str| obj(&format!("newmtl wood\nmap_Kd maps/a.png\nmap_d {mask}\n"), &picture());
    assert_eq!(cutoff(with("maps/a.png")), 32768);
    let other = with("maps/b.png");
    assert!(
        remarks(other.as_ref().expect("it is right")).concat().starts_with("the mask maps/b.png is left out")
    );
    assert_eq!(cutoff(other), 0);
}

/// The tetrahedron with a texture on it: a picture of four texels, in its own data.
fn textured(change: &dyn Fn(&mut Value)) -> Value {
    let mut document = gltf();
    let picture = picture();
    let places: [f32; 8] = [0.25, 0.25, 0.75, 0.25, 0.25, 0.75, 0.75, 0.75];
    let mut data: Vec<u8> = places.iter().flat_map(|part| part.to_le_bytes()).collect();
    data.extend(&picture);
    let list = |document: &mut Value, name: &str, one: Value| match &mut document[name] {
        Value::Array(list) => list.push(one),
        empty => *empty = json!([one]),
    };
    let uri = format!("data:application/octet-stream;base64,{}", STANDARD.encode(&data));
    list(&mut document, "buffers", json!({ "byteLength": data.len(), "uri": uri }));
    list(&mut document, "bufferViews", json!({ "buffer": 1, "byteLength": 32 }));
    list(&mut document, "bufferViews", json!({ "buffer": 1, "byteOffset": 32, "byteLength": picture.len() }));
    list(
        &mut document,
        "accessors",
        json!({ "bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC2" }),
    );
    list(&mut document, "images", json!({ "bufferView": 3, "mimeType": "image/png" }));
    list(&mut document, "samplers", json!({ "wrapS": 33071, "wrapT": 33648 }));
    list(&mut document, "textures", json!({ "source": 0, "sampler": 0 }));
    document["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(2);
    document["materials"][0]["pbrMetallicRoughness"] = json!({ "baseColorTexture": { "index": 0 } });
    change(&mut document);
    document
}

fn read_textured(change: &dyn Fn(&mut Value)) -> Result<Scene, String> {
    read("path = \"a.gltf\"", &[("a.gltf", textured(change).to_string().as_bytes()), ("b.png", &picture())])
}

#[test]
fn textures_of_gltf_begin_at_the_top_and_go_on_as_their_sampler_says() {
    let embedded = read_textured(&|_| ()).expect("it is right");
    let corners = |scene: &Scene| {
        // The first triangle has the corners 0, 2 and 1, the second 0, 1 and 3.
        let paint = |triangle, weights| paint(triangles(scene), triangle, weights);
        [paint(0, [0.0; 2]), paint(0, [0.0, 1.0]), paint(0, [1.0, 0.0]), paint(1, [0.0, 1.0])]
    };
    let texels = TEXELS.map(|[red, green, blue, _]| [red, green, blue]);
    assert_eq!(corners(&embedded), texels);
    let beside = read_textured(&|it| it["images"][0] = json!({ "uri": "b.png" })).expect("it is right");
    assert_eq!(beside.fingerprint(), embedded.fingerprint());
    let repeated = read_textured(&|it| it["samplers"] = json!([{}])).expect("it is right");
    assert_ne!(repeated.fingerprint(), embedded.fingerprint());
    // A quarter turn about the middle: what was on the right is above, what was above on the left.
    let turn = json!({ "KHR_texture_transform": { "rotation": 90f64.to_radians(), "offset": [0, 1] } });
    let turned = read_textured(&|it| {
        it["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = turn.clone();
    });
    assert_eq!(corners(&turned.expect("it is right")), [texels[2], texels[0], texels[3], texels[1]]);
    let plain = read_textured(&|it| {
        it["meshes"][0]["primitives"][0]["attributes"]
            .as_object_mut()
            .expect("an object")
            .remove("TEXCOORD_0");
    });
    assert!(triangles(&plain.expect("it is right")).textures().is_empty());
}

#[test]
fn a_picture_that_cannot_be_read_is_left_out_with_a_remark() {
    let remarks = |scene: Scene| {
        assert!(triangles(&scene).textures().is_empty());
        scene.models[0].remarks.clone()
    };
    let obj = |mtl: &str, picture: &[u8]| remarks(obj(mtl, picture).expect("it is drawn"));
    let gltf = |change: &dyn Fn(&mut Value)| remarks(read_textured(change).expect("it is drawn"));
    let mtl = "newmtl wood\nmap_Kd maps/a.png\n";
    let mut large = picture();
    large[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 1, 0, 0]);
    let texts = [
        (obj(mtl, b"GIF89a"), "a picture is left out: cannot read maps/a.png: it is neither PNG nor JPEG"),
        (
            obj(mtl, &picture()[..20]),
            "a picture is left out: cannot read maps/a.png: as PNG, it ends too early",
        ),
        (
            obj(mtl, &large),
            "a picture is left out: cannot read maps/a.png: as PNG, it has 65536x65536 pixels; the textures of a scene have at most 67108864 together",
        ),
        (obj("newmtl wood\nmap_Kd\n", b""), "map_Kd in a.mtl is left out, as it has not a file"),
        (obj("newmtl wood\nKd 1 1\n", b""), "Kd in a.mtl is left out, as it has not three numbers"),
        (
            obj("newmtl wood\nmap_Kd maps/b.png\n", b""),
            "a picture is left out: cannot read maps/b.png: No such file or directory (os error 2)",
        ),
        (
            obj("newmtl wood\nmap_Kd ../b.png\n", b""),
            "a picture is left out: ../b.png must lie in the folder of the scene file, or in a folder there",
        ),
        (gltf(&|it| it["images"][0] = json!({})), "a picture is left out: image 0 has no data"),
        (
            gltf(&|it| it["images"][0] = json!({ "uri": "data:image/png;base64,!" })),
            "a picture is left out: an image in it is not base64",
        ),
        (
            gltf(&|it| it["bufferViews"][3]["byteLength"] = json!(9999)),
            "a picture is left out: image 0 reaches beyond its data",
        ),
    ];
    for (found, expected) in texts {
        assert_eq!(found, [expected]);
    }
    assert_eq!(obj("newmtl\n", b""), [""; 0]);
    let damaged = obj(mtl, &picture()[..50]).concat();
    assert!(damaged.contains("cannot read maps/a.png: as PNG, ") && !damaged.contains('\n'), "{damaged}");
}

#[test]
fn what_is_wrong_with_a_texture_is_said_in_one_line() {
    let gltf = |change: &dyn Fn(&mut Value)| read_textured(change).expect_err("it is wrong");
    let texts = [
        (
            gltf(&|it| it["textures"][0]["source"] = json!(4)),
            "textures[0].source names something that there is not",
        ),
        (
            gltf(&|it| it["accessors"][2]["count"] = json!(3)),
            "a mesh has not as many places in its texture as corners",
        ),
    ];
    for (found, expected) in texts {
        assert_eq!(found.split_once("\": ").map(|(_, reason)| reason), Some(expected));
    }
}

#[test]
fn options_of_a_picture_scale_and_shift_it() {
    let plain = obj("newmtl wood\nmap_Kd maps/a.png\n", &picture()).expect("it is right");
    let moved = obj("newmtl wood\nmap_Kd -clamp off -s 2 1 1 -o 0.5 0 0 maps/a.png\n", &picture());
    let moved = moved.expect("it is right");
    for u in [0.375, 0.5, 0.625, 0.875] {
        let at = |square: &Triangles, u: f32| paint(square, 0, [u - 0.25, 0.25]);
        assert_eq!(at(triangles(&moved), u), at(triangles(&plain), (2.0 * u + 0.5) % 1.0), "{u}");
    }
}

/// Every byte of a picture, one at a time, is another: nothing panics.
#[test]
fn damaged_pictures_are_read_or_refused() {
    for picture in [picture(), STANDARD.decode(JPEG).expect("base64")] {
        for place in 0..picture.len() {
            for byte in [0, 1, 0x7f, 0xff] {
                let mut damaged = picture.clone();
                damaged[place] = byte;
                let mtl = b"newmtl wood\nmap_Kd a.png".to_vec();
                let beside = |name: &str| Ok(if name == "a.mtl" { mtl.clone() } else { damaged.clone() });
                let companions = Companions::new(&beside, &|_| None);
                let _ = parsed("obj", SQUARE.as_bytes(), &companions).map(|named| named.model.prepared());
            }
        }
    }
}
