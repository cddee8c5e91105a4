//! Films of rides: frames follow the rider's clock, and each records its ride.

use std::fs;

use super::{Png, complaint_of, folder, run_gamow};

const RIDE: &str = "--scene post-office --turn -90 --depth-shift -5.5 --gaze 0,-12 --fov 90 --ride-from 1 --labels off --size 96x64 \
                    --samples 1 --renderer reference";

/// Moments of a film are those of the same ride by themselves, to the last pixel.
#[test]
fn a_film_of_a_ride_follows_the_riders_clock() {
    let folder = folder();
    run_gamow(folder.path(), &format!("render {RIDE} --layout left --ride 2@1,2@-1 --frames 3 --out ride"));
    for (frame, time) in [(0, 0.0), (1, 2.0), (2, 4.0)] {
        let name = format!("ride/frame_{frame:05}.png");
        let film = Png::read(&folder.path().join(name));
        let command = &film.texts["Parameters"];
        assert!(
            command.contains("--ride='2@1,2@-1'") && command.contains(&format!("--time={time}")),
            "{command}"
        );
        run_gamow(
            folder.path(),
            &format!("render {RIDE} --layout left --ride 2@1,2@-1 --time {time} --out still.png"),
        );
        assert_eq!(film.rgb, Png::read(&folder.path().join("still.png")).rgb);
    }
    // Who rides out of rest and brakes as hard is at rest, where it leads: as an eye that stands there at
    // that time.
    let (place, time) = (1.0 + 2.0 * (2.0_f64.cosh() - 1.0), 2.0 * 2.0_f64.sinh());
    let standing = RIDE.replace("--ride-from 1", &format!("--ride-from {place}"));
    run_gamow(
        folder.path(),
        &format!("render {standing} --layout left --ride coast --time {time} --out standing.png"),
    );
    let [ridden, standing] =
        ["ride/frame_00002.png", "standing.png"].map(|name| Png::read(&folder.path().join(name)));
    let differ = ridden.rgb.iter().zip(&standing.rgb).filter(|(a, b)| a.abs_diff(**b) > 2).count();
    // The bicycle's own wheel has turned on in the one, and not in the other.
    assert!(differ < 60, "{differ} values differ");
}

/// Whoever rides across the street and upwards out of rest, and brakes as hard, sees what an eye at rest does
/// that stands there.
#[test]
fn a_ride_leads_off_the_street() {
    let folder = folder();
    let (place, time) = (4.0 * (0.5_f64.cosh() - 1.0), 4.0 * 0.5_f64.sinh());
    let flat = format!("render {RIDE} --layout left --projection gaze");
    for (heading, shift) in [
        ("--ride-azimuth -90", format!("--depth-shift {}", place - 5.5)),
        ("--ride-elevation 90", format!("--depth-shift -5.5 --height-shift {}", -place)),
    ] {
        let ride = format!("{flat} --ride 1@0.5,1@-0.5 {heading}");
        run_gamow(folder.path(), &format!("{ride} --frames 3 --out ride"));
        let standing = flat.replace("--depth-shift -5.5", &shift);
        run_gamow(
            folder.path(),
            &format!("{standing} --ride coast {heading} --time {time} --out standing.png"),
        );
        let [begun, moving, ridden, standing] =
            ["ride/frame_00000.png", "ride/frame_00001.png", "ride/frame_00002.png", "standing.png"]
                .map(|name| Png::read(&folder.path().join(name)));
        assert!(moving.texts["Parameters"].contains(&heading.replace(' ', "=")), "{:?}", moving.texts);
        let differ = |a: &Png, b: &Png| a.rgb.iter().zip(&b.rgb).filter(|(a, b)| a.abs_diff(**b) > 2).count();
        assert!(differ(&ridden, &standing) < 60, "{heading}: {} values differ", differ(&ridden, &standing));
        assert!(differ(&moving, &begun) > 2000 && differ(&moving, &ridden) > 2000, "{heading}");
        fs::remove_dir_all(folder.path().join("ride")).expect("it is there");
    }
}

/// Commands that assume eyes at rest refuse such pictures in one line, and write nothing.
#[test]
fn pictures_of_a_ride_are_refused_by_what_knows_eyes_at_rest() {
    let folder = folder();
    let ride = format!("render {RIDE} --layout side-by-side --ride coast --ride-speed 0.5");
    run_gamow(folder.path(), &format!("{ride} --frames 2 --out ride"));
    for command in [
        "rectify ride/frame_00000.png --beta 0.5 --out out.png",
        "measure ride --marker ff0000 --out out.csv",
    ] {
        let line = complaint_of(folder.path(), command);
        assert!(line.contains("frame_00000.png") && line.contains("taken on a ride"), "{command}: {line}");
    }
    assert_eq!(fs::read_dir(folder.path()).expect("it is there").count(), 1, "only the pictures are there");
}

/// At a proper acceleration a the horizon is 1/a behind the rider.
#[test]
fn eyes_that_reach_to_the_horizon_of_a_ride_are_refused() {
    let folder = folder();
    let ride = format!("render {RIDE} --frames 1 --out ride --ride 1@2:-4:4 --d");
    run_gamow(folder.path(), &format!("{ride} 0.33"));
    let line = complaint_of(folder.path(), &format!("{ride} 0.34"));
    assert!(line.contains("--ride") && line.contains("of 6") && line.contains("0.333"), "{line}");
}
