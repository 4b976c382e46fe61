//! Enclosures of solutions: against closed forms, floats, and free flight.

mod flocks;
mod flow;
