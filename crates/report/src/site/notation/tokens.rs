//! A text as words, numbers, signs and brackets, and what of it is a formula.

/// What a piece of text is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Kind {
    Word,
    Number,
    Sign,
    Space,
    /// Brackets with what is in them.
    Group(Vec<Node>),
    Other,
}

/// A piece of a text, from byte to byte.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Node {
    pub kind: Kind,
    pub start: usize,
    pub end: usize,
}

/// What a piece is to a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    Operand,
    Sign,
    Space,
    Prose,
}

/// Signs of more than one character, longest first.
const LONG_SIGNS: [&str; 15] =
    ["^^", "<<", ">>", "<=", ">=", "!=", ":=", "->", "=>", "<~", "+-", "-+", "...", "..", "||"];
const SIGNS: &str = "+-*/=<>^_|~'±·×≤≥≠→∈⊗∞∑√²³⌈⌉⌊⌋≈";

/// Words that stand for a Greek letter.
pub(super) const GREEK: [(&str, &str); 35] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("eps", "ε"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("th", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
    ("Upsilon", "Υ"),
    ("grad", "∇"),
];

/// Functions that are set upright.
pub(super) const FUNCTIONS: [&str; 24] = [
    "sin", "cos", "tan", "arctan", "exp", "log", "ln", "sqrt", "max", "min", "sup", "inf", "det", "dim", "ker", "rank",
    "span", "diag", "sgn", "Re", "Im", "spec", "binom", "deg",
];

/// Signs that are written as words and need a formula on both sides, or an index.
pub(super) const LARGE: [(&str, &str); 3] = [("sum", "∑"), ("prod", "∏"), ("int", "∫")];

/// The letter behind a word, and what stands over it: `thdot` is a theta with one dot.
pub(super) fn letter(word: &str) -> Option<(&str, &'static str)> {
    for (suffix, over) in [("ddot", "¨"), ("dot", "˙"), ("hat", "^"), ("bar", "¯"), ("tilde", "~"), ("", "")] {
        if let Some(base) = word.strip_suffix(suffix) {
            if let Some((_, greek)) = GREEK.iter().find(|(name, _)| *name == base) {
                return Some((greek, over));
            }
            if base.chars().count() == 1 {
                return Some((base, over));
            }
        }
    }
    None
}

impl Node {
    pub fn text<'a>(&self, text: &'a str) -> &'a str {
        &text[self.start..self.end]
    }

    pub fn is(&self, text: &str, what: &str) -> bool {
        !matches!(self.kind, Kind::Group(_)) && self.text(text) == what
    }

    /// Whether it is in brackets; then what is in them can be had from [`Node::inner`].
    pub fn group(&self) -> Option<&[Node]> {
        match &self.kind {
            Kind::Group(nodes) => Some(nodes),
            _ => None,
        }
    }

    /// The bracket that opens a group.
    pub fn open<'a>(&self, text: &'a str) -> &'a str {
        &text[self.start..self.start + 1]
    }

    /// The bracket that closes a group.
    pub fn close<'a>(&self, text: &'a str) -> &'a str {
        &text[self.end - 1..self.end]
    }

    /// Whether it is a list of lists: `[[1, 2], [3, 4]]`.
    pub fn is_matrix(&self, text: &str) -> bool {
        let is_row = |node: &Node| node.group().is_some() && node.open(text) == "[";
        let rows = self.group().unwrap_or_default();
        self.group().is_some()
            && self.open(text) == "["
            && rows.iter().any(is_row)
            && rows.iter().all(|node| is_row(node) || node.kind == Kind::Space || node.is(text, ","))
    }

    /// Whether there is more to it than numbers and what joins them.
    pub fn is_symbolic(&self, text: &str) -> bool {
        match &self.kind {
            Kind::Word => true,
            Kind::Sign => ["^", "<=", ">=", "!=", "=", "<", ">"].contains(&self.text(text)),
            Kind::Group(nodes) => self.is_matrix(text) || nodes.iter().any(|node| node.is_symbolic(text)),
            _ => false,
        }
    }
}

/// Brackets within so many others are characters like others: no text exhausts the stack.
const DEEPEST: usize = 40;

/// The pieces of a text, with brackets matched where they can be.
pub(super) fn tree(text: &str) -> Vec<Node> {
    let mut open: Vec<(char, usize, Vec<Node>)> = Vec::new();
    let mut nodes: Vec<Node> = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        let first = rest.chars().next().unwrap_or(' ');
        if let Some(bracket) = opening(text, at).filter(|_| open.len() < DEEPEST) {
            open.push((bracket, at, std::mem::take(&mut nodes)));
            at += 1;
            continue;
        }
        if let Some(k) =
            open.iter().rposition(|(bracket, ..)| closes(text, at, *bracket)).filter(|k| k + 1 == open.len())
        {
            let (_, start, before) = open.remove(k);
            let inside = std::mem::replace(&mut nodes, before);
            nodes.push(Node { kind: Kind::Group(inside), start, end: at + 1 });
            at += 1;
            continue;
        }
        let (kind, length) = piece(rest, first);
        nodes.push(Node { kind, start: at, end: at + length });
        at += length;
    }
    // A bracket that is never closed is a character like others.
    while let Some((_, start, mut before)) = open.pop() {
        before.push(Node { kind: Kind::Other, start, end: start + 1 });
        before.append(&mut nodes);
        nodes = before;
    }
    nodes
}

fn opening(text: &str, at: usize) -> Option<char> {
    match text[at..].chars().next()? {
        c @ ('(' | '[' | '{') => Some(c),
        // `<x, y>` has no space inside and none but a space or a bracket before; a comparison has both.
        '<' => {
            let before = text[..at].chars().next_back().is_none_or(|c| " ([{-+*|2".contains(c));
            let after = text[at + 1..].chars().next().is_some_and(|c| c.is_alphanumeric());
            (before && after && text[at..].contains('>')).then_some('<')
        }
        _ => None,
    }
}

fn closes(text: &str, at: usize, bracket: char) -> bool {
    match (bracket, text[at..].chars().next()) {
        ('(' | '[', Some(')' | ']')) | ('{', Some('}')) => true,
        ('<', Some('>')) => !text[..at].ends_with([' ', '-', '=']),
        _ => false,
    }
}

/// What a text begins with, and its length in bytes.
fn piece(rest: &str, first: char) -> (Kind, usize) {
    let while_true = |test: &dyn Fn(char) -> bool| rest.find(|c| !test(c)).unwrap_or(rest.len());
    if first == ' ' {
        return (Kind::Space, while_true(&|c| c == ' '));
    }
    if first.is_ascii_digit() {
        let whole = while_true(&|c| c.is_ascii_digit());
        let after = rest[whole..].strip_prefix('.').map_or("", |after| after);
        let decimals = after.find(|c: char| !c.is_ascii_digit()).unwrap_or(after.len());
        let mantissa = if decimals > 0 { whole + 1 + decimals } else { whole };
        let length = mantissa + exponent(&rest[mantissa..]);
        // A number that fills a line is better left to break anywhere.
        return (if length > 24 { Kind::Other } else { Kind::Number }, length);
    }
    if first.is_alphabetic() {
        return word(rest);
    }
    if let Some(sign) = LONG_SIGNS.iter().find(|sign| rest.starts_with(**sign)) {
        return (Kind::Sign, sign.len());
    }
    (if SIGNS.contains(first) { Kind::Sign } else { Kind::Other }, first.len_utf8())
}

/// The length of `e-12` behind a number.
fn exponent(after: &str) -> usize {
    let sign = after.strip_prefix('e').map(|digits| digits.strip_prefix(['-', '+']).unwrap_or(digits));
    let digits = sign.map_or(0, |digits| digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len()));
    sign.filter(|_| digits > 0).map_or(0, |rest| after.len() - rest.len() + digits)
}

/// A word with the digits behind it; words joined by hyphens, and with an apostrophe, are prose.
fn word(rest: &str) -> (Kind, usize) {
    let letters = |from: usize| rest[from..].find(|c: char| !c.is_alphabetic()).map_or(rest.len(), |k| from + k);
    let mut end = letters(0);
    let mut long = letters(0) > 1 && letter(&rest[..end]).is_none();
    let mut joined = false;
    while let Some(next) =
        rest[end..].strip_prefix(['-', '\'']).filter(|next| next.starts_with(|c: char| c.is_alphabetic()))
    {
        let start = rest.len() - next.len();
        let stop = letters(start);
        // `t-s` is a difference, `x-axis` and `paper's` are words.
        let part_is_long = stop - start > 1 || rest[end..].starts_with('\'');
        if !(long || part_is_long) {
            break;
        }
        (end, long, joined) = (stop, true, true);
    }
    if joined {
        return (Kind::Other, end);
    }
    let digits = rest[end..].find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len() - end);
    end += digits;
    // `paley_particles.eq21` is a name.
    let known = LARGE.iter().any(|(name, _)| *name == &rest[..end]) || FUNCTIONS.contains(&&rest[..end]);
    if long && !known && end > 2 && is_name(&rest[end..]) {
        let part_of_name = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
        let name = &rest[..rest.find(|c| !part_of_name(c)).unwrap_or(rest.len())];
        return (Kind::Other, name.trim_end_matches('.').len());
    }
    (Kind::Word, end)
}

/// Whether a word with this behind it is a name: `_` and more than one letter.
fn is_name(after: &str) -> bool {
    let mut letters = after.chars().skip(1);
    let mut letter = || letters.next().is_some_and(char::is_alphanumeric);
    after.starts_with('_') && letter() && letter()
}

/// What each piece is to a formula.
pub(super) fn classes(text: &str, nodes: &[Node]) -> Vec<Class> {
    // First what needs no neighbour, then what does.
    let sure: Vec<Option<Class>> = (0..nodes.len()).map(|k| surely(text, nodes, k)).collect();
    (0..nodes.len()).map(|k| sure[k].unwrap_or_else(|| by_neighbours(text, nodes, &sure, k))).collect()
}

fn neighbour(nodes: &[Node], k: usize, step: isize) -> Option<(usize, &Node, bool)> {
    let adjacent = k.checked_add_signed(step)?;
    let node = nodes.get(adjacent)?;
    if node.kind != Kind::Space {
        return Some((adjacent, node, true));
    }
    let beyond = adjacent.checked_add_signed(step)?;
    Some((beyond, nodes.get(beyond)?, false))
}

fn surely(text: &str, nodes: &[Node], k: usize) -> Option<Class> {
    let node = &nodes[k];
    let script = |step| {
        neighbour(nodes, k, step).is_some_and(|(_, n, adjacent)| adjacent && (n.is(text, "_") || n.is(text, "^")))
    };
    match &node.kind {
        Kind::Space => Some(Class::Space),
        Kind::Other => {
            let factorial = node.is(text, "!")
                && k > 0
                && nodes[k - 1].kind == Kind::Word
                && letter(nodes[k - 1].text(text)).is_some();
            Some(if factorial { Class::Operand } else { Class::Prose })
        }
        Kind::Number => Some(Class::Operand),
        // An index or exponent that is a sign.
        Kind::Sign if script(-1) => Some(Class::Operand),
        Kind::Sign => Some(match node.text(text) {
            "|" | "||" | "'" | "²" | "³" | "∞" | "⌈" | "⌉" | "⌊" | "⌋" => Class::Operand,
            ".." | "..." => {
                let beside = |step| neighbour(nodes, k, step).is_some_and(|(_, n, _)| n.kind == Kind::Sign);
                if beside(1) || beside(-1) { Class::Operand } else { Class::Prose }
            }
            _ => Class::Sign,
        }),
        Kind::Group(inside) => {
            if script(-1) {
                return Some(Class::Operand);
            }
            // A number or a letter in brackets that follows no formula is a reference.
            if inside.len() == 1 && node.open(text) == "(" && node.end - node.start < 5 {
                return None;
            }
            let inner = classes(text, inside);
            let comma = |n: &Node| [",", ";"].contains(&n.text(text)) || n.is(text, "..") || n.is(text, "...");
            let formula = inside.iter().zip(&inner).all(|(n, class)| *class != Class::Prose || comma(n));
            if inside.is_empty() || !formula {
                return Some(Class::Prose);
            }
            Some(Class::Operand)
        }
        Kind::Word => {
            let word = node.text(text);
            if script(1) || script(-1) {
                return Some(Class::Operand);
            }
            let unit = ["m", "s", "cm"].contains(&word)
                && k >= 2
                && nodes[k - 1].kind == Kind::Space
                && nodes[k - 2].kind == Kind::Number;
            let speed =
                ["m", "s"].contains(&word) && text[..node.end].ends_with("m/s") | text[node.start..].starts_with("m/s");
            if unit || speed {
                return Some(Class::Prose);
            }
            let bare = word.trim_end_matches(|c: char| c.is_ascii_digit());
            let ordinal = word == "th" && k > 0 && nodes[k - 1].kind == Kind::Number;
            // These are no letters with hats.
            let accented = ["that", "what", "chat"].contains(&word.to_lowercase().as_str());
            let abbreviated = abbreviates(text, node);
            let differential = word.strip_prefix('d').is_some_and(|rest| !rest.is_empty() && letter(rest).is_some());
            let divides = |step| neighbour(nodes, k, step).is_some_and(|(_, n, adjacent)| adjacent && n.is(text, "/"));
            let dotted = word == "dot" && k > 1 && nodes[k - 2].is(text, "_");
            match bare {
                _ if dotted => Some(Class::Operand),
                _ if differential && (divides(1) || divides(-1)) => Some(Class::Operand),
                _ if ordinal || accented || abbreviated => Some(Class::Prose),
                "a" | "A" | "I" if bare == word => None,
                _ if LARGE.iter().any(|(name, _)| *name == word) || FUNCTIONS.contains(&word) => None,
                "kron" => Some(Class::Sign),
                "x" if bare == word => None,
                "infinity" | "in" | "dt" | "ds" => None,
                _ if bare != word && bare.chars().count() > 1 && letter(bare).is_none() => Some(Class::Prose),
                _ => Some(if letter(bare).is_some() { Class::Operand } else { Class::Prose }),
            }
        }
    }
}

/// `a.e.`, `i.e.`
fn abbreviates(text: &str, node: &Node) -> bool {
    let letter_and_point =
        |mut rest: std::str::Chars| rest.next().is_some_and(char::is_alphabetic) && rest.next() == Some('.');
    let before: String = text[..node.start].chars().rev().take(2).collect();
    let after = text[node.end..].strip_prefix('.');
    (before.starts_with('.') && before.ends_with(char::is_alphabetic) && after.is_some())
        || after.is_some_and(|after| letter_and_point(after.chars()))
}

fn by_neighbours(text: &str, nodes: &[Node], sure: &[Option<Class>], k: usize) -> Class {
    let word = nodes[k].text(text);
    let before = neighbour(nodes, k, -1).map(|(at, node, near)| (sure[at], node, near));
    let after = neighbour(nodes, k, 1).map(|(at, node, near)| (sure[at], node, near));
    let class = |side: &Option<(Option<Class>, &Node, bool)>| side.as_ref().and_then(|(class, ..)| *class);
    let near = |side: &Option<(Option<Class>, &Node, bool)>| side.as_ref().is_some_and(|(_, _, near)| *near);
    let sign = |side: &Option<(Option<Class>, &Node, bool)>| class(side) == Some(Class::Sign);
    let operand = |side: &Option<(Option<Class>, &Node, bool)>| class(side) == Some(Class::Operand);
    let is_group = |side: &Option<(Option<Class>, &Node, bool)>| {
        side.as_ref().is_some_and(|(_, node, near)| *near && node.group().is_some())
    };
    let formula = match word {
        // An article stands before a word, a letter beside a sign.
        "a" | "A" | "I" => {
            sign(&before)
                || sign(&after)
                || (near(&before) && operand(&before))
                || (near(&after) && operand(&after))
                || is_group(&after)
        }
        "sum" | "prod" | "int" => (operand(&before) || sign(&before)) && operand(&after),
        "infinity" => sign(&before),
        "dt" | "ds" => before.as_ref().is_some_and(|(_, node, near)| *near && node.is(text, "/")) || operand(&before),
        "in" => {
            let set = after.as_ref().is_some_and(|(_, node, _)| {
                node.group().is_some_and(|_| node.open(text) != "(")
                    || ["E", "R", "Z", "span"].contains(&node.text(text))
            });
            if operand(&before) && set { return Class::Sign } else { false }
        }
        // Between two operands it is a sign.
        "x" => {
            let apart = |side: &Option<(Option<Class>, &Node, bool)>| operand(side) && !near(side);
            return if apart(&before) && apart(&after) { Class::Sign } else { Class::Operand };
        }
        _ if nodes[k].group().is_some() => {
            let function = before.as_ref().is_some_and(|(_, node, _)| FUNCTIONS.contains(&node.text(text)));
            near(&before) && (operand(&before) || function)
        }
        _ => is_group(&after) || operand(&after) || (near(&after) && sign(&after)),
    };
    if formula { Class::Operand } else { Class::Prose }
}
