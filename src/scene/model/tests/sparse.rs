//! Sparse data of glTF: numbers that take the places of others, or of zeros.

use serde_json::{Value, json};

use super::extensions::{add, bytes};
use super::{gltf, read};

/// Writes the numbers of an accessor over those at these places.
fn put(document: &mut Value, accessor: usize, numbers: &[u16], values: &[u8]) {
    let data: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    let [numbers_at, values_at] = [&data[..], values].map(|data| {
        let number = add(document, 5121, "SCALAR", data.len(), data);
        document["accessors"][number]["bufferView"].clone()
    });
    document["accessors"][accessor]["sparse"] = json!({
        "count": numbers.len(),
        "indices": { "bufferView": numbers_at, "componentType": 5123 },
        "values": { "bufferView": values_at }
    });
}

/// The tetrahedron, whose last corner sparse data move upwards.
pub fn moved() -> Value {
    let mut document = gltf();
    put(&mut document, 0, &[3], &bytes(&[0.0, 0.0, 5.0]));
    document
}

fn fingerprint(document: &Value) -> Result<String, String> {
    let text = document.to_string();
    read("path = \"a.gltf\"\nup = \"z\"", &[("a.gltf", text.as_bytes())]).map(|scene| scene.fingerprint())
}

#[test]
fn sparse_numbers_take_the_places_of_others() {
    let mut plain = gltf();
    let corners = bytes(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 5.0]);
    let number = add(&mut plain, 5126, "VEC3", 4, &corners);
    plain["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = json!(number);
    let expected = fingerprint(&plain).expect("it is right");
    assert_ne!(expected, fingerprint(&gltf()).expect("it is right"));
    assert_eq!(fingerprint(&moved()).as_ref(), Ok(&expected));
    // Without data of its own it has zeros.
    let mut zeros = gltf();
    zeros["accessors"][0].as_object_mut().expect("an object").remove("bufferView");
    put(&mut zeros, 0, &[1, 2, 3], &corners[12..]);
    assert_eq!(fingerprint(&zeros).as_ref(), Ok(&expected));
    // The numbers of corners may be sparse as well: the last triangle has another corner for a while.
    let indices = |last: [u16; 3]| {
        let mut document = moved();
        let all = [0, 2, 1, 0, 1, 3, 0, 3, 2, last[0], last[1], last[2]];
        let all: Vec<u8> = all.iter().flat_map(|index: &u16| index.to_le_bytes()).collect();
        document["meshes"][0]["primitives"][0]["indices"] =
            json!(add(&mut document, 5123, "SCALAR", 12, &all));
        document
    };
    let mut mended = indices([1, 1, 3]);
    let number = mended["meshes"][0]["primitives"][0]["indices"].as_u64().expect("a number");
    put(&mut mended, number as usize, &[10], &2_u16.to_le_bytes());
    assert_eq!(fingerprint(&mended), fingerprint(&indices([1, 2, 3])));
}

#[test]
fn sparse_data_that_there_are_not_are_refused() {
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut document = moved();
        change(&mut document);
        let error = fingerprint(&document).expect_err("it is wrong");
        error.split_once("\": ").expect("a reason").1.to_owned()
    };
    let beyond = "accessor 0 reaches beyond its data";
    assert_eq!(refused(&|it| it["accessors"][0]["sparse"]["count"] = json!(2)), beyond);
    assert_eq!(refused(&|it| it["accessors"][0]["sparse"]["values"]["byteOffset"] = json!(1)), beyond);
    assert_eq!(refused(&|it| it["accessors"][0]["count"] = json!(5)), beyond);
    assert_eq!(
        refused(&|it| put(it, 0, &[4], &bytes(&[0.0; 3]))),
        "accessor 0 has no element 4, which its sparse data name"
    );
    let many = refused(&|it| {
        it["accessors"][0].as_object_mut().expect("an object").remove("bufferView");
        it["accessors"][0]["count"] = json!(u64::from(u32::MAX));
    });
    assert_eq!(many, "it has more than 5000000 triangles, the most of a model");
}
