//! Rays against bodies of each kind.

use super::body::{Body, Capsule, Group, Ray, Surface};
use super::{block, cylinder, ring, tube};
use crate::kind::Kind;
use crate::lanes::{Simd, V3};

/// Returns the surface of a body where rays meet it.
///
/// Each kind's test is there once, and called.
#[inline(always)]
pub fn surface<S: Simd>(simd: S, kind: Kind, group: &Group, body: &Body<S>, ray: &Ray<S>) -> Surface<S> {
    match kind {
        Kind::Tube => simd.vectorize(
            #[inline(always)]
            || tube::surface(body, ray),
        ),
        Kind::Ring => simd.vectorize(
            #[inline(always)]
            || ring::surface(simd, body, ray),
        ),
        Kind::Box | Kind::Model => simd.vectorize(
            #[inline(always)]
            || block::surface(simd, group, body, ray),
        ),
        Kind::Cylinder => simd.vectorize(
            #[inline(always)]
            || cylinder::surface(simd, group, body, ray),
        ),
    }
}

/// A body's middle, from that of its group.
#[inline(always)]
pub fn middle<S: Simd>(kind: Kind, body: &Body<S>) -> V3<S> {
    match kind {
        Kind::Tube => tube::middle(body),
        Kind::Ring => ring::middle(body),
        Kind::Box | Kind::Cylinder | Kind::Model => block::middle(body),
    }
}

/// Returns a capsule that contains a body.
#[inline(always)]
pub fn around<S: Simd>(kind: Kind, body: &Body<S>) -> Capsule<S> {
    match kind {
        Kind::Tube => tube::around(body),
        Kind::Ring => ring::around(body),
        Kind::Box | Kind::Cylinder | Kind::Model => block::around(body),
    }
}
