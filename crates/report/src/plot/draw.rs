//! From a picture to an SVG document.

use super::ticks::Scale;
use super::{Corner, Mark, PALETTE, Panel, Picture, Series};
use std::fmt::Write;

const FONT: f64 = 13.0;
/// Width of an average letter, in units of the font size.
const LETTER: f64 = 0.6;
const GREY: &str = "#555555";

/// Draws the whole picture.
pub(super) fn svg(picture: &Picture) -> String {
    let (width, height) = picture.panel_size;
    let rows = picture.panels.len().div_ceil(picture.columns);
    let top = if picture.title.is_empty() { 8.0 } else { 36.0 };
    let (all, down) = (width * picture.columns as f64 + 8.0, top + height * rows as f64 + 6.0);
    // Writing to a string cannot fail, here and below.
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{all}\" height=\"{down}\" viewBox=\"0 0 {all} {down}\" \
         font-family=\"DejaVu Sans, sans-serif\" font-size=\"{FONT}\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    if !picture.title.is_empty() {
        let _ = writeln!(
            out,
            "<text x=\"{}\" y=\"24\" text-anchor=\"middle\" font-size=\"16\">{}</text>",
            number(all / 2.0),
            escaped(&picture.title)
        );
    }
    for (k, panel) in picture.panels.iter().enumerate() {
        let corner = ((k % picture.columns) as f64 * width, top + (k / picture.columns) as f64 * height);
        Frame::new(panel, corner, picture.panel_size, k).draw(panel, &mut out);
    }
    out.push_str("</svg>\n");
    out
}

/// The axes of a panel on the sheet.
struct Frame {
    x: Scale,
    y: Scale,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
    index: usize,
}

impl Frame {
    fn new(panel: &Panel, (corner_x, corner_y): (f64, f64), (width, height): (f64, f64), index: usize) -> Self {
        let xs = || panel.series.iter().flat_map(|s| s.points.iter().map(|p| p.0));
        let ys = || panel.series.iter().flat_map(|s| s.points.iter().map(|p| p.1));
        let mut x = Scale::new(&panel.x, xs(), (width / 95.0) as usize);
        let mut y = Scale::new(&panel.y, ys(), (height / 60.0) as usize);
        let widest = y.major.iter().map(|(_, label)| letters(label)).max().unwrap_or(1) as f64;
        let mut frame = Frame {
            left: corner_x + 34.0 + widest * FONT * LETTER,
            right: corner_x + width - 14.0,
            top: corner_y + if panel.title.is_empty() { 10.0 } else { 28.0 },
            bottom: corner_y + height - 46.0,
            x: x.clone(),
            y: y.clone(),
            index,
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

    fn draw(&self, panel: &Panel, out: &mut String) {
        let (width, height) = (self.right - self.left, self.bottom - self.top);
        self.draw_ticks(out);
        let clip = format!("panel{}", self.index);
        let rectangle = format!(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"",
            number(self.left),
            number(self.top),
            number(width),
            number(height)
        );
        let _ = writeln!(out, "<clipPath id=\"{clip}\">{rectangle}/></clipPath>\n<g clip-path=\"url(#{clip})\">");
        let colours = colours(&panel.series);
        for (series, colour) in panel.series.iter().zip(&colours) {
            self.draw_series(series, colour, out);
        }
        let _ = writeln!(out, "</g>\n{rectangle} fill=\"none\" stroke=\"#333333\"/>");
        let middle = (number(0.5 * (self.left + self.right)), number(0.5 * (self.top + self.bottom)));
        let widest = self.y.major.iter().map(|(_, label)| letters(label)).max().unwrap_or(1) as f64;
        let across = number(self.left - widest * FONT * LETTER - 18.0);
        for (x, y, extra, text) in [
            (&middle.0, &number(self.top - 9.0), "", &panel.title),
            (&middle.0, &number(self.bottom + 36.0), "", &panel.x.label),
            (&across, &middle.1, &*format!(" transform=\"rotate(-90 {across} {})\"", middle.1), &panel.y.label),
        ] {
            if !text.is_empty() {
                let _ = writeln!(out, "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\"{extra}>{}</text>", rich(text));
            }
        }
        self.draw_legend(panel, &colours, out);
    }

    fn draw_ticks(&self, out: &mut String) {
        let mut line = |x1: f64, y1: f64, x2: f64, y2: f64, colour: &str| {
            let _ = writeln!(
                out,
                "<path d=\"M{} {}L{} {}\" stroke=\"{colour}\"/>",
                number(x1),
                number(y1),
                number(x2),
                number(y2)
            );
        };
        let across = |x: f64| self.left + self.x.place(x) * (self.right - self.left);
        let down = |y: f64| self.bottom - self.y.place(y) * (self.bottom - self.top);
        for (x, _) in &self.x.major {
            line(across(*x), self.top, across(*x), self.bottom + 5.0, "#e4e4e4");
        }
        for (y, _) in &self.y.major {
            line(self.left - 5.0, down(*y), self.right, down(*y), "#e4e4e4");
        }
        for x in &self.x.minor {
            line(across(*x), self.bottom, across(*x), self.bottom + 3.0, GREY);
        }
        for y in &self.y.minor {
            line(self.left - 3.0, down(*y), self.left, down(*y), GREY);
        }
        let mut free_from = f64::NEG_INFINITY;
        for (x, label) in &self.x.major {
            let half = 0.5 * letters(label) as f64 * FONT * LETTER;
            // A label that would run into the last one is left out.
            if across(*x) - half > free_from {
                free_from = across(*x) + half + 4.0;
                let (x, y) = (number(across(*x)), number(self.bottom + 18.0));
                let _ = writeln!(
                    out,
                    "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" font-size=\"12\">{}</text>",
                    rich(label)
                );
            }
        }
        for (y, label) in &self.y.major {
            let (x, y) = (number(self.left - 8.0), number(down(*y) + 4.5));
            let _ =
                writeln!(out, "<text x=\"{x}\" y=\"{y}\" text-anchor=\"end\" font-size=\"12\">{}</text>", rich(label));
        }
    }

    fn draw_series(&self, series: &Series, colour: &str, out: &mut String) {
        let places: Vec<Option<(f64, f64)>> = series.points.iter().map(|&p| self.at(p)).collect();
        if matches!(series.mark, Mark::Line | Mark::Dashed | Mark::Joined) {
            let (mut path, mut last) = (String::new(), None);
            for place in &places {
                let Some((x, y)) = *place else {
                    last = None;
                    continue;
                };
                let text = format!("{} {}", number(x), number(y));
                // Points that fall together on the sheet are drawn once.
                if last.as_ref() != Some(&text) {
                    path.push(if last.is_none() { 'M' } else { 'L' });
                    path.push_str(&text);
                }
                last = Some(text);
            }
            let dashes = if series.mark == Mark::Dashed { " stroke-dasharray=\"6 4\"" } else { "" };
            let width = if series.mark == Mark::Joined { 1.4 } else { series.size };
            let _ = writeln!(
                out,
                "<path d=\"{path}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dashes}/>"
            );
        }
        match series.mark {
            Mark::Area => {
                let corners: Vec<String> =
                    places.into_iter().flatten().map(|(x, y)| format!("{} {}", number(x), number(y))).collect();
                if !corners.is_empty() {
                    area(&format!("M{}Z", corners.join("L")), colour, out);
                }
            }
            Mark::Arrows => {
                for pair in places.chunks_exact(2) {
                    if let [Some(tail), Some(head)] = pair {
                        arrow(series, colour, *tail, *head, out);
                    }
                }
            }
            _ => {
                for (x, y) in places.into_iter().flatten() {
                    symbol(series, colour, x, y, out);
                }
            }
        }
    }

    /// The legend, in the corner that covers the fewest points.
    fn draw_legend(&self, panel: &Panel, colours: &[&str], out: &mut String) {
        let named: Vec<(&Series, &&str)> =
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
        let _ = writeln!(
            out,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"white\" fill-opacity=\"0.88\" stroke=\"#bbbbbb\"/>",
            number(x0),
            number(y0),
            number(width),
            number(height)
        );
        for (k, (series, colour)) in named.into_iter().enumerate() {
            let y = y0 + 13.0 + 18.0 * k as f64;
            if matches!(series.mark, Mark::Line | Mark::Dashed | Mark::Joined) {
                let dashes = if series.mark == Mark::Dashed { " stroke-dasharray=\"6 4\"" } else { "" };
                let _ = writeln!(
                    out,
                    "<path d=\"M{} {}h24\" stroke=\"{colour}\" stroke-width=\"{}\"{dashes}/>",
                    number(x0 + 7.0),
                    number(y),
                    if series.mark == Mark::Joined { 1.4 } else { series.size.max(1.2) }
                );
            }
            match series.mark {
                Mark::Area => area(&format!("M{} {}h24v10h-24Z", number(x0 + 7.0), number(y - 5.0)), colour, out),
                Mark::Arrows => arrow(series, colour, (x0 + 7.0, y), (x0 + 31.0, y), out),
                _ => symbol(series, colour, x0 + 19.0, y, out),
            }
            let _ = writeln!(
                out,
                "<text x=\"{}\" y=\"{}\" font-size=\"12\">{}</text>",
                number(x0 + 38.0),
                number(y + 4.3),
                rich(&series.name)
            );
        }
    }
}

/// The mark of a single point, if the series has one.
fn symbol(series: &Series, colour: &str, x: f64, y: f64, out: &mut String) {
    let r = number(series.size);
    match series.mark {
        Mark::Points | Mark::Joined => {
            let _ = writeln!(out, "<circle cx=\"{}\" cy=\"{}\" r=\"{r}\" fill=\"{colour}\"/>", number(x), number(y));
        }
        Mark::Crosses => {
            let (x, y, d) = (number(x - series.size), number(y - series.size), number(2.0 * series.size));
            let _ = writeln!(
                out,
                "<path d=\"M{x} {y}l{d} {d}m0 -{d}l-{d} {d}\" stroke=\"{colour}\" stroke-width=\"1.8\"/>"
            );
        }
        Mark::Line | Mark::Dashed | Mark::Arrows | Mark::Area => {}
    }
}

/// A filled outline that lets through what lies below.
fn area(path: &str, colour: &str, out: &mut String) {
    let _ = writeln!(out, "<path d=\"{path}\" fill=\"{colour}\" fill-opacity=\"0.25\"/>");
}

/// A line with a filled head. Where the arrow is shorter than a head, the head is as long as the arrow.
fn arrow(series: &Series, colour: &str, tail: (f64, f64), head: (f64, f64), out: &mut String) {
    let (dx, dy) = (head.0 - tail.0, head.1 - tail.1);
    let length = dx.hypot(dy);
    if length < 0.05 {
        return;
    }
    let (along, across) = ((dx / length, dy / length), (-dy / length, dx / length));
    let (deep, wide) = (length.min(3.0 + 2.5 * series.size), length.min(1.0 + 1.2 * series.size));
    let corner = |side: f64| {
        let (x, y) =
            (head.0 - deep * along.0 + side * wide * across.0, head.1 - deep * along.1 + side * wide * across.1);
        format!("{} {}", number(x), number(y))
    };
    let neck = (head.0 - 0.7 * deep * along.0, head.1 - 0.7 * deep * along.1);
    let _ = writeln!(
        out,
        "<path d=\"M{} {}L{} {}\" stroke=\"{colour}\" stroke-width=\"{}\"/>\n<path d=\"M{} {}L{}L{}Z\" fill=\"{colour}\"/>",
        number(tail.0),
        number(tail.1),
        number(neck.0),
        number(neck.1),
        series.size,
        number(head.0),
        number(head.1),
        corner(1.0),
        corner(-1.0)
    );
}

fn colours(series: &[Series]) -> Vec<&'static str> {
    let mut next = 0..;
    series.iter().map(|s| s.colour.unwrap_or_else(|| PALETTE[next.next().unwrap_or(0) % PALETTE.len()])).collect()
}

/// A coordinate with two decimals at most.
fn number(x: f64) -> String {
    let text = format!("{x:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
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

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// `10^−3` with a raised exponent; an exponent ends at the first character that is neither a digit nor a sign.
fn rich(text: &str) -> String {
    let mut parts = text.split('^');
    let mut out = escaped(parts.next().unwrap_or_default());
    for part in parts {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != '−').unwrap_or(part.len());
        let (exponent, rest) = part.split_at(end);
        let _ = write!(out, "<tspan dy=\"-4.5\" font-size=\"9\">{exponent}</tspan>");
        if !rest.is_empty() {
            let _ = write!(out, "<tspan dy=\"4.5\">{}</tspan>", escaped(rest));
        }
    }
    out
}
