//! beyond.veerman.one_sided_peak: where the gain of the one-sided platoon is largest, for all gains.

use crate::veerman::one_sided::{StrongestVariant, examine_strongest};
use ledger::Record;

pub fn one_sided_peak() -> Record<StrongestVariant> {
    Record::new(
        "beyond.veerman.one_sided_peak",
        "Write v for the claimed w². Then max - value(y) = max (y - v)²/((y - |f|)² + g² y): non-negative, and zero only at \
         y = v. |f| = v + 2u² and |g| = 2|f|u/v with u > 0 runs through all f, g < 0, which makes it an identity of rational \
         functions and shows v < |f|.",
        StrongestVariant::TRUE_LOCATION,
        examine_strongest,
    )
    .stated(
        "corrects veerman, proof of Corollary 1",
        "For all f, g < 0 the gain |gamma^{-1}| of system (1) is largest over w > 0 at exactly one w, where \
         w^2 = (f^2/g^2) (sqrt(1 + 2 g^2/|f|) - 1) < |f|.",
    )
    .clauses(&[
        "For all f, g < 0 the gain |gamma^{-1}| of system (1) is largest over w > 0 where w^2 = (f^2/g^2) (sqrt(1 + 2 g^2/|f|) - 1).",
        "It is less at every other w > 0.",
        "This w^2 is less than |f|.",
    ])
    .control("w² = |f|", StrongestVariant::PRINTED)
    .control("twice the root", StrongestVariant { of_f: (0, 1), of_location: (2, 1) })
}
