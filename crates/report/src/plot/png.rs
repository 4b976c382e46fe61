//! From a drawing in SVG to a PNG, with the font that is built in: no font of the machine is used.

use resvg::{tiny_skia, usvg};

/// Why a picture could not be made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the picture could not be rendered: {0}")]
pub struct PictureError(String);

/// DejaVu Sans, reduced to Latin, Greek and mathematical letters; its licence is in `assets/`.
const FONT: &[u8] = include_bytes!("../../../../assets/DejaVuSans-subset.ttf");

/// Renders an SVG document at twice its size.
///
/// # Errors
/// [`PictureError`].
pub(super) fn svg_to_png(svg: &str) -> Result<Vec<u8>, PictureError> {
    const SCALE: f32 = 2.0;
    let refuse = |what: String| PictureError(what);
    let mut options = usvg::Options { font_family: "DejaVu Sans".to_string(), ..Default::default() };
    options.fontdb_mut().load_font_data(FONT.to_vec());
    options.fontdb_mut().set_sans_serif_family("DejaVu Sans");
    let tree = usvg::Tree::from_str(svg, &options).map_err(|error| refuse(error.to_string()))?;
    let size = tree.size().to_int_size();
    let (width, height) = (size.width() * SCALE as u32, size.height() * SCALE as u32);
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or_else(|| refuse("it has no size".to_string()))?;
    pixels.fill(tiny_skia::Color::WHITE);
    resvg::render(&tree, tiny_skia::Transform::from_scale(SCALE, SCALE), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| refuse(error.to_string()))
}
