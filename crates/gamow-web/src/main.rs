//! The entry of the page: shows the window in a browser, and elsewhere prints that it needs one.

#[cfg(target_arch = "wasm32")]
fn main() {
    gamow::app::shell::web::start();
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    println!(
        "gamow-web runs in a browser: `web/build` makes the page, see docs/web.md. `cargo run --release` is the program of a desktop."
    );
}
