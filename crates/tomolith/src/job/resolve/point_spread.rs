//! The measured spread of a light's pixels, from its file.

use crate::error::{Error, Result};
use crate::grid::PatternGrid;
use crate::job::spec::LightSpec;
use crate::optics::point_spread::PointSpread;
use std::path::Path;
use std::sync::Arc;

/// What `light[i].psf` names; None where a pixel keeps its light.
pub(crate) fn of_light(
    i: usize,
    light: &LightSpec,
    pixels: &PatternGrid,
    base: &Path,
) -> Result<Option<Arc<PointSpread>>> {
    let Some(file) = &light.psf else {
        return Ok(None);
    };
    let refused = |found: String, accepted: String| {
        let found = format!("{}: {found}", file.display());
        Error::config(format!("light[{i}].psf"), found, accepted)
    };
    let read = PointSpread::read(&base.join(file), pixels.pitch_mm);
    let spread = read.map_err(|error| match error {
        Error::Config {
            found, accepted, ..
        }
        | Error::Format {
            found, accepted, ..
        } => refused(found, accepted),
        Error::Io { .. } => Error::config(
            format!("light[{i}].psf"),
            error.to_string(),
            "a file that can be read",
        ),
        other => other,
    })?;
    let reach = spread.reach();
    if reach[0] >= pixels.columns || reach[1] >= pixels.rows {
        let [columns, rows] = reach.map(|n| 2 * n + 1);
        return Err(refused(
            format!(
                "{columns} × {rows} pixels, more than an image of {} × {} can show",
                pixels.columns, pixels.rows
            ),
            "a spread that ends within the image when its middle is lit at an edge".to_owned(),
        ));
    }
    Ok(Some(Arc::new(spread)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::job::tests::document_of;
    use crate::job::{Job, ResolvedJob};
    use crate::models::Work;

    const BALL: &str = r#"
        target = { phantom = { sphere = {} }, size_mm = 1.2 }
        grid = { pitch_mm = 0.1 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [24, 20], angles = 24, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
    "#;

    fn resolved(psf: &Path, changes: &[&str]) -> Result<ResolvedJob> {
        let psf = format!("light[0].psf={psf:?}");
        let changes = [&[&*psf][..], changes].concat();
        ResolvedJob::new(&Job::from_document(document_of(BALL, &changes))?)
    }

    #[test]
    fn a_job_with_a_measured_spread_is_optimized_with_it_on_all_levels() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("psf.csv");
        std::fs::write(&file, "0, 1\n0.1, 0.4\n0.25, 0\n").unwrap();
        let job = resolved(&file, &["multiresolution={ levels = 1 }"]).unwrap();
        let reach = |lights: &[crate::optics::light::Light]| {
            lights[0].point_spread.as_ref().map(|spread| spread.reach())
        };
        assert_eq!(reach(job.lights()), Some([2, 2]));
        let task = job.task(&Work::new()).unwrap();
        let description = task.model.describe();
        tomolith_core::contains!(description, "spread over 5 × 5 pixels");
    }

    #[test]
    fn files_that_hold_no_spread_are_refused_at_their_key() {
        let folder = tempfile::tempdir().unwrap();
        let refused = |text: &str, changes: &[&str]| {
            let file = folder.path().join("psf.csv");
            std::fs::write(&file, text).unwrap();
            let refused = resolved(&file, changes).map(drop).unwrap_err();
            let Error::Config { key, found, .. } = refused else {
                panic!("{refused}")
            };
            (key, found)
        };
        for (text, word) in [
            ("0, 1\n0.1, -1\n", "-1 at 0.1 mm"),
            ("0, 0\n0.1, 0\n", "no light"),
            ("0, 1\n", "a single radius, 0 mm"),
            ("0.2, 1\n", "a single radius, 0.2 mm"),
            ("0, nan\n0.1, 0\n", "line 1: `0, nan`"),
            ("0.1, 1\n0.2, 0\n", "radii from 0.1 to 0.2 mm"),
            (
                "0, 1\n2.1, 0\n",
                "43 × 43 pixels, more than an image of 24 × 20",
            ),
            ("radius, light\n", "no line of numbers"),
        ] {
            let (key, found) = refused(text, &[]);
            assert!(
                key == "light[0].psf" && found.contains(word),
                "{key}: {found}"
            );
        }
        let waves = ["model={ wave = {} }"];
        let (key, found) = refused("0, 1\n0.1, 0\n", &waves);
        assert!(
            key == "model.wave" && found.contains("light.psf"),
            "{key}: {found}"
        );
    }
}
