//! beyond.veerman.growth: which growth of the response occurs for communication graphs on a line.

use crate::veerman::graphs::{GrowthVariant, examine_growth};
use ledger::Record;

pub fn growth() -> Record<GrowthVariant> {
    Record::new(
        "beyond.veerman.growth",
        "Put two two-sided platoons of m cars behind each other: car m ignores the car behind it and so leads the second platoon. Every \
         car tracks only its nearest cars, with a directed path from the leader to every agent. The last car responds with a_m², a_m = 1/T_m(gamma), so \
         the peak is A_m² = (M/2)²/X² + O(1): quadratic in M = 2m. With p platoons it is (M/p)^p/X^p, and with sqrt M platoons of sqrt M cars neither polynomial \
         nor exponential. If everyone tracks the leader all amplitudes are 1/gamma and the peak does not grow at all. For a p \
         between k - 1 and k the last cars form k platoons of about M^(p/k) cars, and all others track the leader: they lead nobody, and the peak is M^p/X^k.",
        GrowthVariant::TRUE,
        examine_growth,
    )
    .stated("bears on veerman, Section 6, last part", "")
    .clauses(&[
        "For f, g < 0 the peak response of the last of M followers of system (1), the largest amplitude over all frequencies of its \
         equilibrium oscillation for a leader of amplitude 1, grows exponentially with M.",
        "Let every follower obey z'' = f (z - m) + g (z' - m'), z its deviation from its place and m the mean deviation of the agents that \
         it tracks. For f, g < 0 and every real p >= 0 there are for M = 1, 2, ... communication graphs of M followers on a line, with a \
         directed path from the leader to every agent, for which the peak response of the last one, to a leader of amplitude 1, lies \
         between two positive multiples of M^p.",
    ])
    .altered("p platoons grow like M^(p+1)", |v| v.shift = 1)
    .altered("system (1) grows like the square of that", |v| v.power = 2)
    .altered("one platoon more than there are", |v| v.more = 1)
}
