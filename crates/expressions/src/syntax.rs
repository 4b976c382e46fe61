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
//! atom      := number | name [ "(" argument { "," argument } ")" ] | "(" property ")" | "[" sum "," sum "]" | "inf"
//! span      := "[" sum "," sum "]"
//! argument  := property [ "where" property ]
//! name      := word { "." word | "." digits | "[" (digits | word) "]" }
//! domain    := sum [ ".." sum ]
//! ```

use crate::problem::Problem;
use arithmetic::{Rational, parse_rational, shown};
use std::fmt;
use winnow::Parser;
use winnow::ascii::{digit0, digit1};
use winnow::combinator::{self, alt, delimited, opt, peek, preceded, repeat, separated, separated_pair, terminated};
use winnow::error::{ErrMode, ParserError};
use winnow::stream::{AsChar, LocatingSlice, Location, Stateful};
use winnow::token::{any, one_of, take_until, take_while};

/// Deepest nesting.
const DEEPEST: usize = 100;

/// Most letters of a name with its owner and indices.
const LONGEST_NAME: usize = 200;

/// Most parts of an expression.
const MOST_PARTS: usize = 10_000;

/// An expression with its place: the byte of the text where it starts.
#[derive(Debug, Clone, PartialEq)]
pub struct Node {
    /// What it is made of.
    pub kind: NodeKind,
    /// The byte of the text where it starts.
    pub at: usize,
}

/// What an expression is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum NodeKind {
    /// A number, exact.
    Number(Rational),
    /// `inf`.
    Infinity,
    /// `name`, `owner.name`, `name[j].1`, `name(..)`.
    Name {
        /// The name with its owner, indices and component.
        name: String,
        /// What stands in the brackets.
        arguments: Vec<Node>,
        /// Whether there are brackets.
        called: bool,
    },
    /// `-a`.
    Negated(Box<Node>),
    /// Terms with whether they are subtracted.
    Sum(Vec<(bool, Node)>),
    /// Factors with whether they divide.
    Product(Vec<(bool, Node)>),
    /// `a^b`.
    Power(Box<Node>, Box<Node>),
    /// `a < b <= c`: each relation stands before its right side.
    Relation(Box<Node>, Vec<(Relation, Node)>),
    /// `not a`.
    Not(Box<Node>),
    /// `a and b`.
    And(Vec<Node>),
    /// `a or b`.
    Or(Vec<Node>),
    /// `a implies b`.
    Implies(Box<Node>, Box<Node>),
    /// `always[a, b] body` and `eventually[a, b] body`.
    Always(bool, Box<[Node; 3]>),
    /// `p until[a, b] q`: a, b, p, q.
    Until(Box<[Node; 4]>),
    /// `j where condition`, as an argument.
    Where(Box<Node>, Box<Node>),
    /// `a..b`, in families.
    Range(Box<Node>, Box<Node>),
    /// `[a, b]`, in families.
    Interval(Box<Node>, Box<Node>),
}

/// How two numbers are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `=`.
    Equal,
    /// `!=`.
    Different,
    /// `<`.
    Less,
    /// `<=`.
    AtMost,
    /// `>`.
    Greater,
    /// `>=`.
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
pub const KEYWORDS: [&str; 9] = ["and", "or", "not", "implies", "always", "eventually", "until", "where", "inf"];

/// A problem at a byte of the text.
pub type Located = (usize, Problem);

/// Reads a property or an expression of a law: something that is true or false, a number, a vector.
///
/// # Errors
/// The byte at fault, and what is wrong there.
pub fn parse_property(text: &str) -> Result<Node, Located> {
    whole(text, implies)
}

/// Reads what a name ranges over.
///
/// # Errors
/// The byte at fault, and what is wrong there.
pub fn parse_domain(text: &str) -> Result<Node, Located> {
    whole(text, domain)
}

/// What is left of the text, and what was made so far.
type Input<'a> = Stateful<LocatingSlice<&'a str>, Made>;

#[derive(Debug, Clone, Copy, Default)]
struct Made {
    depth: usize,
    parts: usize,
}

/// Signs and words that are not there are tried and passed over; whatever else is wrong ends the reading.
type Read<T> = Result<T, ErrMode<Wrong>>;

#[derive(Debug)]
struct Wrong(usize, Problem);

impl ParserError<Input<'_>> for Wrong {
    type Inner = Self;

    fn from_input(input: &Input) -> Self {
        unexpected(input, "something else")
    }

    fn into_inner(self) -> Result<Self, Self> {
        Ok(self)
    }
}

fn whole(text: &str, rule: fn(&mut Input) -> Read<Node>) -> Result<Node, Located> {
    let mut input = Stateful { input: LocatingSlice::new(text), state: Made::default() };
    let node = rule(&mut input).and_then(|node| {
        space(&mut input)?;
        if input.is_empty() { Ok(node) } else { Err(wrong(&mut input, "an operator or the end")) }
    });
    // Nothing waits for more text.
    let nothing = || (text.len(), Problem::expected("an expression", "the end"));
    node.map_err(|error| error.into_inner().map_or_else(|_| nothing(), |Wrong(at, problem)| (at, problem)))
}

/// What stands here instead of what is expected.
fn unexpected(input: &Input, expected: &str) -> Wrong {
    let rest: &str = input.input.as_ref();
    let word: String = rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
    let found = match rest.chars().next() {
        None => "the end".to_string(),
        Some(_) if !word.is_empty() => format!("`{}`", shown(&word)),
        Some(sign) => format!("`{sign}`"),
    };
    Wrong(input.current_token_start(), Problem::expected(expected, found))
}

fn wrong(input: &mut Input, expected: &str) -> ErrMode<Wrong> {
    space(input).map_or_else(|error| error, |()| ErrMode::Cut(unexpected(input, expected)))
}

fn refused<T>(at: usize, problem: impl Into<Problem>) -> Read<T> {
    Err(ErrMode::Cut(Wrong(at, problem.into())))
}

fn space(input: &mut Input) -> Read<()> {
    take_while(0.., char::is_whitespace).void().parse_next(input)
}

/// A sign if it stands here.
fn sign<'a>(sign: &'static str) -> impl Parser<Input<'a>, (), ErrMode<Wrong>> {
    preceded(space, sign).void()
}

/// Whether a sign stands here, which is then taken.
fn has(input: &mut Input, text: &'static str) -> Read<bool> {
    opt(sign(text)).map(|found| found.is_some()).parse_next(input)
}

fn need(text: &'static str) -> impl FnMut(&mut Input) -> Read<()> {
    move |input| if has(input, text)? { Ok(()) } else { Err(wrong(input, &format!("`{text}`"))) }
}

fn any_word<'a>(input: &mut Input<'a>) -> Read<&'a str> {
    let first = |c: char| c.is_ascii_alphabetic() || c == '_';
    preceded(space, (one_of(first), take_while(0.., |c: char| first(c) || c.is_ascii_digit())).take()).parse_next(input)
}

fn word<'a>(word: &'static str) -> impl Parser<Input<'a>, (), ErrMode<Wrong>> {
    any_word.verify(move |found: &str| found == word).void()
}

/// One level deeper.
fn deeper(rule: fn(&mut Input) -> Read<Node>) -> impl FnMut(&mut Input) -> Read<Node> {
    move |input| {
        if input.state.depth >= DEEPEST {
            return refused(input.current_token_start(), Problem::TooDeep(DEEPEST));
        }
        input.state.depth += 1;
        let node = rule(input);
        input.state.depth -= 1;
        node
    }
}

fn boxed<const N: usize>(kind: fn([Box<Node>; N]) -> NodeKind, nodes: [Node; N]) -> Node {
    Node { at: nodes[0].at, kind: kind(nodes.map(Box::new)) }
}

fn domain(input: &mut Input) -> Read<Node> {
    let first = sum(input)?;
    Ok(match opt(preceded(sign(".."), sum)).parse_next(input)? {
        Some(last) => boxed(|[a, b]| NodeKind::Range(a, b), [first, last]),
        None => first,
    })
}

fn implies(input: &mut Input) -> Read<Node> {
    let first = listed("or", NodeKind::Or, listed("and", NodeKind::And, until)).parse_next(input)?;
    Ok(match opt(preceded(word("implies"), deeper(implies))).parse_next(input)? {
        Some(second) => boxed(|[a, b]| NodeKind::Implies(a, b), [first, second]),
        None => first,
    })
}

fn listed<'a>(
    between: &'static str,
    kind: fn(Vec<Node>) -> NodeKind,
    rule: impl Parser<Input<'a>, Node, ErrMode<Wrong>>,
) -> impl Parser<Input<'a>, Node, ErrMode<Wrong>> {
    separated(1.., rule, word(between)).map(move |mut nodes: Vec<Node>| match nodes.len() {
        1 => nodes.remove(0),
        _ => Node { at: nodes[0].at, kind: kind(nodes) },
    })
}

fn until(input: &mut Input) -> Read<Node> {
    let first = not(input)?;
    Ok(match opt((preceded(word("until"), span), not)).parse_next(input)? {
        Some(((from, to), second)) => Node { at: first.at, kind: NodeKind::Until(Box::new([from, to, first, second])) },
        None => first,
    })
}

fn span(input: &mut Input) -> Read<(Node, Node)> {
    delimited(need("["), separated_pair(deeper(sum), need(","), deeper(sum)), need("]")).parse_next(input)
}

fn not(input: &mut Input) -> Read<Node> {
    space(input)?;
    let at = input.current_token_start();
    let timed = |always: bool| move |((from, to), body)| NodeKind::Always(always, Box::new([from, to, body]));
    let negated = preceded(word("not"), deeper(not)).map(|body| NodeKind::Not(Box::new(body)));
    let always = (preceded(word("always"), span), deeper(not)).map(timed(true));
    let eventually = (preceded(word("eventually"), span), deeper(not)).map(timed(false));
    match opt(alt((negated, always, eventually))).parse_next(input)? {
        Some(kind) => Ok(Node { kind, at }),
        None => relation(input),
    }
}

fn relation(input: &mut Input) -> Read<Node> {
    let first = sum(input)?;
    let signs = RELATIONS.map(|(text, relation)| sign(text).value(relation));
    let others: Vec<_> = repeat(0.., (alt(signs), sum)).parse_next(input)?;
    let at = first.at;
    Ok(if others.is_empty() { first } else { Node { kind: NodeKind::Relation(Box::new(first), others), at } })
}

fn sum(input: &mut Input) -> Read<Node> {
    chain(["+", "-"], NodeKind::Sum, product, input)
}

fn product(input: &mut Input) -> Read<Node> {
    chain(["*", "/"], NodeKind::Product, signed, input)
}

/// `rule` joined by a sign or by the inverse one, from left to right.
fn chain(
    signs: [&'static str; 2],
    kind: fn(Vec<(bool, Node)>) -> NodeKind,
    rule: fn(&mut Input) -> Read<Node>,
    input: &mut Input,
) -> Read<Node> {
    let first = rule(input)?;
    let joint = alt((sign(signs[0]).value(false), sign(signs[1]).value(true)));
    let others: Vec<(bool, Node)> = repeat(0.., (joint, rule)).parse_next(input)?;
    if others.is_empty() {
        return Ok(first);
    }
    let at = first.at;
    Ok(Node { kind: kind(std::iter::once((false, first)).chain(others).collect()), at })
}

fn signed(input: &mut Input) -> Read<Node> {
    space(input)?;
    let at = input.current_token_start();
    if has(input, "-")? {
        let body = deeper(signed)(input)?;
        let kind = match body.kind {
            NodeKind::Number(number) => NodeKind::Number(-number),
            kind => NodeKind::Negated(Box::new(Node { kind, at: body.at })),
        };
        return Ok(Node { kind, at });
    }
    let base = atom(input)?;
    Ok(match opt(preceded(sign("^"), deeper(signed))).parse_next(input)? {
        Some(exponent) => boxed(|[a, b]| NodeKind::Power(a, b), [base, exponent]),
        None => base,
    })
}

fn atom(input: &mut Input) -> Read<Node> {
    input.state.parts += 1;
    if input.state.parts > MOST_PARTS {
        return refused(input.current_token_start(), Problem::TooLong(MOST_PARTS));
    }
    space(input)?;
    let at = input.current_token_start();
    let kind = match peek(opt(any)).parse_next(input)? {
        Some('0'..='9' | '.') => number(input)?,
        Some('(') => delimited(need("("), deeper(implies), need(")")).parse_next(input)?.kind,
        Some('[') => span.map(|(from, to)| NodeKind::Interval(Box::new(from), Box::new(to))).parse_next(input)?,
        _ => match peek(opt(any_word)).parse_next(input)? {
            Some("inf") => word("inf").value(NodeKind::Infinity).parse_next(input)?,
            Some(found) if !KEYWORDS.contains(&found) => name(input)?,
            _ => return Err(wrong(input, "a number, a name or a bracket")),
        },
    };
    Ok(Node { kind, at })
}

fn number(input: &mut Input) -> Read<NodeKind> {
    let at = input.current_token_start();
    let decimals = opt((('.', peek(combinator::not('.'))), digit0));
    let exponent = opt((one_of(['e', 'E']), opt(one_of(['+', '-'])), digit1));
    let text = (digit0, decimals, exponent).take().parse_next(input)?;
    parse_rational(text).map(NodeKind::Number).or_else(|error| refused(at, error))
}

fn argument(input: &mut Input) -> Read<Node> {
    let first = implies(input)?;
    Ok(match opt(preceded(word("where"), implies)).parse_next(input)? {
        Some(condition) => boxed(|[a, b]| NodeKind::Where(a, b), [first, condition]),
        None => first,
    })
}

/// A name with owner and indices, `state.velocities[1][2]`, and its arguments.
fn name(input: &mut Input) -> Read<NodeKind> {
    let start = input.current_token_start();
    let mut name = any_word(input)?.to_string();
    loop {
        if name.len() > LONGEST_NAME {
            return refused(start, Problem::Other(format!("a name has at most {LONGEST_NAME} letters")));
        }
        if let Some(part) = opt(preceded(('.', peek(one_of(AsChar::is_alpha))), any_word)).parse_next(input)? {
            name = format!("{name}.{part}");
        } else if let Some(part) = opt(preceded('.', digit1)).parse_next(input)? {
            name = format!("{name}.{part}");
        } else if opt('[').parse_next(input)?.is_some() {
            name = format!("{name}[{}]", index(input)?);
        } else {
            break;
        }
    }
    let called = has(input, "(")?;
    let mut arguments = Vec::new();
    if called && !has(input, ")")? {
        arguments = separated(1.., deeper(argument), sign(",")).parse_next(input)?;
        if !has(input, ")")? {
            return Err(wrong(input, "`,` or `)`"));
        }
    }
    Ok(NodeKind::Name { name, arguments, called })
}

/// What stands between square brackets.
fn index<'a>(input: &mut Input<'a>) -> Read<&'a str> {
    let at = input.current_token_start();
    let Some(inside) = opt(terminated(take_until(0.., "]"), "]")).parse_next(input)? else {
        return refused(at - 1, Problem::expected("`]`", "the end"));
    };
    let index: &str = str::trim(inside);
    let number = index.bytes().all(|b| b.is_ascii_digit()) && index.len() <= 9;
    let letters = index.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_');
    let agent = letters && !index.starts_with(|c: char| c.is_ascii_digit());
    if index.is_empty() || !(number || agent) {
        return refused(at, Problem::expected("an index from 1, or an agent", format!("`{}`", shown(index))));
    }
    Ok(index)
}

impl Relation {
    /// The relation that holds where this one does not.
    pub fn turned(self) -> Self {
        match self {
            Relation::Equal => Relation::Different,
            Relation::Different => Relation::Equal,
            Relation::Less => Relation::AtLeast,
            Relation::AtMost => Relation::Greater,
            Relation::Greater => Relation::AtMost,
            Relation::AtLeast => Relation::Less,
        }
    }

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

impl NodeKind {
    /// How tightly it binds: what stands inside something tighter needs brackets.
    fn level(&self) -> u8 {
        match self {
            NodeKind::Implies(..) | NodeKind::Where(..) => 0,
            NodeKind::Or(_) => 1,
            NodeKind::And(_) => 2,
            NodeKind::Until(_) => 3,
            NodeKind::Not(_) | NodeKind::Always(..) => 4,
            NodeKind::Relation(..) => 5,
            NodeKind::Range(..) => 5,
            NodeKind::Sum(_) => 6,
            NodeKind::Product(_) => 7,
            NodeKind::Number(q) if !q.is_integer() => 7,
            NodeKind::Number(q) if *q < Rational::from_integer(0.into()) => 8,
            NodeKind::Negated(_) => 8,
            NodeKind::Power(..) => 9,
            NodeKind::Number(_) | NodeKind::Infinity | NodeKind::Name { .. } | NodeKind::Interval(..) => 10,
        }
    }
}

impl Node {
    /// Calls `f` with this node and all below it.
    pub fn visit<'n>(&'n self, f: &mut impl FnMut(&'n Node)) {
        f(self);
        match &self.kind {
            NodeKind::Number(_) | NodeKind::Infinity => {}
            NodeKind::Name { arguments, .. } => arguments.iter().for_each(|node| node.visit(f)),
            NodeKind::Negated(body) | NodeKind::Not(body) => body.visit(f),
            NodeKind::Sum(list) | NodeKind::Product(list) => list.iter().for_each(|(_, node)| node.visit(f)),
            NodeKind::And(list) | NodeKind::Or(list) => list.iter().for_each(|node| node.visit(f)),
            NodeKind::Power(a, b)
            | NodeKind::Implies(a, b)
            | NodeKind::Range(a, b)
            | NodeKind::Interval(a, b)
            | NodeKind::Where(a, b) => {
                a.visit(f);
                b.visit(f);
            }
            NodeKind::Relation(first, others) => {
                first.visit(f);
                others.iter().for_each(|(_, node)| node.visit(f));
            }
            NodeKind::Always(_, parts) => parts.iter().for_each(|node| node.visit(f)),
            NodeKind::Until(parts) => parts.iter().for_each(|node| node.visit(f)),
        }
    }

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
            NodeKind::Number(number) => write!(f, "{number}"),
            NodeKind::Infinity => write!(f, "inf"),
            NodeKind::Name { name, arguments, called } => {
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
            NodeKind::Negated(body) => {
                write!(f, "-")?;
                body.write(f, 8)
            }
            NodeKind::Sum(terms) => Node::chained(f, terms, [" + ", " - "], 6),
            NodeKind::Product(factors) => Node::chained(f, factors, ["*", "/"], 7),
            NodeKind::Power(base, exponent) => {
                base.write(f, 10)?;
                write!(f, "^")?;
                exponent.write(f, 8)
            }
            NodeKind::Relation(first, others) => {
                first.write(f, 6)?;
                for (relation, other) in others {
                    write!(f, " {} ", relation.sign())?;
                    other.write(f, 6)?;
                }
                Ok(())
            }
            NodeKind::Not(body) => {
                write!(f, "not ")?;
                body.write(f, 4)
            }
            NodeKind::And(nodes) => Node::joined(f, nodes, "and", 3),
            NodeKind::Or(nodes) => Node::joined(f, nodes, "or", 2),
            NodeKind::Implies(first, second) => {
                first.write(f, 1)?;
                write!(f, " implies ")?;
                second.write(f, 0)
            }
            NodeKind::Always(always, parts) => {
                let [from, to, body] = parts.as_ref();
                write!(f, "{}[{from}, {to}]({body})", if *always { "always" } else { "eventually" })
            }
            NodeKind::Until(parts) => {
                let [from, to, first, second] = parts.as_ref();
                first.write(f, 4)?;
                write!(f, " until[{from}, {to}] ")?;
                second.write(f, 4)
            }
            NodeKind::Where(agent, condition) => write!(f, "{agent} where {condition}"),
            NodeKind::Range(from, to) => write!(f, "{from}..{to}"),
            NodeKind::Interval(from, to) => write!(f, "[{from}, {to}]"),
        }
    }
}
