//! Objectives: how wrong a dose is.
//!
//! *What must it do, and who does it.* Nearly every voxel-wise loss published for TVAM is one form, the band
//! ([`band`]); the table [`OBJECTIVES`] holds its presets. Several objectives are added by [`Sum`].

pub mod band;
pub mod bclp;
pub mod buffer;
pub mod check;
pub mod dose_matching;
pub mod least;
pub mod osmo;
pub mod penalty;
pub mod pm;
pub mod preset;
pub mod process_window;
pub mod species;
pub mod sum;
pub mod threshold;
pub mod voxel_weights;
pub mod window;

pub use band::{Band, BandObjective, Bands};
use preset::SurfaceHandling;
pub use process_window::FoundWindow;
use schemars::JsonSchema;
use serde::de::DeserializeOwned;
pub use species::{Join, PerBlock};
use std::fmt::Debug;
use std::sync::Arc;
pub use sum::Sum;
use tomolith_core::dose::DoseLayout;
use tomolith_core::dose::regions::ByElement;
use tomolith_core::error::{Error, Result};
use tomolith_core::field::{Field, HostField};
use tomolith_core::grid::Volume;
use tomolith_core::kind::{Kind, Read, Section};
use tomolith_core::response::Response;
use tomolith_core::target::Target;
pub use voxel_weights::VoxelWeights;

/// A real-valued function of a dose field. It knows no optics.
pub trait Objective<F: Field>: Send + Sync {
    /// L(dose)
    fn value(&self, dose: &F) -> f64;
    /// L(dose), and ∂L/∂dose written over `grad`; the value equals [`value`](Self::value) bit for bit.
    fn value_and_gradient(&self, dose: &F, grad: &mut F) -> f64;
    /// α ↦ (L, dL/dα) of dose + α·step, for line searches, without a temporary field.
    fn slope_along(&self, dose: &F, step: &F, alpha: f32) -> (f64, f64);
    /// Ends a line search in one pass: dose ← dose + α·step, step ← ∂L/∂dose there; returns L there, bit for bit what
    /// [`value_and_gradient`](Self::value_and_gradient) gives at the new dose.
    fn advance(&self, dose: &mut F, step: &mut F, alpha: f32) -> f64 {
        dose.axpy(alpha, step);
        self.value_and_gradient(dose, step)
    }
    /// Whether L is convex in the dose, so that a line search finds its minimum where the slope changes sign.
    fn is_convex(&self) -> bool;
    /// Whether L is a mean over voxels and not a sum, so that it stays the same on finer voxels.
    fn is_mean(&self) -> bool {
        false
    }
    /// Up to which dose, from 0 on, each element of the dose field costs nothing, whatever the others have; None where that is not known.
    fn harmless(&self) -> Option<Box<ByElement<'_>>> {
        None
    }
    /// The process window of a dose as the objective measures it; None where it does not look for one.
    fn window(&self, _dose: &F) -> Option<FoundWindow> {
        None
    }
    /// Weighs voxels and widens their bands, once, before any work.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for an objective without bands, [`Error::Shape`].
    fn set_voxel_weights(&mut self, _weights: &VoxelWeights) -> Result<()> {
        Err(Error::unsupported(
            "a weight or a tolerance per voxel",
            "this objective has no bands",
        ))
    }
    /// Takes another response of the material; bands stay as they are, in its units.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for an objective that knows no response.
    fn set_response(&mut self, _response: &Arc<dyn Response>) -> Result<()> {
        Err(Error::unsupported(
            "another response",
            "this objective knows none",
        ))
    }
    /// Refuses what the material's response cannot reach; to be called before any work.
    ///
    /// # Errors
    /// [`Error::Config`] (without a key).
    fn must_be_reached(&self) -> Result<()> {
        Ok(())
    }
}

/// A boxed result, to keep signatures short.
pub type BoxedObjective<F> = Result<Box<dyn Objective<F>>>;

/// What an objective is built on.
#[derive(Clone)]
pub struct ObjectiveInput<'a> {
    /// Where the voxels lie in the model's dose field.
    pub layout: &'a DoseLayout,
    /// Label of each voxel ([`target::label`](tomolith_core::target::label)), array order.
    pub labels: &'a Volume<u8>,
    /// The target on the same grid.
    pub target: &'a Target,
    /// M of the one equation; bands are in its units.
    pub response: Arc<dyn Response>,
}

/// An objective with its parameters in their ranges, before it knows a target.
pub trait MakeObjective<F: Field = HostField>: Debug + Send + Sync {
    /// The objective for a target.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a target or a surface that it does not know, [`Error::Shape`].
    fn make(&self, input: &ObjectiveInput) -> BoxedObjective<F>;
    /// How it weighs voxels that the surface cuts.
    fn surface(&self) -> SurfaceHandling;
    /// The largest response that costs nothing in the void, and the smallest in the part; None where it has no such two.
    fn thresholds(&self) -> Option<[f64; 2]> {
        None
    }
    /// Half the width of the band round each value of the target; None where it has none.
    fn epsilon(&self) -> Option<f64> {
        None
    }
    /// Whether it looks for the process window itself, which [`Objective::window`] then tells.
    fn seeks_window(&self) -> bool {
        false
    }
    /// The objective with a parameter that the program chooses; None where it has none such, or where the job names it.
    fn with(&self, _chosen: Chosen) -> Option<Arc<dyn MakeObjective<F>>> {
        None
    }
}

/// A parameter that the program chooses where a job leaves it open.
#[derive(Clone, Copy, Debug)]
pub enum Chosen {
    /// The largest response that costs nothing in the void, where the job names neither threshold.
    Lower(f64),
    /// The power of deviations.
    Exponent(f64),
}

/// Reads the parameters of an objective from its section; refuses those out of range.
pub type BuildObjective<F = HostField> = Read<Arc<dyn MakeObjective<F>>>;

/// The `build` of a row: reads its parameters P and makes an objective of those in their ranges.
fn read<F: Field, P: DeserializeOwned + JsonSchema, M: MakeObjective<F> + 'static>(
    section: &Section,
    make: impl FnOnce(&P) -> Result<M>,
) -> Result<Arc<dyn MakeObjective<F>>> {
    let made = make(&section.parse()?).map_err(|e| e.under(&section.path))?;
    Ok(Arc::new(made))
}

/// Every objective, for doses in host memory.
pub static OBJECTIVES: &[Kind<BuildObjective>] = objectives();

/// Every objective, wherever doses live.
#[must_use]
pub const fn objectives<F: Field>() -> &'static [Kind<BuildObjective<F>>] {
    const {
        &[
            threshold::kind(),
            least::l2(),
            least::l1(),
            dose_matching::kind(),
            pm::kind(),
            osmo::kind(),
            bclp::kind(),
            window::l2n(),
            window::osp(),
            window::ospw(),
            process_window::kind(),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check;
    use serde_json::{Value, json};
    use tomolith_core::check::small::SmallModel;
    use tomolith_core::check::{example, noise, refuses};
    use tomolith_core::dose::cells::Cells;
    use tomolith_core::grid::VolumeGrid;
    use tomolith_core::near;
    use tomolith_core::response::{Identity, Logistic};
    use tomolith_core::target::label;

    /// Voxels and what they should become, for objectives of them.
    #[derive(Clone)]
    pub(crate) struct Room {
        pub(crate) layout: DoseLayout,
        pub(crate) labels: Volume<u8>,
        pub(crate) target: Target,
    }

    impl Room {
        /// All voxels of a grid with these inside shares.
        pub(crate) fn of(shape: [usize; 3], inside: &[f32], gray: bool) -> Self {
            let grid = VolumeGrid::centered(shape, 0.5);
            let target = Target {
                name: "room".into(),
                inside: Volume::new(grid.clone(), inside.to_vec()),
                gray,
            };
            Room {
                layout: DoseLayout::new("dose", grid, 0),
                labels: tomolith_core::target::label_voxels(&target, |_| true),
                target,
            }
        }

        /// A row of voxels.
        pub(crate) fn row(inside: &[f32], gray: bool) -> Self {
            Self::of([1, 1, inside.len()], inside, gray)
        }

        fn ring(model: &SmallModel) -> Self {
            let (target, labels) = model.ring();
            Room {
                layout: model.layout().clone(),
                labels,
                target,
            }
        }

        /// With cells in the voxels that the surface cuts.
        pub(crate) fn cut(mut self) -> Self {
            let cells = Cells::new(&self.layout, &self.target.inside);
            self.layout = self.layout.with_cells(Arc::new(cells));
            self
        }

        pub(crate) fn input(&self, response: Arc<dyn Response>) -> ObjectiveInput<'_> {
            ObjectiveInput {
                layout: &self.layout,
                labels: &self.labels,
                target: &self.target,
                response,
            }
        }

        pub(crate) fn make(&self, kind: &str, json: Value) -> BoxedObjective<HostField> {
            let section = Section::new("objective", json!({ kind: json }));
            section
                .read(OBJECTIVES)?
                .make(&self.input(Arc::new(Identity)))
        }

        pub(crate) fn build(&self, kind: &str, json: Value) -> Box<dyn Objective<HostField>> {
            self.make(kind, json).unwrap()
        }
    }

    fn row(name: &str) -> &'static Kind<BuildObjective> {
        OBJECTIVES.iter().find(|row| row.name == name).unwrap()
    }

    /// A dose between −0.2 and 1.4.
    fn some_dose(layout: &DoseLayout) -> HostField {
        let mut dose = HostField::from_slice(&noise(5, layout.len()));
        dose.scale(0.8);
        dose.shift(0.6);
        dose
    }

    #[test]
    fn every_row_passes_the_check_with_either_response_and_surface() {
        let model = SmallModel::new(18, 2, 21);
        let mut plain = Room::ring(&model);
        // Some voxels that the surface cuts
        let some = plain.target.inside.values.iter_mut().enumerate();
        for (i, s) in some.step_by(7) {
            *s = (*s + 0.37 * (i % 3) as f32).min(1.0);
        }
        let cut = plain.clone().cut();
        assert!(cut.layout.len() > plain.layout.len() + 5);
        let responses: [Arc<dyn Response>; 2] = [
            Arc::new(Identity),
            Arc::new(Logistic::new(Default::default()).unwrap()),
        ];
        for row in OBJECTIVES {
            for response in &responses {
                for surface in ["voxel", "fraction", "cells"] {
                    let room = if surface == "cells" { &cut } else { &plain };
                    let input = room.input(response.clone());
                    let mut section = example(row);
                    section.value["surface"] = surface.into();
                    let objective = (row.build)(&section).unwrap().make(&input).unwrap();
                    check::objective(&*objective, &some_dose(&room.layout))
                        .unwrap_or_else(|e| panic!("{} ({response:?}, {surface}): {e}", row.name));
                }
            }
        }
    }

    #[test]
    fn every_row_takes_another_response() {
        let model = SmallModel::new(18, 2, 21);
        let dose = some_dose(model.layout());
        let [identity, other]: [Arc<dyn Response>; 2] = [
            Arc::new(Identity),
            Arc::new(Logistic::new(Default::default()).unwrap()),
        ];
        for row in OBJECTIVES {
            let make = |response: &Arc<dyn Response>| {
                let parameters = example(row).value;
                let made = check::of_ring(&model, row.name, parameters, Arc::clone(response));
                Sum::new(vec![(2.0, made)]).unwrap()
            };
            let mut changed = make(&identity);
            let first = changed.value(&dose);
            changed.set_response(&other).unwrap();
            assert_eq!(
                changed.value(&dose),
                make(&other).value(&dose),
                "{}",
                row.name
            );
            assert_ne!(changed.value(&dose), first, "{}", row.name);
        }
    }

    #[test]
    fn every_power_passes_the_check() {
        let model = SmallModel::new(18, 2, 21);
        let dose = some_dose(model.layout());
        for p in [0.5, 1.0, 1.5, 2.0, 3.0, 8.0] {
            for q in [0.5, 1.0, 2.0, 5.0] {
                let json =
                    json!({"p": p, "q": q, "epsilon": 0.1, "part_weight": 2.0, "void_weight": 0.5});
                let objective = check::of_ring(&model, "bclp", json, Arc::new(Identity));
                check::objective(&*objective, &dose)
                    .unwrap_or_else(|e| panic!("p = {p}, q = {q}: {e}"));
            }
        }
    }

    #[test]
    fn gray_targets_are_reproduced_or_refused() {
        let model = SmallModel::new(10, 2, 5);
        let mut room = Room::ring(&model);
        room.target.gray = true;
        for (i, value) in room.target.inside.values.iter_mut().enumerate() {
            *value = (i % 10) as f32 / 10.0;
        }
        let gray = HostField::from_slice(&model.layout().field_of(&room.target.inside));
        for row in OBJECTIVES {
            let built = room.make(row.name, example(row).value);
            if ["l2", "l1", "dose_matching", "bclp"].contains(&row.name) {
                let objective = built.unwrap();
                assert_eq!(objective.value(&gray), 0.0, "{}", row.name);
                check::objective(&*objective, &some_dose(model.layout())).unwrap();
            } else {
                assert!(
                    matches!(built, Err(Error::Unsupported { .. })),
                    "{} took a gray target",
                    row.name
                );
            }
        }
    }

    /// The loss of a dose field on one row of voxels with these inside shares, and its gradient. A field that is longer than the row has
    /// cells: first the doses outside, then those inside.
    fn loss_of(kind: &str, json: Value, inside: &[f32], field: &[f32]) -> (f64, Vec<f32>) {
        let mut room = Room::row(inside, false);
        if field.len() > inside.len() {
            room = room.cut();
        }
        let dose = HostField::from_slice(field);
        let mut gradient = dose.zeros_like();
        let loss = room
            .build(kind, json)
            .value_and_gradient(&dose, &mut gradient);
        (loss, gradient.as_slice().to_vec())
    }

    fn assert_loss(kind: &str, json: Value, dose: [f32; 4], loss: f64, gradient: [f32; 4]) {
        let (found, slopes) = loss_of(kind, json, &[1.0, 1.0, 0.0, 0.0], &dose);
        near!(found, loss, 1e-6, "{kind}");
        for (found, expected) in slopes.iter().zip(gradient) {
            near!(found, expected, 1e-6, "{kind}: {slopes:?}");
        }
    }

    /// Preset, its keys, doses of two part and two void voxels, loss, and gradient.
    const PUBLISHED: &str = r#"
threshold | {"lower": 0.9, "upper": 0.95, "exponent": 2} | [0.5, 0.97, 0.92, 0.5] | 0.2029 | [-0.9, 0, 0.04, 0]
threshold | {"lower": 0.4, "upper": 0.95, "exponent": 2} | [0.5, 0.97, 0.92, 0.5] | 0.4829 | [-0.9, 0, 1.04, 0.2]
threshold | {"lower": 0.9, "upper": 0.99, "exponent": 2} | [0.5, 0.97, 0.92, 0.5] | 0.2409 | [-0.98, -0.04, 0.04, 0]
threshold | {"lower": 0.9, "upper": 0.95, "exponent": 1} | [0.5, 1.1, 0.92, 0.5] | 0.57 | [-1, 1, 1, 0]
l2 | {} | [1, 2, 3, 4] | 26 | [0, 2, 6, 8]
l1 | {} | [1, 2, 3, 4] | 8 | [0, 1, 1, 1]
osmo | {"d_h": 0.9, "d_l": 0.85} | [0.5, 2, 0.95, 0.5] | 0.17 | [-0.8, 0, 0.2, 0]
pm | {"d_h": 0.8, "d_l": 0.7, "rho_1": 3} | [0.5, 2, 0.9, 0.5] | 1.1 | [-3, 0, 1, 0]
ospw | {"lower": 0.7, "upper": 0.9, "w": 0} | [0.5, 1, 0.9, 0.5] | 0.21 | [-0.8, 0.2, 0.4, 0]
ospw | {"lower": 0.7, "upper": 0.9, "w": 0.1} | [0.5, 1, 0.9, 0.5] | 0.2 | [-0.8, 0, 0.4, 0]
osp | {"lower": 0.7, "upper": 0.9} | [0.5, 3, 0.9, 0.5] | 0.2 | [-0.8, 0, 0.4, 0]
l2n | {"lower": 0.7, "upper": 0.9} | [0.5, 1, 0.9, 0.5] | 0.25 | [-0.8, 0.2, 0.4, -0.4]
"#;

    #[test]
    fn published_values_of_threshold_and_least_squares() {
        for row in PUBLISHED.trim().lines() {
            let columns: Vec<&str> = row.split(" | ").collect();
            let [kind, keys, dose, loss, gradient] = columns[..] else {
                panic!("{row}")
            };
            let numbers = |text: &str| serde_json::from_str::<[f32; 4]>(text).unwrap();
            let (keys, loss) = (keys.parse().unwrap(), loss.parse().unwrap());
            assert_loss(kind, keys, numbers(dose), loss, numbers(gradient));
        }
        // Whole powers are multiplied out, others are powers: 0.45^K + 0.02^K and its derivatives
        for exponent in [3.0, 3.5, 4.0, 5.0, 8.0, 9.0] {
            let term = |r: f64| r.powf(exponent);
            let slope = |r: f64| (exponent * r.powf(exponent - 1.0)) as f32;
            assert_loss(
                "threshold",
                json!({"lower": 0.9, "upper": 0.95, "exponent": exponent}),
                [0.5, 0.97, 0.92, 0.5],
                term(0.45) + term(0.02),
                [-slope(0.45), 0.0, slope(0.02), 0.0],
            );
        }
        // (0.35² + 0.05²)^½ with both gradients divided by it
        let norm = (0.35f64.powi(2) + 0.05f64.powi(2)).sqrt();
        let slope = |e: f64| (e / norm) as f32;
        assert_loss(
            "bclp",
            json!({"epsilon": 0.1}),
            [0.55, 1.05, 0.15, 0.0],
            norm,
            [-slope(0.35), 0.0, slope(0.05), 0.0],
        );
    }

    #[test]
    fn published_value_of_a_surface_fraction() {
        // s = 0.8 inside at dose 0.2, 0.2 outside: 0.8·0.75² + 0.2·0 with thresholds 0.9 and 0.95
        let json = json!({"lower": 0.9, "upper": 0.95, "surface": "fraction"});
        let (loss, gradient) = loss_of("threshold", json, &[0.8], &[0.2]);
        assert!((loss - 0.8 * 0.75f64.powi(2)).abs() < 1e-6);
        assert!((gradient[0] + 0.8 * 1.5).abs() < 1e-6);
    }

    #[test]
    fn published_values_of_surface_aware_cells() {
        // Inside volumes 0.2 and 2, outside 0.8 and 2: shares 0.2 and 0.5
        let threshold = json!({"lower": 0.9, "upper": 0.95, "surface": "cells"});
        for (kind, json, inside, doses, loss, gradient) in [
            (
                "threshold",
                threshold,
                &[0.2, 0.5][..],
                &[0.1, 0.92, 0.2, 0.96][..],
                0.2 * 0.75 * 0.75 + 0.5 * 0.02 * 0.02,
                &[0.0, 0.02, -0.3, 0.0][..],
            ),
            (
                "l2",
                json!({"surface": "cells"}),
                &[0.2],
                &[0.3, 0.4],
                0.144,
                &[0.48, -0.24],
            ),
        ] {
            let (found, slopes) = loss_of(kind, json, inside, doses);
            assert!((found - loss).abs() < 1e-6, "{kind}: {found}");
            for (a, b) in slopes.iter().zip(gradient) {
                assert!((a - b).abs() < 1e-6, "{kind}: {slopes:?}");
            }
        }
    }

    #[test]
    fn doses_up_to_the_threshold_of_the_void_are_harmless() {
        // Void, part, and a voxel that the surface halves
        let room = Room::row(&[0.0, 1.0, 0.5], false);
        let limits_of = |kind, json| {
            let objective = room.build(kind, json);
            let harmless = objective.harmless().unwrap();
            [0, 1, 2].map(harmless)
        };
        let limits = limits_of("threshold", json!({ "lower": 0.7, "upper": 0.9 }));
        assert_eq!(limits[..2], [0.7, 0.0]);
        let fraction = json!({ "surface": "fraction", "lower": 0.7, "upper": 0.9 });
        assert_eq!(limits_of("threshold", fraction), [0.7, 0.0, 0.0]);
        assert_eq!(limits_of("l2", json!({})), [0.0; 3]);
    }

    #[test]
    fn cells_are_no_voxels_and_voxels_no_cells() {
        let model = SmallModel::new(10, 2, 5);
        let plain = Room::ring(&model);
        let mut cut = plain.clone();
        cut.target.inside.values.fill(0.5);
        let cut = cut.cut();
        for (room, surface) in [(&plain, "cells"), (&cut, "voxel"), (&cut, "fraction")] {
            let made = room.make("threshold", json!({ "surface": surface }));
            let Err(Error::Unsupported { what, .. }) = made else {
                panic!("{surface} was accepted");
            };
            assert!(what.contains(surface), "{what}");
        }
    }

    #[test]
    fn a_loss_of_zero_has_a_gradient_of_zero_whatever_the_powers() {
        for (p, q) in [(2.0, 1.0), (0.5, 0.25), (0.7, 3.0), (1.0, 0.5)] {
            let json = json!({"p": p, "q": q, "epsilon": 0.25});
            let (loss, gradient) = loss_of("bclp", json, &[1.0, 0.0], &[0.75, 0.25]);
            assert_eq!((loss, gradient), (0.0, vec![0.0, 0.0]), "p = {p}, q = {q}");
        }
    }

    #[test]
    fn voxels_outside_and_padding_count_nothing_and_no_number_is_seen() {
        let mut room = Room::of([3, 2, 2], &[1.0; 12], false);
        room.labels.values.fill(label::OUTSIDE);
        let zero = HostField::zeros(room.layout.len());
        assert_eq!(room.build("l2", json!({})).value(&zero), 0.0);
        room.labels.values[5] = label::PART;
        let objective = room.build("l2", json!({}));
        assert_eq!(objective.value(&zero), 1.0);
        for value in [f32::NAN, f32::INFINITY] {
            let mut dose = zero.clone();
            dose.as_mut_slice()[room.layout.index(1, 0, 1)] = value;
            assert!(
                !objective.value(&dose).is_finite(),
                "a dose of {value} went unseen"
            );
        }
    }

    #[test]
    fn parameters_out_of_range_are_named() {
        for (kind, json, key) in [
            ("threshold", json!({"lower": 0.95, "upper": 0.95}), "lower"),
            ("threshold", json!({"lower": 0.9, "upper": 1.05}), "ceiling"),
            ("threshold", json!({"exponent": 0.0}), "exponent"),
            ("threshold", json!({"void_weight": -1.0}), "void_weight"),
            ("threshold", json!({"uper": 0.9}), "uper"),
            ("ospw", json!({"w": -0.1}), "w"),
            ("bclp", json!({"p": 0}), "p"),
            ("bclp", json!({"epsilon": -1}), "epsilon"),
            ("pm", json!({"buffer_mm": -1.0}), "buffer_mm"),
            ("osmo", json!({"d_l": 2.0}), "d_l"),
        ] {
            let section = Section::new("objective", json!({ kind: json }));
            refuses(section.read(OBJECTIVES), &format!("objective.{kind}.{key}"));
        }
        let bands = Bands::labels(vec![0], &[(0, Band::new(0.5, 0.4, 1.0))]);
        assert!(
            BandObjective::<HostField>::new(0..1, bands, 2.0, 2.0, Arc::new(Identity)).is_err()
        );
        let bands = Bands::labels(vec![0], &[(0, Band::exactly(0.5))]);
        assert!(BandObjective::<HostField>::new(0..1, bands, 2.0, 2.0, Arc::new(Identity)).is_ok());
    }

    #[test]
    fn the_buffer_of_penalty_minimization_is_free() {
        // Six voxels of 0.5 mm, three of them part; within 0.5 mm only the two at the surface
        let room = Room::row(&[0.0, 0.0, 0.0, 1.0, 1.0, 1.0], false);
        let dark = HostField::zeros(room.layout.len());
        for (buffer, voxels) in [(0.0, 3.0), (0.5, 2.0), (1.0, 1.0)] {
            let json = json!({"d_h": 1.0, "d_l": 0.5, "buffer_mm": buffer});
            // Every part voxel that counts lacks 1
            let loss = room.build("pm", json).value(&dark);
            assert_eq!(loss, voxels, "buffer {buffer}");
        }
    }

    #[test]
    fn a_sum_is_the_weighted_sum_and_passes_the_check() {
        let model = SmallModel::new(18, 2, 21);
        let build =
            |name: &str| check::of_ring(&model, name, example(row(name)).value, Arc::new(Identity));
        let sum = Sum::new(vec![(0.5, build("threshold")), (2.0, build("l2"))]).unwrap();
        let dose = some_dose(model.layout());
        check::objective(&sum, &dose).unwrap();
        let expected = 0.5 * build("threshold").value(&dose) + 2.0 * build("l2").value(&dose);
        assert_eq!(sum.value(&dose), expected);
    }

    #[test]
    fn the_same_bits_for_any_number_of_threads() {
        let model = SmallModel::new(40, 1, 130);
        let parameters = example(row("threshold")).value;
        let objective = check::of_ring(&model, "threshold", parameters, Arc::new(Identity));
        let dose = some_dose(model.layout());
        let losses = [1, 2, 8].map(|threads| {
            tomolith_core::check::on_threads(threads, || objective.value(&dose)).to_bits()
        });
        assert_eq!(losses[0], losses[1]);
        assert_eq!(losses[0], losses[2]);
    }
}
