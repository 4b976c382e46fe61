//! beyond.veerman.one_sided_peak: where the gain of the one-sided platoon is largest, for all gains.

use crate::veerman::one_sided::{StrongestVariant, examine_strongest};
use ledger::{CheckError, Claim, Control, Outcome, Run, Source};

/// beyond.veerman.one_sided_peak.
pub struct OneSidedPeak;

impl Claim for OneSidedPeak {
    type Variant = StrongestVariant;

    fn id(&self) -> &str {
        "beyond.veerman.one_sided_peak"
    }

    fn source(&self) -> Option<Source> {
        Some(Source {
            place: "corrects veerman, proof of Corollary 1".to_string(),
            statement:
                "For all f, g < 0 the gain |gamma^{-1}| of system (1) is largest over w > 0 at exactly one w, where \
                        w^2 = (f^2/g^2) (sqrt(1 + 2 g^2/|f|) - 1) < |f|."
                    .to_string(),
        })
    }

    fn derivation(&self) -> &str {
        "Write v for the claimed w². Then max - value(y) = max (y - v)²/((y - |f|)² + g² y): non-negative, and zero only at \
         y = v. |f| = v + 2u² and |g| = 2|f|u/v with u > 0 runs through all f, g < 0, which makes it an identity of rational \
         functions and shows v < |f|."
    }

    fn printed(&self) -> StrongestVariant {
        StrongestVariant::TRUE_LOCATION
    }

    fn controls(&self) -> Vec<Control<StrongestVariant>> {
        vec![
            Control::new("w² = |f|", StrongestVariant { of_f: (1, 1), of_location: (0, 1) }),
            Control::new("twice the root", StrongestVariant { of_f: (0, 1), of_location: (2, 1) }),
        ]
    }

    fn examine(&self, variant: &StrongestVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_strongest(variant, run)
    }
}
