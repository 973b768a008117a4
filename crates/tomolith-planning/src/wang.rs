//! Published measurements of a dual-color printer and its resin.
//!
//! **Source** Wang et al., Nat. Commun. 13 (2022) 367, supplement (open access, CC BY): Notes 1, Tables 1 and 2.

/// Gray value and irradiance of the visible projector (455 nm), mW/cm². Gray 77 and 51 were not measured.
pub const GRAY_VISIBLE: [[f64; 2]; 7] = [
    [255.0, 4.62],
    [230.0, 4.53],
    [204.0, 4.43],
    [179.0, 4.15],
    [153.0, 3.11],
    [128.0, 1.98],
    [102.0, 1.04],
];

/// Gray value and irradiance of the UV projector (365 nm), mW/cm².
pub const GRAY_UV: [[f64; 2]; 9] = [
    [255.0, 32.53],
    [230.0, 29.40],
    [204.0, 26.27],
    [179.0, 22.89],
    [153.0, 19.28],
    [128.0, 16.39],
    [102.0, 12.77],
    [77.0, 9.64],
    [51.0, 6.51],
];

/// Gray value, time until a ball is seen (s), delivered light (J) in UV. The last dose is printed illegibly (0.30, 0.37 or 0.39): the area of the
/// others predicts 0.388.
pub const BALLS_UV: [[f64; 3]; 6] = [
    [255.0, 360.0, 0.48],
    [230.0, 365.0, 0.45],
    [204.0, 365.0, 0.40],
    [179.0, 390.0, 0.37],
    [153.0, 450.0, 0.36],
    [128.0, 570.0, 0.39],
];

/// The same in visible light; at gray 128 no ball was seen within 30 minutes.
pub const BALLS_VISIBLE: [[f64; 3]; 5] = [
    [255.0, 1260.0, 0.24],
    [230.0, 1260.0, 0.24],
    [204.0, 1260.0, 0.23],
    [179.0, 1300.0, 0.22],
    [153.0, 1740.0, 0.22],
];

/// Compressive modulus by indentation: x and y (mm), modulus and its standard deviation (MPa) on a part whose grades run along x + y.
pub const STIFFNESS: [[f64; 4]; 27] = [
    [0.5, 0.5, 3.4, 0.7],
    [1.4, 1.4, 5.5, 1.1],
    [2.3, 2.3, 6.5, 1.4],
    [3.2, 3.2, 4.4, 1.1],
    [4.0, 4.0, 6.8, 1.4],
    [4.8, 4.8, 9.4, 1.9],
    [5.7, 5.7, 252.0, 110.0],
    [6.6, 6.6, 8522.0, 6332.0],
    [7.5, 7.5, 7728.0, 7506.0],
    [1.4, 3.2, 3.9, 0.9],
    [3.2, 1.4, 4.8, 0.9],
    [1.4, 5.0, 5.1, 1.4],
    [2.3, 4.1, 5.4, 1.5],
    [4.1, 2.3, 5.4, 1.2],
    [5.0, 1.4, 4.4, 0.9],
    [1.4, 6.6, 5.4, 1.1],
    [2.3, 5.7, 6.2, 1.2],
    [3.2, 4.8, 5.2, 1.0],
    [4.8, 3.2, 5.8, 1.8],
    [5.7, 2.3, 5.8, 1.4],
    [6.6, 1.4, 6.5, 1.7],
    [3.0, 6.6, 9.1, 2.0],
    [3.9, 5.7, 21.4, 5.7],
    [5.7, 3.9, 8.0, 1.9],
    [6.6, 3.0, 9.2, 2.5],
    [4.8, 6.6, 1190.0, 607.0],
    [6.6, 4.8, 980.0, 775.0],
];
