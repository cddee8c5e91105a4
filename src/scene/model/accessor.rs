//! The numbers of a glTF file, checked before they are read: the reader behind them takes their types and
//! places for granted.

use gltf::accessor::sparse::IndexType;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::View;
use gltf::{Accessor, Document};

use super::limits::check_count;

/// The numbers that a part of a model needs.
pub struct Needed {
    types: &'static [DataType],
    dimensions: &'static [Dimensions],
    /// These types and dimensions in words, for an error.
    words: &'static str,
}

/// Types of the components of places and turns, which may be below 0.
const WHOLE: &[DataType] = &[DataType::I8, DataType::U8, DataType::I16, DataType::U16, DataType::F32];
/// Types of the components of colours and weights, from 0 to 1.
const PARTS: &[DataType] = &[DataType::U8, DataType::U16, DataType::F32];

/// The numbers of corners' places.
pub const PLACES: Needed =
    Needed { types: WHOLE, dimensions: &[Dimensions::Vec3], words: "VEC3 of numbers, as places are" };
/// The numbers of turns, as quaternions.
pub const TURNS: Needed =
    Needed { types: WHOLE, dimensions: &[Dimensions::Vec4], words: "VEC4 of numbers, as turns are" };
/// The numbers of corners' joints.
pub const JOINTS: Needed = Needed {
    types: &[DataType::U8, DataType::U16],
    dimensions: &[Dimensions::Vec4],
    words: "VEC4 of bytes or unsigned shorts, as joints are",
};
/// The numbers of corners' weights.
pub const WEIGHTS: Needed = Needed {
    types: PARTS,
    dimensions: &[Dimensions::Vec4],
    words: "VEC4 of bytes, unsigned shorts or floats, as weights are",
};
/// The numbers of joints' matrices.
pub const MATRICES: Needed = Needed {
    types: &[DataType::F32],
    dimensions: &[Dimensions::Mat4],
    words: "MAT4 of floats, as matrices of joints are",
};
/// The numbers of corners' colours.
pub const COLOURS: Needed = Needed {
    types: PARTS,
    dimensions: &[Dimensions::Vec3, Dimensions::Vec4],
    words: "VEC3 or VEC4 of bytes, unsigned shorts or floats, as colours are",
};
/// The numbers of corners' places in a texture.
pub const TEXTURE_PLACES: Needed = Needed {
    types: WHOLE,
    dimensions: &[Dimensions::Vec2],
    words: "VEC2 of numbers, as places in a texture are",
};
/// The numbers by which triangles name their corners.
pub const INDICES: Needed = Needed {
    types: &[DataType::U8, DataType::U16, DataType::U32],
    dimensions: &[Dimensions::Scalar],
    words: "SCALAR of whole numbers, as triangles need",
};

/// Checks that `accessor` has what is `needed`, and has all of it in these buffers.
fn check(accessor: &Accessor<'_>, needed: &Needed, buffers: &[Vec<u8>]) -> Result<(), String> {
    let number = accessor.index();
    if !needed.types.contains(&accessor.data_type()) || !needed.dimensions.contains(&accessor.dimensions()) {
        return Err(format!("accessor {number} must be {}", needed.words));
    }
    let (size, count) = (accessor.size(), accessor.count());
    let beyond = || format!("accessor {number} reaches beyond its data");
    if let Some(sparse) = accessor.sparse() {
        // Without data it has as many zeros as it says.
        check_count(count)?;
        let (numbers, values) = (sparse.indices(), sparse.values());
        let width = numbers.index_type().size();
        let are_there = sparse.count() <= count
            && elements(&numbers.view(), numbers.offset(), sparse.count(), width, buffers).is_some()
            && elements(&values.view(), values.offset(), sparse.count(), size, buffers).is_some();
        return if are_there && accessor.view().is_none_or(|view| has_all(accessor, &view, buffers)) {
            Ok(())
        } else {
            Err(beyond())
        };
    }
    let view = accessor.view().ok_or_else(|| format!("accessor {number} has no data"))?;
    let stride = view.stride().unwrap_or(size);
    if stride < size {
        return Err(format!("accessor {number} has elements of {size} bytes, one every {stride}"));
    }
    if has_all(accessor, &view, buffers) { Ok(()) } else { Err(beyond()) }
}

/// Whether all elements of `accessor` are in its `view`.
fn has_all(accessor: &Accessor<'_>, view: &View<'_>, buffers: &[Vec<u8>]) -> bool {
    elements(view, accessor.offset(), accessor.count(), accessor.size(), buffers).is_some()
}

/// Returns the elements in a `view` from this offset on, each of `size` bytes, if all of them are there.
fn elements<'a>(
    view: &View<'_>,
    offset: usize,
    count: usize,
    size: usize,
    buffers: &'a [Vec<u8>],
) -> Option<impl Iterator<Item = &'a [u8]> + use<'a>> {
    let stride = view.stride().unwrap_or(size).max(1);
    let length = count.checked_sub(1)?.checked_mul(stride)?.checked_add(size)?;
    let bytes = data_of(view, buffers)?.get(offset..offset.checked_add(length)?)?;
    (stride >= size).then(|| bytes.chunks(stride))
}

/// Returns the accessor of this number.
pub fn accessor(document: &Document, number: usize) -> Result<Accessor<'_>, String> {
    document.accessors().nth(number).ok_or_else(|| format!("there is no accessor {number}"))
}

/// Reads the first `N` numbers of each element of `accessor`, which must have what is `needed`. Those in
/// bytes and shorts are parts of the whole if the accessor says so, or if they all are (`is_part`).
pub fn read<const N: usize>(
    accessor: &Accessor<'_>,
    needed: &Needed,
    buffers: &[Vec<u8>],
    is_part: bool,
) -> Result<Vec<[f32; N]>, String> {
    let (kind, is_part) = (accessor.data_type(), is_part || accessor.normalized());
    if kind == DataType::F32 {
        // What nearly all are: without a choice of the type for each number.
        return read_each(accessor, needed, buffers, |element| {
            let (parts, _) = element.as_chunks();
            std::array::from_fn(|part| parts.get(part).copied().map_or(0.0, f32::from_le_bytes))
        });
    }
    let number = |element: &[u8], part: usize| {
        let at = part * kind.size();
        let number = element.get(at..at + kind.size()).map_or(0.0, |bytes| number(bytes, kind));
        if is_part { as_part(number as f32, kind) } else { number as f32 }
    };
    read_each(accessor, needed, buffers, |element| std::array::from_fn(|part| number(element, part)))
}

/// Reads the numbers by which triangles name their corners.
pub fn read_indices(accessor: &Accessor<'_>, buffers: &[Vec<u8>]) -> Result<Vec<u32>, String> {
    let kind = accessor.data_type();
    read_each(accessor, &INDICES, buffers, |element| number(element, kind) as u32)
}

/// Reads each element of `accessor`, which must have what is `needed`: where it is sparse, zeros or those in
/// its data, of which its own take the places of some.
fn read_each<T: Clone>(
    accessor: &Accessor<'_>,
    needed: &Needed,
    buffers: &[Vec<u8>],
    read: impl Fn(&[u8]) -> T,
) -> Result<Vec<T>, String> {
    check(accessor, needed, buffers)?;
    let (size, count) = (accessor.size(), accessor.count());
    let missing = || format!("accessor {} has no data", accessor.index());
    let mut all: Vec<T> = match accessor.view() {
        Some(view) => {
            let elements = elements(&view, accessor.offset(), count, size, buffers);
            elements.ok_or_else(missing)?.map(&read).collect()
        }
        None => vec![read(&vec![0; size]); count],
    };
    let Some(sparse) = accessor.sparse() else { return Ok(all) };
    let (numbers, values) = (sparse.indices(), sparse.values());
    let kind = match numbers.index_type() {
        IndexType::U8 => DataType::U8,
        IndexType::U16 => DataType::U16,
        IndexType::U32 => DataType::U32,
    };
    let places = elements(&numbers.view(), numbers.offset(), sparse.count(), kind.size(), buffers);
    let values = elements(&values.view(), values.offset(), sparse.count(), size, buffers);
    for (place, value) in places.ok_or_else(missing)?.zip(values.ok_or_else(missing)?) {
        let place = number(place, kind) as usize;
        let element = all.get_mut(place);
        *element.ok_or_else(|| {
            format!("accessor {} has no element {place}, which its sparse data name", accessor.index())
        })? = read(value);
    }
    Ok(all)
}

/// Returns the number in the first bytes of an element; every one of these types is an f64.
fn number(bytes: &[u8], kind: DataType) -> f64 {
    match (kind, bytes) {
        (DataType::I8, &[a, ..]) => f64::from(a.cast_signed()),
        (DataType::U8, &[a, ..]) => f64::from(a),
        (DataType::I16, &[a, b, ..]) => f64::from(i16::from_le_bytes([a, b])),
        (DataType::U16, &[a, b, ..]) => f64::from(u16::from_le_bytes([a, b])),
        (DataType::U32, &[a, b, c, d, ..]) => f64::from(u32::from_le_bytes([a, b, c, d])),
        (DataType::F32, &[a, b, c, d, ..]) => f64::from(f32::from_le_bytes([a, b, c, d])),
        _ => 0.0,
    }
}

/// Returns a whole number as a part of the greatest of its kind.
fn as_part(number: f32, kind: DataType) -> f32 {
    match kind {
        DataType::I8 => (number / 127.0).max(-1.0),
        DataType::U8 => number / 255.0,
        DataType::I16 => (number / 32767.0).max(-1.0),
        DataType::U16 => number / 65535.0,
        DataType::U32 | DataType::F32 => number,
    }
}

/// Returns the bytes of a view, if all of them are there.
pub fn data_of<'a>(view: &View<'_>, buffers: &'a [Vec<u8>]) -> Option<&'a [u8]> {
    let end = view.offset().checked_add(view.length())?;
    buffers.get(view.buffer().index())?.get(view.offset()..end)
}
