//! A cube of Schwarz's D surface, the diamond: two labyrinths, each with the bonds of diamond.
//!
//! g = cos kx·cos ky·cos kz − sin kx·sin ky·sin kz, see [`wall`](super::wall). |∇g| lies between k and √1.5·k on the
//! surface, 1.055·k in the (harmonic) mean: the wall is 0.86 to 1.06 of `wall_mm` from place to place.

use super::BuildForm;
use super::wall::{self, Waves};
use tomolith_core::kind::{Kind, schema_of};

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "diamond",
    summary: "A cube of Schwarz's D surface, the diamond: a wall between two labyrinths",
    example: "[target]\nphantom.diamond = { size_mm = 5.0, cells = 2, wall_mm = 0.3 }",
    schema: schema_of::<wall::Params>,
    build: |section| wall::build(section, &DIAMOND),
};

static DIAMOND: Waves = Waves {
    field: |[(sx, cx), (sy, cy), (sz, cz)]| cx * cy * cz - sx * sy * sz,
    steepest: 1.224_744_871_391_589,
    mean_slope: 1.0553,
    thickest: 0.125,
};
