//! Films in MP4 files: their boxes, and their frames as ffmpeg decodes them, which shares no code with this.

use std::path::Path;
use std::process::Command;

use super::{folder, output, render};

/// Frames of the film: two whole groups and a part of one.
const FRAMES: usize = 26;
/// Frames of a group.
const GROUP: usize = 12;
/// The film: something moves in all frames, and sides have odd numbers of pixels.
const FLAGS: &str = "--frames 26 --from -2 --to 2 --size 161x121 --renderer packets --out";

/// The boxes in `bytes`: the kind of each, and what is in it.
fn boxes(mut bytes: &[u8]) -> Vec<(String, &[u8])> {
    let mut all = Vec::new();
    while !bytes.is_empty() {
        let number = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().expect("4 bytes")) as usize;
        let (head, length) = if number(0) == 1 { (16, number(8) << 32 | number(12)) } else { (8, number(0)) };
        let kind = String::from_utf8(bytes[4..8].to_vec()).expect("a kind");
        all.push((kind, &bytes[head..length]));
        bytes = &bytes[length..];
    }
    all
}

/// The inside of the box at the end of this path of kinds.
fn inside<'a>(bytes: &'a [u8], path: &[&str]) -> &'a [u8] {
    path.iter().fold(bytes, |bytes, kind| {
        let found = boxes(bytes).into_iter().find(|(name, _)| name == kind);
        found.unwrap_or_else(|| panic!("no {kind}")).1
    })
}

/// The numbers in a box.
fn numbers(bytes: &[u8]) -> Vec<usize> {
    bytes.as_chunks::<4>().0.iter().map(|part| u32::from_be_bytes(*part) as usize).collect()
}

#[test]
fn the_boxes_of_an_mp4_name_each_frame_before_the_first() {
    let folder = folder();
    let said = String::from_utf8(output(folder.path(), &format!("{FLAGS} ride.mp4")).stderr).expect("text");
    let file = std::fs::read(folder.path().join("ride.mp4")).expect("it is there");
    assert!(
        said.contains("26 frames, 161x121 per eye: about ") && said.contains("estimated from the first "),
        "{said}"
    );
    let kinds: Vec<_> = boxes(&file).into_iter().map(|(kind, _)| kind).collect();
    assert_eq!(kinds, ["ftyp", "moov", "mdat"]);
    let data = inside(&file, &["mdat"]);
    let media = inside(&file, &["moov", "trak", "mdia"]);
    let table = |kind| numbers(inside(media, &["minf", "stbl", kind]));
    let clock = numbers(inside(media, &["mdhd"]));
    assert_eq!(table("stts")[1..], [1, FRAMES, clock[3] / 25]);
    assert_eq!(clock[4], FRAMES * clock[3] / 25);
    assert_eq!(table("stss")[1..], [3, 1, 1 + GROUP, 1 + 2 * GROUP]);
    assert_eq!(table("stco")[1..], [1, file.len() - data.len()]);
    assert_eq!(table("stsc")[1..], [1, 1, FRAMES, 1]);
    let sizes = &table("stsz")[3..];
    assert_eq!((sizes.len(), sizes.iter().sum::<usize>()), (FRAMES, data.len()));
    let mut rest = data;
    for (number, &size) in sizes.iter().enumerate() {
        let (frame, after) = rest.split_at(size);
        assert_eq!(numbers(&frame[..4]), [size - 4], "one slice, after its length");
        assert_eq!(frame[4] & 31, if number % GROUP == 0 { 5 } else { 1 }, "frame {number}");
        rest = after;
    }
}

/// What `program` prints of the film `ride.mp4` in `folder`.
fn printed(folder: &Path, program: &str, arguments: &str) -> Vec<u8> {
    let output = Command::new(program).current_dir(folder).args(arguments.split_whitespace()).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}"));
    assert!(
        output.status.success() && output.stderr.is_empty(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    output.stdout
}

/// The same in a size that is even, of this many pixels.
const EVEN: &str = "--frames 26 --from -2 --to 2 --size 160x120 --renderer packets --out";
const PIXELS: usize = 322 * 132;

/// The description of that film by ffprobe.
const DESCRIPTION: &str = "\
codec_name=h264 profile=High width=322 height=132 has_b_frames=0 color_range=tv color_space=bt709 \
color_transfer=iec61966-2-1 color_primaries=bt709 chroma_location=center r_frame_rate=25/1 duration=1.040000 \
nb_frames=26";

/// Each plane of each frame agrees with the picture to 40 dB (PSNR), and to half a level of 255 on average.
#[test]
#[ignore = "takes ffmpeg: cargo test --test program -- --ignored"]
fn ffmpeg_decodes_the_frames_that_were_drawn() {
    let folder = folder();
    for out in ["ride", "ride.mp4"] {
        render(folder.path(), &format!("{EVEN} {out}"));
    }
    let names: Vec<_> = DESCRIPTION.split_whitespace().filter_map(|entry| entry.split('=').next()).collect();
    let entries = format!("-v error -of default=nw=1 -show_entries stream={} ride.mp4", names.join(","));
    let description = String::from_utf8(printed(folder.path(), "ffprobe", &entries)).expect("text");
    assert_eq!(description.split_whitespace().collect::<Vec<_>>().join(" "), DESCRIPTION);

    let planes = |input| {
        let arguments = format!("-v warning -i {input} -f rawvideo -pix_fmt yuv420p -");
        printed(folder.path(), "ffmpeg", &arguments)
    };
    let film = planes("ride.mp4");
    let drawn = planes("ride/frame_%05d.png -vf scale=out_color_matrix=bt709:out_range=tv:flags=area");
    assert_eq!((film.len(), drawn.len()), (PIXELS * 3 / 2 * FRAMES, film.len()));
    for (number, (film, drawn)) in film.chunks(PIXELS * 3 / 2).zip(drawn.chunks(PIXELS * 3 / 2)).enumerate() {
        for plane in [0..PIXELS, PIXELS..PIXELS * 5 / 4, PIXELS * 5 / 4..PIXELS * 3 / 2] {
            let pairs = film[plane.clone()].iter().zip(&drawn[plane.clone()]);
            let off: Vec<_> = pairs.map(|(film, drawn)| f64::from(*film) - f64::from(*drawn)).collect();
            let mean = off.iter().sum::<f64>() / off.len() as f64;
            let square = off.iter().map(|off| off * off).sum::<f64>() / off.len() as f64;
            let decibels = 10.0 * (255.0_f64.powi(2) / square).log10();
            assert!(decibels > 40.0 && mean.abs() < 0.5, "{number}, {plane:?}: {decibels:.1} dB, {mean:.2}");
        }
    }
}
