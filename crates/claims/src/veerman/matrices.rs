//! veerman.eq1_matrix, veerman.eq2_matrix, veerman.dimL: the equations of motion in vector form.

use algebra::matrix::RationalMatrix;
use arithmetic::identity::RationalIdentity;
use arithmetic::{ArithmeticError, Field, Rational, rational};
use ledger::{CheckError, Claim, Control, Evidence, Fault, Grade, Outcome, Repair, Run};
use models::platoon::vector_form::{control_block, geodesic_block, kronecker_apply};
use models::platoon::{Communication, CommunicationGraph, Gains, accelerations};

/// Platoons of up to this many followers contain every kind of row: first, middle, last, and first = last.
const LARGEST: usize = 5;

/// The printed matrices, entry by entry.
#[derive(Clone, Copy)]
pub struct MatrixVariant {
    communication: Communication,
    diagonal: (i64, i64),
    below: (i64, i64),
    above: (i64, i64),
    /// Left of the diagonal in the last row.
    last: (i64, i64),
    /// The sign with which `zeta` enters.
    zeta_sign: i64,
    /// The matrix `A`, or its transpose.
    transposed: bool,
    /// The only eigenvalue of `P`, where one is claimed.
    eigenvalue: Option<i64>,
}

impl MatrixVariant {
    /// The Laplacian with the printed rows, of all agents: `P` is what is left without the leader's row and column, `L_l` the rest
    /// of its column.
    fn laplacian(&self, followers: usize) -> Vec<Vec<Rational>> {
        let number = |(p, q): (i64, i64)| rational(p, q);
        let mut rows = vec![vec![rational(0, 1); followers + 1]; followers + 1];
        for (k, row) in rows.iter_mut().enumerate().skip(1) {
            row[k] = number(self.diagonal);
            row[k - 1] = number(if k == followers { self.last } else { self.below });
            if k < followers {
                row[k + 1] = number(self.above);
            }
        }
        rows
    }

    fn reduced(&self, followers: usize) -> Vec<Vec<Rational>> {
        self.laplacian(followers).into_iter().skip(1).map(|row| row[1..].to_vec()).collect()
    }

    fn leader_column(&self, followers: usize) -> Vec<Vec<Rational>> {
        self.laplacian(followers).into_iter().skip(1).map(|row| row[..1].to_vec()).collect()
    }
}

/// The vector form gives the velocities and the accelerations of the printed equations, for any state.
struct VectorForm {
    variant: MatrixVariant,
    followers: usize,
}

impl RationalIdentity for VectorForm {
    /// f, g; position, velocity and desired position of every agent.
    fn variables(&self) -> usize {
        2 + 3 * (self.followers + 1)
    }

    fn sides<T: Field>(&self, at: &[T]) -> Result<(Vec<T>, Vec<T>), ArithmeticError> {
        let [f, g, agents @ ..] = at else { return Err(ArithmeticError::Domain("two gains")) };
        let gains = Gains { f: f.clone(), g: g.clone() };
        let state = |k: usize| [agents[3 * k].clone(), agents[3 * k + 1].clone()];
        let desired = |k: usize| [agents[3 * k + 2].clone(), f.zero()];
        let deviation = |k: usize| agents[3 * k].clone() - &agents[3 * k + 2];
        let followers = 1..=self.followers;
        let rates: Vec<T> = followers.clone().map(|k| state(k)[1].clone()).collect();
        let forces = accelerations(
            self.variant.communication,
            &gains,
            (&deviation(0), &state(0)[1]),
            &followers.clone().map(deviation).collect::<Vec<T>>(),
            &rates,
        );
        let sign = f.integer(self.variant.zeta_sign);
        let relative = |k: usize| {
            let ([x, u], [zeta, rest]) = (state(k), desired(k));
            [x + sign.clone() * zeta, u + sign.clone() * rest]
        };
        let geodesic = {
            let a = geodesic_block(f);
            let [[a00, a01], [a10, a11]] = a;
            if self.variant.transposed { [[a00, a10], [a01, a11]] } else { [[a00, a01], [a10, a11]] }
        };
        let control = control_block(&gains);
        let identity =
            RationalMatrix::identity(self.followers).map_err(|_| ArithmeticError::Domain("at least one follower"))?;
        let free = kronecker_apply(&identity.to_rows(), &geodesic, &followers.clone().map(state).collect::<Vec<_>>());
        let own = kronecker_apply(
            &self.variant.reduced(self.followers),
            &control,
            &followers.clone().map(relative).collect::<Vec<_>>(),
        );
        let leader = kronecker_apply(&self.variant.leader_column(self.followers), &control, &[relative(0)]);
        let vector_form = free.into_iter().zip(own).zip(leader).flat_map(|((a, b), c)| {
            let ([a0, a1], [b0, b1], [c0, c1]) = (a, b, c);
            [a0 + b0 + c0, a1 + b1 + c1]
        });
        let equations = rates.into_iter().zip(forces).flat_map(|(u, a)| [u, a]);
        Ok((vector_form.collect(), equations.collect()))
    }

    fn components(&self) -> Vec<String> {
        (1..=self.followers).flat_map(|k| [format!("the rate of x_{k}"), format!("the rate of u_{k}")]).collect()
    }
}

fn examine_matrices(variant: &MatrixVariant, run: &Run) -> Result<Outcome, CheckError> {
    let mut results = Vec::new();
    for followers in 1..=LARGEST {
        let names: Vec<String> = (0..=followers).flat_map(|k| ["x", "u", "h"].map(|v| format!("{v}_{k}"))).collect();
        let names: Vec<&str> = ["f", "g"].into_iter().chain(names.iter().map(String::as_str)).collect();
        results.push(run.identity(
            &VectorForm { variant: *variant, followers },
            &names,
            &format!("the vector form is the printed equations, {followers} followers, any state and leader"),
        ));
    }
    results.push(from_the_graph(variant));
    Run::all(results)
}

/// The printed matrices are those of the communication graph, and `P` has the claimed spectrum.
fn from_the_graph(variant: &MatrixVariant) -> Result<Outcome, CheckError> {
    const MOST: usize = 12;
    for followers in 1..=MOST {
        let graph = CommunicationGraph::of(variant.communication, followers)?;
        let printed = RationalMatrix::from_rows(&variant.laplacian(followers))?;
        let evidence = Evidence::new(Grade::Exact, "matrices of the communication graph", "compared exactly");
        if graph.laplacian()? != printed {
            return Ok(Outcome::fails(format!("{followers} followers: not the Laplacian of the graph"), evidence));
        }
        let reduced = graph.reduced_laplacian()?;
        if let Some(eigenvalue) = variant.eigenvalue
            && reduced.characteristic_polynomial()?.multiplicity(&rational(eigenvalue, 1)) != followers
        {
            let what = format!("{followers} followers: {eigenvalue} is not an eigenvalue of P of multiplicity N + 1");
            return Ok(Outcome::fails(what, evidence));
        }
    }
    let detail = format!("L, P and L_l built from the communication graph are the printed ones, 1 to {MOST} followers");
    let mut evidence = vec![Evidence::new(Grade::Exact, "matrices of the graph", detail).cases(MOST)];
    if variant.eigenvalue.is_some() {
        let detail = format!("characteristic polynomial (x - 1)^(N+1), 1 to {MOST} followers");
        evidence.push(Evidence::new(Grade::Exact, "spectrum of P_1", detail).cases(MOST));
    }
    Ok(Outcome::Holds(evidence))
}

/// veerman.eq1_matrix.
pub struct FrontMatrices;

impl Claim for FrontMatrices {
    type Variant = MatrixVariant;

    fn id(&self) -> &str {
        "veerman.eq1_matrix"
    }

    fn derivation(&self) -> &str {
        "Row k of P_1 and L_l has the entries 1 at k and -1 at k - 1 (in L_l for k = 1). So row k of P_1 ⊗ K (x - zeta) + L_l ⊗ \
         (K (x_l - zeta_l)) is (0, f (y_k - y_{k-1}) + g (u_k - u_{k-1})) with y = x - zeta, and I ⊗ A x adds (u_k, 0): \
         equation (1) with zeta = h. The rows of (L_l, P_1) sum to zero, so zeta may also be h shifted. Every row has one of the shapes first, later or first = last, \
         which platoons of up to five followers show. P_1 is lower triangular with ones on the diagonal: only the eigenvalue 1."
    }

    fn printed(&self) -> MatrixVariant {
        MatrixVariant {
            communication: Communication::Front,
            diagonal: (1, 1),
            below: (-1, 1),
            above: (0, 1),
            last: (-1, 1),
            zeta_sign: -1,
            transposed: false,
            eigenvalue: Some(1),
        }
    }

    fn controls(&self) -> Vec<Control<MatrixVariant>> {
        let printed = self.printed();
        vec![
            Control::new("+1 below the diagonal", MatrixVariant { below: (1, 1), ..printed }),
            Control::new("-1/2 above the diagonal", MatrixVariant { above: (-1, 2), ..printed }),
            Control::new("x + zeta", MatrixVariant { zeta_sign: 1, ..printed }),
            Control::new("the transpose of A", MatrixVariant { transposed: true, ..printed }),
            Control::new("the eigenvalue 2", MatrixVariant { eigenvalue: Some(2), ..printed }),
        ]
    }

    fn examine(&self, variant: &MatrixVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_matrices(variant, run)
    }
}

/// veerman.eq2_matrix.
pub struct FrontAndBackMatrices;

impl Claim for FrontAndBackMatrices {
    type Variant = MatrixVariant;

    fn id(&self) -> &str {
        "veerman.eq2_matrix"
    }

    fn derivation(&self) -> &str {
        "Row k <= N of (L_l, P_2) is 1 at k and -1/2 at k - 1 and k + 1; the last row is 1 at N + 1 and -1 at N. As for system \
         (1), row k of the vector form is then equation (2) with zeta = h. The rows have the shapes first, middle, last and \
         first = last, all of which occur up to five followers."
    }

    fn printed(&self) -> MatrixVariant {
        MatrixVariant {
            communication: Communication::FrontAndBack,
            diagonal: (1, 1),
            below: (-1, 2),
            above: (-1, 2),
            last: (-1, 1),
            zeta_sign: -1,
            transposed: false,
            eigenvalue: None,
        }
    }

    fn controls(&self) -> Vec<Control<MatrixVariant>> {
        let printed = self.printed();
        vec![
            Control::new("-1/2 in the last row", MatrixVariant { last: (-1, 2), ..printed }),
            Control::new("2 on the diagonal", MatrixVariant { diagonal: (2, 1), ..printed }),
            Control::new("nothing above the diagonal", MatrixVariant { above: (0, 1), ..printed }),
            Control::new("x + zeta", MatrixVariant { zeta_sign: 1, ..printed }),
        ]
    }

    fn examine(&self, variant: &MatrixVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_matrices(variant, run)
    }
}

/// veerman.dimL.
pub struct Dimensions;

/// The claimed dimensions of I, L and P, minus the number `N + 1` of followers.
#[derive(Clone, Copy)]
pub struct DimensionsVariant {
    identity: usize,
    laplacian: usize,
    reduced: usize,
}

impl Claim for Dimensions {
    type Variant = DimensionsVariant;

    fn id(&self) -> &str {
        "veerman.dimL"
    }

    fn derivation(&self) -> &str {
        "The agents are 0 to N + 1, so the directed Laplacian with the printed zero first row (the leader's) has N + 2 rows. That \
         L_l consists of the entries 1 through N + 1 of its first column, numbered from 0, and is an (N+1)-vector says the same. \
         Without the leader's row and column it is the printed P_i, of dimension N + 1 like the identity."
    }

    fn printed(&self) -> DimensionsVariant {
        DimensionsVariant { identity: 0, laplacian: 0, reduced: 0 }
    }

    fn repair(&self) -> Option<Repair<DimensionsVariant>> {
        Some(Repair {
            fault: Fault::Slip,
            clauses: Vec::new(),
            statement:
                "I_{N+1} and P_i are the (N+1)-dimensional identity and Reduced Directed Laplacian, and L_i is the \
                        (N+2)-dimensional Directed Laplacian."
                    .to_string(),
            variant: DimensionsVariant { laplacian: 1, ..self.printed() },
        })
    }

    fn controls(&self) -> Vec<Control<DimensionsVariant>> {
        let repaired = DimensionsVariant { laplacian: 1, ..self.printed() };
        vec![
            Control::new("L of dimension N + 3", DimensionsVariant { laplacian: 2, ..repaired }),
            Control::new("P of dimension N + 2", DimensionsVariant { reduced: 1, ..repaired }),
            Control::new("the identity of dimension N + 2", DimensionsVariant { identity: 1, ..repaired }),
        ]
    }

    fn examine(&self, variant: &DimensionsVariant, _: &mut Run) -> Result<Outcome, CheckError> {
        const MOST: usize = 12;
        for communication in [Communication::Front, Communication::FrontAndBack] {
            for followers in 1..=MOST {
                let graph = CommunicationGraph::of(communication, followers)?;
                let found = [
                    ("I", graph.followers(), variant.identity),
                    ("L", graph.laplacian()?.rows(), variant.laplacian),
                    ("P", graph.reduced_laplacian()?.rows(), variant.reduced),
                ];
                if let Some((name, rows, offset)) = found.into_iter().find(|(_, rows, o)| *rows != followers + o) {
                    return Ok(Outcome::fails(
                        format!("N = {}: {name} has dimension {rows}, not {}", followers - 1, followers + offset),
                        Evidence::new(Grade::Exact, "dimensions", "counted in the matrices built from the graph"),
                    ));
                }
            }
        }
        let detail = format!("matrices built from the agents 0 to N + 1, both systems, 1 to {MOST} followers");
        Ok(Outcome::Holds(vec![
            Evidence::new(Grade::Exact, "dimensions", detail).cases(2 * MOST),
            Evidence::new(
                Grade::Text,
                "L_l",
                "the entries 1 through N + 1 of a column numbered from 0 need N + 2 rows",
            ),
        ]))
    }
}
