//! Enclosures of solutions: against closed forms, and floats.

mod flow;
