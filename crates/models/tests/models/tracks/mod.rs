//! Trajectories: reading and refusing, smoothing without crossing gaps, measures against naive twins, schools whose answer is known.

mod choices;
mod delays;
mod measures;
mod npy;
mod nulls;
mod reading;
mod schools;
mod smoothing;
mod synthetic;
