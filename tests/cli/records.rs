//! What files tell of the scene that they show: found again wherever both files go, and nothing of the
//! folders they lay in.

use std::fs;
use std::path::Path;

use super::{Outcome, gamow, run};

const BALL: &str = "name = 'Ball'\n[[object]]\nshape = 'sphere'\ncentre = [0.0, 3.0, 0.5]\nradius = 0.4\n";

/// `gamow render` with these `words` and the scene in the file `scene`, if one is given, run in `folder`.
fn rendered(folder: &Path, scene: Option<&Path>, words: &str) -> Outcome {
    let mut command = gamow();
    command.current_dir(folder).args(["render", "--renderer", "reference", "--size", "8x6"]);
    if let Some(scene) = scene {
        command.arg("--scene").arg(scene);
    }
    run(command.args(words.split_whitespace()), b"")
}

fn contains(bytes: &[u8], text: &str) -> bool {
    bytes.windows(text.len()).any(|window| window == text.as_bytes())
}

#[test]
fn a_picture_goes_with_its_scene_and_tells_no_folder() {
    let folder = tempfile::tempdir().expect("there is a folder for temporary files");
    let at = |name: &str| folder.path().join(name);
    for name in ["marchioness/rides/out", "elsewhere"] {
        fs::create_dir_all(at(name)).expect("it is writable");
    }
    let scene = at("marchioness/rides/ball.toml");
    fs::write(&scene, BALL).expect("it is writable");
    for kind in ["png", "exr"] {
        let file = at("marchioness/rides/seen").with_extension(kind);
        let out = format!("--out {}", file.display());
        rendered(folder.path(), Some(&scene), &out).text();
        let bytes = fs::read(&file).expect("it is there");
        assert!(contains(&bytes, "--scene=ball.toml "), "{kind}");
        assert!(!contains(&bytes, "marchioness") && !contains(&bytes, "rides"), "{kind}");
        fs::copy(&file, at("elsewhere/seen").with_extension(kind)).expect("it is writable");
    }
    // The frames of a sequence are taken for made by the same name.
    for drawn in ["2 frames drawn and 0 kept", "0 frames drawn and 2 kept"] {
        let outcome = rendered(&at("marchioness/rides"), Some(&scene), "--frames 2 --out out");
        assert!(outcome.stderr.contains(drawn), "{}", outcome.stderr);
    }
    let frame = fs::read(at("marchioness/rides/out/frame_00000.png")).expect("it is there");
    assert!(contains(&frame, "--scene=../ball.toml "));

    for kind in ["png", "exr"] {
        let state = format!("--state elsewhere/seen.{kind} --out again.png");
        let complaint = rendered(folder.path(), None, &state).complaint();
        let missed = "gamow: elsewhere/ball.toml: cannot read this scene file: No such file";
        assert!(complaint.starts_with(missed), "{complaint}");
        assert!(!at("again.png").exists());
    }
    // `measure` asks the scene which body is called so.
    let measured = || {
        run(
            gamow().current_dir(folder.path()).args(["measure", "elsewhere/seen.exr", "--object", "sphere"]),
            b"",
        )
    };
    assert!(measured().complaint().contains("elsewhere/ball.toml: cannot read this scene file"));
    fs::copy(&scene, at("elsewhere/ball.toml")).expect("it is writable");
    assert!(!measured().stderr.contains("cannot read"), "the scene is beside the picture");
    for kind in ["png", "exr"] {
        rendered(folder.path(), None, &format!("--state elsewhere/seen.{kind} --out again.png")).text();
        assert!(contains(&fs::read(at("again.png")).expect("it is there"), "--scene=elsewhere/ball.toml "));
    }
}
