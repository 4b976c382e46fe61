//! What nearly every check uses.

pub(crate) use crate::evidence::{
    Placed, are_within, argued, argued_with, at_most, certified, checking, exact, exhaustive, fuzzed, holds, list,
    unless,
};
pub(crate) use arithmetic::identity::Identity;
pub(crate) use arithmetic::{
    ArithmeticError, Complex, Dual, Field, Interval, Number, Probe, Rational, Real, Ring, rational,
};
pub(crate) use ledger::{
    CheckError, Counterexample, Evidence, Fault, Grade, Outcome, Record, Run, Witness, interval_value,
};
