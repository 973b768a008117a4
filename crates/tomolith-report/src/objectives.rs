//! What each of several objectives comes to.
//!
//! A loss is the objective's own: its factor in the sum, `weight`, is left out of it, and so one of factor 0 is only measured. Errors are those of
//! its response against the gray values, every voxel that counts once: in its region, and with a weight above 0.

use super::number::{escape, significant};
use serde::Serialize;
use tomolith_metrics::Measure;

/// One of several objectives.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ObjectiveReport {
    /// Its key in the job, such as `objectives[0].bclp`.
    pub key: String,
    /// Its factor in the sum.
    pub weight: f64,
    /// Its loss without this factor; None where a dose per voxel does not tell it.
    pub loss: Measure,
    /// Voxels that count.
    pub voxels: u64,
    /// Root mean square difference between response and gray value; None for a target of part and void.
    pub rms_error: Measure,
    /// The largest such difference.
    pub max_error: Measure,
}

/// A section of the page, where there are several.
pub(crate) fn section(objectives: &[ObjectiveReport]) -> String {
    if objectives.len() < 2 {
        return String::new();
    }
    let cell = |m: Measure| m.map_or_else(|| "–".to_owned(), |m| significant(m, 4));
    let row = |own: &ObjectiveReport| {
        let numbers = [Some(own.weight), own.loss, own.rms_error, own.max_error];
        let [weight, loss, rms, largest] = numbers.map(cell);
        format!(
            "<tr><td>{}</td><td>{weight}</td><td>{loss}</td><td>{}</td><td>{rms}</td><td>{largest}</td></tr>",
            escape(&own.key),
            own.voxels,
        )
    };
    let rows: String = objectives.iter().map(row).collect();
    format!(
        "<section><h2>Objectives</h2><p>What each of them comes to on the job's own voxels, before the patterns are written. The sum takes a loss times its \
         factor.</p><div class=\"scroll\"><table class=\"plain\"><thead><tr><th>objective</th><th>factor</th><th>loss</th><th>voxels</th><th>rms error</th>\
         <th>largest error</th></tr></thead><tbody>{rows}</tbody></table></div></section>"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn several_objectives_are_a_table_and_one_is_none() {
        let own = |i: usize, rms_error: Measure| ObjectiveReport {
            key: format!("objectives[{i}].bclp"),
            weight: 0.5,
            loss: Some(12.345),
            voxels: 1234,
            rms_error,
            max_error: rms_error,
        };
        let two = [own(0, Some(0.25)), own(1, None)];
        assert_eq!(section(&two[..1]), "");
        let page = section(&two);
        for row in [
            "<td>objectives[0].bclp</td><td>0.5</td><td>12.35</td><td>1234</td><td>0.25</td><td>0.25</td>",
            "<td>objectives[1].bclp</td><td>0.5</td><td>12.35</td><td>1234</td><td>–</td><td>–</td>",
        ] {
            assert!(page.contains(row), "{page}");
        }
    }
}
