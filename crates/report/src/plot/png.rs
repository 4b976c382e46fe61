//! From shapes to a PNG.

use super::Colour;
use super::error::PictureError;
use super::font::Font;
use super::shape::{Anchor, Fill, Outline, Rectangle, Shape, Sheet, Step, Stroke, Text};
use tiny_skia::{Color, FillRule, LineJoin, Mask, Paint, Path, PathBuilder, Pixmap, Rect, StrokeDash, Transform};

/// Pixels of the PNG for each of the sheet.
const SCALE: u32 = 2;

/// Renders the sheet at twice its size.
///
/// # Errors
/// [`PictureError`].
pub(super) fn png(sheet: &Sheet) -> Result<Vec<u8>, PictureError> {
    let pixels = |length: f64| (length.ceil() as u32).saturating_mul(SCALE);
    let (width, height) = (pixels(sheet.width), pixels(sheet.height));
    let mut canvas = Pixmap::new(width, height).ok_or(PictureError::Size { width, height })?;
    canvas.fill(Color::WHITE);
    let mut painter = Painter { canvas, scale: Transform::from_scale(SCALE as f32, SCALE as f32), font: Font::new()? };
    painter.draw_all(&sheet.shapes, None)?;
    painter.canvas.encode_png().map_err(|error| PictureError::Writing(error.to_string()))
}

struct Painter {
    canvas: Pixmap,
    /// From the sheet to pixels.
    scale: Transform,
    font: Font,
}

impl Painter {
    fn draw_all(&mut self, shapes: &[Shape], mask: Option<&Mask>) -> Result<(), PictureError> {
        for shape in shapes {
            match shape {
                Shape::Drawn { outline, fill, stroke } => self.draw(outline, *fill, *stroke, mask)?,
                Shape::Text(text) => self.write(text, mask),
                Shape::Clipped { window, shapes } => {
                    let mask = self.mask(window)?;
                    self.draw_all(shapes, Some(&mask))?;
                }
            }
        }
        Ok(())
    }

    fn draw(
        &mut self,
        outline: &Outline,
        fill: Option<Fill>,
        stroke: Option<Stroke>,
        mask: Option<&Mask>,
    ) -> Result<(), PictureError> {
        let Some(path) = path(outline) else { return Ok(()) };
        if let Some(Fill { colour, opacity }) = fill {
            self.canvas.fill_path(&path, &paint(colour, opacity)?, FillRule::Winding, self.scale, mask);
        }
        if let Some(Stroke { colour, width, dashes }) = stroke {
            let pen = tiny_skia::Stroke {
                width: width as f32,
                line_join: if matches!(outline, Outline::Path(_)) { LineJoin::Round } else { LineJoin::Miter },
                // No dashes are no pattern.
                dash: StrokeDash::new(dashes.iter().map(|length| *length as f32).collect(), 0.0),
                ..tiny_skia::Stroke::default()
            };
            self.canvas.stroke_path(&path, &paint(colour, 1.0)?, &pen, self.scale, mask);
        }
        Ok(())
    }

    fn write(&mut self, text: &Text, mask: Option<&Mask>) {
        let (letters, width) = self.font.outline(&text.spans, text.size as f32);
        let Some(letters) = letters else { return };
        let before = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * width,
            Anchor::End => width,
        };
        let place = self.scale.pre_translate(text.at.0 as f32, text.at.1 as f32);
        let place = place.pre_rotate(if text.turned { -90.0 } else { 0.0 }).pre_translate(-before, 0.0);
        let mut ink = Paint::default();
        ink.set_color(if text.faint { Color::from_rgba8(85, 85, 85, 255) } else { Color::BLACK });
        self.canvas.fill_path(&letters, &ink, FillRule::Winding, place, mask);
    }

    /// Lets through what lies in the window.
    fn mask(&self, window: &Rectangle) -> Result<Mask, PictureError> {
        let (width, height) = (self.canvas.width(), self.canvas.height());
        let mut mask = Mask::new(width, height).ok_or(PictureError::Size { width, height })?;
        if let Some(sides) = rectangle(window) {
            mask.fill_path(&PathBuilder::from_rect(sides), FillRule::Winding, true, self.scale);
        }
        Ok(mask)
    }
}

/// None if there is nothing to draw.
fn path(outline: &Outline) -> Option<Path> {
    match outline {
        Outline::Rectangle(sides) => rectangle(sides).map(PathBuilder::from_rect),
        Outline::Circle { centre: (x, y), radius } => PathBuilder::from_circle(*x as f32, *y as f32, *radius as f32),
        Outline::Path(steps) => {
            let mut path = PathBuilder::new();
            for step in steps {
                match step {
                    Step::Move((x, y)) => path.move_to(*x as f32, *y as f32),
                    Step::Line((x, y)) => path.line_to(*x as f32, *y as f32),
                    Step::Close => path.close(),
                }
            }
            path.finish()
        }
    }
}

fn rectangle(Rectangle { left, top, width, height }: &Rectangle) -> Option<Rect> {
    Rect::from_xywh(*left as f32, *top as f32, *width as f32, *height as f32)
}

fn paint(colour: Colour, opacity: f64) -> Result<Paint<'static>, PictureError> {
    let digits = colour
        .strip_prefix('#')
        .filter(|digits| digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit()));
    let Some(number) = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok()) else {
        return Err(PictureError::Colour(colour.to_string()));
    };
    let [_, red, green, blue] = number.to_be_bytes();
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, (255.0 * opacity).round() as u8);
    Ok(paint)
}
