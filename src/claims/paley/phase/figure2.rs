//! paley.fig2: the twelve columns with their eigenvalues and polygons.

use super::common::{all_equal, holds, laplacian, named};
use crate::arithmetic::{CosineField, RealCyclotomic, Ring};
use crate::ledger::{CheckError, Claim, Control, Evidence, Grade, Outcome, Run, interval_value};
use crate::oscillator::laplacian_rows;

/// paley.fig2.
pub struct Columns;

/// Exponents of the columns, in parts of 1/24 turn, and the eigenvalue `constant - factor cos(2 pi (m - 1)/12)`.
#[derive(Clone, Copy)]
pub struct ColumnVariant {
    exponent: fn(m: i64, k: i64) -> i64,
    constant: i64,
    factor: i64,
}

impl Claim for Columns {
    type Variant = ColumnVariant;

    fn id(&self) -> &str {
        "paley.fig2"
    }

    fn derivation(&self) -> &str {
        "f_m has L f_m = (2 - w^(m-1) - w^(1-m)) f_m. Neighbours differ by the factor w^(m-1) all around, so the edges are chords of one length that turn by \
         one angle: the generalised regular polygon {12/(m - 1)}, star-shaped or covered several times over, for m = 7 a line and for m = 1 a point. The squared \
         length of an edge is the eigenvalue. The scan of the paper has no picture to compare with: the eigenvalues are recorded here."
    }

    fn printed(&self) -> ColumnVariant {
        ColumnVariant { exponent: |m, k| 2 * (m - 1) * (k - 1), constant: 2, factor: 2 }
    }

    fn controls(&self) -> Vec<Control<ColumnVariant>> {
        let printed = self.printed();
        vec![
            Control::new("m instead of m - 1", ColumnVariant { exponent: |m, k| 2 * m * (k - 1), ..printed }),
            Control::new("half of each angle", ColumnVariant { exponent: |m, k| (m - 1) * (k - 1), ..printed }),
            Control::new("eigenvalues 1 - cos", ColumnVariant { constant: 1, factor: 1, ..printed }),
            Control::new("eigenvalues 2 + 2 cos", ColumnVariant { factor: -2, ..printed }),
        ]
    }

    fn examine(&self, variant: &ColumnVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        const NODES: i64 = 12;
        run.checkpoint()?;
        let field = CosineField::new(24);
        let laplacian = laplacian(&named("ring:12")?)?;
        for m in 1..=NODES {
            let z: Vec<_> = (1..=NODES).map(|k| field.phasor((variant.exponent)(m, k))).collect();
            let cosine = field.cos(2 * (m - 1));
            let value = cosine.integer(variant.constant) - cosine.integer(variant.factor) * &cosine;
            let eigenvector = laplacian_rows(&laplacian, &z).into_iter().zip(&z).all(|(lz, z)| lz == z.scale(&value));
            let next = |k: usize| &z[(k + 1) % z.len()];
            // The factor from each vertex to the next, and the squared length of the edge.
            let turns: Vec<_> = z.iter().enumerate().map(|(k, z)| next(k).clone() * z.conj()).collect();
            let lengths: Vec<RealCyclotomic> =
                z.iter().enumerate().map(|(k, z)| (next(k).clone() - z).norm_squared()).collect();
            if !eigenvector || !all_equal(&turns) || !all_equal(&lengths) || lengths[0] != value {
                return Ok(Outcome::fails(
                    format!(
                        "column {m}: eigenvector {eigenvector} for {:.6}, edges alike {}",
                        value.enclose(64)?.to_f64(),
                        all_equal(&turns)
                    ),
                    Evidence::new(Grade::Exact, "columns", "exact roots of unity"),
                ));
            }
            run.value(&format!("eigenvalue_of_column_{m:02}"), value_of(&value)?);
        }
        holds([Evidence::new(
            Grade::Exact,
            "eigenvectors, eigenvalues and polygons",
            "all twelve columns: exact products; every edge has the same length and turns by the same angle",
        )
        .cases(12)])
    }
}

/// Exactly where it is rational.
fn value_of(x: &RealCyclotomic) -> Result<String, CheckError> {
    Ok(match x.rational_value() {
        Some(q) => q.to_string(),
        None => interval_value(&x.enclose(80)?, 12),
    })
}
