//! Small pictures for the page: color maps, and PNG files inside of the HTML.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use tomolith_core::parallel::table;

/// Red, green, blue, opacity.
pub(super) type Color = [u8; 4];

/// Anchors of the color map viridis (matplotlib, CC0), evenly spaced.
const VIRIDIS: [u32; 11] = [
    0x0044_0154,
    0x0048_2475,
    0x0041_4487,
    0x0035_5f8d,
    0x002a_788e,
    0x0021_918c,
    0x0022_a884,
    0x0044_bf70,
    0x007a_d151,
    0x00bd_df26,
    0x00fd_e725,
];
/// A color map for doses.
pub(super) fn viridis(t: f64) -> Color {
    let place = t.clamp(0.0, 1.0) * 10.0;
    let i = (place as usize).min(9);
    let f = place - i as f64;
    let channel = |shift: u32| {
        let at = |i: usize| f64::from(VIRIDIS[i] >> shift & 0xff);
        (at(i) + f * (at(i + 1) - at(i))).round() as u8
    };
    [channel(16), channel(8), channel(0), 255]
}

/// An image of palette indices, row 0 on top.
pub(super) struct Picture {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) pixels: Vec<u8>,
}

impl Picture {
    /// Fills an image pixel by pixel: `index(column, row)`.
    pub(super) fn new(
        width: usize,
        height: usize,
        index: impl Fn(usize, usize) -> u8 + Sync,
    ) -> Self {
        let pixels = table(width * height, |i| index(i % width, i / width));
        Picture {
            width,
            height,
            pixels,
        }
    }

    /// As a PNG in a `data:` address; empty when there is no pixel or the encoder refuses.
    pub(super) fn data_uri(&self, palette: &[Color]) -> String {
        match self.png(palette) {
            Ok(bytes) => format!("data:image/png;base64,{}", STANDARD.encode(bytes)),
            Err(_) => String::from("data:,"),
        }
    }

    fn png(&self, palette: &[Color]) -> Result<Vec<u8>, png::EncodingError> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, self.width as u32, self.height as u32);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::Eight);
        let colors: Vec<u8> = palette.iter().flat_map(|c| [c[0], c[1], c[2]]).collect();
        encoder.set_palette(colors);
        encoder.set_trns(palette.iter().map(|c| c[3]).collect::<Vec<u8>>());
        // Neighboring indices are no neighboring numbers: prediction does not help
        encoder.set_filter(png::Filter::NoFilter);
        encoder.set_compression(png::Compression::High);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&self.pixels)?;
        writer.finish()?;
        Ok(bytes)
    }
}

/// `#rrggbb`.
pub(super) fn hex(color: Color) -> String {
    let [red, green, blue, _] = color;
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_comes_back_with_its_colors() {
        let picture = Picture::new(3, 2, |x, y| (x + 3 * y) as u8);
        let palette: Vec<Color> = (0..6)
            .map(|i| [i * 40, 255 - i * 40, 7, if i == 0 { 0 } else { 255 }])
            .collect();
        let bytes = picture.png(&palette).unwrap();
        let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, palette.as_flattened());
    }

    #[test]
    fn the_color_map_runs_from_dark_to_bright() {
        let light = |t| viridis(t)[..3].iter().map(|&c| u32::from(c)).sum::<u32>();
        assert!((0..20).all(|i| light(f64::from(i) / 20.0) < light(f64::from(i + 1) / 20.0) + 12));
        assert!(light(0.0) < 170 && light(1.0) > 450);
        assert_eq!((viridis(-1.0), viridis(9.0)), (viridis(0.0), viridis(1.0)));
        assert_eq!(hex(viridis(0.0)), "#440154");
    }
}
