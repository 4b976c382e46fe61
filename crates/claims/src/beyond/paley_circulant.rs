//! beyond.paley.circulant_spectrum, beyond.paley.cyclic_patterns: circular formations on circulant graphs.

use crate::prelude::*;
use algebra::matrix::{Inertia, determinant_over_field};
use arithmetic::{CosineField, RealCyclotomic, Sign, Signed};
use models::oscillator::critical::laplacian_hessian;
use models::oscillator::{
    CircularGains, Neighbours, circulant_eigenvalue, circular_control, circular_formation, fourier_column,
    linearisation, quarter_turn,
};

type Number = Complex<RealCyclotomic>;

/// `p_q = s^3 + (k_0 C - k_1 t) s^2 + (omega^2 - turn i omega k_0 D) s - k_1 t omega^2`, `t = C - shift lambda_m`; on directed circulants too.
#[derive(Clone, Copy)]
pub struct SpectrumVariant {
    turn: i64,
    shift: i64,
    directed: bool,
}

/// The pattern `theta_k = 2 pi m k/N` on the circulant graph in which `k + s` is a neighbour of `k` for each offset `s`.
struct Pattern {
    field: CosineField,
    offsets: Vec<usize>,
    order: usize,
    m: usize,
}

impl Pattern {
    fn gains(&self) -> CircularGains<RealCyclotomic> {
        let number = |p, q| self.field.number(&rational(p, q));
        CircularGains { omega: number(-1, 2), spacing: number(3, 2), orientation: number(-2, 3) }
    }

    /// `det(s - A)` of the linearisation, for some values of `s`.
    fn determinants(&self, points: &[RealCyclotomic]) -> Result<Vec<RealCyclotomic>, ArithmeticError> {
        let (gains, order) = (self.gains(), self.order);
        let phasors = fourier_column(&self.field, order, self.m);
        let network = Neighbours::from_fn(order, |k, j| self.offsets.contains(&((j + order - k) % order)));
        let constant = gains.constant();
        let rows = linearisation(&circular_formation(&gains.omega, &phasors)?, &gains.omega, |state| {
            circular_control(&constant, &network, &network, state)
        })?;
        let shifted = |s: &RealCyclotomic| {
            let entry = |i: usize, j: usize, x: &RealCyclotomic| if i == j { s.clone() - x } else { -x.clone() };
            let row = |(i, row): (usize, &Vec<RealCyclotomic>)| {
                row.iter().enumerate().map(|(j, x)| entry(i, j, x)).collect::<Vec<_>>()
            };
            rows.iter().enumerate().map(row).collect()
        };
        points.iter().map(|s| determinant_over_field(shifted(s), s.one())).collect()
    }

    /// The product of the `p_q(s)`.
    fn product(&self, variant: &SpectrumVariant, s: &RealCyclotomic) -> Number {
        let (gains, order) = (self.gains(), self.order);
        let share = s.ratio(1, order as i64);
        let (k0, k1, omega) = (gains.spacing * &share, gains.orientation * &share, gains.omega);
        let square = omega.square();
        let roots: Vec<Number> = (0..order).map(|k| self.field.phasor(k as i64)).collect();
        let eigenvalue = |q: usize| circulant_eigenvalue(&roots, self.offsets.iter().copied(), q % order);
        let own = eigenvalue(self.m).scale(&s.integer(variant.shift));
        let cubic = |q: usize| {
            let (plus, minus) = (eigenvalue(self.m + q), eigenvalue(self.m + order - q));
            let c = (plus.clone() + &minus).scale(&s.ratio(1, 2));
            let d = (plus - minus).scale(&s.ratio(variant.turn, 2));
            let t = (c.clone() - &own).scale(&k1);
            let quadratic = c.scale(&k0) - &t;
            let linear = Complex::real(square.clone()) - quarter_turn(&d).scale(&(omega.clone() * &k0));
            ((Complex::real(s.clone()) + quadratic).scale(s) + linear).scale(s) - t.scale(&square)
        };
        (0..order).fold(Complex::real(s.one()), |product, q| product * cubic(q))
    }
}

pub fn circulant_spectrum() -> Record<SpectrumVariant> {
    Record::new(
        "beyond.paley.circulant_spectrum",
        "In coordinates that turn with each particle, y_k = (a_k + i b_k) e^{i theta_k}, the linearised law is invariant under shifts of the numbers, and Fourier modes \
         separate it into 3 x 3 blocks. Checked exactly: determinants of the whole linearisation over the field of cosines at 3N + 1 \
         values of s, which determine the polynomial. On directed circulants the formation is in general no relative equilibrium at the rate omega_0.",
        SpectrumVariant { turn: 1, shift: 1, directed: false },
        |variant, run| {
            let few: &[(usize, &[usize])] = &[(2, &[1]), (3, &[1, 2]), (4, &[1, 3]), (4, &[1, 2, 3])];
            let more: &[(usize, &[usize])] = &[(5, &[1, 4]), (6, &[1, 3, 5])];
            let directed: &[(usize, &[usize])] = if variant.directed { &[(4, &[1])] } else { &[] };
            let graphs = few.iter().chain(&more[..run.cases(0, more.len())]).chain(directed);
            let patterns = graphs.flat_map(|&(order, offsets)| (0..order).map(move |m| (order, offsets, m)));
            let detail = "exact determinants at 3N + 1 values of s, all m, C_2, C_3, C_4 and K_4 (C_5 and a cubic graph on six nodes with --full)";
            let found = run.instances("spectrum", detail, patterns, |(order, offsets, m)| {
                let pattern = Pattern { field: CosineField::new(order as u32), order, offsets: offsets.to_vec(), m };
                let points: Vec<_> =
                    (0..=3 * order as i64).map(|s| pattern.field.number(&rational(2 * s - 5, 2))).collect();
                let found = pattern.determinants(&points)?;
                let wrong = points.iter().zip(found).any(|(s, left)| pattern.product(variant, s) != Complex::real(left));
                let place = || format!("N = {order}, offsets {offsets:?}, m = {m}");
                Ok(wrong.then(|| format!("{}: the determinant is not the product of the cubics", place())))
            });
            Run::all([
                found.checks("step F5"),
                argued(&[1], "every undirected circulant graph", "notes/paley_phases.md, steps F1-F5"),
            ])
        },
    )
    .stated(
        "beyond (22) and Figure 3",
        "On an undirected circulant graph on N nodes with the Laplacian eigenvalues lambda_q of the vectors e^{2 pi i q k/N}, q modulo N, \
         the circular formation of radius 1/|w0|, w0 != 0, with theta_k = 2 pi m k/N, m an integer, under (22) has, linearised in the \
         turning frame, the characteristic polynomial prod_q p_q(s), q = 0, ..., N-1, p_q = s^3 + (k_0 C_q - k_1 t_q) s^2 + (w0^2 - i w0 \
         k_0 D_q) s - k_1 t_q w0^2, with k_j = K_j/N, C_q = (lambda_{m+q} + lambda_{m-q})/2, D_q = (lambda_{m+q} - lambda_{m-q})/2, t_q = \
         C_q - lambda_m.",
    )
    .altered("without D_q", |v| v.turn = 0)
    .altered("t_q = C_q", |v| v.shift = 0)
    .altered("directed circulants too", |v| v.directed = true)
}

/// On `C_N` the pattern `m` is stable iff `sign K_1 cos(2 pi m/N) < 0`; with `strict`, a zero cosine counts as unstable.
#[derive(Clone, Copy)]
pub struct CyclicVariant {
    sign: i64,
    strict: bool,
}

impl CyclicVariant {
    /// What contradicts the claim at the pattern `m` on `C_N`, for `K_1 > 0`; `K_1 < 0` exchanges the signs.
    fn contradiction(&self, order: usize, m: usize) -> Result<Option<String>, CheckError> {
        let field = CosineField::new(order as u32);
        let network = Neighbours::circulant(order, &[1]);
        let found = laplacian_hessian(&network, &fourier_column(&field, order, m), 1)?;
        let stable = found == Inertia { positive: 0, negative: order - 1, zero: 1 };
        let cosine = (field.cos(m as i64) * field.number(&rational(self.sign, 1))).sign();
        let claimed = cosine == Some(Sign::Negative) || !self.strict && cosine == Some(Sign::Zero);
        let unstable = cosine == Some(Sign::Positive) && found.positive == 0;
        let counts = format!("{} negative, {} zero and {} positive", found.negative, found.zero, found.positive);
        let wrong = stable != claimed || unstable;
        Ok(wrong.then(|| format!("C_{order}, m = {m}: the Hessian of W_1 has {counts} eigenvalues")))
    }
}

pub fn cyclic_patterns() -> Record<CyclicVariant> {
    Record::new(
        "beyond.paley.cyclic_patterns",
        "The Hessian of N W_1 there is cos(2 pi m/N) L, L positive semidefinite with the constants as its kernel; by the inertia theorem of notes/paley_particles.md \
         (V = K_0 S - K_1 w0^-2 W_1) the linearisation has as many eigenvalues with positive real part as K_1 times the Hessian has positive ones, and none on the imaginary axis but \
         those of the symmetries if the cosine is not zero. For N = 12 and K_1 > 0: m = 4 to 8, the patterns with 3, 12, 2, 12, 3 clusters.",
        CyclicVariant { sign: 1, strict: true },
        |variant, run| {
            let most = run.cases(10, 16);
            let patterns = (3..=most).chain([12]).flat_map(|order| (0..order).map(move |m| (order, m)));
            let detail = format!("N = 3 to {most} and 12, all m: exact inertia of the Hessian over cosines");
            let evidence = exhaustive("signs of the Hessian", detail).on([1, 2]);
            let found = run.every(evidence, patterns, |(order, m)| variant.contradiction(order, m));
            Run::all([
                found.checks("step F6, and the Hessian of step F7"),
                argued(&[1, 2], "every N, m and gains", "notes/paley_phases.md, steps F6-F8"),
            ])
        },
    )
    .stated("beyond Figure 3 and the text on balanced circular formations", "")
    .clauses(&[
        "On C_N, N >= 3, under (22) with K_0 > 0 and w0 != 0, the circular formation of radius 1/|w0| with theta_k = 2 pi m k/N, m an \
         integer, is exponentially stable up to rotation and translation iff K_1 cos(2 pi m/N) < 0, whatever the size of the gains and the \
         sign of w0.",
        "With the same K_0 and w0 it is unstable if K_1 cos(2 pi m/N) > 0.",
    ])
    .altered("the other sign", |v| v.sign = -1)
    .altered("a zero cosine is stable too", |v| v.strict = false)
}
