//! beyond.veerman.worst_cases: how far cars come from each other behind a leader of bounded acceleration, beside the resonance.

use crate::prelude::*;
use crate::veerman::{complex_gains, gain_factors, imaginary, parts, unit};
use models::platoon::{
    Communication, Gains, accelerations, amplitude_one_sided, gain_squared_one_sided, strongest_one_sided_square,
};

const CARS: u64 = 6;
const PLACE: &str = "notes/reach.md, Worst cases for all sizes, steps 1 to 5";

/// Settled deviations `k (2 M - k + lag)/f` and gaps `(2 (M - k) + gap)/f` of system (2), `scale k/f` of system (1); the response of gap k there has the factor `gamma^-(k - 1 + power)`.
#[derive(Clone, Copy)]
pub struct WorstVariant {
    lag: i64,
    gap: i64,
    scale: i64,
    power: u64,
    /// Where `|1/gamma| > 1`: for `0 < w² < bound |f|`.
    bound: i64,
}

impl WorstVariant {
    /// The deviation of car `k` of `m` in system (2).
    fn settled<T: Field>(&self, f: &T, m: &T, k: &T) -> Result<T, ArithmeticError> {
        (k.clone() * (m.clone() + m - k + f.integer(self.lag))).over(f)
    }
}

/// With these deviations from the leader, at rest beside it, every follower accelerates by 1 as it does.
fn follows(variant: &WorstVariant, communication: Communication, followers: u64) -> Identity<'_> {
    Identity::of(move |[f, g]| {
        let m = f.integer(followers as i64);
        let deviation = |k: u64| {
            let k = f.integer(k as i64);
            match communication {
                Communication::Front => (k * f.integer(variant.scale)).over(f),
                _ => variant.settled(f, &m, &k),
            }
        };
        let deviations: Vec<Probe> = (1..=followers).map(deviation).collect::<Result<_, _>>()?;
        let still = vec![f.zero(); deviations.len()];
        let gains = Gains { f: f.clone(), g: g.clone() };
        let found = accelerations(communication, &gains, (&f.zero(), &f.zero()), &deviations, &still);
        Ok((found, vec![f.one(); deviations.len()]))
    })
    .within(|at| at[0] < rational(0, 1) && at[1] < rational(0, 1))
}

/// The same for any number of followers, row by row, and the gap.
fn follows_for_all(variant: &WorstVariant) -> Identity<'_> {
    Identity::of(move |[f, m, k]| {
        let one = f.one();
        let at = |k: &Probe| variant.settled(f, m, k);
        let (before, own, after) = (at(&(k.clone() - &one))?, at(k)?, at(&(k.clone() + &one))?);
        let inside = f.clone() * (own.clone() - (before.clone() + &after) * f.ratio(1, 2));
        let last = f.clone() * (at(m)? - at(&(m.clone() - &one))?);
        let gap = ((m.clone() - k) * f.integer(2) + f.integer(variant.gap)).over(f)?;
        Ok((vec![inside, last, at(&f.zero())?, own - before], vec![one.clone(), one, f.zero(), gap]))
    })
    .within(|at| at[0] < rational(0, 1))
}

/// The oscillation of the gaps of system (1), `a_k - a_(k-1) = w² gamma^-(k-1)/(-f - w² - i g w)`.
fn oscillating_gaps(variant: &WorstVariant) -> Identity<'_> {
    Identity::of(move |[f, g, w]| {
        let gains = Gains { f: f.clone(), g: g.clone() };
        let characteristic =
            -(complex_gains(f, g).f + complex_gains(f, g).g * imaginary(w) + Complex::real(w.square()));
        let (mut found, mut claimed) = (Vec::new(), Vec::new());
        for k in 1..=CARS {
            found.push(amplitude_one_sided(&gains, w, k)? - amplitude_one_sided(&gains, w, k - 1)?);
            let factor = amplitude_one_sided(&gains, w, k - 1 + variant.power)?;
            claimed.push((factor * Complex::real(w.square())).over(&characteristic)?);
        }
        Ok((parts(found), parts(claimed)))
    })
    .within(|at| at[0] < rational(0, 1) && at[1] < rational(0, 1) && at[2] > rational(0, 1))
}

pub fn worst_cases() -> Record<WorstVariant> {
    Record::new(
        "beyond.veerman.worst_cases",
        "A leader that accelerates by 1 for ever is followed, in the end, at the deviations for which every follower accelerates by 1 too: k (2M - k)/f in system (2), k/f in system (1). \
         A leader that swings with an acceleration of amplitude 1 makes the gaps of system (1) swing with the amplitude |1/gamma|^(k-1)/|f + i w g + w²|, and |1/gamma| > 1 at the frequency at which it is largest. \
         Worst cases themselves are enclosed by flockproof reach.",
        WorstVariant { lag: 0, gap: 1, scale: 1, power: 0, bound: 2 },
        examine,
    )
    .stated("completes veerman, Section 6: gains of bounded accelerations beside the resonance", "")
    .clauses(&[
        "Let f, g < 0, let all cars of system (2) with M followers start in their places at the leader's velocity, and let the leader's acceleration be any measurable function with values in \
         [-1, 1]. Over all of these and all t >= 0 the supremum of |y_k - y_0|, y_k the deviation of car k from its place, k = 1, ..., M, is at least k (2M - k)/|f|, and M²/|f| for the last car.",
        "In the same setting the supremum of |y_k - y_(k-1)| is at least (2 (M - k) + 1)/|f|.",
        "For system (1), in the same setting, the supremum of |y_k - y_0| is at least k/|f|.",
        "For system (1), in the same setting, the supremum of |y_k - y_(k-1)| is at least |1/gamma|^(k-1)/|f + i w g + w²| for every frequency w > 0, gamma = (f + w² + i w g)/(f + i w g), and so grows exponentially with k: |1/gamma| > 1 for 0 < w² < 2|f|.",
    ])
    .altered("k (2M - k + 1)/|f|", |v| v.lag = 1)
    .altered("gaps of 2 (M - k + 1)/|f|", |v| v.gap = 2)
    .altered("lags 2k/|f| in system (1)", |v| v.scale = 2)
    .altered("|1/gamma|^k in place of |1/gamma|^(k-1)", |v| v.power = 1)
    .altered("|1/gamma| > 1 for 0 < w² < 4|f|", |v| v.bound = 4)
}

fn examine(variant: &WorstVariant, run: &mut Run) -> Result<Outcome, CheckError> {
    let mut results = vec![
        run.identity(
            &follows_for_all(variant),
            &["f", "M", "k"],
            "settled deviations and gaps of system (2), all M and k",
        )
        .on([1, 2])
        .checks("steps 1 and 2"),
    ];
    for followers in 1..=CARS {
        let part = |system: u32| format!("{followers} followers of system ({system}) accelerate as the leader does");
        let two = follows(variant, Communication::FrontAndBack, followers);
        results.push(run.identity(&two, &["f", "g"], &part(2)).on([1]).checks("step 1"));
        let one = follows(variant, Communication::Front, followers);
        results.push(run.identity(&one, &["f", "g"], &part(1)).on([3]).checks("step 3"));
    }
    let gaps = "the oscillation of the first gaps of system (1)";
    results.push(run.identity(&oscillating_gaps(variant), &["f", "g", "w"], gaps).on([4]).checks("step 4"));
    let sign = "the sign of |1/gamma| - 1 is that of w² (2|f| - w²)";
    results.push(run.identity(&gain_factors(variant.bound), &["f", "g", "w"], sign).on([4]).checks("step 5"));
    let gains = unit().map(|gain| Interval::from_rational(gain, 80));
    let square = strongest_one_sided_square(&gains)?;
    run.value("growth_per_car_f_g_-1", interval_value(&gain_squared_one_sided(&gains, &square)?.sqrt()?, 12));
    results.push(argued(&[1, 2, 3, 4], "all gains and sizes", PLACE));
    Run::all(results)
}
