//! From a picture to shapes: where everything goes on the sheet.

use super::shape::{Anchor, Fill, Outline, Place, Rectangle, Shape, Sheet, Span, Step, Stroke, Text, steps};
use super::ticks::Scale;
use super::{Colour, Corner, Mark, PALETTE, Panel, Picture, Series};

/// Size of the labels of axes.
pub(super) const FONT_SIZE: f64 = 13.0;
/// Size of ticks and legends.
const SMALL: f64 = 12.0;
/// Width of an average letter, in units of the font size.
const LETTER: f64 = 0.6;
const GREY: Colour = "#555555";

/// Draws the whole picture.
pub(super) fn draw(picture: &Picture) -> Sheet {
    let (width, height) = picture.panel_size;
    let rows = picture.panels.len().div_ceil(picture.columns);
    let top = if picture.title.is_empty() { 8.0 } else { 36.0 };
    let (all, down) = (width * picture.columns as f64 + 8.0, top + height * rows as f64 + 6.0);
    let mut shapes = Vec::new();
    if !picture.title.is_empty() {
        let spans = vec![Span { text: picture.title.clone(), raised: false }];
        let at = (all / 2.0, 24.0);
        shapes.push(Shape::Text(Text { at, anchor: Anchor::Middle, size: 16.0, turned: false, spans }));
    }
    for (k, panel) in picture.panels.iter().enumerate() {
        let corner = ((k % picture.columns) as f64 * width, top + (k / picture.columns) as f64 * height);
        Frame::new(panel, corner, picture.panel_size).draw(panel, &mut shapes);
    }
    Sheet { width: all, height: down, shapes }
}

/// The axes of a panel on the sheet.
struct Frame {
    x: Scale,
    y: Scale,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

impl Frame {
    fn new(panel: &Panel, (corner_x, corner_y): (f64, f64), (width, height): (f64, f64)) -> Self {
        let xs = || panel.series.iter().flat_map(|s| s.points.iter().map(|p| p.0));
        let ys = || panel.series.iter().flat_map(|s| s.points.iter().map(|p| p.1));
        let mut x = Scale::new(&panel.x, xs(), (width / 95.0) as usize);
        let mut y = Scale::new(&panel.y, ys(), (height / 60.0) as usize);
        let widest = y.major.iter().map(|(_, label)| letters(label)).max().unwrap_or(1) as f64;
        let mut frame = Frame {
            left: corner_x + 34.0 + widest * FONT_SIZE * LETTER,
            right: corner_x + width - 14.0,
            top: corner_y + if panel.title.is_empty() { 10.0 } else { 28.0 },
            bottom: corner_y + height - 46.0,
            x: x.clone(),
            y: y.clone(),
        };
        if panel.equal_scales {
            // The axis with room to spare gets a wider range.
            let (per_x, per_y) =
                ((frame.right - frame.left) / (x.high - x.low), (frame.bottom - frame.top) / (y.high - y.low));
            let widened = |scale: &Scale, factor: f64| {
                let (middle, half) = (0.5 * (scale.low + scale.high), 0.5 * factor * (scale.high - scale.low));
                (middle - half, middle + half)
            };
            if per_x > per_y {
                let (low, high) = widened(&x, per_x / per_y);
                x = Scale::new(&panel.x.clone().between(low, high), xs(), (width / 95.0) as usize);
            } else {
                let (low, high) = widened(&y, per_y / per_x);
                y = Scale::new(&panel.y.clone().between(low, high), ys(), (height / 60.0) as usize);
            }
            (frame.x, frame.y) = (x, y);
        }
        frame
    }

    fn at(&self, (x, y): (f64, f64)) -> Option<(f64, f64)> {
        let (u, v) = (self.x.place(x), self.y.place(y));
        // Far outside is cut down, so that no renderer overflows.
        let far = |p: f64| p.clamp(-50.0, 50.0);
        (u.is_finite() && v.is_finite())
            .then(|| (self.left + far(u) * (self.right - self.left), self.bottom - far(v) * (self.bottom - self.top)))
    }

    fn draw(&self, panel: &Panel, out: &mut Vec<Shape>) {
        self.draw_ticks(out);
        let window =
            Rectangle { left: self.left, top: self.top, width: self.right - self.left, height: self.bottom - self.top };
        let colours = colours(&panel.series);
        let mut inside = Vec::new();
        for (series, colour) in panel.series.iter().zip(&colours) {
            self.draw_series(series, colour, &mut inside);
        }
        out.push(Shape::Clipped { window, shapes: inside });
        let stroke = Some(Stroke { colour: "#333333", width: 1.0, dashed: false });
        out.push(Shape::Drawn { outline: Outline::Rectangle(window), fill: None, stroke });
        let middle = (0.5 * (self.left + self.right), 0.5 * (self.top + self.bottom));
        let widest = self.y.major.iter().map(|(_, label)| letters(label)).max().unwrap_or(1) as f64;
        let across = self.left - widest * FONT_SIZE * LETTER - 18.0;
        for (at, turned, text) in [
            ((middle.0, self.top - 9.0), false, &panel.title),
            ((middle.0, self.bottom + 36.0), false, &panel.x.label),
            ((across, middle.1), true, &panel.y.label),
        ] {
            if !text.is_empty() {
                let (anchor, size, spans) = (Anchor::Middle, FONT_SIZE, spans(text));
                out.push(Shape::Text(Text { at, anchor, size, turned, spans }));
            }
        }
        self.draw_legend(panel, &colours, out);
    }

    fn draw_ticks(&self, out: &mut Vec<Shape>) {
        let mut line = |from: Place, to: Place, colour: Colour| {
            out.push(Shape::line([from, to], Stroke { colour, width: 1.0, dashed: false }));
        };
        let across = |x: f64| self.left + self.x.place(x) * (self.right - self.left);
        let down = |y: f64| self.bottom - self.y.place(y) * (self.bottom - self.top);
        for (x, _) in &self.x.major {
            line((across(*x), self.top), (across(*x), self.bottom + 5.0), "#e4e4e4");
        }
        for (y, _) in &self.y.major {
            line((self.left - 5.0, down(*y)), (self.right, down(*y)), "#e4e4e4");
        }
        for x in &self.x.minor {
            line((across(*x), self.bottom), (across(*x), self.bottom + 3.0), GREY);
        }
        for y in &self.y.minor {
            line((self.left - 3.0, down(*y)), (self.left, down(*y)), GREY);
        }
        let mut free_from = f64::NEG_INFINITY;
        for (x, label) in &self.x.major {
            let half = 0.5 * letters(label) as f64 * FONT_SIZE * LETTER;
            // A label that would run into the last one is left out.
            if across(*x) - half > free_from {
                free_from = across(*x) + half + 4.0;
                out.push(small((across(*x), self.bottom + 18.0), Anchor::Middle, label));
            }
        }
        for (y, label) in &self.y.major {
            out.push(small((self.left - 8.0, down(*y) + 4.5), Anchor::End, label));
        }
    }

    fn draw_series(&self, series: &Series, colour: Colour, out: &mut Vec<Shape>) {
        let places: Vec<Option<Place>> = series.points.iter().map(|&p| self.at(p)).collect();
        if let Some(stroke) = stroke(series, colour) {
            // A point without a place breaks the line.
            let parts = places.split(Option::is_none).map(|part| part.iter().copied().flatten());
            let steps: Vec<Step> = parts.flat_map(steps).collect();
            if !steps.is_empty() {
                out.push(Shape::Drawn { outline: Outline::Path(steps), fill: None, stroke: Some(stroke) });
            }
        }
        match series.mark {
            Mark::Area => {
                if places.iter().any(Option::is_some) {
                    out.push(area(places.into_iter().flatten(), colour));
                }
            }
            Mark::Arrows => {
                for pair in places.chunks_exact(2) {
                    if let [Some(tail), Some(head)] = pair {
                        arrow(series, colour, *tail, *head, out);
                    }
                }
            }
            _ => out.extend(places.into_iter().flatten().filter_map(|place| symbol(series, colour, place))),
        }
    }

    /// The legend, in the corner that covers the fewest points.
    fn draw_legend(&self, panel: &Panel, colours: &[Colour], out: &mut Vec<Shape>) {
        let named: Vec<(&Series, &Colour)> =
            panel.series.iter().zip(colours).filter(|(s, _)| !s.name.is_empty()).collect();
        if named.is_empty() {
            return;
        }
        let widest = named.iter().map(|(s, _)| width_of(&s.name)).fold(0.0, f64::max);
        let (width, height) = (48.0 + 12.0 * widest, 18.0 * named.len() as f64 + 8.0);
        let place = |corner: Corner| match corner {
            Corner::UpperLeft => (self.left + 8.0, self.top + 8.0),
            Corner::UpperRight => (self.right - 8.0 - width, self.top + 8.0),
            Corner::LowerLeft => (self.left + 8.0, self.bottom - 8.0 - height),
            Corner::LowerRight => (self.right - 8.0 - width, self.bottom - 8.0 - height),
        };
        let covered = |corner: &Corner| {
            let (x0, y0) = place(*corner);
            let places = panel.series.iter().flat_map(|s| s.points.iter().filter_map(|&p| self.at(p)));
            places.filter(|(x, y)| (x0..x0 + width).contains(x) && (y0..y0 + height).contains(y)).count()
        };
        let corners = [Corner::UpperRight, Corner::UpperLeft, Corner::LowerRight, Corner::LowerLeft];
        let Some(corner) = panel.legend.or_else(|| corners.into_iter().min_by_key(covered)) else { return };
        let (x0, y0) = place(corner);
        out.push(Shape::Drawn {
            outline: Outline::Rectangle(Rectangle { left: x0, top: y0, width, height }),
            fill: Some(Fill { colour: "#ffffff", opacity: 0.88 }),
            stroke: Some(Stroke { colour: "#bbbbbb", width: 1.0, dashed: false }),
        });
        for (k, (series, colour)) in named.into_iter().enumerate() {
            let y = y0 + 13.0 + 18.0 * k as f64;
            let (left, right) = (x0 + 7.0, x0 + 31.0);
            if let Some(stroke) = stroke(series, colour) {
                let width = stroke.width.max(1.2);
                out.push(Shape::line([(left, y), (right, y)], Stroke { width, ..stroke }));
            }
            match series.mark {
                Mark::Area => {
                    let (top, bottom) = (y - 5.0, y + 5.0);
                    out.push(area([(left, top), (right, top), (right, bottom), (left, bottom)], colour));
                }
                Mark::Arrows => arrow(series, colour, (left, y), (right, y), out),
                _ => out.extend(symbol(series, colour, (x0 + 19.0, y))),
            }
            out.push(small((x0 + 38.0, y + 4.3), Anchor::Start, &series.name));
        }
    }
}

/// How the points of the series are joined, if they are.
fn stroke(series: &Series, colour: Colour) -> Option<Stroke> {
    match series.mark {
        Mark::Line | Mark::Dashed => Some(Stroke { colour, width: series.size, dashed: series.mark == Mark::Dashed }),
        Mark::Joined => Some(Stroke { colour, width: 1.4, dashed: false }),
        Mark::Points | Mark::Crosses | Mark::Arrows | Mark::Area => None,
    }
}

/// The mark of a single point, if the series has one.
fn symbol(series: &Series, colour: Colour, (x, y): Place) -> Option<Shape> {
    let r = series.size;
    match series.mark {
        Mark::Points | Mark::Joined => Some(Shape::Drawn {
            outline: Outline::Circle { centre: (x, y), radius: r },
            fill: Some(Fill { colour, opacity: 1.0 }),
            stroke: None,
        }),
        Mark::Crosses => {
            let lines = [[(x - r, y - r), (x + r, y + r)], [(x + r, y - r), (x - r, y + r)]];
            let outline = Outline::Path(lines.into_iter().flat_map(steps).collect());
            Some(Shape::Drawn { outline, fill: None, stroke: Some(Stroke { colour, width: 1.8, dashed: false }) })
        }
        Mark::Line | Mark::Dashed | Mark::Arrows | Mark::Area => None,
    }
}

/// A filled outline that lets through what lies below.
fn area(corners: impl IntoIterator<Item = Place>, colour: Colour) -> Shape {
    Shape::area(corners, Fill { colour, opacity: 0.25 })
}

/// A line with a filled head. Where the arrow is shorter than a head, the head is as long as the arrow.
fn arrow(series: &Series, colour: Colour, tail: Place, head: Place, out: &mut Vec<Shape>) {
    let (dx, dy) = (head.0 - tail.0, head.1 - tail.1);
    let length = dx.hypot(dy);
    if length < 0.05 {
        return;
    }
    let (along, across) = ((dx / length, dy / length), (-dy / length, dx / length));
    let (deep, wide) = (length.min(3.0 + 2.5 * series.size), length.min(1.0 + 1.2 * series.size));
    let corner = |side: f64| {
        (head.0 - deep * along.0 + side * wide * across.0, head.1 - deep * along.1 + side * wide * across.1)
    };
    let neck = (head.0 - 0.7 * deep * along.0, head.1 - 0.7 * deep * along.1);
    out.push(Shape::line([tail, neck], Stroke { colour, width: series.size, dashed: false }));
    out.push(Shape::area([head, corner(1.0), corner(-1.0)], Fill { colour, opacity: 1.0 }));
}

fn colours(series: &[Series]) -> Vec<Colour> {
    let mut next = 0..;
    series.iter().map(|s| s.colour.unwrap_or_else(|| PALETTE[next.next().unwrap_or(0) % PALETTE.len()])).collect()
}

/// Letters that are seen: the caret before an exponent is not.
fn letters(text: &str) -> usize {
    text.chars().filter(|c| *c != '^').count()
}

/// About how wide a text is, in units of its size.
fn width_of(text: &str) -> f64 {
    let width = |c: char| match c {
        'i' | 'j' | 'l' | 'I' | '.' | ',' | '\'' | '|' | ' ' => 0.32,
        'f' | 'r' | 't' | '(' | ')' | '-' | ':' => 0.4,
        'm' | 'w' | 'M' | 'W' => 0.93,
        'A'..='Z' | '0'..='9' | '=' | '−' | '+' => 0.7,
        _ => 0.6,
    };
    text.chars().map(width).sum()
}

fn small(at: Place, anchor: Anchor, text: &str) -> Shape {
    Shape::Text(Text { at, anchor, size: SMALL, turned: false, spans: spans(text) })
}

/// `10^−3` with a raised exponent; an exponent ends at the first character that is neither a digit nor a sign.
fn spans(text: &str) -> Vec<Span> {
    let mut parts = text.split('^');
    let mut out = vec![(parts.next().unwrap_or_default(), false)];
    for part in parts {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != '−').unwrap_or(part.len());
        let (exponent, rest) = part.split_at(end);
        out.extend([(exponent, true), (rest, false)]);
    }
    let seen = out.into_iter().filter(|(text, _)| !text.is_empty());
    seen.map(|(text, raised)| Span { text: text.to_string(), raised }).collect()
}
