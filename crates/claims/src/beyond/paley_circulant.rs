//! beyond.paley.circulant_spectrum, beyond.paley.cyclic_patterns: circular formations on circulant graphs.

use algebra::matrix::{Inertia, inertia};
use arithmetic::{ArithmeticError, Complex, CosineField, Field, RealCyclotomic, Ring, Sign, Signed, rational};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, Source};
use models::oscillator::{
    CircularGains, Mode, Neighbours, circulant_eigenvalue, circular_control, circular_formation, linearisation,
    misalignment, phase_jacobian,
};

/// beyond.paley.circulant_spectrum.
pub struct CirculantSpectrum;

/// `p_q = s^3 + (k_0 C - k_1 t) s^2 + (omega^2 - turn i omega k_0 D) s - k_1 t omega^2`, `t = C - shift lambda_m`.
#[derive(Clone, Copy)]
pub struct SpectrumVariant {
    turn: i64,
    shift: i64,
    pull: i64,
}

type Number = Complex<RealCyclotomic>;

/// The pattern `theta_k = 2 pi m k/N` on a circulant graph.
struct Pattern<'a> {
    field: CosineField,
    order: usize,
    offsets: &'a [usize],
    m: usize,
}

impl Pattern<'_> {
    fn gains(&self) -> CircularGains<RealCyclotomic> {
        let number = |p, q| self.field.number(&rational(p, q));
        CircularGains { omega: number(-1, 2), spacing: number(3, 2), orientation: number(-2, 3) }
    }

    /// `det(s - A)` of the linearisation, for some values of `s`.
    fn determinants(&self, points: &[RealCyclotomic]) -> Result<Vec<RealCyclotomic>, ArithmeticError> {
        let gains = self.gains();
        let phasors: Vec<Number> = (0..self.order).map(|k| self.field.phasor((self.m * k) as i64)).collect();
        let network = Neighbours::circulant(self.order, self.offsets);
        let constant = gains.constant();
        let rows = linearisation(&circular_formation(&gains.omega, &phasors)?, &gains.omega, |state| {
            circular_control(&constant, &network, &network, state)
        })?;
        points.iter().map(|s| determinant(shifted(&rows, s))).collect()
    }

    /// The product of the `p_q(s)`.
    fn product(&self, variant: &SpectrumVariant, s: &RealCyclotomic) -> Result<Number, ArithmeticError> {
        let gains = self.gains();
        let share = s.ratio(1, self.order as i64);
        let (k0, k1) = (gains.spacing * &share, gains.orientation * &share);
        let omega = &gains.omega;
        let order = self.order;
        let roots: Vec<Number> = (0..order).map(|k| self.field.phasor(k as i64)).collect();
        let eigenvalue = |q: usize| circulant_eigenvalue(&roots, self.offsets.iter().copied(), q % order);
        let own = eigenvalue(self.m);
        let mut product = Complex::real(s.one());
        for q in 0..order {
            let (plus, minus) = (eigenvalue(self.m + q), eigenvalue(self.m + order - q));
            let c = (plus.clone() + &minus) * s.ratio(1, 2);
            let d = (plus - minus) * s.ratio(1, 2);
            let t = c.clone() - own.clone() * s.integer(variant.shift);
            let mode = Mode {
                omega: omega.clone(),
                pull: c * &k0 * s.integer(variant.pull),
                twist: d * &k0 * s.integer(variant.turn),
                hessian: -(k1.clone() * t),
            };
            let zero = Complex::real(s.zero());
            product = product * mode.cubic().iter().rev().fold(zero, |value, c| value.scale(s) + c);
        }
        Ok(product)
    }
}

/// `s - A`.
fn shifted(rows: &[Vec<RealCyclotomic>], s: &RealCyclotomic) -> Vec<Vec<RealCyclotomic>> {
    let entry = |i: usize, j: usize, x: &RealCyclotomic| if i == j { s.clone() - x } else { -x.clone() };
    rows.iter().enumerate().map(|(i, row)| row.iter().enumerate().map(|(j, x)| entry(i, j, x)).collect()).collect()
}

/// The determinant, by elimination.
fn determinant<T: Field + Signed>(mut rows: Vec<Vec<T>>) -> Result<T, ArithmeticError> {
    let first = rows.first().and_then(|row| row.first()).ok_or(ArithmeticError::Domain("at least one row"))?;
    let mut product = first.one();
    for column in 0..rows.len() {
        let found = (column..rows.len()).find(|&i| rows[i][column].sign() != Some(Sign::Zero));
        let Some(pivot) = found else { return Ok(product.zero()) };
        if pivot != column {
            rows.swap(pivot, column);
            product = -product;
        }
        let inverse = rows[column][column].recip()?;
        product = product * &rows[column][column];
        let (upper, lower) = rows.split_at_mut(column + 1);
        for row in lower {
            let factor = row[column].clone() * &inverse;
            for (x, y) in row.iter_mut().zip(&upper[column]).skip(column) {
                *x = x.clone() - factor.clone() * y;
            }
        }
    }
    Ok(product)
}

impl Claim for CirculantSpectrum {
    type Variant = SpectrumVariant;

    fn id(&self) -> &str {
        "beyond.paley.circulant_spectrum"
    }

    fn source(&self) -> Option<Source> {
        Some(Source {
            place: "beyond (22) and Figure 3".to_string(),
            statement: "On a circulant graph with Laplacian eigenvalues lambda_q, the circular formation with theta_k = 2 pi m k/N under (22) has in the turning frame the \
                        characteristic polynomial prod_q p_q(s), p_q = s^3 + (k_0 C_q - k_1 t_q) s^2 + (w0^2 - i w0 k_0 D_q) s - k_1 t_q w0^2, with k_j = K_j/N, C_q = \
                        (lambda_{m+q} + lambda_{m-q})/2, D_q = (lambda_{m+q} - lambda_{m-q})/2, t_q = C_q - lambda_m."
                .to_string(),
        })
    }

    fn derivation(&self) -> &str {
        "In coordinates that turn with each particle, y_k = (a_k + i b_k) e^{i theta_k}, the linearised law is invariant under shifts of the numbers, and Fourier modes \
         separate it into 3 x 3 blocks (notes/paley_particles.md). Checked exactly: determinants of the whole linearisation over the field of cosines at 3N + 1 \
         values of s, which determine the polynomial."
    }

    fn printed(&self) -> SpectrumVariant {
        SpectrumVariant { turn: 1, shift: 1, pull: 1 }
    }

    fn controls(&self) -> Vec<Control<SpectrumVariant>> {
        let printed = self.printed();
        vec![
            Control::new("without D_q", SpectrumVariant { turn: 0, ..printed }),
            Control::new("t_q = C_q", SpectrumVariant { shift: 0, ..printed }),
            Control::new("-k_0 C_q", SpectrumVariant { pull: -1, ..printed }),
        ]
    }

    fn examine(&self, variant: &SpectrumVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let mut graphs: Vec<(usize, Vec<usize>)> = vec![(2, vec![1]), (3, vec![1]), (4, vec![1]), (4, vec![1, 2])];
        if run.cases(0, 1) == 1 {
            graphs.extend([(5, vec![1]), (6, vec![1, 3])]);
        }
        let mut patterns = 0;
        for (order, offsets) in &graphs {
            for m in 0..*order {
                run.checkpoint()?;
                let pattern = Pattern { field: CosineField::new(*order as u32), order: *order, offsets, m };
                let points: Vec<_> =
                    (0..=3 * *order as i64).map(|s| pattern.field.number(&rational(2 * s - 5, 2))).collect();
                patterns += 1;
                for (s, left) in points.iter().zip(pattern.determinants(&points)?) {
                    if pattern.product(variant, s)? != Complex::real(left) {
                        let what = format!(
                            "N = {order}, offsets {offsets:?}, m = {m}: the determinant is not the product of the cubics"
                        );
                        return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "spectrum", "exact determinants")));
                    }
                }
            }
        }
        let detail = "exact determinants at 3N + 1 values of s, all m, C_N and K_4; proof for all circulant graphs in notes/paley_particles.md";
        Ok(Outcome::Holds(vec![Evidence::new(Grade::Exact, "spectrum", detail).cases(patterns)]))
    }
}

/// beyond.paley.cyclic_patterns.
pub struct CyclicPatterns;

/// On `C_N` the pattern `m` is stable iff `sign K_1 cos(2 pi m/N) < 0`; with `strict`, a zero cosine counts as unstable.
#[derive(Clone, Copy)]
pub struct CyclicVariant {
    sign: i64,
    strict: bool,
}

impl Claim for CyclicPatterns {
    type Variant = CyclicVariant;

    fn id(&self) -> &str {
        "beyond.paley.cyclic_patterns"
    }

    fn source(&self) -> Option<Source> {
        Some(Source {
            place: "beyond Figure 3 and the text on balanced circular formations".to_string(),
            statement: "On C_N, N >= 3, under (22) with K_0 > 0, the circular formation with theta_k = 2 pi m k/N is exponentially stable up to rotation and translation iff \
                        K_1 cos(2 pi m/N) < 0, whatever the size of the gains and the sign of w0; it is unstable if K_1 cos(2 pi m/N) > 0."
                .to_string(),
        })
    }

    fn derivation(&self) -> &str {
        "The Hessian of N W_1 there is cos(2 pi m/N) L, L positive semidefinite with the constants as its kernel; by the inertia theorem of notes/paley_particles.md \
         (V = K_0 S - K_1 w0^-2 W_1) the linearisation has as many eigenvalues with positive real part as K_1 times the Hessian has positive ones, and none on the imaginary axis but \
         those of the symmetries if the cosine is not zero. For N = 12 and K_1 > 0: m = 4 to 8, the patterns with 3, 12, 2, 12, 3 clusters."
    }

    fn printed(&self) -> CyclicVariant {
        CyclicVariant { sign: 1, strict: true }
    }

    fn controls(&self) -> Vec<Control<CyclicVariant>> {
        vec![
            Control::new("the other sign", CyclicVariant { sign: -1, strict: true }),
            Control::new("a zero cosine is stable too", CyclicVariant { sign: 1, strict: false }),
        ]
    }

    fn examine(&self, variant: &CyclicVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let most = run.cases(10, 16);
        let mut patterns = 0;
        for order in (3..=most).chain([12]) {
            let field = CosineField::new(order as u32);
            let network = Neighbours::circulant(order, &[1]);
            for m in 0..order {
                run.checkpoint()?;
                let phasors: Vec<Number> = (0..order).map(|k| field.phasor((m * k) as i64)).collect();
                let hessian = phase_jacobian(&phasors, |z| Ok(misalignment(&network, z)))?;
                let found = inertia(&hessian)?;
                // For K_1 > 0; K_1 < 0 exchanges the signs.
                let stable = found == Inertia { positive: 0, negative: order - 1, zero: 1 };
                let cosine = (field.cos(m as i64) * field.number(&rational(variant.sign, 1))).sign();
                let claimed = cosine == Some(Sign::Negative) || !variant.strict && cosine == Some(Sign::Zero);
                let unstable = cosine == Some(Sign::Positive) && found.positive == 0;
                patterns += 1;
                if stable != claimed || unstable {
                    let what = format!(
                        "C_{order}, m = {m}: the Hessian of W_1 has {} negative, {} zero and {} positive eigenvalues",
                        found.negative, found.zero, found.positive
                    );
                    return Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "patterns", "exact inertia")));
                }
            }
        }
        Ok(Outcome::Holds(vec![
            Evidence::new(
                Grade::Exact,
                "exponential stability, all N",
                "inertia theorem and Hessian, proof in notes/paley_particles.md",
            ),
            Evidence::new(
                Grade::Exhaustive,
                format!("N = 3 to {most} and 12, all m"),
                "exact inertia of the Hessian over cosines",
            )
            .cases(patterns),
        ]))
    }
}
