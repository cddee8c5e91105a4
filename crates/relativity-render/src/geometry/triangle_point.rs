//! A point of a model: the number of its triangle, and the weights of the corners there.

/// A point of a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrianglePoint {
    /// Number of the triangle in its model.
    pub triangle: u32,
    /// Barycentric coordinates of the point: the weights of the triangle's second and third corner.
    pub weights: [f32; 2],
}
