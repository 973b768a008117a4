//! One slip each: a word or a number that is wrong by itself.

/// What is wrong: text of the job, what stands there instead, what marks the line, parts of the message.
pub(super) type Wrong = (
    &'static str,
    &'static str,
    &'static str,
    &'static [&'static str],
);

/// One row per kind of slip.
pub(super) const WRONG: &[Wrong] = &[
    // Names
    (
        "iterations = 2",
        "iteratons = 2",
        "iteratons",
        &["stop.iteratons", "did you mean `iterations`?"],
    ),
    (
        "[resin]",
        "[resn]",
        "[resn]",
        &["resn", "did you mean `resin`?"],
    ),
    (
        "[vial.cylinder]",
        "[vial.cilinder]",
        "[vial.cil",
        &["vial.cilinder", "did you mean `cylinder`?", "index_matched"],
    ),
    (
        "[objective.threshold]",
        "[objective.treshold]",
        "[objective.tre",
        &["objective.treshold", "did you mean `threshold`?"],
    ),
    (
        "lower = 0.85",
        "lwer = 0.85",
        "lwer",
        &["objective.threshold.lwer", "did you mean `lower`?"],
    ),
    (
        "\"gear\"",
        "\"gaer\"",
        "\"gaer\"",
        &["target.phantom", "did you mean `gear`?"],
    ),
    (
        "[stop]",
        "[optimizer.lbfg]\n[stop]",
        "[optimizer.lbfg",
        &["optimizer.lbfg", "did you mean `lbfgs`?"],
    ),
    (
        "collimated",
        "colimated",
        "colimated",
        &["light[0].projector.colimated", "did you mean `collimated`?"],
    ),
    // Types and units
    (
        "iterations = 2",
        "iterations = \"two\"",
        "\"two\"",
        &["stop.iterations", "a whole number, 0 or more"],
    ),
    (
        "iterations = 2",
        "iterations = 2.5",
        "2.5",
        &["stop.iterations", "a whole number, 0 or more"],
    ),
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = \"0.1 kg\"\n\n",
        "kg",
        &["grid.pitch_mm", "unknown unit of length `kg`", "nm, um, mm"],
    ),
    (
        "inner_radius_mm = 3.0",
        "inner_radius_mm = true",
        "true",
        &["vial.cylinder.inner_radius_mm", "a length"],
    ),
    (
        "[48, 24]",
        "[48]",
        "[48]",
        &["light[0].pixels", "a list of 2"],
    ),
    ("[[light]]", "[light]", "[light]", &["light", "a list"]),
    // Numbers that cannot be
    (
        "0.05",
        "nan",
        "nan",
        &["resin.absorption_per_mm", "a finite number"],
    ),
    (
        "0.05",
        "-0.05",
        "-0.05",
        &["resin.absorption_per_mm", "found -0.05"],
    ),
    (
        "0.05",
        "0",
        "per_mm = 0",
        &["resin.absorption_per_mm", "found 0", "pure_radon"],
    ),
    (
        "0.05",
        "1e-30",
        "per_mm = 1e-30",
        &[
            "resin.absorption_per_mm",
            "found 1e-30",
            "at least 1e-9 per mm",
        ],
    ),
    (
        "refractive_index = 1.5\nabs",
        "refractive_index = 0.5\nabs",
        "0.5",
        &["resin.refractive_index", "found 0.5"],
    ),
    (
        "outer_radius_mm = 3.5\nrefractive_index = 1.5",
        "outer_radius_mm = 3.5\nrefractive_index = 1e6",
        "1e6",
        &["vial.cylinder.refractive_index", "found 1000000", "1 to 4"],
    ),
    (
        "size_mm = 2.0",
        "size_mm = 2.0\noffset_mm = [0, 0, 1.0]",
        "offset_mm",
        &["target.offset_mm", "passes the axis", "middle lies nearer"],
    ),
    (
        "[[light]]",
        "[resources]\nmemory_gb = 0.001\n\n[[light]]",
        "pitch_mm",
        &["grid.pitch_mm", "MB needed, 1 MB available"],
    ),
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = 0\n\n",
        "pitch_mm = 0\n",
        &["grid.pitch_mm", "found 0"],
    ),
    (
        "size_mm = 2.0",
        "size_mm = -2.0",
        "-2.0",
        &["target.size_mm", "-2"],
    ),
    (
        "angles = 30",
        "angles = 0",
        "angles = 0",
        &["light[0].angles", "found 0"],
    ),
    (
        "angles = 30",
        "angles = { list_deg = [] }",
        "list_deg",
        &["light[0].angles.list_deg", "an empty list", "azimuths"],
    ),
    (
        "inner_radius_mm = 3.0",
        "inner_radius_mm = 3.5",
        "inner_r",
        &["vial.cylinder.inner_radius_mm", "outer_radius_mm = 3.5"],
    ),
    // Indices of a resin whose index changes
    (
        "[stop]",
        "[resin.gradient]\nquadratic_per_mm2 = 0.9\n[stop]",
        "[resin.gradient",
        &[
            "resin.gradient",
            "3 mm from the axis n² is 20.475",
            "from 1 to 4",
        ],
    ),
    (
        "[stop]",
        "[resin.gradient]\nquadratic_per_mm2 = -0.08\n[stop]",
        "[resin.gradient",
        &[
            "resin.gradient",
            "3 mm from the axis n² is 0.63",
            "from 1 to 4",
        ],
    ),
    // Grids that cut the part
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = 0.1\nshape = [10, 10, 10]\n\n",
        "shape = [10",
        &[
            "grid.shape",
            "10 × 10 × 10 voxels of 0.1 mm are 1 × 1 × 1 mm, but the part is 2 × 2 × ",
            "% of its volume would be cut off",
            "grid.clip = true",
        ],
    ),
    // Movies: what the job sets is at fault
    (
        "[stop]",
        "[printer]\nrefresh_hz = 2\n[stop]",
        "refresh_hz",
        &[
            "printer.refresh_hz",
            "no device of 2 images a second shows",
            "at least 5 images a second",
        ],
    ),
    (
        "angles = 30",
        "angles = 3000",
        "angles",
        &[
            "light[0].angles",
            "no device of 240 images a second",
            "at most 1440 frames",
        ],
    ),
    // What is within a table of the vial
    (
        "[stop]",
        "[vial.bottom]\nthickness_mm = 1.0\n[stop]",
        "[vial.bottom",
        &[
            "vial.bottom.z_mm",
            "the key is missing",
            "for example z_mm = -10.0",
        ],
    ),
    // Numbers without thirty digits
    (
        "[stop]",
        "[model.rays]\nleast_power = 1e30\n[stop]",
        "least_power",
        &["model.rays.least_power: found 1e30"],
    ),
    (
        "lower = 0.85",
        "lower = 1e-30\nceiling = 1e-30",
        "ceiling",
        &["objective.threshold.ceiling: ceiling 1e-30 is below upper 0.95"],
    ),
    // Bands
    (
        "lower = 0.85",
        "lower = 0.95",
        "lower",
        &["objective.threshold.lower", "0.95"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\nceiling = 0.9",
        "ceiling",
        &["objective.threshold.ceiling", "0.9"],
    ),
    (
        "threshold]\nlower = 0.85\nupper = 0.95",
        "bclp]\nepsilon = -0.1",
        "epsilon",
        &["objective.bclp.epsilon", "-0.1"],
    ),
    // Numbers with which no loss is a number
    (
        "upper = 0.95",
        "upper = 0.95\nexponent = 1e30",
        "exponent",
        &["objective.threshold.exponent", "at most 100"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\nceiling = 1e38",
        "ceiling",
        &["objective.threshold.ceiling", "from -1e9 to 1e9"],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\npart_weight = 1e300",
        "part_weight",
        &["objective.threshold.part_weight", "from 0 to 1e9"],
    ),
    (
        "[objective.threshold]",
        "[objective]\nweight = 1e300\n[objective.threshold]",
        "weight",
        &["objective.weight", "from 0 to 1e9"],
    ),
    (
        "[stop]",
        "[response.logistic]\nsteepness = 1e30\n[stop]",
        "steepness",
        &["response.logistic.steepness", "at most 1e6"],
    ),
    (
        "[stop]",
        "[bounds]\nmin = 1e30\n[stop]",
        "min = 1e30",
        &["bounds.min", "0 to 1e9 mJ/mm²"],
    ),
    (
        "[stop]",
        "[bounds]\nmax = 1e30\n[stop]",
        "max = 1e30",
        &["bounds.max", "more than bounds.min = 0, up to 1e9 mJ/mm²"],
    ),
    (
        "[stop]",
        "[checkpoint]\nevery_s = \"often\"\n[stop]",
        "often",
        &["checkpoint.every_s", "seconds above 0, or \"auto\""],
    ),
    // More than a machine holds
    (
        "pitch_mm = 0.1\n\n",
        "pitch_mm = 0.0002\n\n",
        "pitch_mm = 0.0002",
        &["grid.pitch_mm", "memory", "MB needed", "MB available"],
    ),
    (
        "pixels = [48, 24]\nangles = 30",
        "pixels = [16000, 16000]\nangles = 1400",
        "pixels",
        &[
            "light[0].pixels",
            "memory",
            "MB needed",
            "fewer pixels or angles",
        ],
    ),
    // Responses and penalties
    (
        "threshold]\nlower = 0.85\nupper = 0.95",
        "pm]\nd_h = 1.4\nd_l = 0.7\n[response.logistic]\nupper = 1.0",
        "pm]",
        &["objective.pm", "1.4", "lies outside the response's range"],
    ),
    (
        "[stop]",
        "[response.table]\ndose = [0, 1, 2]\nresponse = [0.0, 0.6, 0.5]\n[stop]",
        "response = ",
        &["response.table.response[2]", "0.5 after 0.6", "falls"],
    ),
    (
        "[stop]",
        "[response.logistic]\nupper = 0.97\n[stop]",
        "response",
        &[
            "response: the start needs a dose with the response 1, but no dose gives it",
            "from 0 to 0.97",
            "[start.zero], [start.patterns]",
        ],
    ),
    (
        "[stop]",
        "[response.fit]\ndose = [0, 1, 2, 3, 4, 5]\nresponse = [0.9, 0.8, 0.6, 0.5, 0.3, 0.1]\n[stop]",
        "response = ",
        &["response.fit.response", "falls with dose", "0.9 to 0.1"],
    ),
    (
        "[stop]",
        "[response.fit]\nform = \"table\"\ndose = [0, 1, 2]\nresponse = [0.9, 0.6, 0.1]\n[stop]",
        "response = ",
        &["response.fit.response", "falls with dose", "0.9 to 0.1"],
    ),
    (
        "[stop]",
        "[response.logistic]\nlower = 1.0\nupper = 0.2\n[stop]",
        "lower = 1.0",
        &["response.logistic.lower", "lower 1 is not below upper 0.2"],
    ),
    (
        "[stop]",
        "[response.logistic]\n[evaluate]\nthreshold = 1.5\n[stop]",
        "threshold = 1.5",
        &["evaluate.threshold", "found 1.5", "goes from 0 to 1"],
    ),
    (
        "0.05",
        "0.05\ncritical_dose_mj_per_mm3 = 0.8\n[response.logistic]\nupper = 0.5\n[objective.response.identity]\n\
         [start.zero]\n[printer]\ntime_s = 60.0\npeak_irradiance_mw_per_cm2 = 5.0",
        "time_s",
        &["printer.time_s", "solid at 0.900", "from 0 to 0.5"],
    ),
    // Lengths beyond all measure are told in a few digits
    (
        "size_mm = 2.0",
        "size_mm = 1e300",
        "[target]",
        &["target", "reaches 5e299 mm from the axis"],
    ),
    (
        "inner_radius_mm = 3.0",
        "inner_radius_mm = 1e300",
        "inner_radius_mm",
        &["found 1e300 mm, not smaller than outer_radius_mm = 3.5 mm"],
    ),
    // Syntax
    (
        "iterations = 2",
        "iterations = 2\niterations = 3",
        "iterations = 3",
        &["duplicate key"],
    ),
    (
        "iterations = 2",
        "iterations = ",
        "iterations =",
        &["TOML, with each key once"],
    ),
];
