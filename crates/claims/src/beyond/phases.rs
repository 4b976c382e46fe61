//! beyond.paley.inertia and beyond.paley.cyclic_eigenvectors.

use crate::paley::{CyclicVariant, Kind, critical_points, on_the_line};
use algebra::matrix::{Inertia, inertia};
use arithmetic::{Complex, Ring};
use arithmetic::{Field, Signed};
use ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, Source};
use models::oscillator::{moment_gradient, phase_jacobian, sine_of_difference};

/// beyond.paley.inertia.
pub struct CriticalInertia;

/// The inertia (positive, negative, zero) at each kind of critical point, given `N` and the size of the minority.
#[derive(Clone, Copy)]
pub struct InertiaVariant {
    unbalanced: fn(n: usize, minority: usize) -> [usize; 3],
    balanced: fn(n: usize, on_a_line: bool) -> [usize; 3],
}

impl InertiaVariant {
    fn claimed(&self, kind: Kind, n: usize, minority: usize, on_a_line: bool) -> Inertia {
        let [positive, negative, zero] = match kind {
            Kind::Balanced => (self.balanced)(n, on_a_line),
            // Synchronised is the case of no minority.
            _ => (self.unbalanced)(n, minority),
        };
        Inertia { positive, negative, zero }
    }
}

fn hessian_inertia<T: Field + Signed>(z: &[Complex<T>]) -> Result<Inertia, CheckError> {
    Ok(inertia(&phase_jacobian(z, |z| moment_gradient(z, 1))?)?)
}

impl Claim for CriticalInertia {
    type Variant = InertiaVariant;

    fn id(&self) -> &str {
        "beyond.paley.inertia"
    }

    fn source(&self) -> Option<Source> {
        Some(Source {
            place: "sharpens paley, Theorem 1".to_string(),
            statement: "The Hessian of U_1 at a critical point has (positive, negative, zero) eigenvalues: (b, N-b-1, 1) with two opposite clusters of N-b > b \
                        phases (b = 0: synchronised), (2, 0, N-2) at a balanced arrangement not on a line, (1, 0, N-1) at a balanced one on a line. So the unstable \
                        manifold of an unbalanced arrangement has dimension N-b-1 for K_1 > 0 and b for K_1 < 0, and there are no other critical points."
                .to_string(),
        })
    }

    fn derivation(&self) -> &str {
        "On a line the Hessian is s s^T/N - |p| diag(s): the second term has inertia (b, N-b, 0), the first lifts one eigenvalue (Weyl), and the kernel is exactly span{1}. Balanced: \
         the Gram matrix of the phasors over N (notes/paley_phases.md)."
    }

    fn printed(&self) -> InertiaVariant {
        InertiaVariant {
            unbalanced: |n, minority| [minority, n - minority - 1, 1],
            balanced: |n, on_a_line| if on_a_line { [1, 0, n - 1] } else { [2, 0, n - 2] },
        }
    }

    fn controls(&self) -> Vec<Control<InertiaVariant>> {
        let printed = self.printed();
        vec![
            Control::new(
                "(b + 1, N-b-2, 1)",
                InertiaVariant { unbalanced: |n, b| [b + 1, (n - b).saturating_sub(2), 1], ..printed },
            ),
            Control::new("rank 2 on a line too", InertiaVariant { balanced: |n, _| [2, 0, n - 2], ..printed }),
        ]
    }

    fn examine(&self, variant: &InertiaVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let most = run.cases(9, 14);
        let mut cases = 0;
        let fails =
            |what: String| Ok(Outcome::fails(what, Evidence::new(Grade::Exact, "inertia", "exact elimination")));
        for n in 2..=most {
            for minority in 0..n.div_ceil(2) {
                run.checkpoint()?;
                let found = hessian_inertia(&on_the_line(n, minority))?;
                cases += 1;
                if found != variant.claimed(Kind::Unbalanced, n, minority, true) {
                    return fails(format!("N = {n}, {minority} phases opposite to the others: {found:?}"));
                }
            }
        }
        for n in 2..=6 {
            for point in critical_points(n).iter().filter(|point| point.kind == Kind::Balanced) {
                run.checkpoint()?;
                let z = &point.phasors;
                let on_a_line = z.iter().all(|a| sine_of_difference(a, &z[0]) == a.re.zero());
                let found = hessian_inertia(z)?;
                cases += 1;
                if found != variant.claimed(Kind::Balanced, n, 0, on_a_line) {
                    return fails(format!("N = {n}, {}: {found:?}", point.name));
                }
            }
        }
        let detail = format!("all arrangements of two clusters up to N = {most}, balanced ones up to N = 6");
        Ok(Outcome::Holds(vec![
            Evidence::new(Grade::Exact, "every N", "proof in notes/paley_phases.md"),
            Evidence::new(Grade::Exact, "exact inertia", detail).cases(cases),
        ]))
    }
}

/// beyond.paley.cyclic_eigenvectors.
pub struct CyclicClassification;

impl Claim for CyclicClassification {
    type Variant = CyclicVariant;

    fn id(&self) -> &str {
        "beyond.paley.cyclic_eigenvectors"
    }

    fn source(&self) -> Option<Source> {
        Some(Source {
            place: "corrects paley, text after eq (16) and Figure 2".to_string(),
            statement: "N >= 3. The eigenvectors of the Laplacian of the cyclic graph C_N whose entries have modulus one are, up to rotation, the columns of the Fourier matrix, \
                        which are the symmetric patterns of N/gcd(N, m - 1) clusters, and, if and only if 4 divides N, (u, v, -u, -v, ...) with any u, v of modulus one, with \
                        eigenvalue 2. So every such eigenvector is a symmetric pattern if and only if 4 does not divide N."
                .to_string(),
        })
    }

    fn derivation(&self) -> &str {
        "The double eigenvalue of m has the eigenvectors a w^(mk) + b w^(-mk), with squared moduli |a|^2 + |b|^2 + 2 Re(a conj(b) w^(2mk)). They are equal only if a conj(b) = 0, or w^(2m) = -1 and \
         a conj(b) is imaginary; u = a + b and v = i(a - b) are then any two numbers of modulus one (notes/paley_phases.md)."
    }

    fn printed(&self) -> CyclicVariant {
        CyclicVariant::CLASSIFICATION
    }

    fn controls(&self) -> Vec<Control<CyclicVariant>> {
        let right = CyclicVariant::CLASSIFICATION;
        vec![
            Control::new("columns only", CyclicVariant { rhombi: |_, _| false, ..right }),
            Control::new(
                "for even N",
                CyclicVariant { rhombi: |n, m| n % 2 == 0 && (4 * m == n || 4 * m == n + 2), ..right },
            ),
            Control::new(
                "N clusters in each column",
                CyclicVariant { clusters: |n, m| if m == 0 { 1 } else { n }, ..right },
            ),
        ]
    }

    fn examine(&self, variant: &CyclicVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        let most = run.cases(12, 20);
        for nodes in 3..=most {
            run.checkpoint()?;
            if let Some(what) = variant.fails_on(nodes)? {
                return Ok(Outcome::fails(
                    format!("C_{nodes}: {what}"),
                    Evidence::new(Grade::Exact, "eigenvectors", "exact ranks and products"),
                ));
            }
        }
        let detail =
            format!("exact rank of the conditions of equal modulus in every double eigenspace, N = 3 to {most}");
        Ok(Outcome::Holds(vec![
            Evidence::new(Grade::Exact, "every N", "proof in notes/paley_phases.md"),
            Evidence::new(Grade::Exhaustive, "all eigenvectors of modulus one", detail).cases(most - 2),
        ]))
    }
}
