//! The pages that are written by hand, and their blocks of commands, which are run as they stand.
//!
//! A block ```` ```sh ```` is run; one ```` ```shell ```` needs more than the program: an installation, a
//! browser, a window that somebody closes, or files of one's own.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Greatest mean difference of a picture on a page from what its command draws, levels of 255: that of edges
/// which another renderer, or another driver, draws by other rays.
const MOST_LEVELS: f64 = 1.0;
/// Folders of a page's pictures, below the root.
const PICTURES: [&str; 2] = ["docs/pictures", "assets"];

/// Every page that is written by hand, with its path from the root.
pub fn pages() -> Vec<(PathBuf, String)> {
    let mut paths: Vec<PathBuf> = Vec::new();
    for folder in ["docs", "paper"] {
        let entries = fs::read_dir(root().join(folder)).expect("a folder");
        let files = entries.map(|entry| entry.expect("an entry").path());
        paths.extend(files.filter(|path| path.extension().is_some_and(|extension| extension == "md")));
    }
    let others = [
        "README.md",
        "CONTRIBUTING.md",
        "assets/README.md",
        "assets/lessons/README.md",
        "assets/scenes/README.md",
        "crates/gamow-python/README.md",
        "crates/relativity-core/README.md",
        "crates/relativity-render/README.md",
        "fuzz/README.md",
    ];
    paths.extend(others.map(|name| root().join(name)));
    paths.sort();
    paths.into_iter().map(|path| (path.clone(), fs::read_to_string(path).expect("a page"))).collect()
}

/// The contents of the blocks of `page` in this `language`.
pub fn blocks<'a>(page: &'a str, language: &str) -> impl Iterator<Item = &'a str> + use<'a> {
    let head = format!("```{language}\n");
    let starts: Vec<usize> = page.match_indices(&head).map(|(start, _)| start + head.len()).collect();
    starts.into_iter().map(|start| page[start..].split_once("```").expect("the block ends").0)
}

/// Runs each block ```` ```sh ```` that `is_meant`, and compares the pictures that it makes with those on the
/// pages; how many blocks there are.
pub fn run_blocks(is_meant: impl Fn(&str) -> bool) -> usize {
    let mut count = 0;
    for (path, page) in pages() {
        for block in blocks(&page, "sh").filter(|block| is_meant(block)) {
            run_block(&path, block);
            count += 1;
        }
    }
    count
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn run_block(page: &Path, block: &str) {
    let scratch = tempfile::tempdir().expect("there is a folder for temporary files");
    for folder in PICTURES {
        fs::create_dir_all(scratch.path().join(folder)).expect("a folder");
    }
    let program = Path::new(env!("CARGO_BIN_EXE_gamow")).parent().expect("a program is in a folder");
    let path = env::var_os("PATH").unwrap_or_default();
    let folders = [program.to_owned()].into_iter().chain(env::split_paths(&path));
    let output = Command::new("sh")
        .args(["-e", "-c", block])
        .current_dir(scratch.path())
        .env("PATH", env::join_paths(folders).expect("paths join"))
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .output()
        .expect("the shell starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{}: {block}{said}", page.display());
    for folder in PICTURES {
        for entry in fs::read_dir(scratch.path().join(folder)).expect("a folder") {
            let drawn = entry.expect("an entry").path();
            let shown = root().join(folder).join(drawn.file_name().expect("a file"));
            let levels = mean_difference(&drawn, &shown);
            println!("{}: {levels:.2} levels", shown.display());
            assert!(
                levels < MOST_LEVELS,
                "{} is {levels:.2} levels off: docs/pictures/remake",
                shown.display()
            );
        }
    }
}

/// The mean difference of two PNG pictures of one size.
fn mean_difference(drawn: &Path, shown: &Path) -> f64 {
    let [drawn, shown] = [drawn, shown].map(|path| {
        let file = std::io::BufReader::new(fs::File::open(path).expect("the picture is there"));
        let mut reader = png::Decoder::new(file).read_info().expect("a PNG file");
        let mut pixels = vec![0; reader.output_buffer_size().expect("it fits")];
        let info = reader.next_frame(&mut pixels).expect("a whole PNG file");
        ((info.width, info.height, info.color_type), pixels)
    });
    assert_eq!(drawn.0, shown.0, "size and kind of the pictures");
    let difference: u64 = drawn.1.iter().zip(&shown.1).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    difference as f64 / drawn.1.len() as f64
}
