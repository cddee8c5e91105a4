//! Apertures: eyes and pinholes.

/// An aperture (an eye, a pinhole) at rest on the ground.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Aperture {
    /// Place along the direction of motion.
    pub x: f64,
    /// Depth (y) of the aperture.
    pub y: f64,
    /// Height (z) of the aperture.
    pub z: f64,
}

impl Aperture {
    /// The paper's pair, `separation` apart on the x axis: left (primary), right (secondary).
    #[must_use]
    pub const fn pair(separation: f64) -> [Self; 2] {
        let half = separation / 2.0;
        [Self { x: -half, y: 0.0, z: 0.0 }, Self { x: half, y: 0.0, z: 0.0 }]
    }
}
