//! The pairwise argument: a number that is a positive multiple of a sum over pairs, each term of one sign, has that sign, however many agents there are.

use super::How;
use super::identity::sum_over_pairs;
use super::inequality::{Found, on_states};
use super::instance::{Instance, Links};
use arithmetic::{Cancelled, Progress};
use expressions::Comparison;
use polynomials::sums::Certificate;

/// How something was proved, with the certificates.
pub(super) type Proved = (Vec<How>, Vec<Certificate>);

/// Whether a number has a sign at every state because it is a sum over pairs of terms that have.
pub(super) fn holds(
    instance: &Instance,
    comparison: &Comparison,
    progress: &dyn Progress,
) -> Result<Option<Proved>, Cancelled> {
    let pairs: Vec<((usize, usize), Links)> =
        instance.links.pairs().into_iter().map(|pair| (pair, instance.links.only(pair))).collect();
    if instance.of_agent.len() < 3 || pairs.is_empty() {
        return Ok(None);
    }
    let Some((_, bits)) = sum_over_pairs(instance, comparison, &pairs) else { return Ok(None) };
    // Where no agent is named, what holds of one pair holds of all that hear each other alike and range over the same.
    let alike = comparison.is_symmetric() && instance.is_uniform();
    let mutual = |links: &Links| links.is_mutual();
    let (mut how, mut certificates) = (vec![How::Identity(bits), How::Pairs], Vec::new());
    let mut looked: Vec<bool> = Vec::new();
    for ((i, j), links) in &pairs {
        if alike && looked.contains(&mutual(links)) {
            continue;
        }
        let places = [&instance.of_agent[*i][..], &instance.of_agent[*j][..]].concat();
        let alone = std::slice::from_ref(comparison);
        let Found::Holds(ways, own) = on_states(instance, alone, links, &places, progress)? else { return Ok(None) };
        how.extend(ways);
        certificates.extend(own);
        looked.push(mutual(links));
    }
    Ok(Some((how, certificates)))
}
