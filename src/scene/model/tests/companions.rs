//! Companions of models that are missing, elsewhere or in another encoding.

use super::{OBJ, read, remarks, triangles};
use crate::scene::Scene;

/// The colours of the four corners of material, as bytes, and the remarks.
fn painted(files: &[(&str, &[u8])]) -> ([u8; 3], Vec<String>) {
    let scene = read("path = \"a.obj\"", files).expect("it is drawn");
    let point = relativity_render::TrianglePoint { triangle: 3, weights: [0.25; 2] };
    let paint = triangles(&scene).paint(point).map(|part| (100.0 * part).round() as u8);
    (paint, remarks(&scene).into_iter().map(str::to_owned).collect())
}

#[test]
fn a_missing_library_leaves_a_white_model_and_a_remark() {
    let (paint, remarks) = painted(&[("a.obj", OBJ.as_bytes())]);
    assert_eq!(paint, [100; 3]);
    let told = "its materials are left out: cannot read paint.mtl: No such file or directory (os error 2)";
    assert_eq!(remarks, [told]);
}

#[test]
fn a_library_is_found_beside_the_model_in_any_spelling() {
    let library: (&str, &[u8]) = ("paint.mtl", b"newmtl grey\nKd 0.25 0.5 0.75\n");
    for (name, told) in [
        ("paint.mtl", None),
        (
            "none.mtl paint.mtl",
            Some("its materials are left out: cannot read none.mtl: No such file or directory (os error 2)"),
        ),
        ("Paint.MTL", Some("paint.mtl was read in place of Paint.MTL")),
        ("C:\\work\\paint.mtl", Some("paint.mtl was read in place of C:/work/paint.mtl")),
        ("/work/PAINT.mtl", Some("paint.mtl was read in place of /work/PAINT.mtl")),
    ] {
        let obj = OBJ.replace("paint.mtl", name);
        let (paint, remarks) = painted(&[("a.obj", obj.as_bytes()), library]);
        assert_eq!((paint, remarks.first().map(String::as_str)), ([25, 50, 75], told), "{name}");
    }
}

#[test]
fn encodings_marks_line_ends_and_continued_lines_do_not_matter() {
    let library = "newmtl Gr\u{fc}n\nKd 0.25 \\\n 0.5 0.75\n";
    let obj = OBJ.replace("grey", "Gr\u{fc}n").replace("f 2 3 4", "f 2 \\\n3 4");
    let latin = |text: &str| text.chars().map(|letter| u32::from(letter) as u8).collect::<Vec<u8>>();
    let marked = |text: &str| [b"\xef\xbb\xbf", text.as_bytes()].concat();
    let returns = |text: &str| text.replace('\n', "\r").into_bytes();
    let wide = |text: &str| {
        let letters = text.encode_utf16().flat_map(u16::to_le_bytes);
        b"\xff\xfe".iter().copied().chain(letters).collect()
    };
    let plain = |text: &str| text.as_bytes().to_vec();
    let forms = |text: &str| [plain(text), latin(text), marked(text), returns(text), wide(text)];
    for (file, library) in std::iter::zip(forms(&obj), forms(library)) {
        assert_eq!(painted(&[("a.obj", &file), ("paint.mtl", &library)]), ([25, 50, 75], Vec::new()));
    }
}

#[test]
fn what_is_no_scene_is_said_to_be_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let said = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).expect("it is written");
        Scene::load(&path)
            .expect_err("it is none")
            .to_string()
            .replace(&format!("{}/", folder.path().display()), "")
    };
    let none =
        |name: &str| format!("{name} is no scene: scenes end in .toml, models end in .glb, .gltf or .obj");
    assert_eq!(said("a.stl", b"solid a\nendsolid a\n"), none("a.stl"));
    assert_eq!(said("a.fbx", b"Kaydara FBX Binary \x00\x1a\xff"), none("a.fbx"));
    assert_eq!(said("a.toml", b"solid a\n"), "a.toml:1: column 7: key with no value, expected `=`");
    assert_eq!(said("a.txt", b"name = 1"), "a.txt:1: name = 1 must be a text in double quotes");
}
