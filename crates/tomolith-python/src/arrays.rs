//! numpy arrays ↔ images and volumes.

use crate::work::{raised, refused};
use numpy::{PyArray1, PyArray3, PyArrayMethods, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};
use tomolith::Error;
use tomolith::grid::{PatternGrid, Patterns, Volume};

/// numpy's letters of what is a real number: booleans, whole numbers with and without sign, floating-point numbers.
const NUMBERS: [&str; 4] = ["b", "i", "u", "f"];
/// What the axes of an array are.
pub(crate) const IMAGES: &str = "[frame, row, column]";
pub(crate) const VOXELS: &str = "[z, y, x]";

/// The type of every array that is given: float32, converted where it holds other real numbers.
fn float32<'py>(what: &str, array: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let numpy = array.py().import("numpy")?;
    let is_masked = numpy
        .getattr("ma")?
        .call_method1("isMaskedArray", (array,))?;
    if is_masked.is_truthy()? {
        let accepted = "numbers everywhere, for example array.filled(0)";
        return Err(refused(what, "a masked array", accepted));
    }
    let no_numbers = |e: PyErr| {
        let found = e.value(array.py()).to_string();
        raised(Error::config(what, found, "numbers"))
    };
    // Without a conversion: a date is no number, and of a complex one a half would be lost
    let given = numpy
        .call_method1("asarray", (array,))
        .map_err(no_numbers)?;
    let dtype = given.getattr("dtype")?;
    let kind: String = dtype.getattr("kind")?.extract()?;
    if !NUMBERS.contains(&kind.as_str()) {
        let accepted = "numbers that are real, such as float32";
        return Err(refused(what, dtype, accepted));
    }
    // What overflows becomes infinite, and is refused by its place
    let converted = numpy.call_method1("ascontiguousarray", (given, numpy.getattr("float32")?));
    converted.map_err(no_numbers)
}

/// Arrays of these shapes, with finite numbers: a list of them, or the array where there is one shape.
pub(crate) fn arrays(
    what: &str,
    axes: &str,
    given: &Bound<'_, PyAny>,
    shapes: &[[usize; 3]],
) -> PyResult<Vec<Vec<f32>>> {
    let is_list = given.is_instance_of::<PyList>() || given.is_instance_of::<PyTuple>();
    let each = match (is_list, shapes) {
        // A nested list of numbers is one array
        (true, [_]) if given.len()? != 1 => vec![given.clone()],
        (true, _) => given.try_iter()?.collect::<PyResult<Vec<_>>>()?,
        (false, _) => vec![given.clone()],
    };
    if each.len() != shapes.len() {
        let (found, accepted) = (each.len(), shapes.len());
        let accepted = format!("a list of {accepted}, each {axes}");
        return Err(refused(what, format!("{found} array(s)"), accepted));
    }
    let values = |(array, shape): (&Bound<'_, PyAny>, &[usize; 3])| {
        let array = float32(what, array)?;
        let same = |array: &PyReadonlyArray3<'_, f32>| array.shape() == shape;
        let Some(array) = array.extract().ok().filter(same) else {
            let found: Vec<usize> = array.getattr("shape")?.extract()?;
            let found = format!("shape {found:?}");
            return Err(refused(what, found, format!("{shape:?} {axes}")));
        };
        let values = array.as_slice()?.to_vec();
        must_be(
            what,
            axes,
            &values,
            *shape,
            |v| v.is_finite(),
            "finite numbers",
        )?;
        Ok(values)
    };
    each.iter().zip(shapes).map(values).collect()
}

/// Images of every light, which are light: nothing negative.
pub(crate) fn patterns<'a>(
    given: &Bound<'_, PyAny>,
    grids: impl Iterator<Item = &'a PatternGrid>,
) -> PyResult<Vec<Patterns>> {
    let grids: Vec<&PatternGrid> = grids.collect();
    let shapes: Vec<[usize; 3]> = grids.iter().map(|grid| grid.shape()).collect();
    let values = arrays("patterns", IMAGES, given, &shapes)?;
    let patterns = grids
        .into_iter()
        .zip(values)
        .map(|(grid, values)| Patterns {
            grid: grid.clone(),
            values,
        });
    let patterns: Vec<Patterns> = patterns.collect();
    must_be_light(&patterns)?;
    Ok(patterns)
}

/// Refuses images that no projector shows.
pub(crate) fn must_be_light(patterns: &[Patterns]) -> PyResult<()> {
    patterns.iter().try_for_each(|p| {
        let is_light = |v: f32| v.is_finite() && v >= 0.0;
        must_be(
            "patterns",
            IMAGES,
            &p.values,
            p.grid.shape(),
            is_light,
            "finite values ≥ 0",
        )
    })
}

fn must_be(
    what: &str,
    axes: &str,
    values: &[f32],
    [_, rows, columns]: [usize; 3],
    fits: impl Fn(f32) -> bool,
    accepted: &str,
) -> PyResult<()> {
    let Some(i) = values.iter().position(|&value| !fits(value)) else {
        return Ok(());
    };
    let at = [i / (rows * columns), i / columns % rows, i % columns];
    let found = format!("{} at {at:?} {axes}", values[i]);
    Err(refused(what, found, accepted))
}

/// `[z, y, x]`
pub(crate) fn of_volume<'py, T: numpy::Element + Copy>(
    py: Python<'py>,
    volume: Volume<T>,
) -> PyResult<Bound<'py, PyArray3<T>>> {
    PyArray1::from_vec(py, volume.values).reshape(volume.grid.shape)
}

/// `[frame, row, column]`
pub(crate) fn of_patterns<'py>(
    py: Python<'py>,
    patterns: Patterns,
) -> PyResult<Bound<'py, PyArray3<f32>>> {
    PyArray1::from_vec(py, patterns.values).reshape(patterns.grid.shape())
}

/// The array where there is one, or the list of them.
pub(crate) fn one_or_list<'py, T: numpy::Element>(
    py: Python<'py>,
    arrays: impl Iterator<Item = PyResult<Bound<'py, PyArray3<T>>>>,
) -> PyResult<Bound<'py, PyAny>> {
    let mut arrays = arrays.collect::<PyResult<Vec<_>>>()?;
    match arrays.len() {
        1 => Ok(arrays.remove(0).into_any()),
        _ => Ok(PyList::new(py, arrays)?.into_any()),
    }
}

/// An array, or a list of them, that is a copy of what the library holds: a change would be lost, so it is refused.
pub(crate) fn read_only(arrays: Bound<'_, PyAny>) -> PyResult<Bound<'_, PyAny>> {
    let flags = PyDict::new(arrays.py());
    flags.set_item("write", false)?;
    let seal = |array: &Bound<'_, PyAny>| array.call_method("setflags", (), Some(&flags)).map(drop);
    match arrays.cast::<PyList>() {
        Ok(list) => list.iter().try_for_each(|array| seal(&array))?,
        Err(_) => seal(&arrays)?,
    }
    Ok(arrays)
}

/// Refuses what was computed where numbers have become too large for float32.
pub(crate) fn must_be_finite(what: &str, values: &[f32]) -> PyResult<()> {
    match values.iter().find(|v| !v.is_finite()) {
        None => Ok(()),
        Some(found) => Err(refused(
            what,
            format!("{found} in the result"),
            "numbers whose result fits float32 (below 3.4e38)",
        )),
    }
}
