//! The arrangements around `C_12` of Figure 2, exact.

use super::PARTICLES;
use arithmetic::{Complex, CosineField, RealCyclotomic, Ring};
use models::oscillator::{Interaction, Neighbours, clusters_of_pattern};

/// Phases are multiples of this part of a turn.
const PARTS: u32 = 24;

/// Phasors around `C_12`, with what Figure 2 says of them.
pub struct Polygon {
    /// `e^{i theta_k}`.
    pub phasors: Vec<Complex<RealCyclotomic>>,
    /// Whether `L e^{i theta} = value e^{i theta}` for the value that is claimed.
    pub has_value: bool,
    /// Whether the edges have one length and turn by one angle: a generalised regular polygon.
    pub regular: bool,
    /// The squared length of the first edge.
    pub squared_edge: RealCyclotomic,
    /// The clusters of the symmetric pattern that it is, if any.
    pub clusters: Option<u32>,
}

impl Polygon {
    /// Twelve phasors, each `e^{2 pi i part(k)/24}` with `k` from 1.
    fn new(field: &CosineField, part: impl Fn(i64) -> i64, value: &RealCyclotomic) -> Self {
        let phasors: Vec<_> = (1..=PARTICLES as i64).map(|k| field.phasor(part(k))).collect();
        let laplacian = Neighbours::circulant(PARTICLES, &[1]).laplacian_of(&phasors);
        let has_value = laplacian.into_iter().zip(&phasors).all(|(lz, z)| lz == z.scale(value));
        // The factor from each vertex to the next, and the squared length of the edge.
        let edges = || phasors.iter().zip(phasors.iter().cycle().skip(1));
        let turns: Vec<_> = edges().map(|(z, next)| next.clone() * z.conj()).collect();
        let lengths: Vec<_> = edges().map(|(z, next)| (next.clone() - z).norm_squared()).collect();
        Polygon {
            has_value,
            regular: turns.iter().all(|turn| *turn == turns[0]) && lengths.iter().all(|length| *length == lengths[0]),
            squared_edge: lengths[0].clone(),
            clusters: clusters_of_pattern(&phasors),
            phasors,
        }
    }

    /// An eigenvector with the eigenvalue 2 that is no symmetric pattern: phases at 0, 1/6, 1/2 and 2/3 of a turn in turn.
    pub fn rhombus() -> Self {
        let field = CosineField::new(PARTS);
        Polygon::new(&field, |k| [16, 0, 4, 12][k as usize % 4], &field.cos(0).integer(2))
    }
}

/// Columns of a matrix of twelve rows, each with the eigenvalue that it is said to have.
#[derive(Clone, Copy)]
pub struct Columns {
    /// The phase in row `k` of column `m`, both counted from 1, in parts of 1/24 turn.
    pub exponent: fn(m: i64, k: i64) -> i64,
    /// The eigenvalue is this less `factor cos(2 pi (m - 1)/12)`.
    pub constant: i64,
    /// See `constant`.
    pub factor: i64,
}

impl Columns {
    /// Those of the Fourier matrix, as printed.
    pub const PRINTED: Columns = Columns { exponent: |m, k| 2 * (m - 1) * (k - 1), constant: 2, factor: 2 };

    /// The column `m`, counted from 1, and its eigenvalue.
    pub fn column(&self, m: i64) -> (Polygon, RealCyclotomic) {
        let field = CosineField::new(PARTS);
        let cosine = field.cos(2 * (m - 1));
        let value = cosine.integer(self.constant) - cosine.integer(self.factor) * &cosine;
        (Polygon::new(&field, |k| (self.exponent)(m, k), &value), value)
    }
}
