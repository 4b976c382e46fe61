//! beyond.chazelle.angle and beyond.chazelle.losses: Lemmas 3.7 and 3.8 with better bounds.

use crate::chazelle::geometry::{
    LossVariant, OriginVariant, examine_losses, examine_origins, loss_exponent, origin_controls,
};
use ledger::{CheckError, Claim, Control, Outcome, Run, Source};

/// beyond.chazelle.angle.
pub struct Angle;

impl Claim for Angle {
    type Variant = OriginVariant;

    fn id(&self) -> &str {
        "beyond.chazelle.angle"
    }

    fn source(&self) -> Option<Source> {
        Some(Source {
            place: "sharpens chazelle, Lemma 3.7".to_string(),
            statement: "In model D, as long as no edge is longer than 2 (Lemma 3.6), for any bird at any time t >= 1, angle(x_i(t), v_i(t)) <= |v_i(t) - x_i(t)/t| = |E_i(t)|/t, where each coordinate \
                        of E_i(t) is at most max|x(0)| + 4 (s(t) + 1) n^(2a+3), s(t) the number of switches before t, entries of P at least n^-a: \
                        no waiting time and no log t."
                .to_string(),
        })
    }

    fn derivation(&self) -> &str {
        "See chazelle.lem3.7: E_i(t) = x_i(t) - t v_i(t) starts at x(0) and obeys E(t+1) = P(t) E(t) + (I - P(t)) x(t); on a fixed network the last \
         term has stationary mean zero and is mixed away, so it adds at most 4 sum_r tau_1(P^r) in all."
    }

    fn printed(&self) -> OriginVariant {
        OriginVariant::SHARPER
    }

    fn controls(&self) -> Vec<Control<OriginVariant>> {
        origin_controls(self.printed())
    }

    fn examine(&self, variant: &OriginVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_origins(variant, run)
    }
}

/// beyond.chazelle.losses.
pub struct Losses;

impl Claim for Losses {
    type Variant = LossVariant;

    fn id(&self) -> &str {
        "beyond.chazelle.losses"
    }

    fn source(&self) -> Option<Source> {
        Some(Source {
            place: "sharpens chazelle, Lemma 3.8".to_string(),
            statement: "In model D with the hysteresis of the paper, entries of P at least n^-a with a <= 2, speeds and coordinates up to n, and n >= 4 birds, no edge is lost \
                        after time n^(n^4 + 2(n-1)² + 10(n-1) + 17)."
                .to_string(),
        })
    }

    fn derivation(&self) -> &str {
        "See chazelle.lem3.8: an edge of G_{t-1} stays once (2 + 2|E|)/(t-1) < n^(-n^4), and |E| <= n^O(n²) by the sharper bound of the number of \
         switches."
    }

    fn printed(&self) -> LossVariant {
        LossVariant { time: |n| n.pow(4) + 2 * (n - 1).pow(2) + 10 * (n - 1) + 17, from: 4, hysteresis: true }
    }

    fn controls(&self) -> Vec<Control<LossVariant>> {
        let printed = self.printed();
        vec![
            Control::new("after n^n", LossVariant { time: |n| n, ..printed }),
            Control::new("without hysteresis", LossVariant { hysteresis: false, ..printed }),
            Control::new(
                "one less in the exponent than the argument gives",
                LossVariant { time: |n| n.pow(4) + loss_exponent(n, 2, 1) - 1, ..printed },
            ),
        ]
    }

    fn examine(&self, variant: &LossVariant, run: &mut Run) -> Result<Outcome, CheckError> {
        examine_losses(variant, run)
    }
}
