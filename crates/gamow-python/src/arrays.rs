//! NumPy arrays as columns, in and out.

use gamow::columns::Column;
use numpy::{
    PyArrayDyn, PyArrayMethods as _, PyReadonlyArrayDyn, PyReadwriteArrayDyn, PyUntypedArrayMethods as _,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors::value_error;

/// Arrays of numbers by name, broadcast to one shape.
pub struct Columns<'py> {
    /// Names of the columns, in the order in which they were given.
    pub names: Vec<String>,
    /// Contents that are borrowed where they are 64-bit floats beside each other, else copied.
    arrays: Vec<PyReadonlyArrayDyn<'py, f64>>,
    /// The shape to which all columns are broadcast.
    pub shape: Vec<usize>,
}

impl<'py> Columns<'py> {
    /// The columns in `given`; those that are `None` are left out.
    ///
    /// # Errors
    ///
    /// What is no array of numbers, and shapes that cannot be broadcast together.
    pub fn new(given: &Bound<'py, PyDict>) -> PyResult<Self> {
        let numpy = given.py().import("numpy")?;
        let (mut names, mut plain) = (Vec::new(), Vec::new());
        for (name, value) in given {
            if !value.is_none() {
                let name: String = name.extract()?;
                plain.push(floats(&numpy, &name, &value)?);
                names.push(name);
            }
        }
        let shape = common_shape(&names, &plain)?;
        let whole = |array: Bound<'py, PyArrayDyn<f64>>| {
            if array.len() == 1 || array.shape() == shape && array.is_c_contiguous() {
                return Ok(array.try_readonly()?);
            }
            let wide = numpy.call_method1("broadcast_to", (array, shape.clone()))?;
            let copy = numpy.call_method1("ascontiguousarray", (wide,))?;
            Ok(copy.cast_into::<PyArrayDyn<f64>>()?.try_readonly()?)
        };
        let arrays = plain.into_iter().map(whole).collect::<PyResult<_>>()?;
        Ok(Self { names, arrays, shape })
    }

    /// Returns the number of rows.
    pub fn rows(&self) -> usize {
        self.shape.iter().product()
    }

    /// The columns as inputs of a batch.
    pub fn inputs(&self) -> PyResult<Vec<Column<'_, f64>>> {
        let rows = self.rows();
        let inputs = self.arrays.iter().map(|array| match array.get(vec![0; array.ndim()]) {
            Some(&value) if array.len() == 1 && rows != 1 => Ok(Column::Same(value)),
            _ => Ok(Column::Each(array.as_slice()?)),
        });
        inputs.collect()
    }

    /// The place of a row in the shape, as in `[2, 0]: `; nothing of a single number.
    pub fn place(&self, row: usize) -> String {
        let mut left = row;
        let mut indices: Vec<_> = self
            .shape
            .iter()
            .rev()
            .map(|&side| {
                let index = left % side;
                left /= side;
                index.to_string()
            })
            .collect();
        indices.reverse();
        if indices.is_empty() { String::new() } else { format!("[{}]: ", indices.join(", ")) }
    }
}

/// `value` as an array of 64-bit floats, without a copy if it is one.
fn floats<'py>(
    numpy: &Bound<'py, PyModule>,
    name: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    if let Ok(array) = value.cast::<PyArrayDyn<f64>>() {
        return Ok(array.clone());
    }
    let wrong = |found: &str| PyTypeError::new_err(format!("{name}: numbers are needed, not {found}"));
    let array = numpy.call_method1("asarray", (value,)).map_err(|error| {
        let is_unequal = error.is_instance_of::<PyValueError>(numpy.py());
        if is_unequal { wrong("a list of unequal lists") } else { error }
    })?;
    let kind: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
    match kind.as_str() {
        "b" | "u" | "i" | "f" => {}
        "c" => return Err(wrong("complex ones")),
        "U" | "S" => return Err(wrong("text")),
        _ => return Err(wrong("objects")),
    }
    let array = array.call_method1("astype", (numpy.getattr("float64")?,))?;
    Ok(array.cast_into::<PyArrayDyn<f64>>()?)
}

/// The shape to which all `arrays` are broadcast, by NumPy's rule: sides are aligned at their ends, and one
/// of 1 goes with any.
fn common_shape(names: &[String], arrays: &[Bound<'_, PyArrayDyn<f64>>]) -> PyResult<Vec<usize>> {
    let mut shape: Vec<usize> = Vec::new(); // from its end
    let mut owners: Vec<usize> = Vec::new();
    for (index, array) in arrays.iter().enumerate() {
        for (axis, &side) in array.shape().iter().rev().enumerate() {
            if axis == shape.len() {
                shape.push(side);
                owners.push(index);
            } else if shape[axis] == 1 && side != 1 {
                shape[axis] = side;
                owners[axis] = index;
            } else if side != 1 && side != shape[axis] {
                let other = owners[axis];
                return Err(value_error(format_args!(
                    "{} has the shape {:?} and {} has {:?}, which cannot be broadcast together",
                    names[other],
                    arrays[other].shape(),
                    names[index],
                    array.shape()
                )));
            }
        }
    }
    shape.reverse();
    if shape
        .iter()
        .try_fold(1_usize, |rows, &side| rows.checked_mul(side))
        .is_none_or(|rows| rows > MOST_ROWS)
    {
        return Err(value_error(format_args!(
            "the columns broadcast to the shape {shape:?}, which has more than {MOST_ROWS} rows, the most of one call"
        )));
    }
    Ok(shape)
}

/// The most rows of one call.
const MOST_ROWS: usize = 1_000_000_000;

/// Returns the arrays for the columns called `names`: those of `given`, or new ones.
///
/// # Errors
///
/// A given array that is missing, read-only, in use, or none of this shape.
pub fn results<'py>(
    py: Python<'py>,
    names: &[&'static str],
    shape: &[usize],
    given: Option<&Bound<'py, PyDict>>,
) -> PyResult<Vec<PyReadwriteArrayDyn<'py, f64>>> {
    let numpy = py.import("numpy")?;
    let result = |&name: &&'static str| {
        let Some(given) = given else {
            let new = numpy.call_method1("empty", (shape.to_vec(),))?;
            return Ok(new.cast_into::<PyArrayDyn<f64>>()?.try_readwrite()?);
        };
        let wrong = |what: &str| value_error(format_args!("out['{name}'] {what}"));
        let array = given.get_item(name)?.ok_or_else(|| wrong("is missing"))?;
        let array = array.cast_into::<PyArrayDyn<f64>>();
        let array = array.map_err(|_| wrong("must be an array of 64-bit floats"))?;
        if array.shape() != shape || !array.is_c_contiguous() {
            return Err(wrong(&format!("must be a contiguous array of the shape {shape:?}")));
        }
        array.try_readwrite().map_err(|_| wrong("is read-only, or is given twice"))
    };
    names.iter().map(result).collect()
}

/// Returns a dictionary of the filled arrays by their names; of their numbers where the shape is that of a
/// scalar.
pub fn dictionary<'py>(
    py: Python<'py>,
    names: &[&'static str],
    arrays: Vec<PyReadwriteArrayDyn<'py, f64>>,
    given: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyDict>> {
    if let Some(given) = given {
        return Ok(given.clone());
    }
    let dictionary = PyDict::new(py);
    for (name, array) in names.iter().zip(arrays) {
        let array: Bound<'py, PyArrayDyn<f64>> = array.as_any().clone().cast_into()?;
        let is_single = array.ndim() == 0;
        let value = if is_single { array.get_item(())? } else { array.into_any() };
        dictionary.set_item(name, value)?;
    }
    Ok(dictionary)
}
