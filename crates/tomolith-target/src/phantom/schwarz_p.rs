//! A cube of Schwarz's P surface: two cubic lattices of tubes that meet in every cell.
//!
//! g = cos kx + cos ky + cos kz, see [`wall`](super::wall). |∇g| lies between k and √3·k on the surface, 1.312·k in the
//! (harmonic) mean: the wall is 0.76 to 1.31 of `wall_mm` from place to place.
//!
//! ```
//! use tomolith_core::kind::Section;
//! use tomolith_target::{Placement, Shape, phantom::Phantom};
//! let section = Section::new("target.phantom", serde_json::json!("schwarz_p"));
//! let cube = Phantom::build(&section, &Placement::default(), "target").unwrap();
//! assert_eq!(cube.bounds_mm(), [[-2.5; 3], [2.5; 3]]); // 5 mm edges
//! assert_eq!(cube.volume_mm3(), None); // no closed form
//! ```

use super::BuildForm;
use super::wall::{self, Waves};
use tomolith_core::kind::{Kind, schema_of};

pub(super) const KIND: Kind<BuildForm> = Kind {
    name: "schwarz_p",
    summary: "A cube of Schwarz's P surface: a wall between two cubic lattices of tubes",
    example: "[target]\nphantom.schwarz_p = { size_mm = 5.0, cells = 2, wall_mm = 0.5 }",
    schema: schema_of::<wall::Params>,
    build: |section| wall::build(section, &SCHWARZ_P),
};

static SCHWARZ_P: Waves = Waves {
    field: |[(_, cx), (_, cy), (_, cz)]| cx + cy + cz,
    steepest: 1.732_050_807_568_877_2,
    mean_slope: 1.3125,
    thickest: 0.2,
};
