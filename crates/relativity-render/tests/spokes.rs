//! Spokes of wheels that roll, as packets draw them, against the reference: no pixel shows what is seen
//! nowhere within the stated error.

use std::ops::Range;

use relativity_render::{Method, Renderers};

use crate::support::documented;
use crate::wheels::spokes::wrong_pixels;

const DOCUMENTATION: &str = include_str!("../src/renderers.rs");

fn every_pixel_keeps_the_stated_error(views: Range<u32>) {
    let stated_px = documented(DOCUMENTATION, "Outlines of what turns are within ");
    let (covered, wrong) = wrong_pixels(&mut Renderers::new(None), Method::Packets, stated_px, views);
    println!("{} of {covered} pixels are wrong", wrong.len());
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(covered > 10_000, "{covered} pixels show something");
}

#[test]
fn what_a_pixel_shows_is_seen_within_the_stated_error() {
    every_pixel_keeps_the_stated_error(0..40);
}

#[test]
#[ignore = "takes a minute: cargo test -p relativity-render --test cpu -- spokes --ignored --nocapture"]
fn so_it_is_in_a_thousand_views() {
    every_pixel_keeps_the_stated_error(0..1000);
}
