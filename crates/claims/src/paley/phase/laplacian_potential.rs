//! paley.eq13, paley.gradW, paley.eq14_15: the Laplacian phase potential, its gradient and its control.

use super::common::{complete, digraph, holds, identity_of_phases, laplacian, named, names, phasors};
use algebra::graph::WeightedGraph;
use algebra::matrix::SparseMatrix;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Dual, Field, Rational, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run};
use models::oscillator::{
    laplacian_control, misalignment, moment_gradient, moment_potential, pairwise_control, phase_gradient,
    phase_potential, phase_potential_gradient, rate_of_change,
};

/// paley.eq13.
pub struct Complete;

/// `W_1 = constant + sign U_1` on a graph.
#[derive(Clone, Copy)]
pub struct CompleteVariant {
    constant: fn(i64) -> Rational,
    sign: i64,
    graph: fn(usize) -> WeightedGraph,
}

struct CompleteIdentity {
    laplacian: SparseMatrix,
    constant: Rational,
    sign: i64,
}

impl RationalIdentity for CompleteIdentity {
    fn variables(&self) -> usize {
        self.laplacian.order()
    }

    fn sides<T: Field>(&self, t: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let z = phasors(t)?;
        let sign = t[0].integer(self.sign);
        let right = t[0].rational(&self.constant) + moment_potential(&z, 1)? * &sign;
        let slopes = moment_gradient(&z, 1)?.into_iter().map(|slope| slope * &sign);
        let left = [phase_potential(&self.laplacian, &z, 1)?].into_iter();
        let gradient = phase_gradient(&z, |z| phase_potential(&self.laplacian, z, 1))?;
        Ok((left.chain(gradient).collect(), [right].into_iter().chain(slopes).collect()))
    }
}

impl Claim for Complete {
    type Variant = CompleteVariant;

    fn id(&self) -> &str {
        "paley.eq13"
    }

    fn derivation(&self) -> &str {
        "L = N I - 1 1^T: <z, L z> = N * N - |sum z|^2 = N^2 (1 - |p|^2), divided by 2N. The gradients are opposite, so the stationary points are the same."
    }

    fn printed(&self) -> CompleteVariant {
        CompleteVariant { constant: |n| rational(n, 2), sign: -1, graph: complete }
    }

    fn controls(&self) -> Vec<Control<CompleteVariant>> {
        let printed = self.printed();
        vec![
            Control::new("N instead of N/2", CompleteVariant { constant: |n| rational(n, 1), ..printed }),
            Control::new("+ U_1", CompleteVariant { sign: 1, ..printed }),
            Control::new("the path", CompleteVariant { graph: |n| digraph(n, |k, j| k.abs_diff(j) == 1), ..printed }),
        ]
    }

    fn examine(&self, variant: &CompleteVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut parts = Vec::new();
        for n in 1..=3usize {
            let laplacian = laplacian(&(variant.graph)(n))?;
            let identity = CompleteIdentity { laplacian, constant: (variant.constant)(n as i64), sign: variant.sign };
            parts.push(identity_of_phases(run, &identity, &names(n, &[]), &format!("W_1 and its gradient, N = {n}")));
        }
        let identities = Run::all(parts)?;
        Run::all([Ok(identities), holds([Evidence::new(Grade::Exact, "every N", "the line of the derivation")])])
    }
}

/// Graphs of the identities; a directed one first where the statement is to be tried on it.
fn graphs(directed: bool) -> Result<Vec<WeightedGraph>, CheckError> {
    let undirected = ["path:2", "path:3", "complete:3"].map(named);
    let mut graphs = undirected.into_iter().collect::<Result<Vec<_>, _>>()?;
    // Two nodes that are joined, and one on its own.
    graphs.push(digraph(3, |k, j| k + j == 1));
    if directed {
        graphs.insert(0, digraph(2, |k, _| k == 0));
    }
    Ok(graphs)
}

const LINEAR: &str =
    "both sides are linear in the weights of the edges, so one edge decides; N enters by the factor only";

/// paley.gradW.
pub struct Gradient;

/// Factors of the two expressions for the gradient, and the graphs.
#[derive(Clone, Copy)]
pub struct GradientVariant {
    both: (i64, i64),
    own: (i64, i64),
    directed: bool,
}

struct GradientIdentity {
    laplacian: SparseMatrix,
    variant: GradientVariant,
}

impl RationalIdentity for GradientIdentity {
    fn variables(&self) -> usize {
        self.laplacian.order()
    }

    fn sides<T: Field>(&self, t: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let z = phasors(t)?;
        let gradient = phase_gradient(&z, |z| phase_potential(&self.laplacian, z, 1))?;
        let (both, own) = (self.variant.both, self.variant.own);
        let (both, own) = (t[0].ratio(both.0, both.1), t[0].ratio(own.0, own.1 * z.len() as i64));
        let first = phase_potential_gradient(&self.laplacian, &z)?.into_iter().map(|slope| slope * &both);
        let second = misalignment(&self.laplacian, &z).into_iter().map(|term| term * &own);
        Ok((gradient.iter().chain(&gradient).cloned().collect(), first.chain(second).collect()))
    }
}

impl Claim for Gradient {
    type Variant = GradientVariant;

    fn id(&self) -> &str {
        "paley.gradW"
    }

    fn derivation(&self) -> &str {
        "The derivative of (1/(2N)) <z, L z> along i z_k e_k is (1/(2N)) (<i z_k, L_k z> + <z, L e_k i z_k>), and the second term is <i z_k, (L^T)_k z>. \
         For undirected G, L = L^T. (The first form holds for directed graphs too, the second does not: a control.)"
    }

    fn printed(&self) -> GradientVariant {
        GradientVariant { both: (1, 1), own: (1, 1), directed: false }
    }

    fn controls(&self) -> Vec<Control<GradientVariant>> {
        let printed = self.printed();
        vec![
            Control::new("directed graphs too", GradientVariant { directed: true, ..printed }),
            Control::new("1/(2N) with L alone", GradientVariant { own: (1, 2), ..printed }),
            Control::new("1/N with L + L^T", GradientVariant { both: (2, 1), ..printed }),
        ]
    }

    fn examine(&self, variant: &GradientVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut parts = Vec::new();
        for graph in graphs(variant.directed)? {
            let identity = GradientIdentity { laplacian: laplacian(&graph)?, variant: *variant };
            let part = format!("gradient of W_1, {}", super::common::arcs(&graph));
            parts.push(identity_of_phases(run, &identity, &names(graph.order(), &[]), &part));
        }
        let identities = Run::all(parts)?;
        Run::all([Ok(identities), holds([Evidence::new(Grade::Exact, "every undirected graph", LINEAR)])])
    }
}

/// paley.eq14_15.
pub struct Law;

/// Powers and signs of the rate and of the sum over pairs.
#[derive(Clone, Copy)]
pub struct LawVariant {
    power_of_n: u32,
    sine: i64,
    directed: bool,
}

struct LawIdentity {
    graph: WeightedGraph,
    laplacian: SparseMatrix,
    variant: LawVariant,
}

impl RationalIdentity for LawIdentity {
    fn variables(&self) -> usize {
        self.graph.order() + 2
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [t @ .., gain, omega] = at else { return Err(ArithmeticError::Domain("phases, K_1, omega_0")) };
        let z = phasors(t)?;
        let rates: Vec<T> = laplacian_control(gain, &self.laplacian, &z)?.into_iter().map(|u| u + omega).collect();
        let rate = rate_of_change(&z, &rates, |z: &[_]| phase_potential::<Dual<T>>(&self.laplacian, z, 1))?;
        let squares = misalignment(&self.laplacian, &z).iter().fold(gain.zero(), |sum, term| sum + term.square());
        let share = gain.ratio(1, (z.len() as i64).pow(self.variant.power_of_n));
        let sine = gain.integer(self.variant.sine);
        let pairs = pairwise_control(gain, &self.graph, &z)?.into_iter().map(|pair| pair * &sine + omega);
        let left = [rate].into_iter().chain(rates).collect();
        Ok((left, [squares * gain * share].into_iter().chain(pairs).collect()))
    }
}

impl Claim for Law {
    type Variant = LawVariant;

    fn id(&self) -> &str {
        "paley.eq14_15"
    }

    fn derivation(&self) -> &str {
        "dW_1/dtheta_k = (1/N) <i z_k, L_k z> (paley.gradW) times thetadot_k; omega_0 adds omega_0 1^T grad W_1 = 0, because W_1 does not change when all \
         phases turn. <i z_k, L_k z> = -sum_j <i z_k, z_j> = sum_j sin theta_kj."
    }

    fn printed(&self) -> LawVariant {
        LawVariant { power_of_n: 2, sine: 1, directed: false }
    }

    fn controls(&self) -> Vec<Control<LawVariant>> {
        let printed = self.printed();
        vec![
            Control::new("K_1/N in the rate", LawVariant { power_of_n: 1, ..printed }),
            Control::new("sin theta_jk", LawVariant { sine: -1, ..printed }),
            Control::new("directed graphs too", LawVariant { directed: true, ..printed }),
        ]
    }

    fn examine(&self, variant: &LawVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut parts = Vec::new();
        for graph in graphs(variant.directed)? {
            let part = format!("rate of W_1 and (15), {}", super::common::arcs(&graph));
            let names = names(graph.order(), &["K1", "omega0"]);
            let identity = LawIdentity { laplacian: laplacian(&graph)?, graph, variant: *variant };
            parts.push(identity_of_phases(run, &identity, &names, &part));
        }
        let identities = Run::all(parts)?;
        Run::all([Ok(identities), holds([Evidence::new(Grade::Exact, "every undirected graph", "the derivation")])])
    }
}
