//! What every dose model must satisfy.
//!
//! Derivative and adjoint are one matrix: ⟨F′d, c⟩ = ⟨d, F′ᵀc⟩, with c half along F′d, so that a wrong scale shows (with an
//! independent c a 20 % scale error passes at 256³); so it is for some frames alone, whose gradient leaves that of all others. Outputs are overwritten whatever they held. Linear models are
//! linear, and the sum over parts of the frames is the whole. Numbers do not depend on the number of threads.
//!
//! ```
//! use tomolith_core::check::{model::model, small::SmallModel};
//! let found = model(&SmallModel::new(9, 12, 3), 1).unwrap();
//! assert!(found.adjoint_error < 1e-5); // relative to ‖F′d‖‖c‖
//! ```

use super::noise;
use crate::dose::{DoseModel, Work, elements_of, frames_of};
use crate::error::Error;
use crate::field::Field;

/// Adjoint errors that were measured.
#[derive(Clone, Copy, Debug)]
pub struct AdjointCheck {
    /// |⟨F′d, c⟩ − ⟨d, F′ᵀc⟩| / (‖F′d‖·‖c‖)
    pub adjoint_error: f64,
    /// ⟨d, F′ᵀc⟩ / ⟨F′d, c⟩: 1 unless the adjoint is off by a factor.
    pub factor: f64,
}

/// Checks a model at a random point; the message of an error says which property failed and by how much.
///
/// # Errors
/// [`Error::Unsupported`] naming the property; the model's own errors.
pub fn model<M: DoseModel + ?Sized>(model: &M, seed: u64) -> Result<AdjointCheck, Error> {
    let work = Work::new();
    let mut x = model.new_patterns()?;
    x.copy_from_host(
        &noise(seed, x.len())
            .iter()
            .map(|v| v.abs())
            .collect::<Vec<_>>(),
    );
    let found = adjoint(model, &x, seed + 1, &work)?;
    overwrites(model, &x, &work)?;
    frames_add_up(model, &x, &work)?;
    adjoint_of_frames(model, &x, seed + 3, &work)?;
    if model.is_linear() {
        linear(model, &x, seed + 2, &work)?;
    }
    same_bits_on_any_thread_count(model, &x, &work)?;
    Ok(found)
}

fn failed(what: impl Into<String>, reason: String) -> Error {
    Error::unsupported(what, reason)
}

/// F′(x)d: by linearity, or by the polynomial's first coefficient.
fn derivative<M: DoseModel + ?Sized>(
    model: &M,
    x: &M::Field,
    d: &M::Field,
    work: &Work,
) -> Result<M::Field, Error> {
    if model.is_linear() {
        let mut out = model.new_dose()?;
        model.dose(d, &mut out, work)?;
        return Ok(out);
    }
    let terms = model.along(x, d, work)?;
    terms
        .and_then(|mut t| (!t.is_empty()).then(|| t.swap_remove(0)))
        .ok_or_else(|| {
            failed(
                "derivative",
                "a model that is neither linear nor polynomial needs a check of its own".into(),
            )
        })
}

fn adjoint<M: DoseModel + ?Sized>(
    model: &M,
    x: &M::Field,
    seed: u64,
    work: &Work,
) -> Result<AdjointCheck, Error> {
    let mut d = model.new_patterns()?;
    d.copy_from_host(&noise(seed, d.len()));
    let fd = derivative(model, x, &d, work)?;
    let norm = fd.norm();
    if norm == 0.0 {
        return Err(failed("derivative", "no light reaches any voxel".into()));
    }
    let mut c = noise_of_dose(model, seed + 1)?;
    c.axpy((1.0 / norm) as f32, &fd);
    let mut back = model.new_patterns()?;
    model.pullback(x, &c, &mut back, work)?;
    let (forward, backward) = (fd.dot(&c), d.dot(&back));
    let found = AdjointCheck {
        adjoint_error: (forward - backward).abs() / (norm * c.norm()),
        factor: backward / forward,
    };
    if found.adjoint_error <= 1e-5 {
        return Ok(found);
    }
    Err(failed(
        "adjoint",
        format!("{found:?}: ⟨F′d, c⟩ = {forward}, ⟨d, F′ᵀc⟩ = {backward}"),
    ))
}

/// Noise of norm 1, only where the model can put dose: padding lanes are no voxels.
fn noise_of_dose<M: DoseModel + ?Sized>(model: &M, seed: u64) -> Result<M::Field, Error> {
    let mut c = model.new_dose()?;
    for layout in model.outputs() {
        let mut volume = crate::grid::Volume::filled(layout.grid.clone(), 0.0f32);
        volume.values = noise(seed, volume.values.len());
        let mut host = c.to_host();
        host[layout.range()].copy_from_slice(&layout.field_of(&volume));
        let cells = layout.offset + layout.voxels()..layout.range().end;
        let values = noise(seed + 1, cells.len());
        host[cells].copy_from_slice(&values);
        c.copy_from_host(&host);
    }
    let scale = (1.0 / c.norm()) as f32;
    c.scale(scale);
    Ok(c)
}

/// ⟨F′d, c⟩ = ⟨d, F′ᵀc⟩ for d of some frames: one at either end, one in the middle, those of a third, none. All other elements are left as they were, and the bits
/// are those of the gradient of all frames.
fn adjoint_of_frames<M: DoseModel + ?Sized>(
    model: &M,
    x: &M::Field,
    seed: u64,
    work: &Work,
) -> Result<(), Error> {
    let all = frames_of(model.patterns());
    let mut c = noise_of_dose(model, seed)?;
    let noise = noise(seed + 2, model.new_patterns()?.len());
    for frames in [
        0..1,
        all / 2..all / 2 + 1,
        all - 1..all,
        all / 3..2 * all / 3,
        0..0,
    ] {
        let mut part = vec![0.0f32; noise.len()];
        for (range, _) in elements_of(model.patterns(), &frames) {
            part[range.clone()].copy_from_slice(&noise[range]);
        }
        let mut d = model.new_patterns()?;
        d.copy_from_host(&part);
        let fd = derivative(model, x, &d, work)?;
        let norm = fd.norm();
        if norm > 0.0 {
            c.axpy((1.0 / norm) as f32, &fd);
        }
        let mut whole = model.new_patterns()?;
        model.pullback(x, &c, &mut whole, work)?;
        let mut back = model.new_patterns()?;
        back.fill(f32::NAN);
        model.pullback_of(frames.clone(), x, &c, &mut back, work)?;
        let (whole, back) = (whole.to_host(), back.to_host());
        let mut expected = vec![f32::NAN; whole.len()];
        for (range, _) in elements_of(model.patterns(), &frames) {
            expected[range.clone()].copy_from_slice(&whole[range]);
        }
        let bits = |v: &[f32]| v.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        let written = back.iter().filter(|v| !v.is_nan()).count();
        let pairs = part.iter().zip(&back).filter(|(_, b)| !b.is_nan());
        let backward: f64 = pairs.map(|(d, b)| f64::from(*d) * f64::from(*b)).sum();
        let forward = fd.dot(&c);
        let error = (forward - backward).abs();
        if error > 1e-5 * norm * c.norm() || bits(&back) != bits(&expected) {
            return Err(failed(
                "pullback_of",
                format!(
                    "frames {frames:?} of {all}: ⟨F′d, c⟩ = {forward}, ⟨d, F′ᵀc⟩ = {backward}; {written} of {} elements written",
                    back.len()
                ),
            ));
        }
    }
    Ok(())
}

fn overwrites<M: DoseModel + ?Sized>(model: &M, x: &M::Field, work: &Work) -> Result<(), Error> {
    let (mut clean, mut dirty) = (model.new_dose()?, model.new_dose()?);
    dirty.fill(f32::NAN);
    model.dose(x, &mut clean, work)?;
    model.dose(x, &mut dirty, work)?;
    if bits(&clean) != bits(&dirty) {
        return Err(failed(
            "dose",
            "what the output held before shows in the result".into(),
        ));
    }
    let (mut first, mut second) = (model.new_patterns()?, model.new_patterns()?);
    second.fill(f32::NAN);
    model.pullback(x, &clean, &mut first, work)?;
    model.pullback(x, &clean, &mut second, work)?;
    if bits(&first) != bits(&second) {
        return Err(failed(
            "pullback",
            "what the output held before shows in the result".into(),
        ));
    }
    Ok(())
}

fn frames_add_up<M: DoseModel + ?Sized>(model: &M, x: &M::Field, work: &Work) -> Result<(), Error> {
    let frames = frames_of(model.patterns());
    let (mut whole, mut parts) = (model.new_dose()?, model.new_dose()?);
    model.dose(x, &mut whole, work)?;
    let middle = frames / 3;
    model.dose_of(0..middle, x, &mut parts, work)?;
    model.dose_of(middle..frames, x, &mut parts, work)?;
    let size = whole.norm();
    parts.axpy(-1.0, &whole);
    let error = parts.norm() / size;
    if error > 1e-6 {
        return Err(failed(
            "dose_of",
            format!("the frames' doses add up to the dose only within {error:e}"),
        ));
    }
    Ok(())
}

fn linear<M: DoseModel + ?Sized>(
    model: &M,
    x: &M::Field,
    seed: u64,
    work: &Work,
) -> Result<(), Error> {
    let mut y = model.new_patterns()?;
    y.copy_from_host(&noise(seed, y.len()));
    let mut sum = y.clone();
    sum.axpy(2.0, x);
    let (mut fx, mut fy, mut fsum) = (model.new_dose()?, model.new_dose()?, model.new_dose()?);
    model.dose(x, &mut fx, work)?;
    model.dose(&y, &mut fy, work)?;
    model.dose(&sum, &mut fsum, work)?;
    let size = fsum.norm();
    fsum.axpy(-2.0, &fx);
    fsum.axpy(-1.0, &fy);
    let error = fsum.norm() / size;
    if error > 1e-5 {
        return Err(failed(
            "linearity",
            format!("F(2x + y) differs from 2F(x) + F(y) by {error:e}"),
        ));
    }
    Ok(())
}

fn same_bits_on_any_thread_count<M: DoseModel + ?Sized>(
    model: &M,
    x: &M::Field,
    work: &Work,
) -> Result<(), Error> {
    let mut results = Vec::new();
    for threads in [1, 2, 8] {
        let (mut dose, mut grad) = (model.new_dose()?, model.new_patterns()?);
        super::on_threads(threads, || {
            model
                .dose(x, &mut dose, work)
                .and_then(|()| model.pullback(x, &dose, &mut grad, work))
        })?;
        results.push((bits(&dose), bits(&grad)));
    }
    if results.windows(2).all(|pair| pair[0] == pair[1]) {
        return Ok(());
    }
    Err(failed(
        "threads",
        "results differ between 1, 2 and 8 threads".into(),
    ))
}

fn bits<F: Field>(field: &F) -> Vec<u32> {
    field.to_host().into_iter().map(f32::to_bits).collect()
}
