//! The numbers of a glTF file, checked before they are read: the reader behind them takes their types and
//! places for granted.

use gltf::Accessor;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::View;

/// The numbers that a part of a model needs.
pub struct Needed {
    types: &'static [DataType],
    dimensions: &'static [Dimensions],
    /// These types and dimensions in words, for an error.
    words: &'static str,
}

/// The numbers of corners' places.
pub const PLACES: Needed = Needed {
    types: &[DataType::F32],
    dimensions: &[Dimensions::Vec3],
    words: "VEC3 of floats, as places are",
};
/// The numbers of corners' colours.
pub const COLOURS: Needed = Needed {
    types: &[DataType::U8, DataType::U16, DataType::F32],
    dimensions: &[Dimensions::Vec3, Dimensions::Vec4],
    words: "VEC3 or VEC4 of bytes, unsigned shorts or floats, as colours are",
};
/// The numbers of corners' places in a texture.
pub const TEXTURE_PLACES: Needed = Needed {
    types: &[DataType::U8, DataType::U16, DataType::F32],
    dimensions: &[Dimensions::Vec2],
    words: "VEC2 of bytes, unsigned shorts or floats, as places in a texture are",
};
/// The numbers by which triangles name their corners.
pub const INDICES: Needed = Needed {
    types: &[DataType::U8, DataType::U16, DataType::U32],
    dimensions: &[Dimensions::Scalar],
    words: "SCALAR of whole numbers, as triangles need",
};

/// Checks that `accessor` has what is `needed`, and has all of it in these buffers.
pub fn check(accessor: &Accessor<'_>, needed: &Needed, buffers: &[Vec<u8>]) -> Result<(), String> {
    let number = accessor.index();
    if accessor.sparse().is_some() {
        return Err(format!("accessor {number} is sparse, which is not known here"));
    }
    if !needed.types.contains(&accessor.data_type()) || !needed.dimensions.contains(&accessor.dimensions()) {
        return Err(format!("accessor {number} must be {}", needed.words));
    }
    let view = accessor.view().ok_or_else(|| format!("accessor {number} has no data"))?;
    let size = accessor.size();
    let stride = view.stride().unwrap_or(size);
    if stride < size {
        return Err(format!("accessor {number} has elements of {size} bytes, one every {stride}"));
    }
    let is_there = || {
        data_of(&view, buffers)?;
        let end = accessor.count().checked_sub(1)?.checked_mul(stride)?.checked_add(size)?;
        let end = accessor.offset().checked_add(end)?;
        (end <= view.length()).then_some(())
    };
    is_there().ok_or_else(|| format!("accessor {number} reaches beyond its data"))
}

/// Returns the bytes of a view, if all of them are there.
pub fn data_of<'a>(view: &View<'_>, buffers: &'a [Vec<u8>]) -> Option<&'a [u8]> {
    let end = view.offset().checked_add(view.length())?;
    buffers.get(view.buffer().index())?.get(view.offset()..end)
}
