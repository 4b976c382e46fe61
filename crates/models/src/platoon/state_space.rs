//! The response of any linear system `x' = A x + B u, y = C x + D u` to a leader that swings, such as a platoon whose matrices were
//! written by another program.

use super::cars::Platoon;
use super::observe::{Extreme, largest};
use algebra::matrix::{MatrixError, RationalMatrix, SparseMatrix, Transfer, transfer_function_watched};
use algebra::spectrum::matrix_spectrum;
use arithmetic::{ArithmeticError, Complex, Field, Progress, Rational, Ring};

/// Why matrices make no system.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StateSpaceError {
    /// Rows of different lengths, or shapes that do not fit.
    #[error("{name} has {found}, and should have {expected}")]
    Shape {
        /// The matrix.
        name: &'static str,
        /// What it has.
        found: String,
        /// What it should have.
        expected: String,
    },
}

/// A system with one output. The input is the position of the leader, or its position and velocity.
#[derive(Debug, Clone, PartialEq)]
pub struct StateSpace {
    a: RationalMatrix,
    /// One row for each state, of one or two numbers.
    b: Vec<Vec<Rational>>,
    c: Vec<Rational>,
    /// As many numbers as a row of `b` has.
    d: Vec<Rational>,
}

impl StateSpace {
    /// A system of `n >= 1` states: `a` is n x n, `b` n x 1 or n x 2, `c` 1 x n, `d` 1 x 1 or 1 x 2, or zero where it is missing.
    ///
    /// # Errors
    /// [`StateSpaceError`].
    pub fn new(
        a: &[Vec<Rational>],
        b: &[Vec<Rational>],
        c: &[Vec<Rational>],
        d: Option<&[Vec<Rational>]>,
    ) -> Result<Self, StateSpaceError> {
        let (n, inputs) = (a.len(), b.first().map_or(0, Vec::len));
        let inputs_fit = if (1..=2).contains(&inputs) { inputs } else { 1 };
        fits("A", a, n.max(1), n.max(1))?;
        fits("B", b, n, inputs_fit)?;
        fits("C", c, 1, n)?;
        d.map_or(Ok(()), |d| fits("D", d, 1, inputs_fit))?;
        let a = RationalMatrix::from_rows(a).map_err(|error| StateSpaceError::Shape {
            name: "A",
            found: error.to_string(),
            expected: format!("{n} rows of {n} numbers"),
        })?;
        let d = d.map_or_else(|| vec![Rational::default(); inputs_fit], |d| d[0].clone());
        Ok(StateSpace { a, b: b.to_vec(), c: c[0].clone(), d })
    }

    /// A platoon: the state is `y_1, u_1, y_2, u_2, ..`, the input position and velocity of the leader, the output the position of follower `car`,
    /// `1 <= car <= M`.
    ///
    /// # Errors
    /// [`StateSpaceError`] where there is no such car.
    pub fn of_platoon(platoon: &Platoon<Rational>, car: usize) -> Result<Self, StateSpaceError> {
        let followers = platoon.followers();
        let wrong =
            |name, found: usize, expected: String| StateSpaceError::Shape { name, found: found.to_string(), expected };
        if car == 0 || car > followers {
            return Err(wrong("the car that is looked at", car, format!("a number from 1 to {followers}")));
        }
        let refused = |error: MatrixError| wrong("the graph", followers, error.to_string());
        let rows = platoon.motion_rows().map_err(refused)?;
        let b: Vec<Vec<Rational>> =
            platoon.leader_rows().into_iter().flat_map(|row| [vec![Rational::default(); 2], row.to_vec()]).collect();
        let mut c = vec![Rational::default(); 2 * followers];
        c[2 * (car - 1)] = Rational::from_integer(1.into());
        StateSpace::new(&rows, &b, &[c], None)
    }

    /// The rows of `A`, `B`, `C` and `D`.
    pub fn matrices(&self) -> [Vec<Vec<Rational>>; 4] {
        [self.a.to_rows(), self.b.clone(), vec![self.c.clone()], vec![self.d.clone()]]
    }

    /// The response to a leader `e^{st}` as a quotient of polynomials in `s`, of which the denominator has the eigenvalues of `A` as its roots.
    ///
    /// # Errors
    /// [`MatrixError::Cancelled`].
    pub fn transfer(&self, progress: &dyn Progress) -> Result<Transfer, MatrixError> {
        transfer_function_watched(&self.a.to_rows(), &self.b, &self.c, &self.d, progress)
    }

    /// The number of states.
    pub fn states(&self) -> usize {
        self.a.rows()
    }

    /// The complex amplitude of the output for the leader `e^{iwt}`, by the given way to solve equations `(A | b)`.
    fn response_by<T: Field>(
        &self,
        w: &T,
        solve: impl Fn(Vec<Vec<Complex<T>>>) -> Result<Vec<Complex<T>>, ArithmeticError>,
    ) -> Result<Complex<T>, ArithmeticError> {
        let turn = Complex::new(w.zero(), w.clone());
        let real = |q: &Rational| Complex::real(w.rational(q));
        // The velocity of the leader is iw times its position.
        let driven = |row: &[Rational]| match row {
            [position, velocity] => real(position) + turn.clone() * &real(velocity),
            row => row.first().map_or_else(|| turn.zero(), real),
        };
        let n = self.states();
        let rows = (0..n).map(|i| {
            let entry = |j: usize| {
                let entry = -real(&self.a.entry(i, j));
                if i == j { entry + turn.clone() } else { entry }
            };
            (0..n).map(entry).chain([driven(&self.b[i])]).collect()
        });
        let states = solve(rows.collect())?;
        let terms = self.c.iter().zip(&states).map(|(c, x)| real(c) * x);
        Ok(terms.fold(driven(&self.d), |sum, term| sum + term))
    }

    /// The complex amplitude of the output for the leader `e^{iwt}`. Cost: the cube of the number of states.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the response does not exist or cannot be separated from a pole.
    pub fn response<T: Field>(&self, w: &T) -> Result<Complex<T>, ArithmeticError> {
        self.response_by(w, algebra::matrix::solve_over_field)
    }

    /// The same in floating point, with the largest entry of each column as its pivot.
    ///
    /// # Errors
    /// As [`StateSpace::response`].
    pub fn float_response(&self, w: f64) -> Result<Complex<f64>, ArithmeticError> {
        self.response_by(&w, solve_pivoted)
    }

    /// The largest modulus of the response that a search meets, without proof, over frequencies `w > 0`, in floating point: 48 frequencies per factor of 10 from a tenth of the
    /// smallest to ten times the largest modulus of an eigenvalue, and the neighbourhood of each eigenvalue, refined by golden sections.
    ///
    /// # Errors
    /// [`ArithmeticError`] where the response does not exist, or there is no eigenvalue other than 0.
    pub fn searched_peak(&self) -> Result<Extreme, ArithmeticError> {
        let missing = || ArithmeticError::Domain("eigenvalues other than 0");
        let sparse = SparseMatrix::from_dense(&self.a).map_err(|_| missing())?;
        let spectrum = matrix_spectrum(&sparse, None).map_err(|_| missing())?;
        let values = spectrum.eigenvalues.iter().map(|part| (part.re.to_f64(), part.im.to_f64()));
        let values: Vec<(f64, f64)> = values.filter(|(re, im)| re.hypot(*im) > 0.0).collect();
        let sizes = || values.iter().map(|(re, im)| re.hypot(*im));
        let (low, high) = (sizes().fold(f64::INFINITY, f64::min) / 10.0, sizes().fold(0.0, f64::max) * 10.0);
        if values.is_empty() {
            return Err(missing());
        }
        let size = |w: f64| self.float_response(w).map(|y| y.norm_squared().sqrt());
        let count = (48.0 * (high / low).log10()).ceil();
        let at = |k: f64| low * (high / low).powf(k / count);
        let mut best = Extreme { value: 0.0, at: low };
        let grid = (0..=count as usize).map(|k| size(at(k as f64))).collect::<Result<Vec<f64>, _>>()?;
        let top = (0..grid.len()).max_by(|&i, &j| grid[i].total_cmp(&grid[j])).unwrap_or(0) as f64;
        let near = values.iter().filter(|(_, im)| *im > 0.0).map(|(re, im)| (im - 4.0 * re.abs(), im + 4.0 * re.abs()));
        for (from, to) in near.chain([(at((top - 1.0).max(0.0)), at((top + 1.0).min(count)))]) {
            let found = largest((from.max(low), to.max(low)), 24, size)?;
            if found.value > best.value {
                best = found;
            }
        }
        Ok(best)
    }
}

/// Refuses another shape than so many rows of so many numbers.
fn fits(name: &'static str, matrix: &[Vec<Rational>], rows: usize, columns: usize) -> Result<(), StateSpaceError> {
    let bad = matrix.iter().find(|row| row.len() != columns);
    let found = match bad {
        Some(row) => format!("a row of {} numbers", row.len()),
        None if matrix.len() != rows => format!("{} rows", matrix.len()),
        None => return Ok(()),
    };
    Err(StateSpaceError::Shape { name, found, expected: format!("{rows} rows of {columns} numbers") })
}

/// Solves `(A | b)` over floats, with the largest entry of each column as its pivot.
fn solve_pivoted(mut rows: Vec<Vec<Complex<f64>>>) -> Result<Vec<Complex<f64>>, ArithmeticError> {
    let n = rows.len();
    for column in 0..n {
        let size = |i: &usize| rows[*i][column].norm_squared();
        let pivot = (column..n).max_by(|i, j| size(i).total_cmp(&size(j))).unwrap_or(column);
        rows.swap(column, pivot);
        let inverse = rows[column][column].recip()?;
        let (done, rest) = rows.split_at_mut(column + 1);
        let own = &done[column];
        for row in rest {
            let factor = row[column].clone() * &inverse;
            row[column..].iter_mut().zip(&own[column..]).for_each(|(x, y)| *x = x.clone() - factor.clone() * y);
        }
    }
    let mut solution = vec![Complex::real(0.0); n];
    for i in (0..n).rev() {
        let known = (i + 1..n).fold(rows[i][n].clone(), |sum, j| sum - rows[i][j].clone() * &solution[j]);
        solution[i] = known * &rows[i][i].recip()?;
    }
    Ok(solution)
}
