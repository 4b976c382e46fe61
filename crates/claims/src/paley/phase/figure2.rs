//! paley.fig2: the twelve columns with their eigenvalues and polygons.

use ledger::{CheckError, Outcome, Record, Run, exact_value};
use runs::PARTICLES;
use runs::figure2::Columns;

pub fn columns() -> Record<Columns> {
    Record::new(
        "paley.fig2",
        "f_m has L f_m = (2 - w^(m-1) - w^(1-m)) f_m. Neighbours differ by the factor w^(m-1) all around, so the edges are chords of one length that turn by \
         one angle: the generalised regular polygon {12/(m - 1)}, star-shaped or covered several times over, for m = 7 a line and for m = 1 a point. The squared \
         length of an edge is the eigenvalue.",
        Columns::PRINTED,
        examine_columns,
    )
    .reading("The scan of the paper has no picture to compare with: the eigenvalues are those that the columns have")
    .clauses(&[
        "The columns f_km = N^{-1/2} e^{i(2 pi/N)(m-1)(k-1)} are eigenvectors of the Laplacian of C_12.",
        "The edges of each graph form generalized regular polygons.",
    ])
    .altered("half of each angle", |v| v.exponent = |m, k| (m - 1) * (k - 1))
    .altered("eigenvalues 2 + 2 cos", |v| v.factor = -2)
}

fn examine_columns(variant: &Columns, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut values = Vec::new();
    let detail = "all twelve columns: exact products; every edge has the same length and turns by the same angle";
    let found = run.instances("eigenvectors, eigenvalues and polygons", detail, 1..=PARTICLES as i64, |m| {
        let (found, value) = variant.column(m);
        values.push((m, exact_value(&value)?));
        if found.has_value && found.regular && found.squared_edge == value {
            return Ok(None);
        }
        let (value, regular) = (value.enclose(64)?.to_f64(), found.regular);
        Ok(Some(format!("column {m}: eigenvector {} for {value:.6}, edges alike {regular}", found.has_value)))
    })?;
    for (m, value) in values {
        run.value(&format!("eigenvalue_of_column_{m:02}"), value);
    }
    // There are no more columns than these.
    Ok(found.on([1, 2]).for_all())
}
