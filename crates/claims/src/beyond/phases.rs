//! beyond.paley.inertia and beyond.paley.cyclic_eigenvectors.

use crate::paley::CyclicVariant;
use crate::prelude::*;
use algebra::matrix::Inertia;
use arithmetic::Signed;
use models::oscillator::critical::{
    Kind, arrangements, critical_points, hessian, is_critical, is_on_a_line, linearisation, two_clusters,
};

/// The inertia (positive, negative, zero) at critical points on a line, given `N` and the size of the minority, and at balanced ones; and whether
/// balanced arrangements count as critical points.
#[derive(Clone, Copy)]
pub struct InertiaVariant {
    unbalanced: fn(n: usize, minority: usize) -> [usize; 3],
    balanced: fn(n: usize, on_a_line: bool) -> [usize; 3],
    with_balanced: bool,
}

impl InertiaVariant {
    /// What contradicts the claim at two clusters, with the linearisations for both signs of `K_1`.
    fn at_two_clusters<T: Field + Signed>(
        &self,
        (n, minority): (usize, usize),
        z: &[Complex<T>],
    ) -> Result<Option<String>, CheckError> {
        let [positive, negative, zero] = (self.unbalanced)(n, minority);
        let (found, claimed) = (hessian(z)?, Inertia { positive, negative, zero });
        let unstable = [1, -1].map(|gain| linearisation(z, gain).map(|around| around.positive));
        let [decreasing, increasing] = unstable;
        let wrong = found != claimed || (decreasing?, increasing?) != (negative, positive);
        Ok(wrong.then(|| format!("N = {n}, {minority} phases opposite to the others: {found:?}")))
    }
}

pub fn inertia() -> Record<InertiaVariant> {
    let right = InertiaVariant {
        unbalanced: |n, minority| [minority, n - minority - 1, 1],
        balanced: |n, on_a_line| if on_a_line { [1, 0, n - 1] } else { [2, 0, n - 2] },
        with_balanced: true,
    };
    Record::new(
        "beyond.paley.inertia",
        "On a line the Hessian is s s^T/N - |p| diag(s): positive on the b minority directions, negative on the majority vectors of sum 0, and the kernel is exactly span{1}. Balanced: \
         the Gram matrix of the phasors over N.",
        right,
        examine_inertia,
    )
    .stated("sharpens paley, Theorem 1", "")
    .clauses(&[
        "N >= 2. With two opposite clusters of N-b > b phases (b = 0: synchronised) the Hessian of U_1 has the inertia (b, N-b-1, 1): so \
         many positive, negative and zero eigenvalues, in this order.",
        "At a balanced arrangement of N >= 2 phases, not on a line, it has the inertia (2, 0, N-2).",
        "At a balanced arrangement of N >= 2 phases on a line it has the inertia (1, 0, N-1).",
        "The unstable manifold of such an arrangement of two clusters, N-b > b, taken up to rotation, has under (6) with (9) dimension \
         N-b-1 for K_1 > 0 and b for K_1 < 0.",
        "U_1 has no other critical points.",
    ])
    .altered("(b + 1, N-b-2, 1)", |v| v.unbalanced = |n, b| [b + 1, (n - b).saturating_sub(2), 1])
    .altered("rank 2 on a line too", |v| v.balanced = |n, _| [2, 0, n - 2])
    .altered("no balanced critical points", |v| v.with_balanced = false)
}

fn examine_inertia(variant: &InertiaVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let most = run.cases(9, 14);
    let line = exact("two clusters", format!("all of N = 2 to {most}, both signs of K_1; steps C4 and C6")).on([1, 4]);
    let line = run.every(line, two_clusters(most), |(n, minority, z)| variant.at_two_clusters((n, minority), &z));
    let balanced = (2..=6).flat_map(critical_points).filter(|point| point.kind == Kind::Balanced);
    let detail = "triangles and antipodal pairs of 2 to 6 particles, exact elimination; step C5";
    let balanced = run.every(exact("balanced", detail).on([2, 3]), balanced, |point| {
        let (n, found) = (point.phasors.len(), hessian(&point.phasors)?);
        let [positive, negative, zero] = (variant.balanced)(n, is_on_a_line(&point.phasors));
        let wrong = found != Inertia { positive, negative, zero };
        Ok(wrong.then(|| format!("N = {n}, {}: {found:?}", point.name)))
    });
    let detail = "all arrangements of 2 and 3 phases at multiples of 1/12 turn and of 4 at multiples of 1/6; step C1";
    let others = run.every(exhaustive("no others", detail).on([5]), arrangements(), |(place, z)| {
        let known = match Kind::of(&z)? {
            Kind::Balanced => variant.with_balanced,
            _ => is_on_a_line(&z),
        };
        Ok((is_critical(&z)? && !known).then(|| format!("{place}: another critical point")))
    });
    Run::all([line, balanced, others, argued(&[4], "the unstable manifold", "notes/paley_phases.md, step C6")])
}

pub fn cyclic_eigenvectors() -> Record<CyclicVariant> {
    Record::new(
        "beyond.paley.cyclic_eigenvectors",
        "The double eigenvalue of m has the eigenvectors a w^(mk) + b w^(-mk), with squared moduli |a|^2 + |b|^2 + 2 Re(a conj(b) w^(2mk)). They are equal only if a conj(b) = 0, or w^(2m) = -1 and \
         a conj(b) is imaginary; u = a + b and v = i(a - b) are then any two numbers of modulus one.",
        CyclicVariant::CLASSIFICATION,
        |variant, run| {
            let most = run.cases(12, 20);
            let detail = format!(
                "exact rank of the conditions of equal modulus in every double eigenspace, all columns, two rhombi that span all of them, N = 3 to {most}"
            );
            let evidence = exact("all eigenvectors of modulus one", detail).on([1, 2, 3, 4]);
            let found = run.every(evidence, 3..=most, |nodes| {
                Ok(variant.fails_on(nodes)?.map(|what| format!("C_{nodes}: {what}")))
            });
            Run::all([found.checks("steps E1 and E3 to E5"), argued(&[1, 2, 3, 4], "every N", "notes/paley_phases.md, steps E1-E5")])
        },
    )
    .stated("corrects paley, text after eq (16) and Figure 2", "")
    .clauses(&[
        "Up to rotation and a positive factor the eigenvectors of the Laplacian of C_N, N >= 3, with entries of modulus one are columns of \
         the Fourier matrix or, only if 4 divides N, (u, v, -u, -v) N/4 times over with u, v of modulus one.",
        "Column m of the Fourier matrix is an eigenvector and, up to a positive factor, the symmetric pattern of N/gcd(N, m - 1) clusters.",
        "If 4 divides N, (u, v, -u, -v) N/4 times over with any u, v of modulus one is an eigenvector with eigenvalue 2.",
        "Every eigenvector of the Laplacian of C_N, N >= 3, with entries of modulus one is a symmetric pattern if and only if 4 does not divide N.",
    ])
    .altered("columns only", |v| v.rhombi = |_, _| false)
    .altered("for even N", |v| v.rhombi = |n, m| n % 2 == 0 && (4 * m == n || 4 * m == n + 2))
    .altered("N clusters in each column", |v| v.clusters = |n, m| if m == 0 { 1 } else { n })
}
