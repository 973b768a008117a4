//! The bound of the dose range is one: an optimization ends within it.

use serde_json::json;
use std::sync::Arc;
use tomolith_core::check::{self, small::SmallModel};
use tomolith_core::dose::Work;
use tomolith_core::response::Identity;
use tomolith_objective::{FoundWindow, check::of_ring};
use tomolith_optimize::lbfgs::Lbfgs;
use tomolith_optimize::{Limits, Problem, Stop, run};

/// What a process window with these keys reaches on a small ring.
fn reached(keys: serde_json::Value) -> FoundWindow {
    let model = SmallModel::new(18, 6, 9);
    let objective = of_ring(&model, "process_window", keys, Arc::new(Identity));
    let limits = [Limits { min: 0.0, max: 3.0 }];
    let control = Work::new();
    let mut problem = Problem::new(&model, &*objective, &limits, &control).unwrap();
    let mut x = check::even_patterns(&model, 0.05);
    let stop = Stop::after(200);
    let mut lbfgs = Lbfgs::new(Default::default()).unwrap();
    run(&mut problem, &mut lbfgs, &mut x, &stop, None, &mut []).unwrap();
    objective.window(&check::dose(&model, &x)).unwrap()
}

#[test]
fn a_run_with_a_bound_of_the_dose_range_ends_within_it() {
    let free = reached(json!({ "outliers": 0.1 }));
    for share in [0.8, 0.4] {
        let ipdr = share * free.range;
        let bound = reached(json!({ "outliers": 0.1, "ipdr": ipdr }));
        assert!(bound.range <= ipdr, "{bound:?}");
        assert_eq!(bound.warning(), None);
        // It costs window, and is not met by dark patterns
        assert!(bound.window < free.window, "{bound:?}, {free:?}");
        assert!(bound.range > 0.3 * ipdr, "{bound:?}");
        assert!(bound.part_below > 0.9, "{bound:?}");
    }
}
