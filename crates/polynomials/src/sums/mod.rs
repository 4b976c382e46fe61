//! Sums of squares: a polynomial that is not negative where others are not, proved by an identity.
//!
//! Floats propose Gram matrices (`semidefinite`); they are rounded on the affine space of the identity and checked exactly (`gram`). Where the polynomial
//! is zero at a point of the domain, every square must be zero there, too: the Gram matrices are looked for on the face that is left, so that the rounded
//! ones can be positive definite on it.

mod certificate;
mod gram;
mod semidefinite;
mod text;

pub use certificate::{Certificate, Square, Statement};

use crate::multivariate::{Monomial, Multivariate, total_degree};
use arithmetic::{Cancelled, Progress, Rational, rational};
use gram::{Block, combined, complement, is_hopeless, near_kernel, pruned, squares};
use num_traits::{Signed, Zero};

type Polynomial = Multivariate<Rational>;

/// A variable whose square is a polynomial in others.
#[derive(Debug, Clone, PartialEq)]
pub struct Relation {
    /// Its number.
    pub variable: usize,
    /// Its square.
    pub square: Polynomial,
}

impl Relation {
    /// Zero by assumption.
    pub fn equality(&self) -> Polynomial {
        let x = Multivariate::x(self.variable);
        x.clone() * x - self.square.clone()
    }

    /// `p = quotient equality + remainder`, the remainder of degree at most 1 in the variable.
    fn divide(&self, p: &Polynomial) -> (Polynomial, Polynomial) {
        let zero = Multivariate::of(rational(0, 1));
        let x = Multivariate::x(self.variable);
        let mut parts = p.in_variable(self.variable);
        let mut quotient = zero.clone();
        for k in (2..parts.len()).rev() {
            let lead = std::mem::replace(&mut parts[k], zero.clone());
            if lead.is_zero() {
                continue;
            }
            let power = (0..k - 2).fold(lead.clone(), |product, _| product * &x);
            quotient = quotient + power;
            parts[k - 2] = parts[k - 2].clone() + lead * &self.square;
        }
        let remainder = parts.into_iter().rev().fold(zero, |sum, part| sum * &x + part);
        (quotient, remainder)
    }
}

/// `goal >= 0` (or `> 0`) to be proved from constraints and relations.
#[derive(Debug, Clone)]
pub struct Problem {
    /// What should be at least 0.
    pub goal: Polynomial,
    /// Or above 0.
    pub strict: bool,
    /// At least 0.
    pub constraints: Vec<Polynomial>,
    /// Squares that are known; later ones may use the variables of earlier ones.
    pub relations: Vec<Relation>,
    /// Points, with a value for each variable, of the domain at which the goal is 0.
    pub zeros: Vec<Vec<Rational>>,
}

/// What a search came to.
#[derive(Debug, Clone)]
pub enum Search {
    /// A certificate, checked.
    Found(Box<Certificate>),
    /// None was found; the degrees of the identities that were tried.
    Nothing(Vec<u32>),
}

/// Largest sum of the orders of all Gram matrices.
const LARGEST_ORDER: usize = 130;

/// Most equations.
const MOST_EQUATIONS: usize = 500;

/// Most times that a face is left for a smaller one.
const MOST_FACES: usize = 6;

impl Problem {
    /// Looks for a certificate, from small degrees on.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn search(&self, progress: &dyn Progress) -> Result<Search, Cancelled> {
        if let Some(found) = self.quadratic() {
            return Ok(found);
        }
        let mut tried = Vec::new();
        for attempt in self.attempts() {
            progress.checkpoint()?;
            if let Some(found) = self.attempt(&attempt, progress)? {
                return Ok(Search::Found(Box::new(found)));
            }
            tried.push(attempt.degree);
        }
        if let Some(on_surface) = self.on_surface() {
            match on_surface.search(progress)? {
                Search::Found(found) => return Ok(Search::Found(Box::new(found.without_last_equality()))),
                Search::Nothing(degrees) => tried.extend(degrees),
            }
        }
        tried.sort_unstable();
        tried.dedup();
        Ok(Search::Nothing(tried))
    }

    /// The same where two constraints, `p >= 0` and `-p >= 0`, are read as an equation for the square of a variable.
    fn on_surface(&self) -> Option<Problem> {
        if !self.relations.is_empty() {
            return None;
        }
        let all = self.constraints.iter().enumerate();
        let (pair, relation) = all
            .filter_map(|(i, p)| {
                let j = self.constraints.iter().position(|q| *q == -p.clone())?;
                (0..p.arity()).rev().find_map(|variable| {
                    let parts = p.in_variable(variable);
                    let [rest, linear, lead] = &parts[..] else { return None };
                    let lead = lead.as_constant().filter(|_| linear.is_zero())?;
                    Some(([i, j], Relation { variable, square: rest.scaled(&-lead.recip()) }))
                })
            })
            .next()?;
        let left = self.constraints.iter().enumerate().filter(|(k, _)| !pair.contains(k));
        let constraints = left.map(|(_, p)| p.clone()).collect();
        Some(Problem { constraints, relations: vec![relation], ..self.clone() })
    }

    /// A polynomial of degree 2 has one Gram matrix, which nobody needs to guess: with more numbers than floats could propose for. `None` where it is not
    /// positive semidefinite and constraints may help.
    fn quadratic(&self) -> Option<Search> {
        if self.goal.degree() > 2 || !self.relations.is_empty() {
            return None;
        }
        let variables = self.variables();
        let one = Multivariate::of(rational(1, 1));
        let place = |k: usize| variables.iter().position(|own| *own == k).map_or(0, |place| place + 1);
        let mut gram = vec![vec![rational(0, 1); variables.len() + 1]; variables.len() + 1];
        for (monomial, c) in self.goal.terms() {
            let mut factors = monomial.iter().enumerate().flat_map(|(k, &e)| (0..e).map(move |_| k)).map(place);
            let (i, j) = (factors.next().unwrap_or(0), factors.next().unwrap_or(0));
            // Off the diagonal an entry stands twice.
            let half = c / rational(2, 1);
            gram[i][j] += &half;
            gram[j][i] += half;
        }
        let basis = std::iter::once(one.clone()).chain(variables.into_iter().map(Multivariate::x)).collect();
        let block = Block { factors: Vec::new(), product: one, basis };
        match self.certificate(&[block], vec![gram], &self.power_of_norm(0)) {
            Some(found) => Some(Search::Found(Box::new(found))),
            None => self.constraints.is_empty().then(|| Search::Nothing(vec![2])),
        }
    }

    fn reduced(&self, p: &Polynomial) -> Polynomial {
        self.relations.iter().rev().fold(p.clone(), |p, relation| relation.divide(&p).1)
    }

    fn variables(&self) -> Vec<usize> {
        let all = self.constraints.iter().chain([&self.goal]).chain(self.relations.iter().map(|r| &r.square));
        let mut used: Vec<usize> = all
            .flat_map(|p| p.terms().flat_map(|(m, _)| m.iter().enumerate().filter(|(_, e)| **e > 0).map(|(k, _)| k)))
            .chain(self.relations.iter().map(|relation| relation.variable))
            .collect();
        used.sort_unstable();
        used.dedup();
        used
    }

    /// Monomials of at most a degree in the variables, at most 1 in those whose square is known.
    fn monomials(&self, variables: &[usize], degree: u32) -> Vec<Polynomial> {
        let mut list: Vec<Monomial> = vec![Vec::new()];
        for &variable in variables {
            let most = if self.relations.iter().any(|relation| relation.variable == variable) { 1 } else { degree };
            let grown = |monomial: &Monomial| {
                let left = degree - total_degree(monomial);
                let monomial = monomial.clone();
                (0..=left.min(most))
                    .map(move |exponent| {
                        let mut next = monomial.clone();
                        next.resize(variable + 1, 0);
                        next[variable] = exponent;
                        next
                    })
                    .collect::<Vec<_>>()
            };
            list = list.iter().flat_map(grown).collect();
        }
        list.sort_by_key(|monomial| total_degree(monomial));
        list.into_iter()
            .map(|monomial| Multivariate::from_terms([(monomial, rational(1, 1))], &rational(0, 1)))
            .collect()
    }

    /// `1 + sum x²` to a power, as squares.
    fn power_of_norm(&self, power: u32) -> Vec<Square> {
        let one = Multivariate::of(rational(1, 1));
        let mut list = vec![(rational(1, 1), one.clone())];
        for _ in 0..power {
            let by: Vec<Polynomial> = self.variables().into_iter().map(Multivariate::x).chain([one.clone()]).collect();
            list = list.iter().flat_map(|(d, l)| by.iter().map(move |x| (d.clone(), l.clone() * x))).collect();
        }
        list
    }

    /// What is tried, in order.
    fn attempts(&self) -> Vec<Attempt> {
        let even = |degree: u32| degree + degree % 2;
        let own = even(self.goal.degree());
        let all: Vec<usize> = (0..self.constraints.len()).collect();
        let single = || std::iter::once(Vec::new()).chain(all.iter().map(|&k| vec![k])).collect::<Vec<_>>();
        let pairs = || {
            let pairs = all.iter().flat_map(|&i| all.iter().filter(move |&&j| j > i).map(move |&j| vec![i, j]));
            single().into_iter().chain(pairs).collect::<Vec<_>>()
        };
        let mut list = vec![Attempt { norm: 0, products: vec![Vec::new()], degree: own }];
        let largest = self.constraints.iter().map(Multivariate::degree).max().unwrap_or(0);
        let first = even(own.max(largest));
        if !all.is_empty() {
            list.push(Attempt { norm: 0, products: single(), degree: first });
            list.push(Attempt { norm: 0, products: pairs(), degree: even(first.max(2 * largest)) });
        }
        list.push(Attempt { norm: 1, products: vec![Vec::new()], degree: own + 2 });
        if !all.is_empty() {
            list.push(Attempt { norm: 0, products: pairs(), degree: first + 2 });
            list.push(Attempt { norm: 0, products: pairs(), degree: first + 4 });
        } else {
            list.push(Attempt { norm: 2, products: vec![Vec::new()], degree: own + 4 });
        }
        list
    }

    fn blocks(&self, attempt: &Attempt) -> Option<Vec<Block>> {
        let variables = self.variables();
        let one = Multivariate::of(rational(1, 1));
        let mut order = 0;
        let mut blocks = Vec::new();
        for factors in &attempt.products {
            let product = factors.iter().fold(one.clone(), |product, &k| product * &self.constraints[k]);
            let Some(left) = attempt.degree.checked_sub(product.degree()) else { continue };
            let count = binomial(variables.len() as u64 + u64::from(left / 2), u64::from(left / 2));
            order += count;
            if order > LARGEST_ORDER as u64 * 2 {
                return None;
            }
            blocks.push(Block { factors: factors.clone(), product, basis: self.monomials(&variables, left / 2) });
        }
        Some(blocks)
    }

    fn attempt(&self, attempt: &Attempt, progress: &dyn Progress) -> Result<Option<Certificate>, Cancelled> {
        let Some(mut blocks) = self.blocks(attempt) else { return Ok(None) };
        let multiplier = self.power_of_norm(attempt.norm);
        let factor = multiplier.iter().fold(Multivariate::of(rational(0, 1)), |sum, (_, l)| sum + l.clone() * l);
        let target = self.reduced(&(factor * &self.goal));
        for block in &mut blocks {
            let seen: Vec<Vec<Rational>> = self
                .zeros
                .iter()
                .filter(|zero| !block.product.value(zero).is_zero())
                .map(|zero| block.basis.iter().map(|p| p.value(zero)).collect())
                .collect();
            if !seen.is_empty() {
                block.basis = combined(&block.basis, &complement(&seen, block.basis.len()));
            }
        }
        blocks.retain(|block| !block.basis.is_empty());
        for _ in 0..MOST_FACES {
            progress.checkpoint()?;
            let reduce = |p: &Polynomial| self.reduced(p);
            let Some((kept, system)) = pruned(blocks, &target, reduce) else { return Ok(None) };
            if system.len() > MOST_EQUATIONS || system.sizes().iter().sum::<usize>() > LARGEST_ORDER {
                return Ok(None);
            }
            let Some(proposal) = semidefinite::solve(&system.equations(), system.sizes(), progress)? else {
                return Ok(None);
            };
            const HOPELESS: f64 = 1e-3;
            if proposal.residual > HOPELESS {
                return Ok(None);
            }
            for bits in [0, 1, 2, 4, 7, 11, 16, 22, 30, 40] {
                progress.checkpoint()?;
                let Some(matrices) = system.rounded(&proposal, bits) else { break };
                if matrices.iter().any(|g| is_hopeless(g)) {
                    continue;
                }
                if let Some(found) = self.certificate(&kept, matrices, &multiplier) {
                    return Ok(Some(found));
                }
            }
            // The solutions have no interior: on to a smaller face.
            let mut smaller = false;
            blocks = kept;
            for (block, x) in blocks.iter_mut().zip(&proposal.blocks) {
                let kernel = near_kernel(x);
                if !kernel.is_empty() {
                    smaller = true;
                    block.basis = combined(&block.basis, &complement(&kernel, block.basis.len()));
                }
            }
            blocks.retain(|block| !block.basis.is_empty());
            if !smaller || blocks.is_empty() {
                return Ok(None);
            }
        }
        Ok(None)
    }

    fn certificate(
        &self,
        blocks: &[Block],
        matrices: Vec<Vec<Vec<Rational>>>,
        multiplier: &[Square],
    ) -> Option<Certificate> {
        let mut terms = Vec::new();
        for (block, mut g) in blocks.iter().zip(matrices) {
            let mut list = Vec::new();
            if self.strict && block.factors.is_empty() {
                // A positive constant is split off.
                let one = block.basis.iter().position(|p| p.as_constant().is_some())?;
                let most = g[one][one].clone();
                let split = (1..60).map(|k| &most / rational(1i64 << k, 1)).find(|split| {
                    let mut less = g.clone();
                    less[one][one] -= split;
                    most.is_positive() && squares(less).is_some()
                })?;
                g[one][one] -= &split;
                list.push((split, block.basis[one].clone()));
            }
            let own = squares(g)?.into_iter().map(|(d, row)| (d, combined(&block.basis, &[row]).remove(0)));
            list.extend(own);
            if !list.is_empty() {
                terms.push((block.factors.clone(), list));
            }
        }
        let mut certificate = Certificate {
            statement: None,
            constraints: self.constraints.clone(),
            equalities: self.relations.iter().map(Relation::equality).collect(),
            goal: self.goal.clone(),
            strict: self.strict,
            multiplier: multiplier.to_vec(),
            terms,
            cofactors: Vec::new(),
        };
        let mut rest = certificate.defect();
        let mut cofactors = Vec::new();
        for relation in self.relations.iter().rev() {
            let (quotient, remainder) = relation.divide(&rest);
            cofactors.push(quotient);
            rest = remainder;
        }
        certificate.cofactors = cofactors.into_iter().rev().collect();
        certificate.is_valid().then_some(certificate)
    }
}

/// One form of an identity.
struct Attempt {
    /// Power of `1 + sum x²` that the goal is multiplied with.
    norm: u32,
    /// Products of constraints.
    products: Vec<Vec<usize>>,
    /// Degree of both sides.
    degree: u32,
}

fn binomial(n: u64, k: u64) -> u64 {
    (0..k).fold(1u64, |product, i| (product * (n - i) / (i + 1)).min(1 << 40))
}
