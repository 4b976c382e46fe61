//! The language: one syntax tree, its grammar and its canonical text.
//!
//! ```text
//! property  := implies
//! implies   := or [ "implies" implies ]
//! or        := and { "or" and }
//! and       := until { "and" until }
//! until     := not [ "until" span not ]
//! not       := "not" not | ("always" | "eventually") span not | relation
//! relation  := sum { ("=" | "!=" | "<" | "<=" | ">" | ">=") sum }
//! sum       := product { ("+" | "-") product }
//! product   := sign { ("*" | "/") sign }
//! sign      := "-" sign | power
//! power     := atom [ "^" sign ]
//! atom      := number | name [ "(" list ")" ] | "(" property ")" | "[" sum "," sum "]" | "inf"
//! span      := "[" sum "," sum "]"
//! domain    := sum [ ".." sum ]
//! ```

use crate::error::Problem;
use arithmetic::{Rational, parse_rational, shown};
use std::fmt;

/// Deepest nesting.
const DEEPEST: usize = 100;

/// Most letters of a name with its owner and indices.
const LONGEST_NAME: usize = 200;

/// Most parts of an expression.
const MOST_PARTS: usize = 10_000;

/// An expression with its place: the byte of the text where it starts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    pub kind: Kind,
    pub at: usize,
}

/// What an expression is made of.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Kind {
    Number(Rational),
    Infinity,
    /// `name`, `owner.name`, `name(..)`; `called` where there are brackets.
    Name {
        name: String,
        arguments: Vec<Node>,
        called: bool,
    },
    Negated(Box<Node>),
    /// Terms with whether they are subtracted.
    Sum(Vec<(bool, Node)>),
    /// Factors with whether they divide.
    Product(Vec<(bool, Node)>),
    Power(Box<Node>, Box<Node>),
    /// `a < b <= c`: each relation stands before its right side.
    Relation(Box<Node>, Vec<(Relation, Node)>),
    Not(Box<Node>),
    And(Vec<Node>),
    Or(Vec<Node>),
    Implies(Box<Node>, Box<Node>),
    /// `always[a, b] body` and `eventually[a, b] body`.
    Always(bool, Box<[Node; 3]>),
    /// `p until[a, b] q`: a, b, p, q.
    Until(Box<[Node; 4]>),
    /// `a..b`, in families.
    Range(Box<Node>, Box<Node>),
    /// `[a, b]`, in families.
    Interval(Box<Node>, Box<Node>),
}

/// How two numbers are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Relation {
    Equal,
    Different,
    Less,
    AtMost,
    Greater,
    AtLeast,
}

const RELATIONS: [(&str, Relation); 7] = [
    ("<=", Relation::AtMost),
    (">=", Relation::AtLeast),
    ("!=", Relation::Different),
    ("==", Relation::Equal),
    ("=", Relation::Equal),
    ("<", Relation::Less),
    (">", Relation::Greater),
];

/// Words that are no names.
pub(crate) const KEYWORDS: [&str; 8] = ["and", "or", "not", "implies", "always", "eventually", "until", "inf"];

/// A problem at a byte of the text.
pub(crate) type Located = (usize, Problem);

/// Reads a property: something that is true or false, or a number.
pub(crate) fn parse_property(text: &str) -> Result<Node, Located> {
    Parser::new(text).whole(Parser::implies)
}

/// Reads what a name ranges over.
pub(crate) fn parse_domain(text: &str) -> Result<Node, Located> {
    Parser::new(text).whole(Parser::domain)
}

struct Parser<'a> {
    text: &'a str,
    at: usize,
    depth: usize,
    parts: usize,
}

impl<'a> Parser<'a> {
    fn new(text: &'a str) -> Self {
        Parser { text, at: 0, depth: 0, parts: 0 }
    }

    fn whole(mut self, rule: impl FnOnce(&mut Self) -> Result<Node, Located>) -> Result<Node, Located> {
        let node = rule(&mut self)?;
        self.space();
        if self.at < self.text.len() {
            return Err(self.wrong("an operator or the end"));
        }
        Ok(node)
    }

    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn space(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    /// What stands here instead of what is expected.
    fn wrong(&mut self, expected: &str) -> Located {
        self.space();
        let rest = self.rest();
        let word: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
        let found = match rest.chars().next() {
            None => "the end".to_string(),
            Some(_) if !word.is_empty() => format!("`{}`", shown(&word)),
            Some(sign) => format!("`{sign}`"),
        };
        (self.at, Problem::expected(expected, found))
    }

    /// Takes a sign if it stands here.
    fn sign(&mut self, sign: &str) -> bool {
        self.space();
        let found = self.rest().starts_with(sign);
        self.at += if found { sign.len() } else { 0 };
        found
    }

    fn need(&mut self, sign: &str) -> Result<(), Located> {
        if self.sign(sign) { Ok(()) } else { Err(self.wrong(&format!("`{sign}`"))) }
    }

    /// The word that stands here.
    fn peek(&mut self) -> &'a str {
        self.space();
        let rest = self.rest();
        let starts = rest.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
        let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_').unwrap_or(rest.len());
        if starts { &rest[..end] } else { "" }
    }

    fn word(&mut self, word: &str) -> bool {
        let found = self.peek() == word;
        self.at += if found { word.len() } else { 0 };
        found
    }

    /// One level deeper.
    fn deeper(&mut self, rule: impl FnOnce(&mut Self) -> Result<Node, Located>) -> Result<Node, Located> {
        if self.depth >= DEEPEST {
            return Err((self.at, Problem::TooDeep(DEEPEST)));
        }
        self.depth += 1;
        let node = rule(self);
        self.depth -= 1;
        node
    }

    fn domain(&mut self) -> Result<Node, Located> {
        self.space();
        let at = self.at;
        let first = self.sum()?;
        if !self.sign("..") {
            return Ok(first);
        }
        let last = self.sum()?;
        Ok(Node { kind: Kind::Range(Box::new(first), Box::new(last)), at })
    }

    fn implies(&mut self) -> Result<Node, Located> {
        let first = self.listed("or", Kind::Or, |p| p.listed("and", Kind::And, Self::until))?;
        if !self.word("implies") {
            return Ok(first);
        }
        let second = self.deeper(Self::implies)?;
        Ok(Node { at: first.at, kind: Kind::Implies(Box::new(first), Box::new(second)) })
    }

    fn listed(
        &mut self,
        word: &str,
        kind: fn(Vec<Node>) -> Kind,
        rule: impl Fn(&mut Self) -> Result<Node, Located>,
    ) -> Result<Node, Located> {
        let mut nodes = vec![rule(self)?];
        while self.word(word) {
            nodes.push(rule(self)?);
        }
        let at = nodes[0].at;
        Ok(if nodes.len() == 1 { nodes.remove(0) } else { Node { kind: kind(nodes), at } })
    }

    fn until(&mut self) -> Result<Node, Located> {
        let first = self.not()?;
        if !self.word("until") {
            return Ok(first);
        }
        let (from, to) = self.span()?;
        let second = self.not()?;
        Ok(Node { at: first.at, kind: Kind::Until(Box::new([from, to, first, second])) })
    }

    fn span(&mut self) -> Result<(Node, Node), Located> {
        self.need("[")?;
        let from = self.deeper(Self::sum)?;
        self.need(",")?;
        let to = self.deeper(Self::sum)?;
        self.need("]")?;
        Ok((from, to))
    }

    fn not(&mut self) -> Result<Node, Located> {
        self.space();
        let at = self.at;
        if self.word("not") {
            let body = self.deeper(Self::not)?;
            return Ok(Node { kind: Kind::Not(Box::new(body)), at });
        }
        for (word, always) in [("always", true), ("eventually", false)] {
            if self.word(word) {
                let (from, to) = self.span()?;
                let body = self.deeper(Self::not)?;
                return Ok(Node { kind: Kind::Always(always, Box::new([from, to, body])), at });
            }
        }
        self.relation()
    }

    fn relation(&mut self) -> Result<Node, Located> {
        let first = self.sum()?;
        let mut others = Vec::new();
        while let Some((_, relation)) = RELATIONS.into_iter().find(|(sign, _)| self.sign(sign)) {
            others.push((relation, self.sum()?));
        }
        let at = first.at;
        Ok(if others.is_empty() { first } else { Node { kind: Kind::Relation(Box::new(first), others), at } })
    }

    fn sum(&mut self) -> Result<Node, Located> {
        self.chain('+', '-', Kind::Sum, Self::product)
    }

    fn product(&mut self) -> Result<Node, Located> {
        self.chain('*', '/', Kind::Product, Self::signed)
    }

    /// `rule` joined by `plain` and `inverse`, from left to right.
    fn chain(
        &mut self,
        plain: char,
        inverse: char,
        kind: fn(Vec<(bool, Node)>) -> Kind,
        rule: fn(&mut Self) -> Result<Node, Located>,
    ) -> Result<Node, Located> {
        let mut nodes = vec![(false, rule(self)?)];
        loop {
            let inverted = if self.sign(plain.encode_utf8(&mut [0; 4])) {
                false
            } else if self.sign(inverse.encode_utf8(&mut [0; 4])) {
                true
            } else {
                break;
            };
            nodes.push((inverted, rule(self)?));
        }
        let at = nodes[0].1.at;
        Ok(if nodes.len() == 1 { nodes.remove(0).1 } else { Node { kind: kind(nodes), at } })
    }

    fn signed(&mut self) -> Result<Node, Located> {
        self.space();
        let at = self.at;
        if self.sign("-") {
            let body = self.deeper(Self::signed)?;
            let kind = match body.kind {
                Kind::Number(number) => Kind::Number(-number),
                kind => Kind::Negated(Box::new(Node { kind, at: body.at })),
            };
            return Ok(Node { kind, at });
        }
        let base = self.atom()?;
        if !self.sign("^") {
            return Ok(base);
        }
        let exponent = self.deeper(Self::signed)?;
        Ok(Node { at, kind: Kind::Power(Box::new(base), Box::new(exponent)) })
    }

    fn atom(&mut self) -> Result<Node, Located> {
        self.parts += 1;
        if self.parts > MOST_PARTS {
            return Err((self.at, Problem::TooLong(MOST_PARTS)));
        }
        self.space();
        let at = self.at;
        let kind = match self.rest().chars().next() {
            Some(c) if c.is_ascii_digit() || c == '.' => self.number()?,
            Some('(') => {
                self.at += 1;
                let inner = self.deeper(Self::implies)?;
                self.need(")")?;
                return Ok(Node { kind: inner.kind, at });
            }
            Some('[') => {
                let (from, to) = self.span()?;
                Kind::Interval(Box::new(from), Box::new(to))
            }
            _ => match self.peek() {
                "inf" => {
                    self.at += 3;
                    Kind::Infinity
                }
                word if word.is_empty() || KEYWORDS.contains(&word) => {
                    return Err(self.wrong("a number, a name or a bracket"));
                }
                _ => self.name()?,
            },
        };
        Ok(Node { kind, at })
    }

    fn number(&mut self) -> Result<Kind, Located> {
        let bytes = self.rest().as_bytes();
        let digits = |from: usize| bytes[from..].iter().take_while(|b| b.is_ascii_digit()).count();
        let mut end = digits(0);
        if bytes.get(end) == Some(&b'.') && bytes.get(end + 1) != Some(&b'.') {
            end += 1 + digits(end + 1);
        }
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
            let exponent = digits(end + 1 + sign);
            end += if exponent > 0 { 1 + sign + exponent } else { 0 };
        }
        let number = parse_rational(&self.rest()[..end]).map_err(|error| (self.at, error.into()))?;
        self.at += end;
        Ok(Kind::Number(number))
    }

    /// A name with owner and indices, `state.velocities[1][2]`, and its arguments.
    fn name(&mut self) -> Result<Kind, Located> {
        let start = self.at;
        let mut name = self.peek().to_string();
        self.at += name.len();
        loop {
            if name.len() > LONGEST_NAME {
                return Err((start, Problem::Other(format!("a name has at most {LONGEST_NAME} letters"))));
            }
            let rest = self.rest();
            let bytes = rest.as_bytes();
            if bytes.first() == Some(&b'.') && bytes.get(1).is_some_and(u8::is_ascii_alphabetic) {
                self.at += 1;
                let part = self.peek();
                name = format!("{name}.{part}");
                self.at += part.len();
            } else if bytes.first() == Some(&b'[') {
                let end = rest.find(']').ok_or_else(|| (self.at, Problem::expected("`]`", "the end")))?;
                let index = rest[1..end].trim();
                if index.is_empty() || !index.bytes().all(|b| b.is_ascii_digit()) || index.len() > 9 {
                    return Err((self.at + 1, Problem::expected("an index from 1", format!("`{}`", shown(index)))));
                }
                name = format!("{name}[{index}]");
                self.at += end + 1;
            } else {
                break;
            }
        }
        let mut arguments = Vec::new();
        let called = self.sign("(");
        if called && !self.sign(")") {
            loop {
                arguments.push(self.deeper(Self::implies)?);
                if !self.sign(",") {
                    break;
                }
            }
            if !self.sign(")") {
                return Err(self.wrong("`,` or `)`"));
            }
        }
        Ok(Kind::Name { name, arguments, called })
    }
}

impl Relation {
    /// Its sign.
    pub fn sign(self) -> &'static str {
        match self {
            Relation::Equal => "=",
            Relation::Different => "!=",
            Relation::Less => "<",
            Relation::AtMost => "<=",
            Relation::Greater => ">",
            Relation::AtLeast => ">=",
        }
    }
}

impl Kind {
    /// How tightly it binds: what stands inside something tighter needs brackets.
    fn level(&self) -> u8 {
        match self {
            Kind::Implies(..) => 0,
            Kind::Or(_) => 1,
            Kind::And(_) => 2,
            Kind::Until(_) => 3,
            Kind::Not(_) | Kind::Always(..) => 4,
            Kind::Relation(..) => 5,
            Kind::Range(..) => 5,
            Kind::Sum(_) => 6,
            Kind::Product(_) => 7,
            Kind::Number(q) if !q.is_integer() => 7,
            Kind::Number(q) if *q < Rational::from_integer(0.into()) => 8,
            Kind::Negated(_) => 8,
            Kind::Power(..) => 9,
            Kind::Number(_) | Kind::Infinity | Kind::Name { .. } | Kind::Interval(..) => 10,
        }
    }
}

impl Node {
    /// Writes it, in brackets where it binds less than `level`.
    fn write(&self, f: &mut fmt::Formatter<'_>, level: u8) -> fmt::Result {
        if self.kind.level() < level {
            return write!(f, "({self})");
        }
        write!(f, "{self}")
    }

    fn joined(f: &mut fmt::Formatter<'_>, nodes: &[Node], word: &str, level: u8) -> fmt::Result {
        for (k, node) in nodes.iter().enumerate() {
            if k > 0 {
                write!(f, " {word} ")?;
            }
            node.write(f, level)?;
        }
        Ok(())
    }

    fn chained(f: &mut fmt::Formatter<'_>, nodes: &[(bool, Node)], signs: [&str; 2], level: u8) -> fmt::Result {
        for (k, (inverse, node)) in nodes.iter().enumerate() {
            if k > 0 {
                write!(f, "{}", signs[usize::from(*inverse)])?;
            }
            node.write(f, if k == 0 { level } else { level + 1 })?;
        }
        Ok(())
    }
}

/// The canonical text: it does not depend on spaces, needless brackets or how numbers are written.
impl fmt::Display for Node {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.kind {
            Kind::Number(number) => write!(f, "{number}"),
            Kind::Infinity => write!(f, "inf"),
            Kind::Name { name, arguments, called } => {
                write!(f, "{name}")?;
                if *called {
                    write!(f, "(")?;
                    for (k, argument) in arguments.iter().enumerate() {
                        write!(f, "{}{argument}", if k > 0 { ", " } else { "" })?;
                    }
                    write!(f, ")")?;
                }
                Ok(())
            }
            Kind::Negated(body) => {
                write!(f, "-")?;
                body.write(f, 8)
            }
            Kind::Sum(terms) => Node::chained(f, terms, [" + ", " - "], 6),
            Kind::Product(factors) => Node::chained(f, factors, ["*", "/"], 7),
            Kind::Power(base, exponent) => {
                base.write(f, 10)?;
                write!(f, "^")?;
                exponent.write(f, 8)
            }
            Kind::Relation(first, others) => {
                first.write(f, 6)?;
                for (relation, other) in others {
                    write!(f, " {} ", relation.sign())?;
                    other.write(f, 6)?;
                }
                Ok(())
            }
            Kind::Not(body) => {
                write!(f, "not ")?;
                body.write(f, 4)
            }
            Kind::And(nodes) => Node::joined(f, nodes, "and", 3),
            Kind::Or(nodes) => Node::joined(f, nodes, "or", 2),
            Kind::Implies(first, second) => {
                first.write(f, 1)?;
                write!(f, " implies ")?;
                second.write(f, 0)
            }
            Kind::Always(always, parts) => {
                let [from, to, body] = parts.as_ref();
                write!(f, "{}[{from}, {to}]({body})", if *always { "always" } else { "eventually" })
            }
            Kind::Until(parts) => {
                let [from, to, first, second] = parts.as_ref();
                first.write(f, 4)?;
                write!(f, " until[{from}, {to}] ")?;
                second.write(f, 4)
            }
            Kind::Range(from, to) => write!(f, "{from}..{to}"),
            Kind::Interval(from, to) => write!(f, "[{from}, {to}]"),
        }
    }
}
