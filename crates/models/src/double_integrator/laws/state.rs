//! Positions and velocities of agents in the plane, vectors, and rates of change by duals.

use arithmetic::{ArithmeticError, Dual, Field, Ring};

/// A pair of agents, counted from 0.
pub type Pair = (usize, usize);

/// A vector of the plane.
pub type Vector<T> = [T; 2];

/// `a + b`.
#[inline(always)]
pub fn sum<T: Ring>(a: &Vector<T>, b: &Vector<T>) -> Vector<T> {
    [a[0].clone() + &b[0], a[1].clone() + &b[1]]
}

/// `a - b`.
#[inline(always)]
pub fn difference<T: Ring>(a: &Vector<T>, b: &Vector<T>) -> Vector<T> {
    [a[0].clone() - &b[0], a[1].clone() - &b[1]]
}

/// `factor a`.
#[inline(always)]
pub fn scaled<T: Ring>(factor: &T, a: &Vector<T>) -> Vector<T> {
    [factor.clone() * &a[0], factor.clone() * &a[1]]
}

/// `z x a`: the vector turned by a right angle, in Cartesian coordinates.
pub fn rotated<T: Ring>(a: &Vector<T>) -> Vector<T> {
    [-a[1].clone(), a[0].clone()]
}

/// The inner product of two vectors, in Cartesian coordinates.
pub fn dot<T: Ring>(a: &Vector<T>, b: &Vector<T>) -> T {
    a[0].clone() * &b[0] + a[1].clone() * &b[1]
}

/// `a x b`, the component along `z`, in Cartesian coordinates.
pub fn cross<T: Ring>(a: &Vector<T>, b: &Vector<T>) -> T {
    a[0].clone() * &b[1] - a[1].clone() * &b[0]
}

/// The basis in which the coordinates are meant. The laws are the same in both; only lengths differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinates {
    /// Two orthogonal unit vectors.
    Cartesian,
    /// Two unit vectors at 60 degrees: the corners of an equilateral triangle have integer coordinates.
    Triangular,
}

impl Coordinates {
    /// The inner product of two vectors.
    #[inline(always)]
    pub fn product<T: Field>(self, a: &Vector<T>, b: &Vector<T>) -> T {
        let straight = a[0].clone() * &b[0] + a[1].clone() * &b[1];
        match self {
            Coordinates::Cartesian => straight,
            Coordinates::Triangular => straight + (a[0].clone() * &b[1] + a[1].clone() * &b[0]) * a[0].ratio(1, 2),
        }
    }

    /// The squared length of a vector.
    #[inline(always)]
    pub fn square<T: Field>(self, a: &Vector<T>) -> T {
        self.product(a, a)
    }
}

/// Positions `r_i` and velocities `v_i` of `N` agents, one of each for every agent.
#[derive(Debug, Clone, PartialEq)]
pub struct State<T> {
    /// `r_i`.
    pub positions: Vec<Vector<T>>,
    /// `v_i`.
    pub velocities: Vec<Vector<T>>,
}

impl<T: Ring> State<T> {
    /// The state of `count` agents from a list `x_1, y_1, ..., x_N, y_N` of positions and then one of velocities; `None`
    /// where the list has another length than `4 count`.
    pub fn from_list(count: usize, list: &[T]) -> Option<Self> {
        (count.checked_mul(4) == Some(list.len())).then(|| State::from_halves(list))
    }

    /// The state whose positions are the first half of a list, and whose velocities are the second.
    pub(in crate::double_integrator) fn from_halves(list: &[T]) -> Self {
        let vectors = |part: &[T]| part.chunks_exact(2).map(|p| [p[0].clone(), p[1].clone()]).collect();
        let (positions, velocities) = list.split_at(list.len() / 2);
        State { positions: vectors(positions), velocities: vectors(velocities) }
    }

    /// Makes this the state of a list of its length; `None` for another length.
    pub(in crate::double_integrator) fn read(&mut self, list: &[T]) -> Option<()> {
        (list.len() == 4 * self.count()).then_some(())?;
        let places = self.positions.iter_mut().chain(&mut self.velocities);
        for (to, from) in places.zip(list.chunks_exact(2)) {
            to.clone_from_slice(from);
        }
        Some(())
    }

    /// The list that [`Self::from_list`] reads.
    pub fn to_list(&self) -> Vec<T> {
        self.positions.iter().chain(&self.velocities).flatten().cloned().collect()
    }

    /// Whether there is a velocity for each position.
    ///
    /// # Errors
    /// [`ArithmeticError::Domain`] where there is not.
    pub(in crate::double_integrator) fn check(&self) -> Result<(), ArithmeticError> {
        let one_of_each = self.positions.len() == self.velocities.len();
        if one_of_each { Ok(()) } else { Err(ArithmeticError::Domain("a velocity for each position")) }
    }

    /// The number of agents.
    pub fn count(&self) -> usize {
        self.positions.len()
    }

    /// `r_ij = r_i - r_j`.
    ///
    /// # Panics
    /// Where `i` or `j` is not below [`State::count`], as an index of a list.
    pub fn separation(&self, i: usize, j: usize) -> Vector<T> {
        difference(&self.positions[i], &self.positions[j])
    }

    /// `v_i - v_j`.
    ///
    /// # Panics
    /// As [`State::separation`].
    pub fn relative_velocity(&self, i: usize, j: usize) -> Vector<T> {
        difference(&self.velocities[i], &self.velocities[j])
    }

    /// The state with derivatives along the closed loop: `rdot_i = v_i`, `vdot_i = accelerations_i`. What is computed from it
    /// has as its derivative the rate of change along the motion.
    pub fn moving(&self, accelerations: &[Vector<T>]) -> State<Dual<T>> {
        let pair = |value: &Vector<T>, rate: &Vector<T>| [0, 1].map(|k| Dual::new(value[k].clone(), rate[k].clone()));
        let pairs =
            |values: &[Vector<T>], rates: &[Vector<T>]| values.iter().zip(rates).map(|(a, b)| pair(a, b)).collect();
        State {
            positions: pairs(&self.positions, &self.velocities),
            velocities: pairs(&self.velocities, accelerations),
        }
    }

    /// Every scalar mapped.
    pub fn map<U>(&self, convert: impl Fn(&T) -> U) -> State<U> {
        let all = |vectors: &[Vector<T>]| vectors.iter().map(|v| [convert(&v[0]), convert(&v[1])]).collect();
        State { positions: all(&self.positions), velocities: all(&self.velocities) }
    }
}

/// `sqrt(sum |v_i - mean|²)`.
pub fn disagreement(state: &State<f64>) -> f64 {
    let count = state.count().max(1) as f64;
    let total = state.velocities.iter().fold([0.0, 0.0], |s, v| sum(&s, v));
    let mean = scaled(&(1.0 / count), &total);
    state.velocities.iter().map(|v| Coordinates::Cartesian.square(&difference(v, &mean))).sum::<f64>().sqrt()
}
