//! One slip each: a word or a number that stands wrong in a job.

/// What is wrong: text of the job, what stands there instead, what marks the line, parts of the message.
type Wrong = (
    &'static str,
    &'static str,
    &'static str,
    &'static [&'static str],
);

/// One row per kind of slip.
pub(super) const WRONG: &[Wrong] = &[
    // Waves
    (
        "[stop]",
        "[model.wave]\n[stop]",
        "[model.wave",
        &[
            "model.wave",
            "this vial refracts or has walls",
            "index_matched",
        ],
    ),
    (
        "[vial.cylinder]\ninner_radius_mm = 3.0\nouter_radius_mm = 3.5\nrefractive_index = 1.5",
        "[model.wave]\nnumerical_aperture = 0.1\n[vial.index_matched]\nradius_mm = 3.0",
        "numerical_aperture",
        &[
            "model.wave.numerical_aperture",
            "pixels of 0.1 mm make at most 0.00286",
            "at most 0.002864 mm",
        ],
    ),
    (
        "[vial.cylinder]\ninner_radius_mm = 3.0\nouter_radius_mm = 3.5\nrefractive_index = 1.5",
        "[model.wave]\nrelative_error = 0.5\n[vial.index_matched]\nradius_mm = 3.0",
        "relative_error",
        &["model.wave.relative_error", "1e-6 to 0.1"],
    ),
    (
        "[vial.cylinder]\ninner_radius_mm = 3.0\nouter_radius_mm = 3.5\nrefractive_index = 1.5",
        "[model.wave]\nrings = 3\n[vial.index_matched]\nradius_mm = 3.0",
        "rings",
        &["model.wave.rings", "found 3", "`etendue_deg` above 0"],
    ),
    (
        "[vial.cylinder]\ninner_radius_mm = 3.0\nouter_radius_mm = 3.5\nrefractive_index = 1.5",
        "[model.wave]\nnumerical_aperture = 1e-5\n[vial.index_matched]\nradius_mm = 3.0",
        "numerical_aperture",
        &[
            "model.wave.numerical_aperture",
            "spots wider than the image of 2.4 mm",
            "at least 8.4375e-5",
        ],
    ),
    (
        "[vial.cylinder]\ninner_radius_mm = 3.0\nouter_radius_mm = 3.5\nrefractive_index = 1.5",
        "[model.wave]\n[optimizer.fista]\n[vial.index_matched]\nradius_mm = 3.0",
        "[optimizer.fista]",
        &[
            "cannot be combined with waves",
            "accepted: lbfgs, gradient, adam, pm, bclp",
        ],
    ),
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
    // Names that were
    (
        "[stop]",
        "[model]\norders = {}\n[stop]",
        "orders",
        &["model", "`orders` is now called `successive_orders`"],
    ),
    (
        "[stop]",
        "[coarse ]\nlevels = 2\n[stop]",
        "coarse",
        &["`coarse` is now called `multiresolution`"],
    ),
    (
        "[stop]",
        "[printer]\ngrey_curve = [[0.0, 0.0], [1.0, 1.0]]\n[stop]",
        "grey_curve",
        &["`grey_curve` is now called `gray_curve`"],
    ),
    (
        "[stop]",
        "[motion]\nwobble_mm = 0.1\n[stop]",
        "wobble",
        &["motion.wobble_mm", "did you mean `axis_runout_mm`?"],
    ),
    (
        "[stop]",
        "[motion]\nwobble_phase_deg = 0.1\n[stop]",
        "wobble",
        &["motion.wobble_phase_deg", "did you mean `axis_runout_deg`?"],
    ),
    (
        "[stop]",
        "[printer]\nwobble_mm = 0.1\n[stop]",
        "wobble",
        &["printer.wobble_mm", "did you mean `eccentricity_mm`?"],
    ),
    (
        "[stop]",
        "[printer]\nwobble_deg = 0.1\n[stop]",
        "wobble",
        &["printer.wobble_deg", "did you mean `eccentricity_deg`?"],
    ),
    // Numbers that cannot be
    (
        "0.05",
        "nan",
        "nan",
        &["resin.absorption_per_mm", "a finite number"],
    ),
    (
        "0.05",
        "inf",
        "inf",
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
        &["target.offset_mm", "along the axis", "middle lies nearer"],
    ),
    (
        "[[light]]",
        "[resources]\nmemory_gb = 0.001\n\n[[light]]",
        "pitch_mm",
        &["grid.pitch_mm", "MB needed, 1 MB available"],
    ),
    (
        "[[light]]",
        "[resources]\nmemory_gb = 0.0001\n\n[[light]]",
        "pitch_mm",
        &["grid.pitch_mm", "MB needed, less than 1 MB available"],
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
    (
        "size_mm = 2.0",
        "size_mm = -1e30",
        "-1e30",
        &["target.size_mm: found -1e30"],
    ),
    // Bands
    (
        "lower = 0.85",
        "lower = 0.95",
        "lower",
        &["objective.threshold.lower", "0.95"],
    ),
    (
        "lower = 0.85",
        "lower = 1.85",
        "lower",
        &["objective.threshold.lower", "1.85"],
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
        &["bounds.max", "from bounds.min = 0 to 1e9 mJ/mm²"],
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
    // Methods and what they cannot have
    (
        "[stop]",
        "[optimizer.lbfgs]\nfilter = \"hann\"\n[stop]",
        "filter",
        &[
            "optimizer.lbfgs.filter",
            "`lbfgs` has no `filter`, these have:",
            "optimizer.osmo",
            "optimizer.cal",
            "start.fbp",
        ],
    ),
    (
        "[stop]",
        "[start.zero]\nfilter = \"hann\"\n[stop]",
        "filter",
        &[
            "start.zero.filter",
            "nothing: this table has no keys",
            "start.fbp",
        ],
    ),
    (
        "[stop]",
        "[start.patterns]\nfile = \"x.npz\"\nbounds_as = { lsqr = { iterations = 0 } }\n[stop]",
        "bounds_as",
        &["start.patterns.bounds_as.lsqr.iterations", "1 to 1000"],
    ),
    (
        "[stop]",
        "[optimizer.osmo]\nfilter = \"ramlak\"\n[stop]",
        "filter",
        &["optimizer.osmo.filter", "did you mean `ram_lak`?"],
    ),
    (
        "[stop]",
        "[bounds]\nbits = 8\n[stop]",
        "bits",
        &["bounds.bits", "optimizer.lbfgs with rounding in every step"],
    ),
    (
        "[stop]",
        "[optimizer.fista]\n[response.logistic]\n[stop]",
        "[optimizer",
        &["optimizer.fista", "not convex together", "accepted: lbfgs"],
    ),
    (
        "[objective.threshold]\nlower = 0.85\nupper = 0.95",
        "[optimizer.osmo]\n[objective.l2]",
        "[optimizer",
        &[
            "optimizer.osmo",
            "allows no dose at all in the void",
            "in the end all light",
            "accepted: lbfgs, gradient, fista",
        ],
    ),
    (
        "[stop]",
        "[optimizer.osmo]\n[[penalties]]\nweight = 1.0\nsparsity = { exponent = 2 }\n[stop]",
        "[[penalties",
        &["penalties[0]", "optimizer.osmo with penalties"],
    ),
    // Bits
    (
        "[stop]",
        "[evaluate]\nbit_depth = 0\n[stop]",
        "bit_depth",
        &["evaluate.bit_depth", "found 0", "from 1 to 16"],
    ),
    (
        "[stop]",
        "[evaluate]\nbit_depth = 17\n[stop]",
        "bit_depth",
        &["evaluate.bit_depth", "found 17", "from 1 to 16"],
    ),
    (
        "[stop]",
        "[bounds]\nbits = 0\n[stop]",
        "bits",
        &["bounds.bits", "found 0", "1 to 16 bits"],
    ),
    (
        "[stop]",
        "[bounds]\nbits = 17\n[stop]",
        "bits",
        &["bounds.bits", "found 17", "1 to 16 bits"],
    ),
    (
        "[stop]",
        "[evaluate]\nrequire_in_band = 0.9\n[stop]",
        "require",
        &["evaluate.require_in_band", "part and void", "require_iou"],
    ),
    (
        "[stop]",
        "[[penalties]]\nsparsity = { exponent = 2 }\n[stop]",
        "penalties",
        &["penalties[0].weight", "missing"],
    ),
    (
        "absorption_per_mm = 0.05\n",
        "",
        "[resin]",
        &[
            "resin.absorption_per_mm",
            "the key is missing",
            "pure_radon",
        ],
    ),
    (
        "[[light]]",
        "[light]",
        "[light]",
        &[
            "light",
            "found a table",
            "a list, whose tables are written [[light]]",
        ],
    ),
    // Light that is gone before it comes to the part
    (
        "absorption_per_mm = 0.05",
        "absorption_per_mm = 90",
        "[[light]]",
        &["light", "no light meets the target", "absorption_per_mm"],
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
    // What does not fit
    (
        "size_mm = 2.0",
        "size_mm = 9.0",
        "[target]",
        &["target", "reaches 4.5", "the resin ends at 3"],
    ),
    (
        "size_mm = 2.0",
        "size_mm = 9.123456789012345",
        "[target]",
        &["target", "reaches 4.56173 mm from the axis"],
    ),
    (
        "[48, 24]",
        "[12, 24]",
        "[12, 24]",
        &["light[0].pixels", "sideways"],
    ),
    (
        "[48, 24]",
        "[48, 4]",
        "[48, 4]",
        &["light[0].pixels", "along the axis"],
    ),
    // The machine
    (
        "[stop]",
        "[printer]\nrpm = 3\n[stop]",
        "rpm = 3",
        &["printer.rpm", "unknown name"],
    ),
    (
        "[stop]",
        "[printer]\ncanvas = [40, 60]\n[stop]",
        "[40, 60]",
        &["printer.canvas", "need 48 × 24", "at least [48, 24]"],
    ),
    (
        "[stop]",
        "[printer]\ngray_curve = [[0.0, 0.0], [0.5, 0.7], [1.0, 0.6]]\n[stop]",
        "gray_curve",
        &[
            "printer.gray_curve",
            "not monotone",
            "usable from value 0 to 0.5",
            "`tomolith calibrate gray`",
        ],
    ),
    (
        "[stop]",
        "[printer]\ngray_curve = [[0.0, -0.2], [0.5, 0.2], [1.0, 0.6]]\n[stop]",
        "gray_curve",
        &[
            "printer.gray_curve",
            "an intensity of -0.2",
            "usable from value 0.5 to 1",
        ],
    ),
    // Doses and the print in time
    (
        "0.05\n",
        "0.05\ncritical_dose_mj_per_cm2 = 80\n",
        "critical_dose_mj_per_cm2",
        &[
            "resin.critical_dose_mj_per_cm2",
            "a dose per area, and one per volume is meant",
            "E/(100·D) mJ/mm³",
            "did you mean `critical_dose_mj_per_mm3`",
        ],
    ),
    (
        "0.05\n",
        "0.05\ncritical_dose_mj_per_mm3 = \"80 mJ/cm2\"\n",
        "critical_dose_mj_per_mm3",
        &[
            "resin.critical_dose_mj_per_mm3",
            "found \"80 mJ/cm2\"",
            "in mJ/mm³",
            "E/(100·D) mJ/mm³",
        ],
    ),
    (
        "0.05\n",
        "0.05\ncritical_dose_mj_per_mm3 = 0.8\n[schedule]\noptimize = \"frozen\"\n",
        "optimize",
        &[
            "schedule.optimize",
            "no network has an inhibitor: there is nothing to freeze",
        ],
    ),
    (
        "[stop]",
        "[schedule]\noptimize = \"frozen\"\n[[material.photopolymer.networks]]\nname = \"resin\"\n\
         curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }\ninhibitors = [{ initial = { even = 0.0 }, diffusion_mm2_per_s = 1e-4 }]\n[stop]",
        "optimize",
        &["schedule.optimize", "0 from beginning to end"],
    ),
    (
        "[stop]",
        "[schedule]\nlevel_heights = true\n[[material.photopolymer.networks]]\nname = \"resin\"\n\
         curing = { rate_law = { rate_per_s = 1.0, exponent = 0.5, gel_conversion = 0.2 } }\n[stop]",
        "level_heights",
        &[
            "schedule.level_heights",
            "resin cures by a rate law with an exponent below 1",
            "a threshold of the dose",
        ],
    ),
    (
        "[stop]",
        "[schedule]\nstep_s = 1e-9\n[[material.photopolymer.networks]]\nname = \"resin\"\ncuring = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }\n[stop]",
        "step_s",
        &["schedule.step_s", "found 1e-9", "at most 1e7 steps"],
    ),
    (
        "[stop]",
        "[schedule]\nstep_s = 30.0\n[[material.photopolymer.networks]]\nname = \"resin\"\ncuring = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }\n\
         inhibitors = [{ diffusion_mm2_per_s = 1e-4 }]\n[stop]",
        "step_s",
        &[
            "schedule.step_s",
            "found 30 s",
            "stable up to 16.6667 s only",
            "\"spectral\"",
        ],
    ),
    (
        "[stop]",
        "[schedule]\n[[material.photopolymer.networks]]\nname = \"resin\"\ncuring = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }\n\
         inhibitors = [{ capacity_mj_per_mm3 = 0.0 }]\n[stop]",
        "capacity_mj_per_mm3 = 0.0",
        &[
            "networks[0].inhibitors[0].capacity_mj_per_mm3",
            "found 0",
            "above 0",
        ],
    ),
    (
        "[[light]]\n",
        "[[species]]\nname = \"soft\"\n[[species]]\nname = \"stiff\"\ndriven_by = { uv = 1.0 }\n[[light]]\nname = \"violet\"\n",
        "driven_by",
        &[
            "species[1].driven_by.uv",
            "no light has this name",
            "the name of a light: violet",
        ],
    ),
    (
        "[[light]]\n",
        "[[species]]\nname = \"soft\"\n[[species]]\nname = \"stiff\"\ndriven_by = {}\n[[light]]\nname = \"violet\"\n",
        "driven_by",
        &[
            "species[1].driven_by",
            "no light drives it",
            "a factor above 0",
        ],
    ),
    (
        "[stop]",
        "[printer]\nflat_field = \"none.png\"\n[stop]",
        "flat_field",
        &["printer.flat_field", "none.png"],
    ),
    (
        "[stop]",
        "[printer]\nrefresh_hz = 4.0\n[stop]",
        "refresh_hz",
        &["printer.refresh_hz", "5 frames a second", "at most 8 turns"],
    ),
    (
        "\"FOLDER\"",
        "\"FOLDER\"\nrpm = 900",
        "rpm",
        &["output.rpm", "450 frames a second", "at most 480 turns"],
    ),
    (
        "\"FOLDER\"",
        "\"FOLDER\"\nrpm = 0.01",
        "rpm",
        &["output.rpm", "0.005 frames a second", "at least 0.2 turns"],
    ),
    (
        "[stop]",
        "[printer]\ncopies_px = [[0, 0], [30, 0]]\n[stop]",
        "copies_px",
        &["printer.copies_px", "copies 1 and 2 overlap"],
    ),
    // Cells that the surface cuts, beside what knows whole voxels only
    (
        "upper = 0.95",
        "upper = 0.95\nsurface = \"cells\"\n\n[optimizer.osmo]",
        "surface",
        &[
            "objective.threshold.surface",
            "[optimizer.osmo]",
            "whole voxels",
        ],
    ),
    (
        "upper = 0.95",
        "upper = 0.95\nsurface = \"cells\"\n\n[model.parallel]",
        "surface",
        &[
            "objective.threshold.surface",
            "[model.parallel]",
            "whole voxels",
        ],
    ),
    (
        "[objective.threshold]\nlower = 0.85\nupper = 0.95",
        "[[objectives]]\nthreshold = { surface = \"cells\" }\n\n[[objectives]]\nl2 = {}",
        "l2",
        &["objectives[1].l2", "another objective has cells"],
    ),
    // What scatters, and what is beyond parallel light
    (
        "0.05",
        "0.05\nscattering_per_mm = -1.0",
        "scatt",
        &["resin.scattering_per_mm", "1/mm"],
    ),
    (
        "0.05",
        "0.05\nattenuation_per_mm = 0.1\nscattering_per_mm = 0.2",
        "atten",
        &["resin.attenuation_per_mm", "resin.scattering_per_mm"],
    ),
    (
        "0.05",
        "0.05\nphase.raleigh = {}",
        "phase",
        &["resin.phase.raleigh", "did you mean `rayleigh`?"],
    ),
    (
        "angles = 30",
        "angles = 30\noffset_mm = [0, 2000]",
        "offset_mm",
        &["light[0].offset_mm[1]", "-1000 to 1000"],
    ),
    (
        "angles = 30",
        "angles = 30\noffset_mm = [0, -0.9]",
        "offset_mm",
        &[
            "light[0].offset_mm",
            "the field reaches 0.3 mm along the axis",
            "a smaller offset",
        ],
    ),
    (
        "pixel_pitch_mm = 0.1",
        "pixel_pitch_mm = [0.1, 0]",
        "pixel_pitch",
        &["light[0].projector.collimated.pixel_pitch_mm[1]", "> 0"],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.columns = [40, 9]",
        "selection",
        &[
            "light[0].selection.columns",
            "found [40, 9], but there are 48",
        ],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.rows = [0, 14]",
        "selection",
        &[
            "light[0].selection",
            "the field reaches 0.2 mm along the axis",
        ],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.min_contribution = 1.5",
        "selection",
        &["light[0].selection.min_contribution", "0 to 0.999"],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.corner_radius_mm = 0.2",
        "selection",
        &[
            "light[0].selection.corner_radius_mm",
            "its outer wall has none",
        ],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.mask = \"none.png\"",
        "selection",
        &[
            "light[0].selection.mask",
            "none.png",
            "a file that can be read",
        ],
    ),
    (
        "[stop]",
        "[motion]\ntilt_deg = 95\n[stop]",
        "tilt",
        &["motion.tilt_deg", "-80 to 80"],
    ),
    (
        "[stop]",
        "[[obstacles]]\nmesh = \"none.stl\"\n[stop]",
        "mesh",
        &["obstacles[0].mesh", "none.stl"],
    ),
    (
        "[stop]",
        "[model.rays]\nrays_per_pixel = 0\n[stop]",
        "rays_per",
        &["model.rays.rays_per_pixel", "1 to 4096"],
    ),
    (
        "[stop]",
        "[model.successive_orders]\nrays_per_pixel = 5000\n[stop]",
        "rays_per",
        &["model.successive_orders.rays_per_pixel", "1 to 4096"],
    ),
    // A model that does not cover the optics
    (
        "[stop]",
        "[model.parallel]\n[motion]\ntilt_deg = 5\n[stop]",
        "[model.parallel]",
        &["model.parallel", "light is not normal to the axis"],
    ),
    (
        "0.05\n",
        "0.05\nscattering_per_mm = 0.2\n\n[model.rays]\n",
        "[model.rays]",
        &["model.rays", "the resin scatters", "[model.monte_carlo]"],
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
        &["a job file in TOML"],
    ),
];
