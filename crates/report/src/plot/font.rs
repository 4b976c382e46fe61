//! The outlines of texts in the font that is built in: no font of the machine is used.

use super::error::PictureError;
use super::shape::Span;
use tiny_skia::{Path, PathBuilder};
use ttf_parser::{Face, OutlineBuilder};

/// DejaVu Sans, reduced to Latin, Greek and mathematical letters; its licence is in `assets/`.
const FONT: &[u8] = include_bytes!("../../assets/DejaVuSans-subset.ttf");

pub(super) struct Font(Face<'static>);

impl Font {
    pub fn new() -> Result<Self, PictureError> {
        Face::parse(FONT, 0).map(Font).map_err(|error| PictureError::Font(error.to_string()))
    }

    /// The letters from the origin to the right, if there is anything to see, and the width of the text.
    pub fn outline(&self, spans: &[Span], size: f32) -> (Option<Path>, f32) {
        let mut pen = Pen { path: PathBuilder::new(), x: 0.0, y: 0.0, unit: 0.0 };
        for span in spans {
            let (up, own) = span.level.shift();
            let size = own.map_or(size, |own| own as f32);
            (pen.y, pen.unit) = (-up as f32, size / f32::from(self.0.units_per_em()));
            for letter in span.text.chars() {
                // What the font lacks is shown as a box.
                let glyph = self.0.glyph_index(letter).unwrap_or_default();
                self.0.outline_glyph(glyph, &mut pen);
                pen.x += pen.unit * f32::from(self.0.glyph_hor_advance(glyph).unwrap_or(0));
            }
        }
        (pen.path.finish(), pen.x)
    }
}

/// Draws a letter, given in units of the font with y upwards, where the pen stands.
struct Pen {
    path: PathBuilder,
    x: f32,
    y: f32,
    unit: f32,
}

impl Pen {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (self.x + self.unit * x, self.y - self.unit * y)
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2), (x, y)) = (self.at(x1, y1), self.at(x2, y2), self.at(x, y));
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}
