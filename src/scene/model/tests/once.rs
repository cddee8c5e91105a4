//! Models of a scene that have files, textures or triangles in common: these are read and kept once, and have
//! limits for all models together.

use std::sync::Arc;

use relativity_render::{Body, Triangles};

use super::textures::{SQUARE, picture};
use super::{OBJ, folder_of, read};
use crate::scene::Scene;
use crate::scene::model::companions::Companions;
use crate::scene::model::limits::Room;
use crate::scene::model::parsed;

/// A square with a texture, and a wheel beside it with the same.
fn textured_parts() -> Scene {
    let wheel = "o wheel\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nf 5/1 6/2 7/3 8/4\n";
    let obj = format!("{SQUARE}{wheel}");
    let files: [(&str, &[u8]); 3] =
        [("a.obj", obj.as_bytes()), ("a.mtl", b"newmtl wood\nmap_Kd a.png\n"), ("a.png", &picture())];
    read("path = \"a.obj\"\nwheels = [\"wheel\"]", &files).expect("it is right")
}

fn models(bodies: &[Body]) -> Vec<&Arc<Triangles>> {
    bodies.iter().filter_map(|body| body.triangles.as_ref()).collect()
}

#[test]
fn models_that_differ_by_their_place_alone_share_their_triangles() {
    let one = "path = \"a.obj\"\nscale = 2";
    let place = [10.0, -3.0, 0.5];
    let table = format!(
        "{one}\n[[model]]\n{one}\nname = \"b\"\nplace = {place:?}\n[[model]]\n{one}\nname = \"c\"\nangle = 1"
    );
    let scene = read(&table, &[("a.obj", OBJ.as_bytes())]).expect("it is right");
    let [a, b, c] = models(&scene.bodies)[..] else { panic!("there are three") };
    assert!(Arc::ptr_eq(a, b) && !Arc::ptr_eq(a, c));
    assert_eq!(scene.bodies[1].shape, scene.bodies[0].shape.moved(place));
    assert_eq!(scene.models.len(), 1);
    let alone = read(&format!("{one}\nplace = {place:?}"), &[("a.obj", OBJ.as_bytes())]);
    assert_eq!(alone.expect("it is right").bodies[0], scene.bodies[1]);
}

#[test]
fn includes_of_one_preset_share_its_models() {
    let (_folder, path) = folder_of("path = \"a.obj\"", &[("a.obj", OBJ.as_bytes())]);
    let scene = (0..20).fold("name = \"trams\"\n".to_owned(), |text, i| {
        text + &format!("[[include]]\nscene = \"tram\"\noffset = [{}, 0, 0]\n", 20 * i)
    });
    std::fs::write(&path, scene).expect("it is written");
    let scene = Scene::load(&path).expect("it is right");
    let mut places: Vec<_> = models(&scene.bodies).into_iter().map(Arc::as_ptr).collect();
    let all = places.len();
    places.sort_unstable();
    places.dedup();
    assert_eq!(all, 20 * places.len());
    assert!(scene.models.is_empty(), "nobody asks what is in a preset");
}

#[test]
fn wheels_share_the_textures_of_the_rest() {
    let scene = textured_parts();
    let textures: Vec<_> = models(&scene.bodies).into_iter().map(|model| &model.textures()[0]).collect();
    assert_eq!(textures.len(), 2);
    assert!(Arc::ptr_eq(textures[0], textures[1]));
}

#[test]
fn all_models_of_a_scene_have_the_limits_of_one() {
    let room = Room::default();
    assert_eq!(room.take_triangles(3_000_000), Ok(()));
    let many = "the models of the scene have more than 5000000 triangles together";
    assert_eq!(room.take_triangles(3_000_000), Err(many.to_owned()));
    assert_eq!(room.take_triangles(2_000_000), Ok(()));
    assert_eq!(room.take_bytes(300 << 20), Ok(()));
    let many = "the models of the scene have files of more than 536870912 bytes together";
    assert_eq!(room.take_bytes(300 << 20), Err(many.to_owned()));
    // A picture for which there is no room is left out.
    let files = |name: &str| match name {
        "a.mtl" => Ok(b"newmtl wood\nmap_Kd maps/a.png\n".to_vec()),
        _ => Ok(picture()),
    };
    for (texels, left) in [(4, 0), (3, 3)] {
        let companions = Companions::new(&files, &|_| None);
        companions.texels.set(texels);
        let read = parsed("obj", SQUARE.as_bytes(), &companions).expect("it is drawn");
        assert_eq!((companions.texels.get(), read.model.textures.len()), (left, usize::from(left == 0)));
        assert_eq!(companions.into_remarks().len(), usize::from(left > 0));
    }
}

#[test]
fn a_model_is_reported_in_one_line() {
    let scene = read("path = \"a.obj\"\nscale = 7", &[("a.obj", OBJ.as_bytes())]).expect("it is right");
    let told = "a.obj: 4 triangles, 1 by 1 by 2, 0 materials, 0 textures; its materials are left out: cannot read paint.mtl: No such file or directory (os error 2)";
    assert_eq!(scene.reports().collect::<Vec<_>>(), [told]);
    assert_eq!(scene.provenance(String::new()).texts()[3], ("Models", told));
    let scene = textured_parts();
    let told = "a.obj: 4 triangles, 2 by 1 by 0, 1 material, 1 texture";
    assert_eq!(scene.reports().collect::<Vec<_>>(), [told]);
    assert!(Scene::default().provenance(String::new()).texts().len() == 3);
}
