//! From a picture to shapes: where everything goes on the sheet.

use super::shape::{
    Anchor, DASHES, Fill, Level, Outline, Place, Rectangle, Shape, Sheet, Span, Step, Stroke, Text, steps,
};
use super::ticks::Scale;
use super::{AS_IT_IS, Colour, Mark, PALETTE, Panel, Picture, Series};

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
    let columns = picture.columns;
    // Panels below one another have the same left margin, panels in a row the same room for legends.
    let (mut margins, mut legends) = (vec![0f64; columns], Vec::new());
    for (k, panel) in picture.panels.iter().enumerate() {
        let margin = Frame::new(panel, (0.0, 0.0), picture.panel_size, 0.0, 0.0).margin();
        margins[k % columns] = margins[k % columns].max(margin);
        if k % columns == 0 {
            legends.push(0f64);
        }
        if let Some(room) = legends.last_mut() {
            *room = room.max(legend_height(panel, width));
        }
    }
    let mut shapes = Vec::new();
    let all = width * columns as f64 + 8.0;
    let title = lines(&picture.title, 8.7, all - 16.0);
    for (k, line) in title.iter().enumerate() {
        let at = (all / 2.0, 24.0 + 20.0 * k as f64);
        shapes.push(Shape::Text(Text {
            at,
            anchor: Anchor::Middle,
            size: 16.0,
            turned: false,
            faint: false,
            spans: spans(line),
        }));
    }
    let mut top = if title.is_empty() { 8.0 } else { 16.0 + 20.0 * title.len() as f64 };
    for (row, panels) in picture.panels.chunks(columns).enumerate() {
        let legend = legends.get(row).copied().unwrap_or(0.0);
        for (column, panel) in panels.iter().enumerate() {
            let corner = (column as f64 * width, top);
            let frame = Frame::new(panel, corner, (width, height + legend), margins[column], legend);
            // The title of a panel without a legend stays at its axes, whatever room the others in the row need.
            let frame = if legend_height(panel, width) == 0.0 { Frame { legend: 0.0, ..frame } } else { frame };
            frame.draw(panel, &mut shapes);
        }
        top += height + legend;
    }
    let caption = lines(&picture.caption, 6.6, all - 24.0);
    for (k, line) in caption.iter().enumerate() {
        let at = (12.0, top + 12.0 + 15.0 * k as f64);
        shapes.push(Shape::Text(Text {
            at,
            anchor: Anchor::Start,
            size: 11.0,
            turned: false,
            faint: true,
            spans: vec![Span { text: line.clone(), level: Level::Line }],
        }));
    }
    let below = if caption.is_empty() { 6.0 } else { 8.0 + 15.0 * caption.len() as f64 };
    Sheet { width: all, height: top + below, shapes }
}

/// A text broken into lines that fit.
fn lines(text: &str, letter: f64, width: f64) -> Vec<String> {
    const BOUND: char = '\u{a0}';
    let fit = ((width / letter) as usize).max(20);
    if text.is_empty() {
        return Vec::new();
    }
    // A formula such as `f = g = −1` stays in one line.
    let bound = ['=', '+', '−', '<', '>']
        .into_iter()
        .fold(text.to_string(), |text, sign| text.replace(&format!(" {sign} "), &format!("{BOUND}{sign}{BOUND}")));
    textwrap::wrap(&bound, fit).into_iter().map(|line| line.replace(BOUND, " ")).collect()
}

/// The rows of a legend that is as wide as its panel: which series stand in each, and how far from the left.
fn legend_rows(panel: &Panel, width: f64) -> Vec<Vec<(usize, f64)>> {
    let mut rows: Vec<Vec<(usize, f64)>> = Vec::new();
    let mut right = f64::INFINITY;
    for (k, series) in panel.series.iter().enumerate().filter(|(_, series)| !series.name.is_empty()) {
        let room = 44.0 + SMALL * width_of(&series.name);
        if right + room > width {
            rows.push(Vec::new());
            right = 0.0;
        }
        if let Some(row) = rows.last_mut() {
            row.push((k, right));
        }
        right += room;
    }
    rows
}

/// The height of the legend of a panel.
fn legend_height(panel: &Panel, width: f64) -> f64 {
    let rows = legend_rows(panel, width - LEGEND_MARGIN).len();
    if rows == 0 { 0.0 } else { 18.0 * rows as f64 + 9.0 }
}

/// What a legend leaves free of the width of its panel.
const LEGEND_MARGIN: f64 = 28.0;

/// The axes of a panel on the sheet.
struct Frame {
    x: Scale,
    y: Scale,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
    corner: (f64, f64),
    width: f64,
    legend: f64,
}

impl Frame {
    /// The axes of a panel with at least this margin on the left, and this room for the legend.
    fn new(panel: &Panel, corner: (f64, f64), (width, height): (f64, f64), margin: f64, legend: f64) -> Self {
        let (corner_x, corner_y) = corner;
        let xs = || panel.series.iter().flat_map(|s| s.points.iter().map(|p| p.0));
        let ys = || panel.series.iter().flat_map(|s| s.points.iter().map(|p| p.1));
        let mut x = Scale::new(&panel.x, xs(), (width / 80.0) as usize);
        let mut y = Scale::new(&panel.y, ys(), (height / 60.0) as usize);
        let widest = y.major.iter().map(|(_, label)| letters(label)).max().unwrap_or(1) as f64;
        let mut frame = Frame {
            left: corner_x + margin.max(34.0 + widest * FONT_SIZE * LETTER),
            right: corner_x + width - 14.0,
            top: corner_y + legend + if panel.title.is_empty() { 10.0 } else { 28.0 },
            bottom: corner_y + height - 46.0,
            x: x.clone(),
            y: y.clone(),
            corner,
            width,
            legend,
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
                x = Scale::new(&panel.x.clone().between(low, high), xs(), (width / 80.0) as usize);
            } else {
                let (low, high) = widened(&y, per_y / per_x);
                y = Scale::new(&panel.y.clone().between(low, high), ys(), (height / 60.0) as usize);
            }
            (frame.x, frame.y) = (x, y);
        }
        frame
    }

    /// From the left edge of the panel to the axes.
    fn margin(&self) -> f64 {
        self.left - self.corner.0
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
        let looks = looks(&panel.series);
        let mut inside = Vec::new();
        for (series, look) in panel.series.iter().zip(&looks) {
            self.draw_series(series, *look, &mut inside);
        }
        out.push(Shape::Clipped { window, shapes: inside });
        let stroke = Some(Stroke { colour: "#333333", width: 1.0, dashes: &[] });
        out.push(Shape::Drawn { outline: Outline::Rectangle(window), fill: None, stroke });
        let middle = (0.5 * (self.left + self.right), 0.5 * (self.top + self.bottom));
        let widest = self.y.major.iter().map(|(_, label)| letters(label)).max().unwrap_or(1) as f64;
        let across = self.left - widest * FONT_SIZE * LETTER - 18.0;
        for (at, turned, text) in [
            ((middle.0, self.top - 9.0 - self.legend), false, &panel.title),
            ((middle.0, self.bottom + 36.0), false, &panel.x.label),
            ((across, middle.1), true, &panel.y.label),
        ] {
            if !text.is_empty() {
                let (anchor, size, spans) = (Anchor::Middle, FONT_SIZE, spans(text));
                out.push(Shape::Text(Text { at, anchor, size, turned, faint: false, spans }));
            }
        }
        self.draw_legend(panel, &looks, out);
    }

    fn draw_ticks(&self, out: &mut Vec<Shape>) {
        let mut line = |from: Place, to: Place, colour: Colour| {
            out.push(Shape::line([from, to], Stroke { colour, width: 1.0, dashes: &[] }));
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

    fn draw_series(&self, series: &Series, look: Look, out: &mut Vec<Shape>) {
        let colour = look.colour;
        let places: Vec<Option<Place>> = series.points.iter().map(|&p| self.at(p)).collect();
        if let Some(stroke) = stroke(series, look) {
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
            _ => out.extend(places.into_iter().flatten().filter_map(|place| symbol(series, look, place))),
        }
    }

    /// The legend, between the title and the axes.
    fn draw_legend(&self, panel: &Panel, looks: &[Look], out: &mut Vec<Shape>) {
        let top = self.top - self.legend;
        for (row, entries) in legend_rows(panel, self.width - LEGEND_MARGIN).into_iter().enumerate() {
            let y = top + 9.0 + 18.0 * row as f64;
            for (k, from) in entries {
                let (Some(series), Some(look)) = (panel.series.get(k), looks.get(k)) else { continue };
                let (left, right) = (self.corner.0 + 20.0 + from, self.corner.0 + 48.0 + from);
                if let Some(stroke) = stroke(series, *look) {
                    let width = stroke.width.max(1.2);
                    out.push(Shape::line([(left, y), (right, y)], Stroke { width, ..stroke }));
                }
                match series.mark {
                    Mark::Area => {
                        let (top, bottom) = (y - 5.0, y + 5.0);
                        out.push(area([(left, top), (right, top), (right, bottom), (left, bottom)], look.colour));
                    }
                    Mark::Arrows => arrow(series, look.colour, (left, y), (right, y), out),
                    _ => out.extend(symbol(series, *look, (0.5 * (left + right), y))),
                }
                out.push(small((right + 6.0, y + 4.3), Anchor::Start, &series.name));
            }
        }
    }
}

/// How a series is told from the others: by colour, and by its line or mark as well.
#[derive(Debug, Clone, Copy)]
struct Look {
    colour: Colour,
    /// Its place among the series that take the next look.
    place: usize,
}

/// How the points of the series are joined, if they are.
fn stroke(series: &Series, look: Look) -> Option<Stroke> {
    let colour = look.colour;
    match series.mark {
        Mark::Line => Some(Stroke { colour, width: series.size, dashes: DASHES[look.place % DASHES.len()] }),
        Mark::Dashed => Some(Stroke { colour, width: series.size, dashes: DASHES[1] }),
        Mark::Joined => Some(Stroke { colour, width: 1.4, dashes: &[] }),
        Mark::Points | Mark::Crosses | Mark::Arrows | Mark::Area => None,
    }
}

/// The mark of a single point, if the series has one.
fn symbol(series: &Series, look: Look, (x, y): Place) -> Option<Shape> {
    let (r, colour) = (series.size, look.colour);
    match series.mark {
        Mark::Points | Mark::Joined => Some(solid(look.place, r, colour, (x, y))),
        Mark::Crosses => {
            let lines = [[(x - r, y - r), (x + r, y + r)], [(x + r, y - r), (x - r, y + r)]];
            let outline = Outline::Path(lines.into_iter().flat_map(steps).collect());
            Some(Shape::Drawn { outline, fill: None, stroke: Some(Stroke { colour, width: 1.8, dashes: &[] }) })
        }
        Mark::Line | Mark::Dashed | Mark::Arrows | Mark::Area => None,
    }
}

/// A disc, square, triangle, diamond, triangle that points down or upright cross, of about the same area.
fn solid(place: usize, r: f64, colour: Colour, (x, y): Place) -> Shape {
    let corners: &[Place] = match place % 6 {
        1 => &[(-0.9, -0.9), (0.9, -0.9), (0.9, 0.9), (-0.9, 0.9)],
        2 => &[(0.0, -1.3), (1.15, 0.75), (-1.15, 0.75)],
        3 => &[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)],
        4 => &[(0.0, 1.3), (1.15, -0.75), (-1.15, -0.75)],
        5 => &[
            (-0.45, -1.3),
            (0.45, -1.3),
            (0.45, -0.45),
            (1.3, -0.45),
            (1.3, 0.45),
            (0.45, 0.45),
            (0.45, 1.3),
            (-0.45, 1.3),
            (-0.45, 0.45),
            (-1.3, 0.45),
            (-1.3, -0.45),
            (-0.45, -0.45),
        ],
        _ => {
            let fill = Some(Fill { colour, opacity: 1.0 });
            return Shape::Drawn { outline: Outline::Circle { centre: (x, y), radius: r }, fill, stroke: None };
        }
    };
    Shape::area(corners.iter().map(|(u, v)| (x + r * u, y + r * v)), Fill { colour, opacity: 1.0 })
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
    out.push(Shape::line([tail, neck], Stroke { colour, width: series.size, dashes: &[] }));
    out.push(Shape::area([head, corner(1.0), corner(-1.0)], Fill { colour, opacity: 1.0 }));
}

/// Series with a colour of their own have whole lines and discs, unless it is one of the palette and they, or others of the
/// same kind and colour, have a name; the others take the next look, where they have a name or marks.
fn looks(series: &[Series]) -> Vec<Look> {
    let mut next = 0;
    let look = |s: &Series| match s.colour {
        // The first colours of the palette, given by name, keep the line that goes with them.
        Some(colour) => {
            let like = |o: &Series| !o.name.is_empty() && o.colour == s.colour && o.mark == s.mark;
            let known = PALETTE.iter().position(|known| *known == colour).filter(|_| series.iter().any(like));
            Look { colour, place: known.unwrap_or(0) }
        }
        None => {
            next += 1;
            let place = if s.name.is_empty() && s.mark != Mark::Joined { 0 } else { next - 1 };
            Look { colour: PALETTE[(next - 1) % PALETTE.len()], place }
        }
    };
    series.iter().map(look).collect()
}

/// Letters that are seen: the sign before an exponent or index is not.
fn letters(text: &str) -> usize {
    text.chars().filter(|c| !['^', '_', AS_IT_IS].contains(c)).count()
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
    Shape::Text(Text { at, anchor, size: SMALL, turned: false, faint: false, spans: spans(text) })
}

/// `10^−3` with a raised exponent, `K_M` with a lowered index. An exponent ends at the first character that is neither a digit
/// nor a sign, an index at the first that is neither a letter nor a digit.
fn spans(text: &str) -> Vec<Span> {
    let mut out: Vec<(String, Level)> = vec![(String::new(), Level::Line)];
    let mut level = Level::Line;
    let mut rest = text.chars().peekable();
    let mut last = ' ';
    while let Some(c) = rest.next() {
        let next = rest.peek().copied().unwrap_or(' ');
        if c == AS_IT_IS {
            last = c;
            continue;
        }
        let begins = match c {
            _ if last == AS_IT_IS => None,
            '^' if next.is_ascii_digit() || next == '−' => Some(Level::Exponent),
            '_' if next.is_alphanumeric() && last.is_alphabetic() => Some(Level::Index),
            _ => None,
        };
        if let Some(begins) = begins {
            level = begins;
            out.push((String::new(), level));
        } else {
            let stays = match level {
                Level::Line => true,
                Level::Exponent => c.is_ascii_digit() || c == '−',
                Level::Index => c.is_alphanumeric(),
            };
            if !stays {
                level = Level::Line;
                out.push((String::new(), level));
            }
            if let Some((part, _)) = out.last_mut() {
                part.push(c);
            }
        }
        last = c;
    }
    let seen = out.into_iter().filter(|(text, _)| !text.is_empty());
    seen.map(|(text, level)| Span { text, level }).collect()
}
