//! The binary data of glTF: numbers of several types, packed or interleaved.

use serde::Deserialize;

/// Component types of accessors, as the specification numbers them.
const U8: u32 = 5121;
const U16: u32 = 5123;
const U32: u32 = 5125;
const F32: u32 = 5126;

/// A description of numbers in a view.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct Accessor {
    buffer_view: Option<usize>,
    #[serde(default)]
    byte_offset: usize,
    component_type: u32,
    count: usize,
    #[serde(rename = "type")]
    kind: String,
    sparse: Option<serde_json::Value>,
}

/// A part of a buffer.
#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
pub struct BufferView {
    buffer: usize,
    #[serde(default)]
    byte_offset: usize,
    byte_length: usize,
    byte_stride: Option<usize>,
}

/// The binary data of a file, and the descriptions of what is in it.
pub struct Data<'a> {
    pub accessors: &'a [Accessor],
    pub views: &'a [BufferView],
    pub buffers: &'a [Vec<u8>],
}

/// Elements, each `stride` bytes after the one before.
struct Elements<'a> {
    bytes: &'a [u8],
    stride: usize,
    count: usize,
    component: u32,
    size: usize,
}

impl Data<'_> {
    /// The vectors of an accessor: their first three numbers, of whole numbers as parts of the greatest.
    pub fn vectors(&self, number: usize) -> Result<Vec<[f64; 3]>, String> {
        let accessor = self.accessor(number)?;
        let parts = match accessor.kind.as_str() {
            "VEC3" => 3,
            "VEC4" => 4,
            _ => return Err(format!("accessor {number} has {} where vectors are needed", accessor.kind)),
        };
        let elements = self.elements(number, parts)?;
        let one = |element: usize| std::array::from_fn(|part| elements.number(element, part));
        Ok((0..elements.count).map(one).collect())
    }

    /// The whole numbers of an accessor.
    pub fn indices(&self, number: usize) -> Result<Vec<u32>, String> {
        let accessor = self.accessor(number)?;
        if accessor.kind != "SCALAR" || accessor.component_type == F32 {
            return Err(format!("accessor {number} has no whole numbers, as corners of triangles need"));
        }
        let elements = self.elements(number, 1)?;
        Ok((0..elements.count).map(|element| elements.whole(element, 0)).collect())
    }

    fn accessor(&self, number: usize) -> Result<&Accessor, String> {
        self.accessors.get(number).ok_or_else(|| format!("there is no accessor {number}"))
    }

    fn elements(&self, number: usize, parts: usize) -> Result<Elements<'_>, String> {
        let accessor = self.accessor(number)?;
        if accessor.sparse.is_some() {
            return Err(format!("accessor {number} is sparse, which is not known here"));
        }
        let component = accessor.component_type;
        let size = match component {
            U8 => 1,
            U16 => 2,
            U32 | F32 => 4,
            _ => {
                return Err(format!(
                    "accessor {number} has numbers of the type {component}, which is not known here"
                ));
            }
        };
        let view = accessor.buffer_view.and_then(|view| self.views.get(view));
        let view = view.ok_or_else(|| format!("accessor {number} has no data"))?;
        let stride = view.byte_stride.unwrap_or(parts * size).max(parts * size);
        let found = || {
            let buffer = self.buffers.get(view.buffer)?;
            let all = buffer.get(view.byte_offset..view.byte_offset.checked_add(view.byte_length)?)?;
            let bytes = all.get(accessor.byte_offset..)?;
            let last = accessor.count.checked_sub(1)?.checked_mul(stride)?.checked_add(parts * size)?;
            (last <= bytes.len()).then_some(bytes)
        };
        let bytes = if accessor.count == 0 { Some(&[][..]) } else { found() };
        let bytes = bytes.ok_or_else(|| format!("accessor {number} reaches beyond its data"))?;
        Ok(Elements { bytes, stride, count: accessor.count, component, size })
    }
}

impl Elements<'_> {
    fn bytes_of(&self, element: usize, part: usize) -> &[u8] {
        let first = element * self.stride + part * self.size;
        &self.bytes[first..first + self.size]
    }

    fn whole(&self, element: usize, part: usize) -> u32 {
        self.bytes_of(element, part).iter().rev().fold(0, |number, &byte| number << 8 | u32::from(byte))
    }

    fn number(&self, element: usize, part: usize) -> f64 {
        let whole = self.whole(element, part);
        match self.component {
            F32 => f64::from(f32::from_bits(whole)),
            U8 => f64::from(whole) / 255.0,
            U16 => f64::from(whole) / 65535.0,
            _ => f64::from(whole),
        }
    }
}
