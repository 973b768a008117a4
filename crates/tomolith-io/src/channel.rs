//! Light in one channel of color images, as machines need it that use one color of a projector.
//!
//! [`Channel::color`] makes colors of a gray level, `gray_of` levels of colors. It takes the channel that is asked for;
//! else the only one that is lit; and of gray pixels (r = g = b) their gray. An image lit in several channels is refused where
//! none is asked for, as nothing says which of them reach the resin.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt;

/// A channel of color images.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Channel {
    /// The first of three numbers.
    Red,
    /// The second.
    Green,
    /// The third.
    Blue,
}

impl Channel {
    /// Every channel, in the order of a pixel's numbers.
    pub const ALL: [Self; 3] = [Channel::Red, Channel::Green, Channel::Blue];

    /// Its name in a job.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Channel::Red => "red",
            Channel::Green => "green",
            Channel::Blue => "blue",
        }
    }

    /// The pixel `[red, green, blue]` that has a level here and is dark elsewhere.
    #[must_use]
    pub fn color(self, level: u16) -> [u16; 3] {
        Channel::ALL.map(|channel| if channel == self { level } else { 0 })
    }
}

/// Where the light of an image is, unless every pixel is black.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lit {
    /// Evenly in all channels.
    Gray,
    /// In the channel that was taken.
    In(Channel),
    /// Only in others than the channel that was asked for.
    Without(Channel),
}

impl fmt::Display for Lit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Lit::Gray => f.write_str("gray light"),
            Lit::In(channel) => write!(f, "{} light", channel.name()),
            Lit::Without(channel) => write!(f, "light, but none of it {}", channel.name()),
        }
    }
}

/// The levels of interleaved pixels of so many samples each (gray, gray and opacity, RGB, or RGB and opacity), and where
/// their light is; opacity does not count.
///
/// # Errors
/// The channels that are lit, and the first colored pixel, where nothing says which channel counts.
pub(crate) fn gray_of(
    numbers: &[u16],
    samples: usize,
    asked: Option<Channel>,
) -> Result<(Vec<u16>, Option<Lit>), (String, usize)> {
    let pixels = numbers.chunks_exact(samples);
    let level_in = |channel: Channel| -> Vec<u16> {
        let at = if samples < 3 { 0 } else { channel as usize };
        pixels.clone().map(|pixel| pixel[at]).collect()
    };
    let is_colored = |pixel: &[u16]| samples >= 3 && pixel[..3] != [pixel[0]; 3];
    let is_lit = |levels: &[u16]| levels.iter().any(|level| *level > 0);
    let colored = pixels.clone().position(is_colored);
    if let (Some(asked), Some(_)) = (asked, colored) {
        let levels = level_in(asked);
        let lit = if is_lit(&levels) {
            Lit::In(asked)
        } else {
            Lit::Without(asked)
        };
        return Ok((levels, Some(lit)));
    }
    let Some(at) = colored else {
        let levels = level_in(Channel::Red);
        let lit = is_lit(&levels).then(|| asked.map_or(Lit::Gray, Lit::In));
        return Ok((levels, lit));
    };
    let all = Channel::ALL.map(|channel| (channel, level_in(channel)));
    let lit = all.into_iter().filter(|(_, levels)| is_lit(levels));
    match <[_; 1]>::try_from(lit.collect::<Vec<_>>()) {
        Ok([(only, levels)]) => Ok((levels, Some(Lit::In(only)))),
        Err(lit) => {
            let names: Vec<&str> = lit.iter().map(|(channel, _)| channel.name()).collect();
            Err((names.join(" and "), at))
        }
    }
}
