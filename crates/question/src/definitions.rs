//! Abbreviations of a question: names that stand for expressions, put in their places when the question is read.

use crate::error::Problem;
use crate::syntax::{Kind, Node};

/// Most parts of an expression with everything put in its place.
const MOST_PARTS: usize = 10_000;

/// `name(i, j) = "body"`.
#[derive(Debug, Clone)]
pub(crate) struct Definition {
    pub name: String,
    pub parameters: Vec<String>,
    pub body: Node,
}

impl Definition {
    /// Name and parameters of `name` or `name(i, j)`; `None` of anything else.
    pub fn header(key: &Node) -> Option<(String, Vec<String>)> {
        let plain = |name: &str| name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
        let Kind::Name { name, arguments, called } = &key.kind else { return None };
        let parameter = |node: &Node| match &node.kind {
            Kind::Name { name, called: false, .. } if plain(name) => Some(name.clone()),
            _ => None,
        };
        let parameters = arguments.iter().map(parameter).collect::<Option<Vec<String>>>()?;
        let different = (0..parameters.len()).all(|k| !parameters[..k].contains(&parameters[k]));
        (plain(name) && different && *called != parameters.is_empty()).then(|| (name.clone(), parameters))
    }

    /// An expression with the body wherever the name stands.
    pub fn expand(&self, node: Node) -> Result<Node, (usize, Problem)> {
        let expanded = self.replaced(&node)?;
        let mut parts = 0;
        expanded.visit(&mut |_| parts += 1);
        if parts > MOST_PARTS {
            let why = format!("with `{}` in its place the expression has more than {MOST_PARTS} parts", self.name);
            return Err((node.at, Problem::Other(why)));
        }
        Ok(expanded)
    }

    fn replaced(&self, node: &Node) -> Result<Node, (usize, Problem)> {
        let mapped = map(node, &mut |inner| self.replaced(inner))?;
        let Kind::Name { name, arguments, .. } = &mapped.kind else { return Ok(mapped) };
        if *name != self.name {
            return Ok(mapped);
        }
        if arguments.len() != self.parameters.len() {
            let plural = if self.parameters.len() == 1 { "" } else { "s" };
            return Err((
                node.at,
                Problem::Arguments {
                    name: name.clone(),
                    expected: format!("{} argument{plural}", self.parameters.len()),
                    found: arguments.len(),
                },
            ));
        }
        let mut used: Vec<&str> = Vec::new();
        arguments.iter().for_each(|argument| argument.visit(&mut |node| used.extend(plain_name(node))));
        let names: Vec<(String, Node)> = self.parameters.iter().cloned().zip(arguments.iter().cloned()).collect();
        let mut taken = used.clone();
        self.body.visit(&mut |node| taken.extend(plain_name(node)));
        Ok(at(&substituted(&self.body, &names, &used, &taken), node.at))
    }
}

/// A name without brackets.
fn plain_name(node: &Node) -> Option<&str> {
    match &node.kind {
        Kind::Name { name, called: false, .. } => Some(name),
        _ => None,
    }
}

/// Names replaced by expressions; a name that the body binds itself gets another one where the expressions use it, and not one that is taken.
fn substituted(node: &Node, names: &[(String, Node)], used: &[&str], taken: &[&str]) -> Node {
    if let Some(name) = plain_name(node) {
        return names.iter().find(|(own, _)| own == name).map_or_else(|| node.clone(), |(_, with)| with.clone());
    }
    let mut names = names.to_vec();
    for own in bound_by(node) {
        names.retain(|(known, _)| *known != own);
        if used.contains(&own.as_str()) {
            let fresh = (1..).map(|k| format!("{own}_{k}")).find(|name| !taken.contains(&name.as_str()));
            let kind = Kind::Name { name: fresh.unwrap_or_default(), arguments: Vec::new(), called: false };
            names.push((own, Node { kind, at: node.at }));
        }
    }
    let mapped = map(node, &mut |inner| Ok::<_, ()>(substituted(inner, &names, used, taken)));
    mapped.unwrap_or_else(|()| node.clone())
}

/// The names that a sum over a graph binds: those of its first argument.
fn bound_by(node: &Node) -> Vec<String> {
    let Kind::Name { name, arguments, called: true } = &node.kind else { return Vec::new() };
    let own = name.rsplit('.').next().unwrap_or(name);
    let first = match arguments.first().map(|first| &first.kind) {
        Some(Kind::Where(first, _)) => Some(first.as_ref()),
        _ => arguments.first(),
    };
    match first.map(|first| &first.kind) {
        Some(Kind::Name { name, called: false, .. }) if ["sum", "count"].contains(&own) => vec![name.clone()],
        Some(Kind::Name { name, arguments, called: true }) if ["vertex", "edge", "pair"].contains(&name.as_str()) => {
            arguments.iter().filter_map(plain_name).map(ToString::to_string).collect()
        }
        _ => Vec::new(),
    }
}

/// The same at another place.
fn at(node: &Node, place: usize) -> Node {
    let mapped = map(node, &mut |inner| Ok::<_, ()>(at(inner, place)));
    Node { at: place, ..mapped.unwrap_or_else(|()| node.clone()) }
}

/// An expression with its parts replaced.
fn map<E>(node: &Node, f: &mut impl FnMut(&Node) -> Result<Node, E>) -> Result<Node, E> {
    fn all<E>(list: &[Node], f: &mut impl FnMut(&Node) -> Result<Node, E>) -> Result<Vec<Node>, E> {
        list.iter().map(f).collect()
    }
    fn signed<E, S: Clone>(
        list: &[(S, Node)],
        f: &mut impl FnMut(&Node) -> Result<Node, E>,
    ) -> Result<Vec<(S, Node)>, E> {
        list.iter().map(|(sign, node)| Ok((sign.clone(), f(node)?))).collect()
    }
    fn several<E, const N: usize>(
        list: &[Node; N],
        f: &mut impl FnMut(&Node) -> Result<Node, E>,
    ) -> Result<Box<[Node; N]>, E> {
        let mut copy = Box::new(list.clone());
        copy.iter_mut().try_for_each(|node| f(node).map(|mapped| *node = mapped))?;
        Ok(copy)
    }
    let kind = match &node.kind {
        Kind::Number(_) | Kind::Infinity => node.kind.clone(),
        Kind::Name { name, arguments, called } => {
            Kind::Name { name: name.clone(), arguments: all(arguments, f)?, called: *called }
        }
        Kind::Negated(body) => Kind::Negated(Box::new(f(body)?)),
        Kind::Sum(list) => Kind::Sum(signed(list, f)?),
        Kind::Product(list) => Kind::Product(signed(list, f)?),
        Kind::Power(a, b) => Kind::Power(Box::new(f(a)?), Box::new(f(b)?)),
        Kind::Relation(first, others) => Kind::Relation(Box::new(f(first)?), signed(others, f)?),
        Kind::Not(body) => Kind::Not(Box::new(f(body)?)),
        Kind::And(list) => Kind::And(all(list, f)?),
        Kind::Or(list) => Kind::Or(all(list, f)?),
        Kind::Implies(a, b) => Kind::Implies(Box::new(f(a)?), Box::new(f(b)?)),
        Kind::Always(always, parts) => Kind::Always(*always, several(parts, f)?),
        Kind::Until(parts) => Kind::Until(several(parts, f)?),
        Kind::Where(a, b) => Kind::Where(Box::new(f(a)?), Box::new(f(b)?)),
        Kind::Range(a, b) => Kind::Range(Box::new(f(a)?), Box::new(f(b)?)),
        Kind::Interval(a, b) => Kind::Interval(Box::new(f(a)?), Box::new(f(b)?)),
    };
    Ok(Node { kind, at: node.at })
}
