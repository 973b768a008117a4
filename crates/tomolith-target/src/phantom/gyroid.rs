//! A cube of gyroid: a curved wall that splits space into two labyrinths.
//!
//! g = sin kx·cos ky + sin ky·cos kz + sin kz·cos kx, see [`wall`](super::wall). |∇g| lies between √2·k and √3·k on the
//! surface, 1.53·k in the (harmonic) mean: the wall is 0.88 to 1.08 of `wall_mm` from place to place. The test of
//! TVAM AID's section 3.4 has 2 × 2 × 2 cells (Pellizzon 2025); its wall is not given.

use super::BuildForm;
use super::wall::{self, Waves};
use tomolith_core::kind::{Kind, schema_of};

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "gyroid",
    summary: "A cube of gyroid: a curved wall that splits space into two labyrinths",
    example: "[target]\nphantom.gyroid = { size_mm = 5.0, cells = 2, wall_mm = 0.5 }",
    schema: schema_of::<wall::Params>,
    build: |section| wall::build(section, &GYROID),
};

static GYROID: Waves = Waves {
    field: |[(sx, cx), (sy, cy), (sz, cz)]| sx * cy + sy * cz + sz * cx,
    steepest: 1.732_050_807_568_877_2,
    mean_slope: 1.5293,
    thickest: 0.2,
};
