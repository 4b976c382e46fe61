//! `switches`: a flock of model D run again, every position exact.

use crate::Refusal;
use crate::budget::bits;
use crate::matrix::Matrix;
use crate::read::{Fraction, Reader};
use num_bigint::{BigInt, Sign};

const MOST_BIRDS: usize = 64;
const MOST_DIMENSIONS: usize = 8;
const MOST_STEPS: usize = 100_000;

enum Weights {
    Lazy,
    Vicsek,
    Given(Matrix),
}

impl Weights {
    /// `(p, q)` with `c_i = p/q`, for a bird with neighbours.
    fn of(&self, bird: usize, degree: usize) -> (BigInt, BigInt) {
        match self {
            Weights::Lazy => (BigInt::from(2), BigInt::from(3 * degree)),
            Weights::Vicsek => (BigInt::from(1), BigInt::from(degree + 1)),
            Weights::Given(c) => (c.at(0, bird).clone(), c.denominator.clone()),
        }
    }
}

/// Edges `i < j`, pair after pair: (1,2), (1,3), .., (1,n), (2,3), ..
type Network = Vec<(usize, usize)>;

/// `x(t)` and `v(t+1)`, numerators over one denominator, one row for each bird.
struct Flock<'a> {
    birds: usize,
    dimension: usize,
    weights: Weights,
    hysteresis: Option<Fraction<'a>>,
    positions: Vec<BigInt>,
    velocities: Vec<BigInt>,
    denominator: BigInt,
}

pub fn check(reader: &mut Reader) -> Result<String, Refusal> {
    let mut flock = read_start(reader)?;
    let until = reader.count("until", 0, MOST_STEPS)?;
    let (mut count, mut last) = (0usize, 0);
    let (time, mut network) = read_network(reader, flock.birds)?;
    reader.require(time == 0, "the first network is not that of t = 0")?;
    reader.require(flock.network(None) == network, "the network at t = 0 is another one")?;
    let mut next = read_next(reader, flock.birds)?;
    for t in 1..=until {
        let before = network.clone();
        network = flock.step(reader, &before)?;
        if network == before {
            let early = next.as_ref().is_some_and(|(time, _)| *time == t);
            reader.require(!early, &format!("the network does not change at t = {t}"))?;
            continue;
        }
        let stated = next.take().filter(|(time, _)| *time == t);
        let stated = stated.ok_or_else(|| reader.refusal(format!("the network changes at t = {t}")))?;
        reader.require(stated.1 == network, &format!("the network at t = {t} is another one"))?;
        (count, last) = (count + 1, t);
        next = read_next(reader, flock.birds)?;
    }
    reader.require(next.is_none(), "a change of the network that does not happen by then, or out of order")?;
    Ok(match count {
        0 => format!("the flock of model D below keeps its network from t = 0 to t = {until}"),
        _ => format!(
            "the flock of model D below changes its network {count} times from t = 1 to t = {until}, at the times and to the \
             networks below and at no other time, the last time at t = {last}"
        ),
    })
}

fn read_start<'a>(reader: &mut Reader<'a>) -> Result<Flock<'a>, Refusal> {
    let birds = reader.count("birds", 1, MOST_BIRDS)?;
    let dimension = reader.count("dimension", 1, MOST_DIMENSIONS)?;
    let weights = match reader.value("weights")? {
        "lazy" => Weights::Lazy,
        "vicsek" => Weights::Vicsek,
        "given" => Weights::Given(reader.matrix("c", 1, birds)?),
        _ => return Err(reader.refusal("`lazy`, `vicsek` or `given` is expected")),
    };
    let hysteresis = match reader.value("hysteresis")? {
        "none" => None,
        text => Some(reader.fraction_of(text)?),
    };
    let is_negative = hysteresis.as_ref().is_some_and(|h| h.numerator.sign() == Sign::Minus);
    reader.require(!is_negative, "the threshold is negative")?;
    let positions = reader.matrix("positions", birds, dimension)?;
    let velocities = reader.matrix("velocities", birds, dimension)?;
    let over = |list: &Matrix, unit: &BigInt| list.entries.iter().map(|x| x * unit).collect();
    Ok(Flock {
        birds,
        dimension,
        weights,
        hysteresis,
        positions: over(&positions, &velocities.denominator),
        velocities: over(&velocities, &positions.denominator),
        denominator: positions.denominator * velocities.denominator,
    })
}

/// `network T none` or `network T 1-2 2-3 ..`, the edges in order.
fn read_network(reader: &mut Reader, birds: usize) -> Result<(usize, Network), Refusal> {
    let value = reader.value("network")?;
    parse_network(reader, value, birds)
}

fn read_next(reader: &mut Reader, birds: usize) -> Result<Option<(usize, Network)>, Refusal> {
    reader.value_if_any("network").map(|value| parse_network(reader, value, birds)).transpose()
}

fn parse_network(reader: &Reader, value: &str, birds: usize) -> Result<(usize, Network), Refusal> {
    let (time, edges) = value.split_once(' ').ok_or_else(|| reader.refusal("a time and edges are expected"))?;
    let time = reader.count_of(time, 0, MOST_STEPS)?;
    let mut network = Network::new();
    for edge in edges.split(' ').filter(|_| edges != "none") {
        let (i, j) = edge.split_once('-').ok_or_else(|| reader.refusal("an edge `i-j` is expected"))?;
        let edge = (reader.count_of(i, 1, birds)? - 1, reader.count_of(j, 1, birds)? - 1);
        let in_order = edge.0 < edge.1 && network.last().is_none_or(|last| *last < edge);
        reader.require(in_order, "the edges are not in order")?;
        network.push(edge);
    }
    Ok((time, network))
}

impl Flock<'_> {
    /// `x(t+1) = x(t) + v(t+1)`, the network then, and `v(t+2)`.
    fn step(&mut self, reader: &mut Reader, before: &Network) -> Result<Network, Refusal> {
        let length = bits(self.positions.iter().chain(&self.velocities)).max(self.denominator.bits());
        let threshold = self.hysteresis.as_ref().map_or(0, |h| h.numerator.bits().max(h.denominator.bits()));
        reader.pay(8 * self.birds * self.birds * self.dimension, length + threshold, length + threshold)?;
        self.positions.iter_mut().zip(&self.velocities).for_each(|(x, v)| *x += v);
        let network = self.network(Some(before));
        self.average(reader, &network)?;
        Ok(network)
    }

    /// The distance rule, and hysteresis for the edges of the network before.
    fn network(&self, before: Option<&Network>) -> Network {
        let pairs = (0..self.birds).flat_map(|i| (i + 1..self.birds).map(move |j| (i, j)));
        let one = &self.denominator * &self.denominator;
        let joined = |&(i, j): &(usize, usize)| {
            let now = self.squared(i, j, false);
            now <= one || (before.is_some_and(|edges| edges.binary_search(&(i, j)).is_ok()) && self.is_held(&now, i, j))
        };
        pairs.filter(joined).collect()
    }

    /// The squared distance of two birds, or that of one step earlier.
    fn squared(&self, i: usize, j: usize, earlier: bool) -> BigInt {
        let difference = |list: &[BigInt], k: usize| &list[i * self.dimension + k] - &list[j * self.dimension + k];
        let coordinate = |k: usize| {
            let now = difference(&self.positions, k);
            let x = if earlier { now - difference(&self.velocities, k) } else { now };
            &x * &x
        };
        (0..self.dimension).map(coordinate).sum()
    }

    /// `| sqrt a - sqrt b | < h`, that is `a + b - h² < 2 sqrt(a b)`.
    fn is_held(&self, now: &BigInt, i: usize, j: usize) -> bool {
        let Some(threshold) = &self.hysteresis else { return false };
        let square = |x: &BigInt| x * x;
        let scale = square(&threshold.denominator);
        let (a, b) = (now * &scale, self.squared(i, j, true) * &scale);
        let rest = &a + &b - square(&(&threshold.numerator * &self.denominator));
        rest.sign() == Sign::Minus || square(&rest) < a * b * 4
    }

    /// `v_i + c_i sum (v_j - v_i)` over the neighbours.
    fn average(&mut self, reader: &mut Reader, network: &Network) -> Result<(), Refusal> {
        let mut near = vec![Vec::new(); self.birds];
        for &(i, j) in network {
            near[i].push(j);
            near[j].push(i);
        }
        let mut unit = BigInt::from(1);
        let mut weights = Vec::new();
        for (bird, near) in near.iter().enumerate() {
            let (p, q) = match near.len() {
                0 => (BigInt::ZERO, BigInt::from(1)),
                degree => self.weights.of(bird, degree),
            };
            let is_admissible = near.is_empty() || (p.sign() == Sign::Plus && &p * near.len() < q);
            reader.require(is_admissible, &format!("bird {}: 0 < c d < 1 fails", bird + 1))?;
            unit = least_multiple(reader, unit, &q)?;
            weights.push((p, q));
        }
        let length = bits(&self.velocities);
        reader.pay(4 * self.birds * self.birds * self.dimension, length, unit.bits())?;
        let old = std::mem::take(&mut self.velocities);
        for (bird, (p, q)) in weights.into_iter().enumerate() {
            let factor = p * (&unit / q);
            for k in 0..self.dimension {
                let own = &old[bird * self.dimension + k];
                let pull: BigInt = near[bird].iter().map(|&j| &old[j * self.dimension + k] - own).sum();
                self.velocities.push(own * &unit + pull * &factor);
            }
        }
        self.positions.iter_mut().for_each(|x| *x *= &unit);
        self.denominator *= unit;
        Ok(())
    }
}

/// Of two positive numbers.
fn least_multiple(reader: &mut Reader, a: BigInt, b: &BigInt) -> Result<BigInt, Refusal> {
    reader.pay(a.bits().min(b.bits()) as usize + 2, a.bits(), b.bits())?;
    let (mut x, mut y) = (a.clone(), b.clone());
    while y.sign() != Sign::NoSign {
        (x, y) = (y.clone(), x % y);
    }
    Ok(a / x * b)
}
