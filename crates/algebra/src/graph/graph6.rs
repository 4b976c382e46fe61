//! The formats graph6, sparse6 and digraph6 of nauty (McKay, "formats.txt"): graphs as short texts of printable characters.

use super::{Graph, WeightedGraph};
use arithmetic::rational;

/// Largest order that is read.
const LARGEST: u64 = 1 << 16;

/// Most bits of a matrix that are read.
const MOST_BITS: u64 = 1 << 22;

/// Why a text is not of its format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Graph6Error {
    /// A character that none of the formats has.
    #[error("character {0} is not one of those between `?` and `~`")]
    Character(usize),
    /// The text ends in the number of vertices, or is empty.
    #[error("the number of vertices is not complete")]
    Order,
    /// More vertices than are read.
    #[error("{0} vertices are too many")]
    TooMany(u64),
    /// A text of another length.
    #[error("{order} vertices take {expected} characters after their number, but there are {found}")]
    Length {
        /// The number of vertices.
        order: u64,
        /// Characters that they take.
        expected: u64,
        /// Characters that there are.
        found: u64,
    },
    /// Bits at the end that must be 0.
    #[error("the bits after the last pair are not 0")]
    Padding,
    /// A loop in sparse6.
    #[error("there is an edge from vertex {0} to itself, which is not allowed")]
    Loop(u64),
    /// An edge twice in sparse6.
    #[error("the edge {0}-{1} is there twice")]
    Repeated(u64, u64),
}

/// The values of the characters, six bits each, from the order on.
fn sixes(text: &str) -> Result<Vec<u8>, Graph6Error> {
    let six = |(place, byte): (usize, u8)| match byte {
        63..=126 => Ok(byte - 63),
        _ => Err(Graph6Error::Character(place + 1)),
    };
    text.bytes().enumerate().map(six).collect()
}

/// The number of vertices: one character, or `~` and three, or `~~` and six.
fn order(sixes: &[u8]) -> Result<(u64, &[u8]), Graph6Error> {
    let long = sixes.iter().take(2).take_while(|&&six| six == 63).count();
    let count = [1, 3, 6][long];
    let digits = sixes.get(long..long + count).ok_or(Graph6Error::Order)?;
    let order = digits.iter().fold(0u64, |n, &six| n << 6 | u64::from(six));
    if order > LARGEST { Err(Graph6Error::TooMany(order)) } else { Ok((order, &sixes[long + count..])) }
}

fn bits(sixes: &[u8]) -> impl Iterator<Item = bool> {
    sixes.iter().flat_map(|six| (0..6).rev().map(move |k| six >> k & 1 == 1))
}

/// The bits of so many pairs, and nothing more.
fn matrix(order: u64, pairs: u64, sixes: &[u8]) -> Result<Vec<bool>, Graph6Error> {
    if pairs > MOST_BITS {
        return Err(Graph6Error::TooMany(order));
    }
    let (expected, found) = (pairs.div_ceil(6), sixes.len() as u64);
    if expected != found {
        return Err(Graph6Error::Length { order, expected, found });
    }
    let mut bits: Vec<bool> = bits(sixes).collect();
    if bits.split_off(pairs as usize).contains(&true) { Err(Graph6Error::Padding) } else { Ok(bits) }
}

/// The graph of a text in graph6, without the prefix.
///
/// # Errors
/// [`Graph6Error`].
pub fn read_graph6(text: &str) -> Result<Graph, Graph6Error> {
    let sixes = sixes(text)?;
    let (n, rest) = order(&sixes)?;
    let bits = matrix(n, n * n.saturating_sub(1) / 2, rest)?;
    Ok(Graph::from_fn(n as usize, |i, j| bits[j * (j - 1) / 2 + i]))
}

/// The directed graph of a text in digraph6 after its `&`.
///
/// # Errors
/// [`Graph6Error`].
pub fn read_digraph6(text: &str) -> Result<WeightedGraph, Graph6Error> {
    let sixes = sixes(text)?;
    let (n, rest) = order(&sixes)?;
    let bits = matrix(n, n * n, rest)?;
    let n = n as usize;
    let arcs = bits.iter().enumerate().filter(|(_, bit)| **bit).map(|(k, _)| (k / n, k % n, rational(1, 1)));
    Ok(WeightedGraph::from_arcs(n, arcs))
}

/// The graph of a text in sparse6 after its `:`.
///
/// # Errors
/// [`Graph6Error`].
pub fn read_sparse6(text: &str) -> Result<Graph, Graph6Error> {
    let sixes = sixes(text)?;
    let (n, rest) = order(&sixes)?;
    let width = u64::BITS - n.saturating_sub(1).leading_zeros();
    let bits: Vec<bool> = bits(rest).collect();
    let (mut v, mut edges) = (0u64, std::collections::BTreeSet::new());
    for pair in bits.chunks_exact(width as usize + 1) {
        v += u64::from(pair[0]);
        let x = pair[1..].iter().fold(0u64, |x, &bit| x << 1 | u64::from(bit));
        // What is left at the end is filled with ones.
        if x >= n || v >= n {
            break;
        }
        if x > v {
            v = x;
        } else if x == v {
            return Err(Graph6Error::Loop(v + 1));
        } else if !edges.insert((x as usize, v as usize)) {
            return Err(Graph6Error::Repeated(x + 1, v + 1));
        }
    }
    Ok(Graph::of_pairs(n as usize, edges.into_iter()))
}

impl Graph {
    /// The graph in graph6, without a prefix; `None` above 2^18 - 1 vertices.
    pub fn graph6(&self) -> Option<String> {
        let n = self.order();
        let order: Vec<u8> = match n {
            0..=62 => vec![n as u8],
            63..=0x3FFFF => vec![63, (n >> 12) as u8, (n >> 6 & 63) as u8, (n & 63) as u8],
            _ => return None,
        };
        let bits: Vec<bool> =
            (0..n).flat_map(|j| (0..j).map(move |i| (i, j))).map(|(i, j)| self.has_edge(i, j)).collect();
        let six = |bits: &[bool]| (0..6).fold(0, |six, k| six << 1 | u8::from(bits.get(k) == Some(&true)));
        Some(order.into_iter().chain(bits.chunks(6).map(six)).map(|six| char::from(six + 63)).collect())
    }
}
