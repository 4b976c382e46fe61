//! What the producer of certificates writes, the separate checker accepts, and it composes the same claim.

use super::{Checked, Invariant, OrFails, Stop, Tested, require};
use crate::draws::Draws;
use crate::strategies::{connected_graph, platoon_gains, start, stochastic_sequence, symmetric};
use arithmetic::rational;
use models::averaging::{Hysteresis, Start, Weights};
use proofs::certificates::{Certificate, CertificateError, Inertia, Limit, Peak, Product, Switches};

pub(super) const TABLE: &[Invariant] = &[
    Invariant {
        id: "certificate.product",
        statement: "The checker accepts certificates of tau_1 of products.",
        control: "the last digit of the claim and of the last line is another one",
        block: 50,
        check: product,
    },
    Invariant {
        id: "certificate.limit",
        statement: "The checker accepts certificates of the limit of the powers of a transition matrix.",
        control: "the last digit of the claim and of the last line is another one",
        block: 20,
        check: limit,
    },
    Invariant {
        id: "certificate.switches",
        statement: "The checker accepts certificates of the switches of a flock.",
        control: "the last digit of the claim and of the last line is another one",
        block: 20,
        check: switches,
    },
    Invariant {
        id: "certificate.inertia",
        statement: "The checker accepts certificates of the inertia of a symmetric matrix.",
        control: "the last digit of the claim and of the last line is another one",
        block: 50,
        check: inertia,
    },
    Invariant {
        id: "certificate.peak",
        statement: "The checker accepts certificates of the main resonance of a two-sided platoon.",
        control: "the last digit of the claim and of the last line is another one",
        block: 1,
        check: peak,
    },
];

/// The text with another last digit in the claim and in the last line of numbers.
fn altered(text: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
    let last = lines.len().saturating_sub(2);
    for k in [1, last] {
        if let Some(line) = lines.get_mut(k)
            && let Some((at, digit)) = line.char_indices().rfind(|(_, c)| c.is_ascii_digit())
        {
            let other = if digit == '9' { "8" } else { "9" };
            line.replace_range(at..=at, other);
        }
    }
    lines.join("\n") + "\n"
}

fn accepted(made: Result<Certificate, CertificateError>, tested: Tested) -> Checked {
    let certificate = made.or_fails("no certificate is made")?;
    let mut text = certificate.text();
    if tested.is_altered() {
        text = altered(&text);
    }
    let described = || text.clone();
    let checked = flockproof_checker::check(text.as_bytes()).map_err(|refusal| Stop::Fails {
        why: format!("refused in line {}: {}", refusal.line, refusal.reason),
        instance: described(),
    })?;
    let same = checked.claim == certificate.claim() && checked.kind == certificate.kind();
    require(same, format!("what is checked is: {}", checked.claim), described)?;
    Ok(None)
}

fn product(draws: &mut Draws, tested: Tested) -> Checked {
    let (order, length) = (draws.between(1, 4), draws.between(1, 5));
    let factors = stochastic_sequence(draws, order, length, 12).or_fails("a stochastic matrix is refused")?;
    accepted(Product::new(&factors).map(Certificate::Product), tested)
}

fn limit(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 5);
    let network = connected_graph(draws, order);
    let weights = match draws.below(3) {
        0 => Weights::Lazy,
        1 => Weights::Vicsek,
        _ => Weights::Given((0..order).map(|_| rational(1 + draws.below(3) as i64, 4 * order as i64)).collect()),
    };
    accepted(Limit::new(&network, &weights).map(Certificate::Limit), tested)
}

fn switches(draws: &mut Draws, tested: Tested) -> Checked {
    let start = start(draws);
    // The threshold of the paper is too long to be written out for more than a few birds.
    let hysteresis = if start.positions.len() > 4 && start.hysteresis == Hysteresis::Paper {
        Hysteresis::None
    } else {
        start.hysteresis.clone()
    };
    let until = draws.between(0, 30) as u64;
    accepted(Switches::new(&Start { hysteresis, ..start }, until).map(Certificate::Switches), tested)
}

fn inertia(draws: &mut Draws, tested: Tested) -> Checked {
    let order = draws.between(1, 5);
    let matrix = symmetric(draws, order).or_fails("a matrix is refused")?;
    match Inertia::new(&matrix) {
        // A documented limit: some remainder has a zero diagonal.
        Err(CertificateError::NoPivot) => Err(Stop::Undecided(CertificateError::NoPivot.to_string())),
        made => accepted(made.map(Certificate::Inertia), tested),
    }
}

fn peak(draws: &mut Draws, tested: Tested) -> Checked {
    let followers = draws.between(1, 8) as u64;
    let gains = platoon_gains(draws);
    match Peak::new(&gains, followers) {
        Err(CertificateError::Resonance(error)) => Err(Stop::Undecided(error.to_string())),
        made => accepted(made.map(Certificate::Peak), tested),
    }
}
