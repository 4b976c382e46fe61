//! Flocks of every size: what is decided here holds for any number of agents, on complete networks or on all without directions.
//!
//! A number of order k whose coefficients have degree d in the number N of agents ([`Bodies`]) is 0 at all states for every N from 2 on, if it is for
//! N = 2, .., k + d + 2; on all networks, if it is with a variable for the weight of each link. So identities are tested for these N, among them that a number is a
//! positive multiple of a sum over the linked pairs of its value for the two alone: then it has the sign that this has at all states of two.

use super::decide::{Found, clause_holds};
use super::identity::agree;
use super::inequality::{self, on_states};
use super::instance::{Instance, filled};
use super::search::{Tried, counterexample};
use super::{How, LawFile, Network};
use crate::bindings::{Bindings, Value};
use crate::error::QuestionError;
use crate::question::{Expression, Question};
use algebra::graph::AnyGraph;
use algebra::graph::Graph;
use arithmetic::{ArithmeticError, Field, Probe, Progress, Ring, rational};
use expressions::{Bodies, Comparison, Relation};
use std::sync::Arc;

/// Agents of flocks in which counterexamples are looked for, and states of each.
const TRIED: u32 = 5;
const STATES: usize = 1000;

/// Identities are not tested for more agents.
const MOST_TESTED: u32 = 24;

/// The flocks of all sizes of a property.
pub(super) struct Sizes<'a> {
    question: &'a Question,
    file: &'a LawFile,
    expression: &'a Expression,
    bindings: &'a Bindings,
    network: Network,
}

/// A flock with the names that describe it.
pub(super) struct Member {
    pub instance: Instance,
    pub bindings: Bindings,
}

/// `(N/2)^power (N - 1)^others`: positive for N >= 2, and 1 for N = 2.
#[derive(Debug, Clone, Copy)]
struct Factor {
    half: i32,
    others: i32,
}

impl Factor {
    fn at(self, agents: u32) -> f64 {
        (f64::from(agents) / 2.0).powi(self.half) * (f64::from(agents) - 1.0).powi(self.others)
    }

    fn exactly(self, agents: u32, like: &Probe) -> Result<Probe, ArithmeticError> {
        let power = |base: Probe, exponent: i32| {
            let power = base.power(u64::from(exponent.unsigned_abs()));
            if exponent < 0 { power.recip() } else { Ok(power) }
        };
        let agents = i64::from(agents);
        Ok(power(like.rational(&rational(agents, 2)), self.half)? * power(like.integer(agents - 1), self.others)?)
    }

    fn bodies(self) -> Bodies {
        let (up, down) = (|k: i32| k.max(0).unsigned_abs(), |k: i32| k.min(0).unsigned_abs());
        Bodies {
            order: 2,
            degree: up(self.half) + up(self.others),
            all: down(self.half),
            others: down(self.others),
            complete_only: false,
        }
    }
}

impl<'a> Sizes<'a> {
    pub fn new(
        question: &'a Question,
        file: &'a LawFile,
        expression: &'a Expression,
        bindings: &'a Bindings,
        network: Network,
    ) -> Self {
        Sizes { question, file, expression, bindings, network }
    }

    fn member(&self, agents: u32, graph: Option<Graph>) -> Result<Member, QuestionError> {
        let mut bindings = self.bindings.clone();
        bindings.push(Arc::from("agents"), Value::Number(rational(i64::from(agents), 1)));
        if let Some(graph) = graph {
            bindings.push(Arc::from("graph"), Value::Graph(Arc::new(AnyGraph::Simple(graph))));
        }
        let instance = Instance::new(self.question, self.file, self.expression, &bindings)?;
        Ok(Member { instance, bindings })
    }

    /// A clause, by its number.
    pub fn clause_holds(
        &self,
        clause: usize,
        progress: &dyn Progress,
    ) -> Result<(Found, Option<Bindings>), QuestionError> {
        let general = self.file.law.statement_of_any(&self.expression.node);
        let general = general.map_err(|error| self.file.refused(self.question, self.expression, error))?;
        // Identities first: in floats they look false everywhere.
        for (place, comparison) in general[clause].iter().enumerate() {
            let Some(bodies) = self.bodies(comparison).filter(|_| may_vanish(comparison.relation)) else { continue };
            if let Some(bits) = self.vanishes((clause, place), bodies, progress)?
                && let Found::Holds(mut how, certificates) = self.alone(clause, progress)?
            {
                how.extend([How::Identity(bits), How::EverySize]);
                return Ok((Found::Holds(how, certificates), None));
            }
        }
        let mut has_value = false;
        for agents in 1..=TRIED {
            let size = agents as usize;
            let mut graphs = vec![None];
            if self.network == Network::Mutual {
                graphs = [Graph::complete(size), Graph::path(size), Graph::star(size)].map(Some).to_vec();
                graphs.dedup();
            }
            for graph in graphs {
                let member = self.member(agents, graph)?;
                let own = &member.instance.clauses[clause];
                match counterexample(&member.instance, own, STATES, progress)? {
                    Tried::False(state) => {
                        let bindings = super::decide::with_state(&member.bindings, &member.instance, &state);
                        return Ok((Found::Fails(state), Some(bindings)));
                    }
                    Tried::Nothing => has_value = true,
                    Tried::NoValue => {}
                }
            }
        }
        if !has_value {
            return Ok((Found::NoValue, None));
        }
        let Found::Holds(how, certificates) = self.alone(clause, progress)? else {
            return Ok((Found::Open("one agent alone is undecided".to_string()), None));
        };
        for (place, comparison) in general[clause].iter().enumerate() {
            let is_one_sided = matches!(comparison.relation, Relation::AtMost | Relation::AtLeast);
            let Some(bodies) = self.bodies(comparison).filter(|_| is_one_sided) else { continue };
            let Some(bits) = self.sum_over_pairs((clause, place), bodies, progress)? else {
                continue;
            };
            let two = self.member(2, None)?.instance;
            let alone = std::slice::from_ref(&two.clauses[clause][place]);
            let all: Vec<usize> = (0..two.sides.len()).collect();
            if let inequality::Found::Holds(ways, own) = on_states(&two, alone, &two.links, &all, progress)? {
                let how = [how, vec![How::Identity(bits), How::Pairs, How::EverySize], ways].concat();
                return Ok((Found::Holds(how, [certificates, own].concat()), None));
            }
        }
        let why = format!(
            "no counterexample was found among up to {TRIED} agents, and no identity and no sum over pairs of terms of one sign that is the same for all sizes"
        );
        Ok((Found::Open(why), None))
    }

    /// A clause for one agent: where it has no value, for instance the largest over nobody, there is nothing to hold.
    fn alone(&self, clause: usize, progress: &dyn Progress) -> Result<Found, QuestionError> {
        let alone = self.member(1, None)?.instance;
        Ok(match clause_holds(&alone, &alone.clauses[clause], progress)? {
            Found::NoValue => Found::Holds(Vec::new(), Vec::new()),
            found => found,
        })
    }

    /// How a number depends on the number of agents, where that can be made use of.
    fn bodies(&self, comparison: &Comparison) -> Option<Bodies> {
        let bodies = comparison.bodies().filter(|_| comparison.is_symmetric())?;
        (self.network == Network::Complete || !bodies.complete_only).then_some(bodies)
    }

    /// The least bits of an identity for all sizes for which it has to be tested; one for each size.
    fn for_sizes(
        &self,
        bodies: Bodies,
        progress: &dyn Progress,
        test: impl Fn(u32, &Instance) -> Option<u64>,
    ) -> Result<Option<u64>, QuestionError> {
        let last = bodies.order + bodies.degree + 2;
        if last > MOST_TESTED {
            return Ok(None);
        }
        let mut least = u64::MAX;
        for agents in 2..=last {
            progress.checkpoint()?;
            let instance = self.member(agents, None)?.instance;
            let Some(bits) = test(agents, &instance) else {
                return Ok(None);
            };
            least = least.min(bits);
        }
        // Any of the tests may miss.
        Ok(least.checked_sub(u64::from(u32::BITS - last.leading_zeros())))
    }

    /// The number with the weights of links behind its state, or on a complete network.
    fn value(
        &self,
        comparison: &Comparison,
        state: &[Probe],
        weights: &[Vec<Probe>],
    ) -> Result<Probe, ArithmeticError> {
        let (time, state) = state.split_last().ok_or(ArithmeticError::Domain("a state"))?;
        match self.network {
            Network::Mutual => comparison.weighted(time, state, weights),
            Network::Complete => comparison.value(time, state, &expressions::Everyone(weights.len())),
        }
    }

    /// An identity in the numbers of a state and the weights of links.
    fn identity(
        &self,
        instance: &Instance,
        functions: u64,
        sides: impl Fn(&[Probe], &[Vec<Probe>]) -> Result<(Vec<Probe>, Vec<Probe>), ArithmeticError>,
    ) -> Option<u64> {
        let (free, agents) = (instance.free(), instance.of_agent.len());
        let links = if self.network == Network::Mutual { agents * (agents - 1) / 2 } else { 0 };
        if free.is_empty() {
            return None;
        }
        agree(free.len() + links, functions, |numbers| {
            let (own, mut rest) = numbers.split_at(free.len());
            let mut weights = vec![vec![own[0].one(); agents]; agents];
            let pairs = (0..agents).flat_map(|i| (i + 1..agents).map(move |j| (i, j)));
            for (i, j) in pairs {
                if let Some((first, others)) = rest.split_first() {
                    (weights[i][j], weights[j][i]) = (first.clone(), first.clone());
                    rest = others;
                }
            }
            sides(&filled(&instance.sides, &free, own), &weights)
        })
    }

    fn vanishes(
        &self,
        (clause, place): (usize, usize),
        bodies: Bodies,
        progress: &dyn Progress,
    ) -> Result<Option<u64>, QuestionError> {
        self.for_sizes(bodies, progress, |_, instance| {
            let comparison = &instance.clauses[clause][place];
            self.identity(instance, comparison.functions(instance.of_agent.len()), |state, weights| {
                let value = self.value(comparison, state, weights)?;
                let zero = value.zero();
                Ok((vec![value], vec![zero]))
            })
        })
    }

    /// Whether the number is a positive multiple, which depends on the number of agents only, of the sum over linked pairs of its value for the two alone.
    fn sum_over_pairs(
        &self,
        (clause, place): (usize, usize),
        bodies: Bodies,
        progress: &dyn Progress,
    ) -> Result<Option<u64>, QuestionError> {
        let two = self.member(2, None)?.instance;
        let pair = &two.clauses[clause][place];
        let Some(factor) = self.factor((clause, place), &two)? else {
            return Ok(None);
        };
        self.for_sizes(bodies.sum(factor.bodies()), progress, |agents, instance| {
            let comparison = &instance.clauses[clause][place];
            let pairs = u64::from(agents * (agents - 1) / 2);
            let functions = comparison.functions(agents as usize) + pairs * pair.functions(2);
            let everyone = expressions::Everyone(agents as usize);
            self.identity(instance, functions, |state, weights| {
                let whole = self.value(comparison, state, weights)?;
                let (time, numbers) = state.split_last().ok_or(ArithmeticError::Domain("a state"))?;
                let known = comparison.trail(time, numbers, &everyone)?;
                let mut sum = whole.zero();
                let all = 0..agents as usize;
                let pairs = all.clone().flat_map(|i| all.clone().skip(i + 1).map(move |j| (i, j)));
                for (i, j) in pairs {
                    let mut both = vec![whole.zero(); two.sides.len() - 1];
                    for (own, from) in [(0, i), (1, j)] {
                        let places = two.of_agent[own].iter().zip(&instance.of_agent[from]);
                        places.for_each(|(&to, &from)| both[to] = numbers[from].clone());
                    }
                    let found = pair.trail(time, &both, &expressions::Everyone(2))?;
                    // Where the whole has a value, its parts have one, too.
                    if !found[1..].iter().all(|own| known[1..].contains(own) || is_small(own)) {
                        return Err(ArithmeticError::Domain("parts with values"));
                    }
                    sum = sum + &(found[0].clone() * &weights[i][j]);
                }
                let factor = factor.exactly(agents, &whole)?;
                Ok((vec![whole], vec![sum * &factor]))
            })
        })
    }

    /// Proposed by floats at one state of three and of five agents.
    fn factor(&self, (clause, place): (usize, usize), two: &Instance) -> Result<Option<Factor>, QuestionError> {
        let mut ratios = Vec::new();
        for agents in [3u32, 5] {
            let instance = self.member(agents, None)?.instance;
            let state = instance.somewhere();
            let value = |comparison: &Comparison, state: &[f64], agents: u32| {
                let (time, state) = state.split_last()?;
                comparison.value(time, state, &expressions::Everyone(agents as usize)).ok()
            };
            let Some(whole) = value(&instance.clauses[clause][place], &state, agents) else { return Ok(None) };
            let mut sum = 0.0;
            for i in 0..agents as usize {
                for j in i + 1..agents as usize {
                    let mut both = vec![0.0; two.sides.len()];
                    for (own, from) in [(0, i), (1, j)] {
                        let places = two.of_agent[own].iter().zip(&instance.of_agent[from]);
                        places.for_each(|(&to, &from)| both[to] = state[from]);
                    }
                    let Some(part) = value(&two.clauses[clause][place], &both, 2) else { return Ok(None) };
                    sum += part;
                }
            }
            ratios.push((agents, whole / sum));
        }
        let all = (-4..=4).flat_map(|half| (-4..=4).map(move |others| Factor { half, others }));
        let fits = |factor: &Factor| {
            ratios.iter().all(|(agents, ratio)| (ratio - factor.at(*agents)).abs() < 1e-9 * factor.at(*agents))
        };
        Ok(all.into_iter().find(fits))
    }
}

/// Whether it is a small integer other than 0, which constants of the two have where those of the whole are others.
fn is_small(number: &Probe) -> bool {
    matches!(number, Probe::Degree(_)) || (1..=i64::from(MOST_TESTED)).any(|n| *number == number.integer(n))
}

fn may_vanish(relation: Relation) -> bool {
    matches!(relation, Relation::Equal | Relation::AtMost | Relation::AtLeast)
}
