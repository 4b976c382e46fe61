//! From shapes to an SVG document.

use super::draw::FONT_SIZE;
use super::shape::{Anchor, Fill, Level, Outline, Rectangle, Shape, Sheet, Step, Stroke, Text};
use std::fmt::Write;

/// What changes where the reader prefers a dark page: paper, writing, lines and the darker colours of the palette.
const DARK: &str = "<style>@media (prefers-color-scheme: dark) {\n\
    [fill='#ffffff'] { fill: #16181b } text { fill: #e4e4df } text[fill='#555555'] { fill: #a4a9b0 }\n\
    [stroke='#333333'] { stroke: #a4a9b0 } [stroke='#e4e4e4'] { stroke: #303439 } [stroke='#555555'] { stroke: #a4a9b0 }\n\
    [stroke='#0b5fa5'] { stroke: #6db3f2 } [fill='#0b5fa5'] { fill: #6db3f2 }\n\
    [stroke='#d1580b'] { stroke: #f39a5a } [fill='#d1580b'] { fill: #f39a5a }\n\
    [stroke='#138a5e'] { stroke: #55c79b } [fill='#138a5e'] { fill: #55c79b }\n\
    [stroke='#a3247a'] { stroke: #e27fc4 } [fill='#a3247a'] { fill: #e27fc4 }\n\
    [stroke='#8a4a20'] { stroke: #cf9468 } [fill='#8a4a20'] { fill: #cf9468 }\n\
    [stroke='#6b6b6b'] { stroke: #b5b5b5 } [fill='#6b6b6b'] { fill: #b5b5b5 }\n\
    [stroke='#1d2b36'] { stroke: #dfe6ec } [fill='#1d2b36'] { fill: #dfe6ec }\n\
    [stroke='#222222'] { stroke: #e4e4df } [fill='#222222'] { fill: #e4e4df }\n\
    [stroke='#c22f2f'] { stroke: #f08a86 } [fill='#c22f2f'] { fill: #f08a86 }\n\
    [stroke='#000000'] { stroke: #e4e4df } [fill='#000000'] { fill: #e4e4df } }</style>\n";

/// Writes the document.
pub(super) fn svg(sheet: &Sheet) -> String {
    let Sheet { width, height, shapes } = sheet;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"{FONT_SIZE}\">\n\
         {DARK}<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
    );
    write_all(shapes, &mut 0, &mut out);
    out.push_str("</svg>\n");
    out
}

/// `windows` counts the clipped groups, for their names.
fn write_all(shapes: &[Shape], windows: &mut usize, out: &mut String) {
    // Writing to a string cannot fail, here and below.
    for shape in shapes {
        let _ = match shape {
            Shape::Drawn { outline, fill, stroke } => {
                writeln!(out, "<{}{}{}/>", element(outline), filled(outline, *fill), stroked(outline, *stroke))
            }
            Shape::Text(text) => writeln!(out, "{}", written(text)),
            Shape::Clipped { window, shapes } => {
                let (name, window) = (format!("panel{windows}"), rectangle(window));
                *windows += 1;
                let _ = writeln!(out, "<clipPath id=\"{name}\"><{window}/></clipPath>\n<g clip-path=\"url(#{name})\">");
                write_all(shapes, windows, out);
                writeln!(out, "</g>")
            }
        };
    }
}

fn element(outline: &Outline) -> String {
    match outline {
        Outline::Path(steps) => format!("path d=\"{}\"", path(steps)),
        Outline::Rectangle(sides) => rectangle(sides),
        Outline::Circle { centre: (x, y), radius } => {
            format!("circle cx=\"{}\" cy=\"{}\" r=\"{}\"", number(*x), number(*y), number(*radius))
        }
    }
}

fn rectangle(Rectangle { left, top, width, height }: &Rectangle) -> String {
    let [x, y, width, height] = [left, top, width, height].map(|length| number(*length));
    format!("rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"")
}

/// Places that fall together on the sheet are written once.
fn path(steps: &[Step]) -> String {
    let (mut out, mut last) = (String::new(), String::new());
    for step in steps {
        let (letter, (x, y)) = match step {
            Step::Move(place) => ('M', place),
            Step::Line(place) => ('L', place),
            Step::Close => {
                out.push('Z');
                continue;
            }
        };
        let place = format!("{} {}", number(*x), number(*y));
        if letter == 'M' || place != last {
            out.push(letter);
            out.push_str(&place);
        }
        last = place;
    }
    out
}

/// Whether there is a corner to be round; what has none has no inside that must stay empty.
fn has_corners(steps: &[Step]) -> bool {
    steps.windows(2).any(|pair| matches!(pair, [Step::Line(_), Step::Line(_)]))
}

fn filled(outline: &Outline, fill: Option<Fill>) -> String {
    match (fill, outline) {
        (Some(Fill { colour, opacity }), _) if opacity < 1.0 => {
            format!(" fill=\"{colour}\" fill-opacity=\"{opacity}\"")
        }
        (Some(Fill { colour, .. }), _) => format!(" fill=\"{colour}\""),
        (None, Outline::Path(steps)) if !has_corners(steps) => String::new(),
        (None, _) => " fill=\"none\"".to_string(),
    }
}

fn stroked(outline: &Outline, stroke: Option<Stroke>) -> String {
    let Some(Stroke { colour, width, dashes }) = stroke else { return String::new() };
    let mut out = format!(" stroke=\"{colour}\"");
    if width != 1.0 {
        let _ = write!(out, " stroke-width=\"{width}\"");
    }
    if matches!(outline, Outline::Path(steps) if has_corners(steps)) {
        out.push_str(" stroke-linejoin=\"round\"");
    }
    if !dashes.is_empty() {
        let lengths: Vec<String> = dashes.iter().map(f64::to_string).collect();
        let _ = write!(out, " stroke-dasharray=\"{}\"", lengths.join(" "));
    }
    out
}

fn written(text: &Text) -> String {
    let (x, y) = (number(text.at.0), number(text.at.1));
    let mut out = format!("<text x=\"{x}\" y=\"{y}\"");
    match text.anchor {
        Anchor::Start => {}
        Anchor::Middle => out.push_str(" text-anchor=\"middle\""),
        Anchor::End => out.push_str(" text-anchor=\"end\""),
    }
    if text.size != FONT_SIZE {
        let _ = write!(out, " font-size=\"{}\"", text.size);
    }
    if text.faint {
        out.push_str(" fill=\"#555555\"");
    }
    if text.turned {
        let _ = write!(out, " transform=\"rotate(-90 {x} {y})\"");
    }
    out.push('>');
    let mut up = 0.0;
    for span in &text.spans {
        let (raised, size) = span.level.shift();
        let text = escaped(&span.text);
        let (by, size) = (up - raised, size.map_or(String::new(), |size| format!(" font-size=\"{size}\"")));
        let _ = match span.level {
            Level::Line if by == 0.0 => write!(out, "{text}"),
            _ if by == 0.0 => write!(out, "<tspan{size}>{text}</tspan>"),
            _ => write!(out, "<tspan dy=\"{by}\"{size}>{text}</tspan>"),
        };
        up = raised;
    }
    out + "</text>"
}

/// A coordinate with two decimals at most.
fn number(x: f64) -> String {
    let text = format!("{x:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
