//! One slip each: words and numbers that do not go with the rest of the job.

use super::slips::Wrong;

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
        &["bounds.bits", "found 0", "bits, 1 to 16"],
    ),
    (
        "[stop]",
        "[bounds]\nbits = 17\n[stop]",
        "bits",
        &["bounds.bits", "found 17", "bits, 1 to 16"],
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
        &["light[0].pixels", "heights of -0.2 to 0.2 mm", "10 rows"],
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
            "stable up to 16.666 s only",
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
            "light passes the axis at heights of -2.1 to 0.3 mm",
            "light[0].offset_mm = [0, 0]",
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
    // Light from above that the vial lifts over the part
    (
        "[stop]",
        "[motion]\ntilt_deg = 50\n[stop]",
        "[[light]]",
        &[
            "light[0].offset_mm",
            "the axis is tilted by 50°, and light bends at the walls",
            "light[0].offset_mm = [0, -",
        ],
    ),
    (
        "angles = 30",
        "angles = 30\nselection.rows = [0, 14]",
        "selection",
        &[
            "light[0].selection",
            "heights of -0.2 to 1.2 mm",
            "may be lit up to the edge",
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
];
