//! Pieces of a formula as MathML.

use super::tokens::{FUNCTIONS, Kind, LARGE, Node, letter};
use crate::page::escape;

/// A formula; between its terms the line may be broken.
pub(super) fn formula(text: &str, nodes: &[Node]) -> String {
    let mut terms: Vec<String> = vec![String::new()];
    for part in row(text, nodes, true) {
        if part.breaks && terms.last().is_some_and(|term| !term.is_empty()) {
            terms.push(String::new());
        }
        if let Some(term) = terms.last_mut() {
            term.push_str(&part.xml);
        }
    }
    let terms: Vec<String> =
        terms.into_iter().filter(|term| !term.is_empty()).map(|term| format!("<math>{term}</math>")).collect();
    terms.join("<wbr>")
}

/// A part of a row.
struct Part {
    xml: String,
    /// Whether a line may be broken before it.
    breaks: bool,
    /// Whether something must stand before it that it acts on.
    infix: bool,
}

/// Groups with more characters than this may be broken inside.
const LONG: usize = 20;

fn joined(parts: Vec<Part>) -> String {
    parts.into_iter().map(|part| part.xml).collect()
}

fn grouped(text: &str, nodes: &[Node]) -> String {
    let parts = row(text, nodes, false);
    if parts.len() == 1 { joined(parts) } else { format!("<mrow>{}</mrow>", joined(parts)) }
}

/// The parts of a row; at the top long groups are opened, so that they can be broken.
fn row(text: &str, nodes: &[Node], top: bool) -> Vec<Part> {
    let mut parts: Vec<Part> = Vec::new();
    let mut at = 0;
    let mut spaced = false;
    while at < nodes.len() {
        let node = &nodes[at];
        if node.kind == Kind::Space {
            (spaced, at) = (true, at + 1);
            continue;
        }
        // An x that ends a formula is a letter: x^T L x.
        let last = nodes[at + 1..].iter().all(|node| node.kind == Kind::Space);
        if let Some(sign) = infix(text, node, &parts).filter(|sign| !last || *sign != "×") {
            // A sign at the start of a term keeps the room that it has between two.
            let prefix = parts.last().is_none_or(|last| last.infix);
            let form = if prefix { "prefix" } else { "infix" };
            let fence = if sign == "/" { " lspace=\"0\" rspace=\"0\"" } else { " stretchy=\"false\"" };
            parts.push(Part {
                xml: format!("<mo form=\"{form}\"{fence}>{}</mo>", escape(sign)),
                breaks: !prefix && sign != "/",
                infix: true,
            });
            (spaced, at) = (false, at + 1);
            continue;
        }
        if spaced && parts.last().is_some_and(|last| !last.infix) {
            parts.push(Part { xml: "<mspace width=\"0.2em\"/>".to_string(), breaks: top, infix: false });
        }
        spaced = false;
        let long = top && node.group().is_some() && !node.is_matrix(text) && node.end - node.start > LONG;
        let (xml, next) = if long { opened(text, nodes, at, &mut parts) } else { operand(text, nodes, at) };
        parts.push(Part { xml, breaks: false, infix: false });
        at = next;
    }
    parts
}

/// The sign that a piece is between two others.
fn infix<'a>(text: &'a str, node: &Node, before: &[Part]) -> Option<&'a str> {
    let sign = match (&node.kind, node.text(text)) {
        (Kind::Word, "kron") => "⊗",
        (Kind::Word, "in") => "∈",
        (Kind::Word, "x") if is_times(text, node) && before.last().is_some_and(|last| !last.infix) => "×",
        (Kind::Group(_) | Kind::Word | Kind::Number, _) => return None,
        (_, "-") => "−",
        (_, "*") => "·",
        (_, "<<") => "≪",
        (_, ">>") => "≫",
        (_, "-+") => "∓",
        (_, "<=") => "≤",
        (_, ">=") => "≥",
        (_, "!=") => "≠",
        (_, "->") => "→",
        (_, "=>") => "⇒",
        (_, "<~") => "≲",
        (_, "+-") => "±",
        (_, "^^") => "↑↑",
        (_, ".." | "...") => "…",
        (_, "'" | "!" | "|" | "||" | "^" | "_" | "²" | "³" | "∞" | "⌈" | "⌉" | "⌊" | "⌋") => return None,
        (_, other) => other,
    };
    // A star that acts on nothing is a star.
    Some(if sign == "·" && before.is_empty() { "*" } else { sign })
}

/// An x that stands apart, with something other than a sign on both sides.
fn is_times(text: &str, node: &Node) -> bool {
    let before = text[..node.start].strip_suffix(' ').and_then(|rest| rest.chars().next_back());
    let after = text[node.end..].strip_prefix(' ').and_then(|rest| rest.chars().next());
    before.is_some_and(|c| c.is_alphanumeric() || ")]}".contains(c))
        && after.is_some_and(|c| c.is_alphanumeric() || "([{".contains(c))
}

/// A matrix: its rows and their cells.
fn matrix(text: &str, rows: &[Node]) -> String {
    let mut out = String::new();
    for row in rows.iter().filter_map(Node::group) {
        let cells = row.split(|node| node.is(text, ","));
        out.push_str("<mtr>");
        out.extend(cells.map(|cell| format!("<mtd>{}</mtd>", grouped(text, cell))));
        out.push_str("</mtr>");
    }
    format!("<mrow><mo>[</mo><mtable>{out}</mtable><mo>]</mo></mrow>")
}

/// A long group at the top: its brackets and its parts, the closing one with its exponent.
fn opened(text: &str, nodes: &[Node], at: usize, parts: &mut Vec<Part>) -> (String, usize) {
    let node = &nodes[at];
    let (open, close) = brackets(text, node);
    parts.push(Part { xml: bracket(open, "prefix"), breaks: false, infix: true });
    parts.extend(row(text, node.group().unwrap_or_default(), true));
    scripts(text, nodes, at + 1, bracket(close, "postfix"))
}

fn brackets<'a>(text: &'a str, node: &Node) -> (&'a str, &'a str) {
    match node.open(text) {
        "<" => ("⟨", "⟩"),
        open => (open, node.close(text)),
    }
}

fn bracket(sign: &str, form: &str) -> String {
    format!("<mo form=\"{form}\" stretchy=\"false\">{sign}</mo>")
}

/// One operand with its indices and exponents, and where the next piece is.
fn operand(text: &str, nodes: &[Node], at: usize) -> (String, usize) {
    let node = &nodes[at];
    match &node.kind {
        Kind::Group(rows) if node.is_matrix(text) => scripts(text, nodes, at + 1, matrix(text, rows)),
        Kind::Group(inside) => {
            let (open, close) = brackets(text, node);
            let inside = joined(row(text, inside, false));
            let xml = format!("<mrow>{}{inside}{}</mrow>", bracket(open, "prefix"), bracket(close, "postfix"));
            scripts(text, nodes, at + 1, xml)
        }
        Kind::Number => scripts(text, nodes, at + 1, format!("<mn>{}</mn>", node.text(text))),
        Kind::Word => word(text, nodes, at),
        _ => {
            let sign = match node.text(text) {
                "||" => "‖",
                "'" => "′",
                "²" => return ("<msup><mi></mi><mn>2</mn></msup>".to_string(), at + 1),
                "³" => return ("<msup><mi></mi><mn>3</mn></msup>".to_string(), at + 1),
                other => other,
            };
            let xml = format!("<mo form=\"prefix\" stretchy=\"false\" lspace=\"0\" rspace=\"0\">{}</mo>", escape(sign));
            if ["|", "||", "⌉", "⌋"].contains(&node.text(text)) {
                scripts(text, nodes, at + 1, xml)
            } else {
                (xml, at + 1)
            }
        }
    }
}

fn word(text: &str, nodes: &[Node], at: usize) -> (String, usize) {
    let word = nodes[at].text(text);
    let adjacent = nodes.get(at + 1).filter(|next| next.group().is_some() && next.open(text) == "(");
    match (word, adjacent.and_then(|next| next.group())) {
        ("sqrt", Some(inside)) => {
            return scripts(text, nodes, at + 2, format!("<msqrt>{}</msqrt>", grouped(text, inside)));
        }
        ("binom", Some(inside)) => {
            if let Some(comma) = inside.iter().position(|node| node.is(text, ",")) {
                let (above, below) = (grouped(text, &inside[..comma]), grouped(text, &inside[comma + 1..]));
                let xml = format!("<mrow><mo>(</mo><mfrac linethickness=\"0\">{above}{below}</mfrac><mo>)</mo></mrow>");
                return scripts(text, nodes, at + 2, xml);
            }
        }
        ("infinity", _) => return ("<mi>∞</mi>".to_string(), at + 1),
        _ => {}
    }
    if let Some((_, sign)) = LARGE.iter().find(|(name, _)| *name == word) {
        return scripts(
            text,
            nodes,
            at + 1,
            format!("<mo form=\"prefix\" largeop=\"false\" movablelimits=\"false\" rspace=\"0.2em\">{sign}</mo>"),
        );
    }
    if FUNCTIONS.contains(&word) {
        let (xml, next) = scripts(text, nodes, at + 1, format!("<mi>{word}</mi>"));
        let room = nodes.get(next).is_some_and(|after| after.kind == Kind::Space);
        return (if room { xml + "<mspace width=\"0.17em\"/>" } else { xml }, next);
    }
    let (base, digits) = word.split_at(word.trim_end_matches(|c: char| c.is_ascii_digit()).len());
    // The paper writes an omega where the ledger has `w0`.
    let base = if word == "w0" { "omega" } else { base };
    let (name, over) = letter(base).unwrap_or((base, ""));
    let differential = base.strip_prefix('d').and_then(letter).filter(|_| letter(base).is_none());
    let mut xml = match name.chars().count() {
        _ if differential.is_some() => format!("<mi>d</mi><mi>{}</mi>", differential.map_or("", |(name, _)| name)),
        2 => name.chars().map(|c| format!("<mi>{c}</mi>")).collect(),
        1 if name == "∇" => "<mi mathvariant=\"normal\">∇</mi>".to_string(),
        _ => format!("<mi>{}</mi>", escape(name)),
    };
    if !over.is_empty() {
        xml = format!("<mover>{xml}<mo stretchy=\"false\">{over}</mo></mover>");
    }
    if !digits.is_empty() {
        xml = format!("<msub>{xml}<mn>{digits}</mn></msub>");
    }
    // Two letters are one base.
    let xml = if xml.matches("<mi>").count() > 1 { format!("<mrow>{xml}</mrow>") } else { xml };
    scripts(text, nodes, at + 1, xml)
}

/// Adds the indices and exponents that follow a base; `W_1dot` has its dot behind the index.
fn scripts(text: &str, nodes: &[Node], mut at: usize, base: String) -> (String, usize) {
    let (mut below, mut above, mut primes) = (None, None, 0);
    let mut base = base;
    while let Some(node) = nodes.get(at) {
        let node_text = if node.group().is_some() { "" } else { node.text(text) };
        match node_text {
            "_" if below.is_none() => (below, at) = script(text, nodes, at + 1),
            "^" if above.is_none() => (above, at) = script(text, nodes, at + 1),
            "'" => (primes, at) = (primes + 1, at + 1),
            "²" if above.is_none() => (above, at) = (Some("<mn>2</mn>".to_string()), at + 1),
            "³" if above.is_none() => (above, at) = (Some("<mn>3</mn>".to_string()), at + 1),
            "dot" if below.is_some() => {
                base = format!("<mover>{base}<mo stretchy=\"false\">˙</mo></mover>");
                at += 1;
            }
            "!" => {
                base = format!("<mrow>{base}<mo form=\"postfix\" lspace=\"0\" rspace=\"0\">!</mo></mrow>");
                at += 1;
            }
            _ => break,
        }
    }
    let above = match (above, primes) {
        (above, 0) => above,
        (None, n) => Some(format!("<mo>{}</mo>", "′".repeat(n))),
        (Some(above), n) => Some(format!("<mrow><mo>{}</mo>{above}</mrow>", "′".repeat(n))),
    };
    let xml = match (below, above) {
        (None, None) => base,
        (Some(below), None) => format!("<msub>{base}{below}</msub>"),
        (None, Some(above)) => format!("<msup>{base}{above}</msup>"),
        (Some(below), Some(above)) => format!("<msubsup>{base}{below}{above}</msubsup>"),
    };
    (xml, at)
}

/// One index or exponent: a group, or a sign with what it stands before.
fn script(text: &str, nodes: &[Node], at: usize) -> (Option<String>, usize) {
    let Some(node) = nodes.get(at) else { return (Some("<mo>_</mo>".to_string()), at) };
    match &node.kind {
        Kind::Group(inside) if node.open(text) == "{" || (node.open(text) == "(" && inside.len() > 1) => {
            (Some(grouped(text, inside)), at + 1)
        }
        Kind::Sign if ["-", "+", "+-", "*"].contains(&node.text(text)) => {
            let sign = match node.text(text) {
                "-" => "−",
                "+-" => "±",
                other => other,
            };
            let next = nodes.get(at + 1).filter(|next| matches!(next.kind, Kind::Word | Kind::Number | Kind::Group(_)));
            match next.filter(|_| sign != "*") {
                None => (Some(format!("<mo>{sign}</mo>")), at + 1),
                Some(_) => {
                    let (xml, end) = plain(text, nodes, at + 1);
                    (Some(format!("<mrow><mo form=\"prefix\">{sign}</mo>{xml}</mrow>")), end)
                }
            }
        }
        _ => {
            let (xml, end) = plain(text, nodes, at);
            (Some(xml), end)
        }
    }
}

/// A letter, some letters or a number as an index, with the brackets that follow a letter: `n^O(n)`.
fn plain(text: &str, nodes: &[Node], at: usize) -> (String, usize) {
    let node = &nodes[at];
    let word = node.text(text);
    let xml = match &node.kind {
        Kind::Number => format!("<mn>{word}</mn>"),
        Kind::Group(inside) => format!(
            "<mrow><mo form=\"prefix\" stretchy=\"false\">(</mo>{}<mo form=\"postfix\" stretchy=\"false\">)</mo></mrow>",
            grouped(text, inside)
        ),
        Kind::Word => {
            let (base, digits) = word.split_at(word.trim_end_matches(|c: char| c.is_ascii_digit()).len());
            let name = match letter(base) {
                _ if base == "perp" => "<mo>⊥</mo>".to_string(),
                Some((name, _)) => format!("<mi>{name}</mi>"),
                // Two letters are two indices, more are a word.
                None if base.chars().count() == 2 => base.chars().map(|c| format!("<mi>{c}</mi>")).collect(),
                None => format!("<mtext>{}</mtext>", escape(base)),
            };
            let digits = if digits.is_empty() { String::new() } else { format!("<mn>{digits}</mn>") };
            format!("<mrow>{name}{digits}</mrow>")
        }
        _ => format!("<mo>{}</mo>", escape(word)),
    };
    let applied = nodes.get(at + 1).filter(|next| word == "O" && next.group().is_some() && next.open(text) == "(");
    match applied.and_then(|next| next.group()) {
        Some(inside) => (
            format!(
                "<mrow>{xml}<mo form=\"prefix\" stretchy=\"false\">(</mo>{}<mo form=\"postfix\" stretchy=\"false\">)</mo></mrow>",
                grouped(text, inside)
            ),
            at + 2,
        ),
        None => (xml, at + 1),
    }
}
