//! From shapes to an SVG document.

use super::draw::FONT_SIZE;
use super::shape::{Anchor, DASHES, Fill, Outline, RAISED, Rectangle, Shape, Sheet, Step, Stroke, Text};
use std::fmt::Write;

/// Writes the document.
pub(super) fn svg(sheet: &Sheet) -> String {
    let Sheet { width, height, shapes } = sheet;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"{FONT_SIZE}\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
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
    let Some(Stroke { colour, width, dashed }) = stroke else { return String::new() };
    let mut out = format!(" stroke=\"{colour}\"");
    if width != 1.0 {
        let _ = write!(out, " stroke-width=\"{width}\"");
    }
    if matches!(outline, Outline::Path(steps) if has_corners(steps)) {
        out.push_str(" stroke-linejoin=\"round\"");
    }
    if dashed {
        let _ = write!(out, " stroke-dasharray=\"{} {}\"", DASHES.0, DASHES.1);
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
    if text.turned {
        let _ = write!(out, " transform=\"rotate(-90 {x} {y})\"");
    }
    out.push('>');
    let (by, small) = RAISED;
    let mut raised = false;
    for span in &text.spans {
        let text = escaped(&span.text);
        let _ = match (raised, span.raised) {
            (false, true) => write!(out, "<tspan dy=\"-{by}\" font-size=\"{small}\">{text}</tspan>"),
            (true, true) => write!(out, "<tspan font-size=\"{small}\">{text}</tspan>"),
            (true, false) => write!(out, "<tspan dy=\"{by}\">{text}</tspan>"),
            (false, false) => write!(out, "{text}"),
        };
        raised = span.raised;
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
