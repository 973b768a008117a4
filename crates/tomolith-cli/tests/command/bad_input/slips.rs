//! One slip each: a word or a number that is wrong by itself.

/// Read by [`slipped`](crate::bench::slipped).
pub(super) const WRONG: &str = r#"
# Names
- iterations = 2
+ iteratons = 2
stop.iteratons … did you mean `iterations`?

- [resin]
+ [resn]
resn … did you mean `resin`?

- [vial.cylinder]
+ [vial.cilinder]
vial.cilinder … did you mean `cylinder`? … index_matched

- phantom = "gear"
+ phantom = "gaer"
target.phantom … did you mean `gear`?

- projector.collimated = { pixel_pitch_mm = 0.1 }
+ projector.colimated = { pixel_pitch_mm = 0.1 }
light[0].projector.colimated … did you mean `collimated`?

- angles = 30
+ angles = { cuont = 30 }
light[0].angles.cuont … did you mean `count`?

  angles = 30
+ polarization = "q"
light[0].polarization … unpolarized, s, p

- absorption_per_mm = 0.05
+ penetration_depth_mm = 20.0
resin.penetration_depth_mm … 1/D per mm … did you mean `absorption_per_mm`?

# Types and units
- iterations = 2
+ iterations = -1
stop.iterations … a whole number, 0 or more

+ [vial]
+ surrounding_index = "air"
vial.surrounding_index: found "air" … a number

- pitch_mm = 0.1
+ pitch_mm = "0.1 kg"
grid.pitch_mm … unknown unit of length `kg` … nm, um, mm

- inner_radius_mm = 3.0
+ inner_radius_mm = true
vial.cylinder.inner_radius_mm … a length

- pixels = [48, 24]
+ pixels = [48]
light[0].pixels … a list of 2

# Numbers that cannot be
- absorption_per_mm = 0.05
+ absorption_per_mm = nan
resin.absorption_per_mm … a finite number

- absorption_per_mm = 0.05
+ absorption_per_mm = 0
resin.absorption_per_mm … found 0 … 1e-9 to 100 per mm … pure_radon

  outer_radius_mm = 3.5
- refractive_index = 1.5
+ refractive_index = 1e6
vial.cylinder.refractive_index … found 1000000 … 1 to 4

  size_mm = 2.0
+ offset_mm = [0, 0, 1.0]
target.offset_mm … passes the axis … middle lies nearer

+ [resources]
+ memory_gb = 0.001
grid.pitch_mm … MB needed, 1 MB available

- size_mm = 2.0
+ size_mm = -2.0
target.size_mm … -2

- inner_radius_mm = 3.0
+ inner_radius_mm = 3.5
vial.cylinder.inner_radius_mm … outer_radius_mm = 3.5

# Indices of a resin whose index changes
+ [resin.gradient]
+ quadratic_per_mm2 = 0.9
resin.gradient … 3 mm from the axis n² is 20.475 … from 1 to 4

+ [resin.gradient]
+ quadratic_per_mm2 = -0.08
resin.gradient … 3 mm from the axis n² is 0.63 … from 1 to 4

# Grids that cut the part
  pitch_mm = 0.1
+ shape = [10, 10, 10]
grid.shape … 10 × 10 × 10 voxels of 0.1 mm are 1 × 1 × 1 mm, but the part is 2 × 2 ×  …
% of its volume would be cut off … grid.clip = true

# Movies: what the job sets is at fault
+ [printer]
+ refresh_hz = 2
printer.refresh_hz … no device of 2 images a second shows … at least 5 images a second

- angles = 30
+ angles = 3000
light[0].angles … no device of 240 images a second … at most 1440 frames

# What is within a table of the vial
+ [vial.bottom]
+ thickness_mm = 1.0
vial.bottom.z_mm … the key is missing … for example z_mm = -10.0

# Numbers without thirty digits
+ [model.rays]
+ least_power = 1e30
model.rays.least_power: found 1e30

# Nothing would end the rays that walls split
+ [model.rays]
+ reflections = true
+ least_power = 0.0
model.rays.least_power: found 0 … 1e-9 to 0.1

- lower = 0.85
+ lower = 1e-30
+ ceiling = 1e-30
objective.threshold.ceiling: ceiling 1e-30 is below upper 0.95

# Bands
- lower = 0.85
+ lower = 0.95
objective.threshold.lower … 0.95

  upper = 0.95
+ ceiling = 0.9
objective.threshold.ceiling … 0.9

- [objective.threshold]
- lower = 0.85
- upper = 0.95
+ [objective.bclp]
+ epsilon = -0.1
objective.bclp.epsilon … -0.1

# Numbers with which no loss is a number
  upper = 0.95
+ exponent = 1e30
objective.threshold.exponent … at most 100

  upper = 0.95
+ ceiling = 1e38
objective.threshold.ceiling … -1e9 to 1e9

  upper = 0.95
+ part_weight = 1e300
objective.threshold.part_weight … 0 to 1e9

+ [objective]
+ weight = 1e300
objective.weight … 0 to 1e9

+ [response.logistic]
+ steepness = 1e30
response.logistic.steepness … at most 1e6

+ [checkpoint]
+ every_s = "often"
checkpoint.every_s … seconds above 0, or "auto"

# More than a machine holds
- pitch_mm = 0.1
+ pitch_mm = 0.0002
grid.pitch_mm … memory … MB needed … MB available

- pixels = [48, 24]
- angles = 30
+ pixels = [16000, 16000]
+ angles = 1400
light[0].pixels … memory … MB needed … fewer pixels or angles

# Responses and penalties
- [objective.threshold]
- lower = 0.85
- upper = 0.95
+ [objective.pm]
+ d_h = 1.4
+ d_l = 0.7
+ [response.logistic]
+ upper = 1.0
objective.pm … 1.4 … lies outside the response's range

+ [response.table]
+ dose = [0, 1, 2]
+ response = [0.0, 0.6, 0.5]
response.table.response[2] … 0.5 after 0.6 … falls

+ [response.logistic]
+ upper = 0.97
response: the start needs a dose with the response 1, but no dose gives it … from 0 to 0.97 …
[start.zero], [start.patterns]

+ [response.fit]
+ dose = [0, 1, 2, 3, 4, 5]
+ response = [0.9, 0.8, 0.6, 0.5, 0.3, 0.1]
response.fit.response … falls with dose … 0.9 to 0.1

+ [response.fit]
+ form = "table"
+ dose = [0, 1, 2]
+ response = [0.9, 0.6, 0.1]
response.fit.response … falls with dose … 0.9 to 0.1

+ [response.logistic]
+ lower = 1.0
+ upper = 0.2
response.logistic.lower … lower 1 is not below upper 0.2

+ [response.logistic]
+ [evaluate]
+ threshold = 1.5
evaluate.threshold … found 1.5 … goes from 0 to 1

  absorption_per_mm = 0.05
+ critical_dose_mj_per_mm3 = 0.8
+ [response.logistic]
+ upper = 0.5
+ [objective.response.identity]
+ [start.zero]
+ [printer]
+ time_s = 60.0
+ peak_irradiance_mw_per_cm2 = 5.0
printer.time_s … solid at 0.900 … from 0 to 0.5

# Lengths beyond all measure are told in a few digits
- size_mm = 2.0
+ size_mm = 1e300
target … reaches 5e299 mm from the axis

- inner_radius_mm = 3.0
+ inner_radius_mm = 1e300
vial.cylinder.inner_radius_mm: found 1e300 mm, not smaller than outer_radius_mm = 3.5 mm

# Syntax
  iterations = 2
+ iterations = 3
duplicate key

- iterations = 2
+ iterations =
TOML, with each key once
"#;
