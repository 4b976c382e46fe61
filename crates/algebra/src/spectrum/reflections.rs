//! A product of blocks of reflections as a matrix of floats, with a lower bound of its least singular value that costs next to
//! nothing: no product of the matrix with its transpose is formed.
//!
//! **Theorem.** Let `B_k = I - V_k X_k V_kᵀ` for any matrices of floats `V_k` and `X_k`, let `δ_k >= ‖B_kᵀB_k - I‖₂`, and let the
//! floats `Q_k`, from `Q_(m+1) = I` down to `Q_1 = Q`, fulfil `‖Q_k - B_k Q_(k+1)‖ <= ε_k`. If all `δ_k < 1`, then the least singular
//! value of `Q` is at least `∏ (1 - δ_k) - ∏ (1 + δ_k) Σ ε_k`.
//!
//! *Proof.* The singular values of `B_k` lie between `√(1 - δ_k)` and `√(1 + δ_k)`, so between `1 - δ_k` and `1 + δ_k`; that of a product is
//! at least the product of the least ones. `Q = B_1 ... B_m + Σ B_1 ... B_(k-1) (Q_k - B_k Q_(k+1))`, and a singular value moves by
//! at most the norm of what is added (Weyl). ∎
//!
//! **δ.** `BᵀB - I = V D Vᵀ` with `D = Xᵀ(VᵀV)X - X - Xᵀ`, a small matrix, so `δ = ‖V‖_F² ‖D‖_F`. Products of floats are within `k u |a||b|`
//! for the inner dimension `k`, in any order of summation: with `v = ‖V‖_F`, `x = ‖X‖_F`, `r` rows and `w` columns of `V`, the computed
//! `D` is within `(r + 2w + 4) u (v²x² + 2x)`.
//!
//! **ε.** `P - V(X(VᵀP))` by three products: `VᵀP` is within `r u v p` where `p = ‖P‖_F`, and contributes at most `v x` times that; the
//! second product contributes at most `w u v²x p` and the third with the difference `(w + 2) u (p + v²x p)`. Together
//! `ε <= (r + 2w + 4) u (1 + v²x) p`, and the next `p` is at most `(1 + δ) p + ε`. Second-order terms are in [`SLACK`].
//!
//! Nothing is assumed of where `V` and `X` come from.

use super::float_bounds::{SLACK, UNDERFLOW, UNIT, frobenius};
use dense::{Mat, MatMut, add_product, product};

/// `I - V X Vᵀ` on the rows from `from` on.
pub(super) struct Block {
    pub from: usize,
    pub v: Mat<f64>,
    pub x: Mat<f64>,
}

/// Blocks of reflections, from the left to the right.
pub(super) struct Reflections {
    order: usize,
    blocks: Vec<Block>,
}

impl Reflections {
    /// Blocks that reach down to the last row.
    pub fn new(order: usize, blocks: Vec<Block>) -> Self {
        Reflections { order, blocks }
    }

    /// Some columns of the product: the unit vectors, reflected block by block from the last to the first.
    pub fn columns(&self, start: usize, width: usize) -> Mat<f64> {
        let mut panel = Mat::zeros(self.order, width);
        (0..width).for_each(|j| panel[(start + j, j)] = 1.0);
        // Blocks that begin below these columns leave them as they are, exactly.
        for block in self.blocks.iter().rev().filter(|block| block.from < start + width) {
            // Its rows of columns before it are zero.
            let first = block.from.saturating_sub(start);
            block.apply(panel.as_mut().submatrix_mut(block.from, first, self.order - block.from, width - first));
        }
        panel
    }

    /// A bound from below of the least singular value of the matrix of all [`Self::columns`], in whatever parts they are found; NaN
    /// where there is none.
    pub fn least_singular_value(&self) -> f64 {
        let (mut least, mut most, mut errors) = (1.0, 1.0, 0.0);
        let mut size = (self.order as f64).sqrt() * SLACK;
        for block in self.blocks.iter().rev() {
            let (departure, rounding) = block.bounds();
            let error = rounding * size * SLACK + UNDERFLOW;
            least *= if departure < 0.5 { 1.0 - departure } else { f64::NAN };
            most *= 1.0 + departure;
            errors += error;
            size = (size * (1.0 + departure) + error) * SLACK;
        }
        // Fewer than 10⁴ products, rounded up or down by a part in 10⁶ as a whole.
        (least - most * errors * SLACK) / SLACK
    }
}

impl Block {
    fn apply(&self, mut panel: MatMut<'_, f64>) {
        let inner = product(self.v.transpose(), panel.as_ref());
        let inner = product(self.x.as_ref(), inner.as_ref());
        add_product(panel.as_mut(), -1.0, self.v.as_ref(), inner.as_ref());
    }

    /// Bounds of `δ`, and of `ε/p`.
    fn bounds(&self) -> (f64, f64) {
        let (v, x) = (frobenius(self.v.as_ref()), frobenius(self.x.as_ref()));
        let gram = product(self.v.transpose(), self.v.as_ref());
        let turned = product(self.x.transpose(), product(gram.as_ref(), self.x.as_ref()).as_ref());
        let difference =
            Mat::from_fn(turned.nrows(), turned.ncols(), |i, j| turned[(i, j)] - self.x[(i, j)] - self.x[(j, i)]);
        let unit = (self.v.nrows() as f64 + 2.0 * self.v.ncols() as f64 + 4.0) * UNIT * SLACK;
        let error = unit * (v * v * x * x + 2.0 * x) + UNDERFLOW;
        let departure = v * v * (frobenius(difference.as_ref()) + error) * SLACK;
        (departure, unit * (1.0 + v * v * x) * SLACK)
    }
}

#[cfg(test)]
mod tests {
    use super::super::testing::{assert_equals, assert_rounded_up, whole as whole_number};
    use super::*;

    /// The matrix of the product, whole or in panels, and the least singular value by an eigenvalue routine.
    fn whole(reflections: &Reflections) -> Mat<f64> {
        reflections.columns(0, reflections.order)
    }

    fn random(order: usize, width: usize, tilt: f64) -> Reflections {
        let mut seed = 1u64;
        let mut draw = move || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 * 2f64.powi(-52) - 1.0
        };
        let block = |from: usize| {
            let (rows, width) = (order - from, width.min(order - from));
            let entry = |i: usize, j: usize| if i > j { draw() } else { f64::from(u8::from(i == j)) };
            let v = Mat::from_fn(rows, width, entry);
            let mut x = Mat::<f64>::zeros(width, width);
            for j in 0..width {
                let overlap = |l: usize| (0..rows).map(|i| v[(i, l)] * v[(i, j)]).sum::<f64>();
                let weight = 2.0 / overlap(j);
                for k in 0..j {
                    x[(k, j)] = -weight * (k..j).map(|l| x[(k, l)] * overlap(l)).sum::<f64>();
                }
                x[(j, j)] = weight * (1.0 + tilt);
            }
            Block { from, v, x }
        };
        Reflections::new(order, (1..order).step_by(width).map(block).collect())
    }

    #[test]
    fn the_bound_holds_and_is_close_for_reflections() {
        for (order, width) in [(2, 1), (3, 8), (40, 8), (129, 32), (200, 48)] {
            for tilt in [0.0, 1e-9, 1e-4] {
                let reflections = random(order, width, tilt);
                let bound = reflections.least_singular_value();
                let whole = whole(&reflections);
                let matrix = nalgebra::DMatrix::from_fn(order, order, |i, j| whole[(i, j)]);
                let least = matrix.singular_values().min();
                // The bound is crude where the blocks are not reflections to many digits.
                assert!(
                    bound <= least * (1.0 + 1e-12) || bound.is_nan() && tilt > 1e-6,
                    "{order} {width} {tilt}: {bound} {least}"
                );
                if tilt == 0.0 {
                    assert!(bound > 0.999, "{order} {width}: {bound}");
                }
            }
        }
    }

    #[test]
    fn what_is_far_from_a_reflection_has_no_bound() {
        assert!(random(60, 16, 3.0).least_singular_value().is_nan());
        // `BᵀB - I = 4x² - 4x` for `V = (1 1 1 1)/2` of length 1 and `X = x`: -7/16 and -9/16.
        let alone = |x: f64| {
            let (v, x) = (Mat::from_fn(4, 1, |_, _| 0.5), Mat::from_fn(1, 1, |_, _| x));
            Reflections::new(4, vec![Block { from: 0, v, x }]).least_singular_value()
        };
        assert!((alone(0.25) - 9.0 / 16.0).abs() < 1e-5 && alone(0.375).is_nan());
    }

    /// Whole numbers, so that `D = Xᵀ(VᵀV)X - X - Xᵀ` is exact; each norm is rounded up once.
    #[test]
    fn bounds_of_blocks_are_the_formulas() {
        for (rows, width) in [(1, 1), (3, 1), (4, 2), (7, 3), (9, 9)] {
            let (v, x) =
                (Mat::from_fn(rows, width, whole_number), Mat::from_fn(width, width, |i, j| whole_number(j, i)));
            let gram = |k: usize, l: usize| (0..rows).map(|i| v[(i, k)] * v[(i, l)]).sum::<f64>();
            let pairs = || (0..width).flat_map(|k| (0..width).map(move |l| (k, l)));
            let difference = |i: usize, j: usize| {
                pairs().map(|(k, l)| x[(k, i)] * gram(k, l) * x[(l, j)]).sum::<f64>() - x[(i, j)] - x[(j, i)]
            };
            let norm = |squares: f64| squares.sqrt() * SLACK;
            let d = norm(pairs().map(|(i, j)| difference(i, j).powi(2)).sum());
            let v_size =
                norm((0..rows).flat_map(|i| (0..width).map(move |j| (i, j))).map(|place| v[place].powi(2)).sum());
            let x_size = norm(pairs().map(|place| x[place].powi(2)).sum());
            let unit = (rows + 2 * width + 4) as f64 * UNIT * SLACK;
            let error = unit * (v_size.powi(2) * x_size.powi(2) + 2.0 * x_size);
            let (departure, rounding) = Block { from: 0, v: v.clone(), x: x.clone() }.bounds();
            assert_equals(departure, v_size.powi(2) * (d + error) * SLACK, &format!("{rows} x {width}"));
            assert_equals(rounding, unit * (1.0 + v_size.powi(2) * x_size) * SLACK, &format!("{rows} x {width}"));
        }
        // Reflections: rounding is all that is left of the departure, v² (r + 2w + 4) u (v² x² + 2x).
        for (v, x, derived) in [
            ([1.0, 1.0, 2f64.powi(-60)], 1.0, 2.0 * 9.0 * (2.0 + 2.0)),
            ([0.5, 0.5, 0.0], 4.0, 0.5 * 9.0 * (8.0 + 8.0)),
        ] {
            let (v, x) = (Mat::from_fn(3, 1, |i, _| v[i]), Mat::from_fn(1, 1, |_, _| x));
            assert_rounded_up(Block { from: 0, v, x }.bounds().0, derived * UNIT, "a reflection");
        }
    }

    /// Of the last block first: the sizes of what it is applied to, and of what it leaves.
    #[test]
    fn the_bound_of_a_product_is_the_formula() {
        // Far from reflections, `BᵀB - I = 0.21 V Vᵀ`, and many: what is lost in each is magnified by the others.
        let far = |_| {
            let (v, x) = (Mat::from_fn(4, 1, |_, _| 0.5), Mat::from_fn(1, 1, |_, _| 2.1));
            Block { from: 0, v, x }
        };
        let many = Reflections::new(4, (0..40).map(far).collect());
        for reflections in [random(3, 8, 0.0), random(40, 8, 1e-6), random(90, 32, 1e-5), random(90, 32, 1e-7), many] {
            let (mut least, mut most, mut errors) = (1.0, 1.0, 0.0);
            let mut size = (reflections.order as f64).sqrt() * SLACK;
            for (departure, rounding) in reflections.blocks.iter().rev().map(Block::bounds) {
                assert!(departure < 0.5, "{departure}");
                let error = rounding * size * SLACK;
                (least, most, errors) = (least * (1.0 - departure), most * (1.0 + departure), errors + error);
                size = (size + size * departure + error) * SLACK;
            }
            let derived = (least - most * errors * SLACK) / SLACK;
            assert!(derived > 0.0);
            assert_equals(reflections.least_singular_value(), derived, &format!("order {}", reflections.order));
        }
    }

    #[test]
    fn panels_are_parts_of_the_whole() {
        let reflections = random(90, 16, 0.0);
        let whole = whole(&reflections);
        for (start, width) in [(0, 30), (30, 7), (37, 53)] {
            let panel = reflections.columns(start, width);
            for (i, j) in (0..90).flat_map(|i| (0..width).map(move |j| (i, j))) {
                assert!((panel[(i, j)] - whole[(i, start + j)]).abs() < 1e-12);
            }
        }
        // Against the reflections one by one.
        let product = reflections.blocks.iter().fold(Mat::<f64>::identity(90, 90), |product, block| {
            let mut full = Mat::<f64>::identity(90, 90);
            let part = &block.v * &block.x * block.v.transpose();
            for (i, j) in (0..part.nrows()).flat_map(|i| (0..part.nrows()).map(move |j| (i, j))) {
                full[(block.from + i, block.from + j)] -= part[(i, j)];
            }
            product * full
        });
        assert!(frobenius((product - whole).as_ref()) < 1e-11);
    }
}
