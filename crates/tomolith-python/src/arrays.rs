//! numpy arrays ↔ fields, volumes and patterns.

use crate::work::TomolithError;
use numpy::{
    PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray3, PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use tomolith::field::HostField;
use tomolith::grid::{PatternGrid, Patterns, Volume};

/// numpy's letters of what is a real number: booleans, whole numbers with and without sign, floating-point numbers.
const NUMBERS: [&str; 4] = ["b", "i", "u", "f"];

/// The type of every array that is given: float32, converted where it holds other real numbers.
pub(crate) fn float32<'py>(array: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let numpy = array.py().import("numpy")?;
    let is_masked = numpy
        .getattr("ma")?
        .call_method1("isMaskedArray", (array,))?;
    if is_masked.is_truthy()? {
        return Err(TomolithError::new_err(
            "array: found a masked array; accepted: numbers everywhere, for example array.filled(0)",
        ));
    }
    // Without a conversion: a date is no number, and of a complex one a half would be lost
    let dtype = numpy.call_method1("asarray", (array,))?.getattr("dtype")?;
    let kind: String = dtype.getattr("kind")?.extract()?;
    if !NUMBERS.contains(&kind.as_str()) {
        return Err(TomolithError::new_err(format!(
            "array: found {dtype}; accepted: numbers that are real, such as float32"
        )));
    }
    let converted = numpy.call_method1("ascontiguousarray", (array, numpy.getattr("float32")?));
    converted.map_err(|e| {
        let found = e.value(array.py()).to_string();
        TomolithError::new_err(format!("array: {found}; accepted: numbers"))
    })
}

/// A field of `len` elements.
pub(crate) fn field(what: &str, array: &Bound<'_, PyAny>, len: usize) -> PyResult<HostField> {
    let array = float32(array)?;
    let Ok(array) = array.extract::<PyReadonlyArray1<'_, f32>>() else {
        return Err(TomolithError::new_err(format!(
            "{what}: found an array of several axes; accepted: one axis of {len} elements"
        )));
    };
    if array.len() != len {
        return Err(TomolithError::new_err(format!(
            "{what}: found {} elements; accepted: {len}",
            array.len()
        )));
    }
    must_be_finite(what, array.as_slice()?, "finite numbers")?;
    let mut field = HostField::zeros(len);
    field.as_mut_slice().copy_from_slice(array.as_slice()?);
    Ok(field)
}

/// What was computed; refused where numbers have become too large for float32.
pub(crate) fn of_field<'py>(
    py: Python<'py>,
    what: &str,
    field: &HostField,
) -> PyResult<Bound<'py, PyArray1<f32>>> {
    must_be_finite(what, field.as_slice(), "patterns whose doses are numbers")?;
    Ok(PyArray1::from_slice(py, field.as_slice()))
}

fn must_be_finite(what: &str, values: &[f32], accepted: &str) -> PyResult<()> {
    match values.iter().position(|v| !v.is_finite()) {
        None => Ok(()),
        Some(i) => Err(TomolithError::new_err(format!(
            "{what}: found {} at element {i}; accepted: {accepted}",
            values[i]
        ))),
    }
}

/// `[z, y, x]`
pub(crate) fn of_volume<'py, T: numpy::Element + Copy>(
    py: Python<'py>,
    volume: &Volume<T>,
) -> PyResult<Bound<'py, PyArray3<T>>> {
    PyArray1::from_slice(py, &volume.values).reshape(volume.grid.shape)
}

/// `[frame, row, column]`
pub(crate) fn of_patterns<'py>(
    py: Python<'py>,
    patterns: &Patterns,
) -> PyResult<Bound<'py, PyArray3<f32>>> {
    PyArray1::from_slice(py, &patterns.values).reshape(patterns.grid.shape())
}

/// Images of every light: a list of arrays, or the array of a single light.
pub(crate) fn patterns<'a>(
    given: &Bound<'_, PyAny>,
    grids: impl ExactSizeIterator<Item = &'a PatternGrid>,
) -> PyResult<Vec<Patterns>> {
    let one_each = match given.try_iter() {
        Ok(each)
            if given.is_instance_of::<pyo3::types::PyList>()
                || given.is_instance_of::<pyo3::types::PyTuple>() =>
        {
            each.collect::<PyResult<Vec<_>>>()?
        }
        _ => vec![given.clone()],
    };
    if one_each.len() != grids.len() {
        return Err(TomolithError::new_err(format!(
            "patterns: found {} arrays; accepted: {}, one for each light",
            one_each.len(),
            grids.len()
        )));
    }
    let of_light = |(array, grid): (&Bound<'_, PyAny>, &PatternGrid)| {
        let array = float32(array)?;
        let shape = grid.shape();
        let same = |array: &PyReadonlyArray3<'_, f32>| array.shape() == shape;
        let Some(array) = array.extract().ok().filter(same) else {
            let found: Vec<usize> = array.getattr("shape")?.extract()?;
            return Err(TomolithError::new_err(format!(
                "patterns: found shape {found:?}; accepted: {shape:?} [frame, row, column]"
            )));
        };
        let is_light = |value: &f32| value.is_finite() && *value >= 0.0;
        if let Some(i) = array.as_slice()?.iter().position(|value| !is_light(value)) {
            let [_, rows, columns] = shape;
            let at = [i / (rows * columns), i / columns % rows, i % columns];
            let found = array.as_slice()?[i];
            return Err(TomolithError::new_err(format!(
                "patterns: found {found} at {at:?} [frame, row, column]; accepted: finite values ≥ 0"
            )));
        }
        Ok(Patterns {
            grid: grid.clone(),
            values: array.as_slice()?.to_vec(),
        })
    };
    one_each.iter().zip(grids).map(of_light).collect()
}
