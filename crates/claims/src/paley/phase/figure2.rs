//! paley.fig2: the twelve columns with their eigenvalues and polygons.

use super::common::{Exact, all_equal, at, laplacian, named};
use arithmetic::{CosineField, RealCyclotomic, Ring};
use ledger::{CheckError, Outcome, Record, Run, interval_value};
use models::oscillator::{clusters_of_pattern, laplacian_rows};

const NODES: i64 = 12;
/// Phases are multiples of this part of a turn.
const PARTS: u32 = 24;

/// Phasors around `C_12`, with what Figure 2 says of them.
pub struct Polygon {
    /// `e^{i theta_k}`.
    pub phasors: Exact,
    /// Whether `L e^{i theta} = value e^{i theta}` for the value that is claimed.
    pub has_value: bool,
    /// Whether the edges have one length and turn by one angle: a generalised regular polygon.
    pub regular: bool,
    /// The squared length of the first edge.
    pub squared_edge: RealCyclotomic,
    /// The clusters of the symmetric pattern that it is, if any.
    pub clusters: Option<u32>,
}

fn polygon(phasors: Exact, value: &RealCyclotomic) -> Result<Polygon, CheckError> {
    let laplacian = laplacian(&named("ring:12")?)?;
    let has_value = laplacian_rows(&laplacian, &phasors).into_iter().zip(&phasors).all(|(lz, z)| lz == z.scale(value));
    let next = |k: usize| &phasors[(k + 1) % phasors.len()];
    // The factor from each vertex to the next, and the squared length of the edge.
    let turns: Vec<_> = phasors.iter().enumerate().map(|(k, z)| next(k).clone() * z.conj()).collect();
    let lengths: Vec<RealCyclotomic> =
        phasors.iter().enumerate().map(|(k, z)| (next(k).clone() - z).norm_squared()).collect();
    Ok(Polygon {
        has_value,
        regular: all_equal(&turns) && all_equal(&lengths),
        squared_edge: lengths[0].clone(),
        clusters: clusters_of_pattern(&phasors),
        phasors,
    })
}

/// The column `m`, counted from 1, in the variant, and its eigenvalue.
fn column(variant: &ColumnVariant, m: i64) -> Result<(Polygon, RealCyclotomic), CheckError> {
    let field = CosineField::new(PARTS);
    let z: Vec<_> = (1..=NODES).map(|k| field.phasor((variant.exponent)(m, k))).collect();
    let cosine = field.cos(2 * (m - 1));
    let value = cosine.integer(variant.constant) - cosine.integer(variant.factor) * &cosine;
    Ok((polygon(z, &value)?, value))
}

/// The column `m`, counted from 1, as printed, and its eigenvalue.
pub fn printed_column(m: i64) -> Result<(Polygon, RealCyclotomic), CheckError> {
    column(&PRINTED, m)
}

/// An eigenvector with the eigenvalue 2 that is no symmetric pattern: phases at 0, 1/6, 1/2 and 2/3 of a turn in turn.
pub fn rhombus() -> Result<Polygon, CheckError> {
    let field = CosineField::new(PARTS);
    let phasors = at(&field, &(0..NODES as usize).map(|k| [0, 4, 12, 16][k % 4]).collect::<Vec<_>>());
    polygon(phasors, &field.cos(0).integer(2))
}

/// Exponents of the columns, in parts of 1/24 turn, and the eigenvalue `constant - factor cos(2 pi (m - 1)/12)`.
#[derive(Clone, Copy)]
pub struct ColumnVariant {
    exponent: fn(m: i64, k: i64) -> i64,
    constant: i64,
    factor: i64,
}

const PRINTED: ColumnVariant = ColumnVariant { exponent: |m, k| 2 * (m - 1) * (k - 1), constant: 2, factor: 2 };

pub fn columns() -> Record<ColumnVariant> {
    Record::new(
        "paley.fig2",
        "f_m has L f_m = (2 - w^(m-1) - w^(1-m)) f_m. Neighbours differ by the factor w^(m-1) all around, so the edges are chords of one length that turn by \
         one angle: the generalised regular polygon {12/(m - 1)}, star-shaped or covered several times over, for m = 7 a line and for m = 1 a point. The squared \
         length of an edge is the eigenvalue.",
        PRINTED,
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

fn examine_columns(variant: &ColumnVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut values = Vec::new();
    let detail = "all twelve columns: exact products; every edge has the same length and turns by the same angle";
    let found = run.instances("eigenvectors, eigenvalues and polygons", detail, 1..=NODES, |m| {
        let (found, value) = column(variant, m)?;
        values.push((m, value_of(&value)?));
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

/// Exactly where it is rational.
pub fn value_of(x: &RealCyclotomic) -> Result<String, CheckError> {
    Ok(match x.rational_value() {
        Some(q) => q.to_string(),
        None => interval_value(&x.enclose(80)?, 12),
    })
}
