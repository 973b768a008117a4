//! What the same patterns print in each scenario.

use crate::error::Result;
use crate::grid::Volume;
use crate::job::resolve::ResolvedJob;
use crate::job::resolve::scenarios::{Scenario, name_of_join};
use crate::metrics::published::percentiles;
use crate::metrics::scan::Scan;
use crate::report::{ScenarioRow, ScenarioTable};

/// What the written patterns print in the job and in each scenario, all gelled at the job's threshold; None without scenarios. `response_of` gives
/// the response in a scenario.
pub(crate) fn table(
    resolved: &ResolvedJob,
    labels: &[u8],
    response: &Volume<f32>,
    threshold: Option<f64>,
    mut response_of: impl FnMut(&Scenario) -> Result<Volume<f32>>,
) -> Result<Option<ScenarioTable>> {
    if resolved.scenarios.is_empty() {
        return Ok(None);
    }
    let row = |name: &str, response: &Volume<f32>| -> Result<ScenarioRow> {
        let scan = Scan::new(labels, &response.values)?;
        let [low, _, out] = percentiles(&scan, resolved.evaluation().trim_percent);
        Ok(ScenarioRow {
            name: name.to_owned(),
            iou: scan.best_plateau().map(|plateau| plateau.iou),
            iou_at_threshold: threshold.and_then(|threshold| scan.iou_at(threshold)),
            gamma: scan.length_near_best().map(|length| 100.0 * length),
            part_low: low,
            void_high: out,
        })
    };
    let mut rows = vec![row("the job", response)?];
    for scenario in &resolved.scenarios {
        rows.push(row(&scenario.name, &response_of(scenario)?)?);
    }
    let join = name_of_join(resolved);
    Ok(Some(ScenarioTable::new(join, threshold, rows)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::resolve::scenarios::tests::resolved;
    use crate::models::Work;

    #[test]
    fn every_scenario_is_evaluated() {
        let job = resolved(&["resin.absorption_per_mm = 0.3"], &[]).unwrap();
        let resolved = &job;
        let labels = &job.own_voxels(&Work::new()).unwrap()[0].labels;
        let response = Volume {
            grid: labels.grid.clone(),
            values: labels
                .values
                .iter()
                .map(|&label| f32::from(label == crate::target::label::PART))
                .collect(),
        };
        let halved = |_: &Scenario| {
            Ok(Volume {
                grid: response.grid.clone(),
                values: response.values.iter().map(|v| 0.5 * v).collect(),
            })
        };
        let table = table(resolved, &labels.values, &response, Some(0.75), halved)
            .unwrap()
            .unwrap();
        // Half the dose is right at half the threshold, and prints nothing at that of the job
        assert_eq!(table.rows.len(), 2);
        assert_eq!((table.rows[1].iou, table.worst_iou), (Some(1.0), Some(0.0)));
        assert_eq!(table.window, Some(0.5));
    }
}
