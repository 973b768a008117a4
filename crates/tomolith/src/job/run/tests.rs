use super::*;
use crate::job::progress::{Silent, Snapshot, Wants};
use crate::job::spec::document::Document;

#[test]
fn check_promises_a_ceiling_only_where_the_run_looks_for_one() {
    let text = |method: &str| {
        format!(
            r#"
            target = {{ phantom = "gyroid", size_mm = 0.05 }}
            grid = {{ pitch_mm = 0.002 }}
            resin = {{ refractive_index = 1.5, pure_radon = true }}
            vial = {{ index_matched = {{ radius_mm = 0.045 }} }}
            light = [{{ pixels = [48, 32], angles = 24, projector = {{ collimated = {{ pixel_pitch_mm = 0.002 }} }} }}]
            {method} = {{}}
            stop = {{ iterations = 3 }}
            "#
        )
    };
    let searches = |method| {
        let document = Document::toml("job.toml", text(method)).unwrap();
        let job = Job::from_document(document).unwrap();
        let plan = check(&job, &mut Silent, &Work::new()).unwrap();
        let mut notes = plan.notes.iter();
        notes.any(|note| note.contains("the lowest ceiling"))
    };
    assert!(searches("model.parallel"));
    for without in ["model.wave", "optimizer.pm"] {
        assert!(!searches(without), "{without}");
    }
}

#[test]
fn a_request_to_stop_ends_the_stage_at_hand() {
    let place = tempfile::tempdir().unwrap();
    let file = place.path().join("job.toml");
    let text = r#"
        target = { phantom = "gyroid", size_mm = 2.0 }
        grid = { pitch_mm = 0.1 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [24, 24], angles = 12, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        objective = { threshold = {} }
        stop = { iterations = 3 }
    "#;
    std::fs::write(&file, text).unwrap();
    let job = Job::read(&file, &[]).unwrap();
    let stages = [
        "reading the job",
        "sampling the target",
        OPTIMIZING,
        "evaluating the written patterns",
        "writing",
    ];
    for (i, at) in stages.into_iter().enumerate() {
        let folder = place.path().join(i.to_string());
        let (work, mut begun) = (Work::new(), Vec::new());
        let mut cancel = |event: &Event| {
            if let Event::Stage { name } = event {
                begun.push(name.clone());
                if name == at {
                    work.cancel();
                }
            }
        };
        let job = job.clone().with_folder(&folder, "--output");
        let ended = super::run(&job, false, &mut cancel, &work);
        assert!(matches!(ended, Err(Error::Canceled)), "{at}: {ended:?}");
        assert_eq!(begun, stages[..=i], "{at}");
        // Of a run whose patterns are there they are kept; nothing else is left
        assert_eq!(
            folder.join("checkpoint/patterns.npz").exists(),
            i >= 3,
            "{at}"
        );
        for name in ["report.json", "patterns.npz", "dose.npy", ".new"] {
            assert!(!folder.join(name).exists(), "{at}: {name}");
        }
        if i == 3 {
            super::run(&job, true, &mut Silent, &Work::new()).unwrap();
            let left = folder.join("checkpoint/patterns.npz");
            assert!(!left.exists() && folder.join("patterns.npz").exists());
        }
    }
}

/// Asks for copies, and keeps them.
#[derive(Default)]
struct Looker(Vec<Snapshot>);

impl Progress for Looker {
    fn event(&mut self, _: &Event) {}

    fn wants(&self) -> Wants {
        Wants {
            patterns: true,
            dose: true,
            print: self.0.len() >= 2,
            target: self.0.is_empty(),
        }
    }

    fn snapshot(&mut self, snapshot: Snapshot) {
        self.0.push(snapshot);
    }
}

#[test]
fn an_observer_has_copies_of_every_iteration_and_of_what_is_evaluated() {
    let place = tempfile::tempdir().unwrap();
    let text = r#"
        target = { phantom = "gear", size_mm = 2.0 }
        grid = { pitch_mm = 0.1 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [28, 12], angles = 16, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        response = { logistic = { steepness = 10.0, midpoint = 0.8 } }
        bounds = { max = 1.0 }
        stop = { iterations = 3 }
        evaluate = { refine = 2 }
    "#;
    let job = Job::from_document(Document::toml(place.path().join("job.toml"), text).unwrap());
    let job = job
        .unwrap()
        .with_folder(&place.path().join("run"), "--output");
    let mut looker = Looker::default();
    super::run(&job, false, &mut looker, &Work::new()).unwrap();
    let seen: Vec<Option<usize>> = looker.0.iter().map(|snapshot| snapshot.iteration).collect();
    assert_eq!(seen, [Some(0), Some(1), Some(2), Some(3), None]);
    let prints: Vec<usize> = looker
        .0
        .iter()
        .map(|snapshot| snapshot.print.len())
        .collect();
    assert_eq!(prints, [0, 0, 1, 1, 1]);
    // The target once, on the voxels of the dose
    let targets: Vec<usize> = looker
        .0
        .iter()
        .map(|snapshot| snapshot.target.len())
        .collect();
    assert_eq!(targets, [1, 0, 0, 0, 0]);
    assert_eq!(looker.0[0].target[0].inside.grid, looker.0[0].dose[0].grid);
    let [.., last, written] = looker.0.as_slice() else {
        unreachable!()
    };
    // The response of the dose at hand
    let (dose, print) = (&last.dose[0].values, &last.print[0].values);
    let response = |dose: f32| 1.0 / (1.0 + (-10.0 * (dose - 0.8)).exp());
    let wrong = dose
        .iter()
        .zip(print)
        .find(|(d, p)| (response(**d) - **p).abs() > 1e-5);
    assert!(wrong.is_none(), "{wrong:?}");
    // 8 bits of the brightest pixel apart at most
    let brightest = last.patterns[0].values.iter().copied().fold(0.0, f32::max);
    let pairs = last.patterns[0]
        .values
        .iter()
        .zip(&written.patterns[0].values);
    let apart = pairs
        .map(|(raw, shown)| (raw - shown).abs())
        .fold(0.0, f32::max);
    assert!(apart < brightest / 255.0, "{apart} of {brightest}");
    // What is evaluated lies on the job's voxels, its print on finer ones
    assert_eq!(
        written.print[0].values.len(),
        8 * written.dose[0].values.len()
    );
}

/// A card that is lost in the middle of a run.
#[cfg(feature = "gpu")]
mod lost_card {
    use super::*;
    use crate::io::npy::read_patterns;
    use crate::job::resolve::card::Card;
    use std::path::Path;

    /// Destroys the card at an event, and remembers the notes after that.
    struct Loses<'a> {
        device: &'a str,
        is_time: &'a dyn Fn(&Event) -> bool,
        is_lost: bool,
        notes: Vec<String>,
    }

    impl Progress for Loses<'_> {
        fn event(&mut self, event: &Event) {
            if let Event::Note { text } = event
                && self.is_lost
            {
                self.notes.push(text.clone());
            }
            if !self.is_lost && (self.is_time)(event) {
                self.is_lost = true;
                let card = Card::of(Some(self.device)).unwrap().unwrap();
                card.gpu().destroy();
            }
        }
    }

    const GEAR: &str = r#"
        target = { phantom = "gear", size_mm = 2.0 }
        grid = { pitch_mm = 0.1 }
        resin = { refractive_index = 1.5, absorption_per_mm = 0.1 }
        vial = { index_matched = { radius_mm = 2.0 } }
        light = [{ pixels = [28, 12], angles = 16, projector = { collimated = { pixel_pitch_mm = 0.1 } } }]
        stop = { iterations = 6 }
        checkpoint = { every_s = 1e-9 }
    "#;

    fn run(
        device: &str,
        folder: &Path,
        resume: bool,
        progress: &mut dyn Progress,
    ) -> Result<Summary> {
        let text = format!("{GEAR}resources = {{ device = \"{device}\" }}");
        let job = Job::from_document(Document::toml(Path::new("gear.toml"), &text)?)?;
        super::super::run(
            &job.with_folder(folder, "--output"),
            resume,
            progress,
            &Work::new(),
        )
    }

    #[test]
    fn a_run_that_loses_its_card_leaves_nothing_half_says_what_is_left_and_goes_on() {
        let Some(adapter) = tomolith_gpu::adapters().into_iter().next() else {
            let is_needed = std::env::var_os("TOMOLITH_NEEDS_GPU").is_some();
            assert!(
                !is_needed,
                "TOMOLITH_NEEDS_GPU is set, and there is no card"
            );
            return;
        };
        let device = format!("gpu:{}", adapter.name);
        let place = tempfile::tempdir().unwrap();
        let whole = place.path().join("whole");
        run(&device, &whole, false, &mut crate::job::Silent).unwrap();
        let patterns = |folder: &Path| read_patterns(&folder.join("patterns.npz")).unwrap();
        let loses_at = |name: &str, is_time: &dyn Fn(&Event) -> bool, left: &str| {
            let folder = place.path().join(name);
            let mut loses = Loses {
                device: &device,
                is_time,
                is_lost: false,
                notes: Vec::new(),
            };
            let ended = run(&device, &folder, false, &mut loses);
            assert!(
                matches!(ended, Err(Error::Device { .. })),
                "{name}: {ended:?}"
            );
            let notes = loses.notes.join("\n");
            assert!(loses.is_lost && notes.contains(left), "{name}: {notes}");
            for file in ["report.json", "patterns.npz", "dose.npy", ".new"] {
                assert!(!folder.join(file).exists(), "{name}: {file}");
            }
            // The card is there again
            run(&device, &folder, true, &mut crate::job::Silent).unwrap();
            assert_eq!(patterns(&folder), patterns(&whole), "{name}");
        };
        let begins =
            |event: &Event, stage: &str| matches!(event, Event::Stage { name } if name == stage);
        loses_at("start", &|event| begins(event, OPTIMIZING), "");
        let in_loop = |event: &Event| matches!(event, Event::Iteration { iteration: 3, .. });
        let left = "`--resume` goes on from the last checkpoint";
        let lost = format!("the card held the patterns, and they are lost; {left}");
        loses_at("loop", &in_loop, &lost);
        let evaluating = "evaluating the written patterns";
        loses_at("evaluation", &|event| begins(event, evaluating), left);
    }
}
