//! A state of the closed loop (1), (4), (5) at which printed rates fail: equal headings, for which all readings of `theta_i - theta_j`
//! agree.

use crate::prelude::*;

/// Two linked agents at (0, 0) and (1, 1) that move upwards with the speeds 2 and 1, `V = 1/s + log s`, so that `V'(2) = 1/4`. The
/// headings, both `pi/2`, are given in units of `pi/2`.
pub(super) fn upwards() -> Vec<Rational> {
    let q = |n| rational(n, 1);
    vec![q(0), q(0), q(1), q(1), q(0), q(2), q(0), q(1), rational(1, 4), q(1), q(1)]
}

pub(super) const UPWARDS: &str = "two agents at (0, 0) and (1, 1) with velocities (0, 2) and (0, 1), V = 1/s + log s";

/// These agents, to be seen.
pub(super) fn moving_upwards() -> Witness {
    let point = |x, y| [x, y].map(|x| rational(x, 1));
    Witness::agents(&[point(0, 0), point(1, 1)], &[point(0, 2), point(0, 1)], &[])
}

/// Whether the sides agree at the state above; the counterexample if not, in this part.
pub(super) fn at_upwards(identity: &Identity, part: &str, what: &str) -> Result<Option<Outcome>, ArithmeticError> {
    let (left, right) = identity.at(&upwards())?;
    let place = left.iter().zip(&right).position(|(l, r)| l != r);
    Ok(place.map(|k| {
        let text = format!("{UPWARDS}: {what} is {}, but {} is claimed", left[k], right[k]);
        let compared = Witness::compared(what, &left[k], "claimed", &right[k]);
        Outcome::fails(
            Counterexample::new(text, [moving_upwards(), compared]),
            exact(part, "exact rates of change; equal headings, so that alignment forces vanish"),
        )
    }))
}
