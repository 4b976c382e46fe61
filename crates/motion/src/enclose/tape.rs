//! A right-hand side written down once as a list of operations, for expansions of every order in one pass.

use crate::System;
use arithmetic::{ArithmeticError, Field, FloatInterval, Number, Rational, Real, Ring, Sign, Signed};
use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// A function of one number whose Taylor coefficients follow from those of another one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    Reciprocal,
    Root,
    /// The derivative of these is the one of the operation that is named with them, times -1 for the cosine.
    Exponential,
    Logarithm,
    Sine,
    Cosine,
    ArcTangent,
    HyperbolicSine,
    HyperbolicCosine,
}

/// An operation on the results of others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Op {
    /// A number of the state, or after them the time.
    Input(usize),
    Constant(FloatInterval),
    Sum(usize, usize),
    Difference(usize, usize),
    Product(usize, usize),
    /// A function, its argument, and where the function stands that its derivative is made of (itself where that is not needed).
    Function(Kind, usize, usize),
}

/// A right-hand side as operations. It is valid on the box on which it was written down, and everywhere if no sign was asked for.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tape {
    pub ops: Vec<Op>,
    pub outputs: Vec<usize>,
    /// Whether signs were asked for.
    pub branches: bool,
}

impl Tape {
    /// Writes down the right-hand side on a box and a stretch of time.
    ///
    /// # Errors
    /// Where it has no value there, or asks for a sign that is not certain.
    pub fn of(system: &impl System, time: FloatInterval, over: &[FloatInterval]) -> Result<Self, ArithmeticError> {
        let writer = Arc::new(Mutex::new(Writer::default()));
        let input = |(index, value): (usize, &FloatInterval)| {
            let id = lock(&writer).add(Op::Input(index));
            Traced { writer: writer.clone(), id, value: *value }
        };
        let state: Vec<Traced> = over.iter().enumerate().map(input).collect();
        let rates = system.rate(&input((over.len(), &time)), &state)?;
        let mut written = lock(&writer);
        if written.undecided {
            return Err(ArithmeticError::Domain("signs that are certain"));
        }
        let ops = std::mem::take(&mut written.ops);
        Ok(Tape { ops, outputs: rates.iter().map(|rate| rate.id).collect(), branches: written.branches })
    }

    /// The same with the derivatives of the outputs by the `size` numbers of the state as further operations: for each output, the numbers that it depends on
    /// with where their derivatives stand. Each operation is differentiated by those numbers only that it depends on, so that pairs cost what pairs have.
    pub fn differentiated(&self, size: usize) -> (Tape, Derivatives) {
        let mut writer = Writer::default();
        let mut slopes: Vec<Vec<(usize, usize)>> = Vec::with_capacity(self.ops.len());
        // The operations keep their numbers.
        self.ops.iter().for_each(|op| writer.push(*op));
        let one = writer.add(Op::Constant(FloatInterval::point(1.0)));
        let minus = writer.add(Op::Constant(FloatInterval::point(-1.0)));
        for (id, op) in self.ops.iter().enumerate() {
            let own = match *op {
                Op::Input(index) if index < size => vec![(index, one)],
                Op::Input(_) | Op::Constant(_) => Vec::new(),
                Op::Sum(a, b) => writer.joined(&slopes[a], &slopes[b]),
                Op::Difference(a, b) => {
                    let second = writer.scaled(&slopes[b], minus);
                    writer.joined(&slopes[a], &second)
                }
                Op::Product(a, b) => {
                    let (first, second) = (writer.scaled(&slopes[a], b), writer.scaled(&slopes[b], a));
                    writer.joined(&first, &second)
                }
                Op::Function(_, a, _) if slopes[a].is_empty() => Vec::new(),
                Op::Function(kind, a, partner) => {
                    let slope = writer.slope(kind, (id, partner), minus);
                    writer.scaled(&slopes[a], slope)
                }
            };
            slopes.push(own);
        }
        let derivatives = self.outputs.iter().map(|&output| slopes[output].clone()).collect();
        (Tape { ops: writer.ops, outputs: self.outputs.clone(), branches: self.branches }, derivatives)
    }
}

/// For each output of a tape the numbers of the state that it depends on, with the operations that are its derivatives by them.
pub(super) type Derivatives = Vec<Vec<(usize, usize)>>;

/// The value of a function.
pub(super) fn value_of<T: Number>(kind: Kind, x: &T) -> Result<T, ArithmeticError> {
    match kind {
        Kind::Reciprocal => x.recip(),
        Kind::Root => x.sqrt(),
        Kind::Exponential => x.exp(),
        Kind::Logarithm => x.ln(),
        Kind::Sine => x.sin(),
        Kind::Cosine => x.cos(),
        Kind::ArcTangent => x.atan(),
        Kind::HyperbolicSine => Ok(x.sinh_cosh()?.0),
        Kind::HyperbolicCosine => x.cosh(),
    }
}

/// Operations that are being written down; the same operation on the same results stands once.
#[derive(Debug, Default)]
struct Writer {
    ops: Vec<Op>,
    known: HashMap<(u8, u64, u64), usize>,
    branches: bool,
    undecided: bool,
}

fn lock(writer: &Mutex<Writer>) -> MutexGuard<'_, Writer> {
    writer.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Writer {
    /// An operation as it is.
    fn push(&mut self, op: Op) {
        self.known.entry(Writer::key(&op)).or_insert(self.ops.len());
        self.ops.push(op);
    }

    fn product(&mut self, a: usize, b: usize) -> usize {
        match (self.is(a, 1.0), self.is(b, 1.0)) {
            (true, _) => b,
            (_, true) => a,
            _ => self.add(Op::Product(a, b)),
        }
    }

    /// Derivatives times an operation.
    fn scaled(&mut self, list: &[(usize, usize)], factor: usize) -> Vec<(usize, usize)> {
        list.iter().map(|&(index, slope)| (index, self.product(slope, factor))).collect()
    }

    /// The sum of two lists in the order of their numbers.
    fn joined(&mut self, a: &[(usize, usize)], b: &[(usize, usize)]) -> Vec<(usize, usize)> {
        let mut all: Vec<(usize, usize)> = a.iter().chain(b).copied().collect();
        all.sort_by_key(|(index, _)| *index);
        let mut sum: Vec<(usize, usize)> = Vec::with_capacity(all.len());
        for (index, slope) in all {
            match sum.last_mut() {
                Some((last, known)) if *last == index => *known = self.add(Op::Sum(*known, slope)),
                _ => sum.push((index, slope)),
            }
        }
        sum
    }

    /// The derivative of a function.
    fn slope(&mut self, kind: Kind, (own, partner): (usize, usize), minus: usize) -> usize {
        match kind {
            Kind::Reciprocal => {
                let square = self.add(Op::Product(own, own));
                self.add(Op::Product(minus, square))
            }
            Kind::Root => {
                let twice = self.add(Op::Sum(own, own));
                let place = self.ops.len();
                self.add(Op::Function(Kind::Reciprocal, twice, place))
            }
            Kind::Cosine => self.add(Op::Product(minus, partner)),
            _ => partner,
        }
    }

    fn key(op: &Op) -> (u8, u64, u64) {
        match *op {
            Op::Input(index) => (0, index as u64, 0),
            Op::Constant(x) => (1, x.lo().to_bits(), x.hi().to_bits()),
            Op::Sum(a, b) => (2, a.min(b) as u64, a.max(b) as u64),
            Op::Difference(a, b) => (3, a as u64, b as u64),
            Op::Product(a, b) => (4, a.min(b) as u64, a.max(b) as u64),
            Op::Function(kind, a, _) => (5 + kind as u8, a as u64, 0),
        }
    }

    /// Where an operation stands, which is written down if it is new.
    fn add(&mut self, op: Op) -> usize {
        let key = Writer::key(&op);
        if let Some(&id) = self.known.get(&key) {
            return id;
        }
        self.ops.push(op);
        self.known.insert(key, self.ops.len() - 1);
        self.ops.len() - 1
    }

    fn constant(&self, id: usize) -> Option<FloatInterval> {
        match self.ops[id] {
            Op::Constant(value) => Some(value),
            _ => None,
        }
    }

    fn is(&self, id: usize, x: f64) -> bool {
        self.constant(id) == Some(FloatInterval::point(x))
    }
}

/// A scalar that writes down what is done with it, with its values on the box.
#[derive(Debug, Clone)]
struct Traced {
    writer: Arc<Mutex<Writer>>,
    id: usize,
    value: FloatInterval,
}

impl Traced {
    fn with(&self, op: Op, value: FloatInterval) -> Self {
        let id = lock(&self.writer).add(op);
        Traced { writer: self.writer.clone(), id, value }
    }

    fn constant(&self, value: FloatInterval) -> Self {
        self.with(Op::Constant(value), value)
    }

    fn combined(
        &self,
        other: &Self,
        op: fn(usize, usize) -> Op,
        value: FloatInterval,
        simpler: impl Fn(&Writer) -> Option<usize>,
    ) -> Self {
        let (found, constants) = {
            let writer = lock(&self.writer);
            (simpler(&writer), writer.constant(self.id).is_some() && writer.constant(other.id).is_some())
        };
        match found {
            Some(id) => Traced { writer: self.writer.clone(), id, value },
            None if constants => self.constant(value),
            None => self.with(op(self.id, other.id), value),
        }
    }

    fn plus(a: &Self, b: &Self) -> Self {
        let simpler = |w: &Writer| match (w.is(a.id, 0.0), w.is(b.id, 0.0)) {
            (true, _) => Some(b.id),
            (_, true) => Some(a.id),
            _ => None,
        };
        a.combined(b, Op::Sum, a.value + b.value, simpler)
    }

    fn minus(a: &Self, b: &Self) -> Self {
        a.combined(b, Op::Difference, a.value - b.value, |w| w.is(b.id, 0.0).then_some(a.id))
    }

    fn times(a: &Self, b: &Self) -> Self {
        let simpler = |w: &Writer| {
            if w.is(a.id, 1.0) || w.is(b.id, 0.0) {
                Some(b.id)
            } else if w.is(b.id, 1.0) || w.is(a.id, 0.0) {
                Some(a.id)
            } else {
                None
            }
        };
        a.combined(b, Op::Product, if a.id == b.id { a.value.square() } else { a.value * b.value }, simpler)
    }

    fn negated(a: &Self) -> Self {
        Traced::minus(&a.constant(FloatInterval::point(0.0)), a)
    }

    /// The values of a function, and whether they are one constant. On intervals it may have none where the expansion shows that it has: then they are not known.
    fn applied(&self, kind: Kind) -> Result<(FloatInterval, bool), ArithmeticError> {
        let constant = lock(&self.writer).constant(self.id).is_some();
        let value = value_of(kind, &self.value);
        Ok((if constant { value? } else { value.unwrap_or(FloatInterval::LINE) }, constant))
    }

    /// A function whose derivative is made of itself alone.
    fn alone(&self, kind: Kind) -> Result<Self, ArithmeticError> {
        let (value, constant) = self.applied(kind)?;
        if constant {
            return Ok(self.constant(value));
        }
        let mut writer = lock(&self.writer);
        let place = writer.ops.len();
        let id = writer.add(Op::Function(kind, self.id, place));
        Ok(Traced { writer: self.writer.clone(), id, value })
    }

    /// Two functions whose derivatives are made of each other.
    fn both(&self, kinds: [Kind; 2]) -> Result<(Self, Self), ArithmeticError> {
        let [(first, constant), (second, _)] = [self.applied(kinds[0])?, self.applied(kinds[1])?];
        let values = [first, second];
        if constant {
            return Ok((self.constant(first), self.constant(second)));
        }
        let mut writer = lock(&self.writer);
        let place = writer.ops.len();
        let first = writer.add(Op::Function(kinds[0], self.id, place + 1));
        let second = writer.add(Op::Function(kinds[1], self.id, place));
        drop(writer);
        let made = |id: usize, value: FloatInterval| Traced { writer: self.writer.clone(), id, value };
        Ok((made(first, values[0]), made(second, values[1])))
    }

    /// A function whose derivative is another one.
    fn from(&self, kind: Kind, slope: &Self) -> Result<Self, ArithmeticError> {
        let (value, constant) = self.applied(kind)?;
        Ok(if constant { self.constant(value) } else { self.with(Op::Function(kind, self.id, slope.id), value) })
    }
}

macro_rules! by_reference_and_value {
    ($($trait:ident $method:ident $function:ident),*) => {$(
        impl std::ops::$trait<&Traced> for Traced {
            type Output = Traced;
            fn $method(self, right: &Traced) -> Traced {
                Traced::$function(&self, right)
            }
        }
        impl std::ops::$trait for Traced {
            type Output = Traced;
            fn $method(self, right: Traced) -> Traced {
                Traced::$function(&self, &right)
            }
        }
    )*};
}

by_reference_and_value!(Add add plus, Sub sub minus, Mul mul times);

impl std::ops::Neg for Traced {
    type Output = Traced;
    fn neg(self) -> Traced {
        Traced::negated(&self)
    }
}

impl Ring for Traced {
    fn integer(&self, n: i64) -> Self {
        self.constant(self.value.integer(n))
    }
}

impl Field for Traced {
    fn rational(&self, q: &Rational) -> Self {
        self.constant(FloatInterval::from_rational(q))
    }

    fn ratio(&self, p: i64, q: i64) -> Self {
        self.constant(self.value.ratio(p, q))
    }

    fn recip(&self) -> Result<Self, ArithmeticError> {
        self.alone(Kind::Reciprocal)
    }
}

impl Signed for Traced {
    fn sign(&self) -> Option<Sign> {
        let sign = self.value.sign();
        let mut writer = lock(&self.writer);
        if writer.constant(self.id).is_none() {
            writer.branches = true;
        }
        writer.undecided |= sign.is_none();
        sign
    }
}

impl Number for Traced {
    fn circle(&self) -> Result<Self, ArithmeticError> {
        Ok(self.constant(self.value.pi()))
    }

    fn sqrt(&self) -> Result<Self, ArithmeticError> {
        self.alone(Kind::Root)
    }

    fn exp(&self) -> Result<Self, ArithmeticError> {
        self.alone(Kind::Exponential)
    }

    fn ln(&self) -> Result<Self, ArithmeticError> {
        self.from(Kind::Logarithm, &self.recip()?)
    }

    fn sin_cos(&self) -> Result<(Self, Self), ArithmeticError> {
        self.both([Kind::Sine, Kind::Cosine])
    }

    fn atan(&self) -> Result<Self, ArithmeticError> {
        self.from(Kind::ArcTangent, &(self.square() + self.one()).recip()?)
    }

    fn sinh_cosh(&self) -> Result<(Self, Self), ArithmeticError> {
        self.both([Kind::HyperbolicSine, Kind::HyperbolicCosine])
    }
}
