//! One slip each: words and numbers that do not go with the rest of the job.

/// Read by [`slipped`](crate::bench::slipped).
pub(super) const WRONG: &str = r#"
# Waves
+ [model.wave]
model.wave … this vial refracts or has walls … index_matched

- [vial.cylinder]
- inner_radius_mm = 3.0
- outer_radius_mm = 3.5
- refractive_index = 1.5
+ [model.wave]
+ numerical_aperture = 0.1
+ [vial.index_matched]
+ radius_mm = 3.0
model.wave.numerical_aperture … pixels of 0.1 mm make at most 0.00286 … at most 0.002864 mm

- [vial.cylinder]
- inner_radius_mm = 3.0
- outer_radius_mm = 3.5
- refractive_index = 1.5
+ [model.wave]
+ relative_error = 0.5
+ [vial.index_matched]
+ radius_mm = 3.0
model.wave.relative_error … 1e-6 to 0.1

- [vial.cylinder]
- inner_radius_mm = 3.0
- outer_radius_mm = 3.5
- refractive_index = 1.5
+ [model.wave]
+ rings = 3
+ [vial.index_matched]
+ radius_mm = 3.0
model.wave.rings … found 3 … `etendue_deg` above 0

- [vial.cylinder]
- inner_radius_mm = 3.0
- outer_radius_mm = 3.5
- refractive_index = 1.5
+ [model.wave]
+ numerical_aperture = 1e-5
+ [vial.index_matched]
+ radius_mm = 3.0
model.wave.numerical_aperture … spots wider than the image of 2.4 mm … at least 8.4375e-5

- [vial.cylinder]
- inner_radius_mm = 3.0
- outer_radius_mm = 3.5
- refractive_index = 1.5
+ [model.wave]
+ [optimizer.fista]
+ [vial.index_matched]
+ radius_mm = 3.0
optimizer.fista: cannot be combined with waves … accepted: lbfgs, gradient, adam, pm, bclp

# Methods and what they cannot have
+ [optimizer.lbfgs]
+ filter = "hann"
optimizer.lbfgs.filter … `lbfgs` has no `filter`, these have: … optimizer.osmo … optimizer.cal …
start.fbp

+ [start.zero]
+ filter = "hann"
start.zero.filter … nothing: this table has no keys … start.fbp

+ [start.patterns]
+ file = "x.npz"
+ bounds_as = { lsqr = { iterations = 0 } }
start.patterns.bounds_as.lsqr.iterations … 1 to 1000

+ [optimizer.osmo]
+ filter = "ramlak"
optimizer.osmo.filter … did you mean `ram_lak`?

+ [bounds]
+ bits = 8
bounds.bits … optimizer.lbfgs with rounding in every step

+ [optimizer.fista]
+ [response.logistic]
optimizer.fista … not convex together … accepted: lbfgs

- [objective.threshold]
- lower = 0.85
- upper = 0.95
+ [optimizer.osmo]
+ [objective.l2]
optimizer.osmo … allows no dose at all in the void … in the end all light …
accepted: lbfgs, gradient, fista

+ [optimizer.osmo]
+ [[penalties]]
+ weight = 1.0
+ sparsity = { exponent = 2 }
penalties[0] … optimizer.osmo with penalties

# What is missing or has no meaning here
+ [evaluate]
+ require_in_band = 0.9
evaluate.require_in_band … part and void … require_iou

+ [[penalties]]
+ sparsity = { exponent = 2 }
penalties[0].weight … missing

- absorption_per_mm = 0.05
resin.absorption_per_mm … the key is missing … pure_radon

- [[light]]
+ [light]
light … found a table … a list, whose tables are written [[light]]

# Light that is gone before it comes to the part
- absorption_per_mm = 0.05
+ absorption_per_mm = 90
light … no light meets the target … absorption_per_mm

# A plate of a fifth of a voxel
- phantom = "gear"
- size_mm = 2.0
+ phantom = { cylinder = { size_mm = 2.0, height_mm = 0.02 } }
target … no voxel of the grid is half filled by the target … a smaller grid.pitch_mm

# What does not fit
- size_mm = 2.0
+ size_mm = 9.0
target … reaches 4.5 … the resin ends at 3

- size_mm = 2.0
+ size_mm = 9.123456789012345
target … reaches 4.56173 mm from the axis

- pixels = [48, 24]
+ pixels = [12, 24]
light[0].pixels … sideways

- pixels = [48, 24]
+ pixels = [48, 4]
light[0].pixels … heights of -0.2 to 0.2 mm … 10 rows

# The machine
+ [printer]
+ rpm = 3
printer.rpm … unknown name

+ [printer]
+ canvas = [40, 60]
printer.canvas … need 48 × 24 … at least [48, 24]

+ [printer]
+ gray_curve = [[0.0, 0.0], [0.5, 0.7], [1.0, 0.6]]
printer.gray_curve … not monotone … usable from value 0 to 0.5 … `tomolith calibrate gray`

+ [printer]
+ gray_curve = [[0.0, -0.2], [0.5, 0.2], [1.0, 0.6]]
printer.gray_curve … an intensity of -0.2 … usable from value 0.5 to 1

# Doses and the print in time
  absorption_per_mm = 0.05
+ critical_dose_mj_per_cm2 = 80
resin.critical_dose_mj_per_cm2 … a dose per area, and one per volume is meant … E/(100·D) mJ/mm³ …
did you mean `critical_dose_mj_per_mm3`

  absorption_per_mm = 0.05
+ critical_dose_mj_per_mm3 = "80 mJ/cm2"
resin.critical_dose_mj_per_mm3 … found "80 mJ/cm2" … in mJ/mm³ … E/(100·D) mJ/mm³

  absorption_per_mm = 0.05
+ critical_dose_mj_per_mm3 = 0.8
+ [schedule]
+ optimize = "frozen"
schedule.optimize … no network has an inhibitor: there is nothing to freeze

+ [schedule]
+ optimize = "frozen"
+ [[material.photopolymer.networks]]
+ name = "resin"
+ curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }
+ inhibitors = [{ initial = { even = 0.0 }, diffusion_mm2_per_s = 1e-4 }]
schedule.optimize … 0 from beginning to end

+ [schedule]
+ level_heights = true
+ [[material.photopolymer.networks]]
+ name = "resin"
+ curing = { rate_law = { rate_per_s = 1.0, exponent = 0.5, gel_conversion = 0.2 } }
schedule.level_heights … resin cures by a rate law with an exponent below 1 …
a threshold of the dose

+ [schedule]
+ step_s = 1e-9
+ [[material.photopolymer.networks]]
+ name = "resin"
+ curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }
schedule.step_s … found 1e-9 … at most 1e7 steps

+ [schedule]
+ step_s = 30.0
+ [[material.photopolymer.networks]]
+ name = "resin"
+ curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }
+ inhibitors = [{ diffusion_mm2_per_s = 1e-4 }]
schedule.step_s … found 30 s … stable up to 16.666 s only … "spectral"

+ [schedule]
+ [[material.photopolymer.networks]]
+ name = "resin"
+ curing = { threshold = { critical_dose_mj_per_mm3 = 0.4 } }
+ inhibitors = [{ capacity_mj_per_mm3 = 0.0 }]
networks[0].inhibitors[0].capacity_mj_per_mm3 … found 0 … above 0

- [[light]]
+ [[species]]
+ name = "soft"
+ [[species]]
+ name = "stiff"
+ driven_by = { uv = 1.0 }
+ [[light]]
+ name = "violet"
species[1].driven_by.uv … no light has this name … the name of a light: violet

+ [[species]]
+ name = "soft"
+ [[species]]
+ name = "stiff"
+ [[property]]
+ name = "modulus"
+ map = { logistic = {} }
property[0].of … the key is missing … one of soft, stiff

- [[light]]
+ [[species]]
+ name = "soft"
+ [[species]]
+ name = "stiff"
+ driven_by = {}
+ [[light]]
+ name = "violet"
species[1].driven_by … no light drives it … a factor above 0

+ [printer]
+ flat_field = "none.png"
printer.flat_field … none.png

+ [printer]
+ refresh_hz = 4.0
printer.refresh_hz … 5 frames a second … at most 8 turns

  folder = "FOLDER"
+ rpm = 900
output.rpm … 450 frames a second … at most 480 turns

  folder = "FOLDER"
+ rpm = 0.01
output.rpm … 0.005 frames a second … at least 0.2 turns

+ [printer]
+ copies_px = [[0, 0], [30, 0]]
printer.copies_px … copies 1 and 2 overlap

# Cells that the surface cuts, beside what knows whole voxels only
  upper = 0.95
+ surface = "cells"
+ [optimizer.osmo]
objective.threshold.surface … [optimizer.osmo] … whole voxels

  upper = 0.95
+ surface = "cells"
+ [model.parallel]
objective.threshold.surface … [model.parallel] … whole voxels

- [objective.threshold]
- lower = 0.85
- upper = 0.95
+ [[objectives]]
+ threshold = { surface = "cells" }
+ [[objectives]]
+ l2 = {}
objectives[1].l2 … another objective has cells

# What scatters, and what is beyond parallel light
  absorption_per_mm = 0.05
+ attenuation_per_mm = 0.1
+ scattering_per_mm = 0.2
resin.attenuation_per_mm … resin.scattering_per_mm

  absorption_per_mm = 0.05
+ phase.raleigh = {}
resin.phase.raleigh … did you mean `rayleigh`?

  angles = 30
+ offset_mm = [0, 2000]
light[0].offset_mm[1] … -1000 to 1000

  angles = 30
+ offset_mm = [0, -0.9]
light[0].offset_mm … light passes the axis at heights of -2.1 to 0.3 mm …
light[0].offset_mm = [0, 0]

- projector.collimated = { pixel_pitch_mm = 0.1 }
+ projector.collimated = { pixel_pitch_mm = [0.1, 0] }
light[0].projector.collimated.pixel_pitch_mm[1] … > 0

  angles = 30
+ selection.columns = [40, 9]
light[0].selection.columns … found [40, 9], but there are 48

# Light from above that the vial lifts over the part
+ [motion]
+ tilt_deg = 50
light[0].offset_mm … the axis is tilted by 50°, and light bends at the walls …
light[0].offset_mm = [0, -

  angles = 30
+ selection.rows = [0, 14]
light[0].selection … heights of -0.2 to 1.2 mm … may be lit up to the edge

  angles = 30
+ selection.min_contribution = 1.5
light[0].selection.min_contribution … 0 to 0.999

  angles = 30
+ selection.corner_radius_mm = 0.2
light[0].selection.corner_radius_mm … its outer wall has none

  angles = 30
+ selection.mask = "none.png"
light[0].selection.mask … none.png … a file that can be read

+ [motion]
+ tilt_deg = 95
motion.tilt_deg … -80 to 80

+ [[obstacles]]
+ mesh = "none.stl"
obstacles[0].mesh … none.stl

+ [model.rays]
+ rays_per_pixel = 0
model.rays.rays_per_pixel … 1 to 4096

+ [model.successive_orders]
+ rays_per_pixel = 5000
model.successive_orders.rays_per_pixel … 1 to 4096

# A model that does not cover the optics
+ [model.parallel]
+ [motion]
+ tilt_deg = 5
model.parallel … light is not normal to the axis

  absorption_per_mm = 0.05
+ scattering_per_mm = 0.2
+ [model.rays]
model.rays … the resin scatters … [model.monte_carlo]
"#;
