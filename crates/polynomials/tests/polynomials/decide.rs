use arithmetic::{ArithmeticError, Number, Rational, Unwatched, rational};
use polynomials::decide::{Decision, Effort, decide};
use polynomials::{Compared, Function, Literal, Side};

/// A function of the list below.
#[derive(Clone, Copy)]
enum Known {
    SineBelow,
    Cosine,
    Exponential,
    Logarithm,
    Quartic,
    Valley(i64),
    Sum,
}

impl Function for Known {
    fn value<T: Number>(&self, at: &[T]) -> Result<T, ArithmeticError> {
        let x = &at[0];
        Ok(match self {
            Known::SineBelow => x.clone() - x.sin()?,
            Known::Cosine => x.cos()? - x.one() + x.square() * x.ratio(1, 2),
            Known::Exponential => x.exp()? - x.one() - x,
            Known::Logarithm => x.clone() - x.one() - x.ln()?,
            Known::Quartic => (x.square() - x.ratio(1, 4)).square(),
            // Convex around (1/3, 2/3), where it is the constant.
            Known::Valley(parts) => {
                let y = &at[1];
                let a = x.clone() - x.ratio(1, 3);
                let b = y.clone() - y.ratio(2, 3);
                a.exp()? - x.one() - &a + b.square() * (x.integer(2) + a.sin()?) + x.ratio(*parts, 1_000_000)
            }
            Known::Sum => at[0].clone() - x.ratio(1, 2),
        })
    }
}

fn asked(function: Known, compared: Compared, lo: (i64, i64), hi: (i64, i64)) -> Decision {
    let side = Side::between(rational(lo.0, lo.1), rational(hi.0, hi.1));
    let arity = match function {
        Known::Valley(_) => 2,
        Known::Sum => 40,
        _ => 1,
    };
    let domain = vec![side; arity];
    decide(&[Literal { function, compared, guarded: false }], &domain, Effort::default(), &Unwatched).unwrap()
}

fn holds(decision: Decision) -> Vec<Vec<Rational>> {
    match decision {
        Decision::Holds(proof) => proof.zeros,
        other => panic!("{other:?}"),
    }
}

#[test]
fn inequalities_are_decided_where_they_are_attained() {
    use Compared::{NotNegative, Positive};
    let zero = vec![vec![rational(0, 1)]];
    assert_eq!(holds(asked(Known::SineBelow, NotNegative, (0, 1), (1, 1))), zero);
    assert_eq!(holds(asked(Known::Cosine, NotNegative, (-3, 1), (3, 1))), zero);
    assert_eq!(holds(asked(Known::Exponential, NotNegative, (-2, 1), (2, 1))), zero);
    assert_eq!(holds(asked(Known::Logarithm, NotNegative, (1, 10), (10, 1))), vec![vec![rational(1, 1)]]);
    assert_eq!(holds(asked(Known::Quartic, NotNegative, (-7, 1), (5, 1))).len(), 2);
    let bottom = vec![vec![rational(1, 3), rational(2, 3)]];
    assert_eq!(holds(asked(Known::Valley(0), NotNegative, (-1, 1), (2, 1))), bottom);
    assert!(holds(asked(Known::Valley(1), Positive, (-1, 1), (2, 1))).is_empty());
    for (function, compared) in [
        (Known::Valley(0), Positive),
        (Known::Valley(-1), NotNegative),
        (Known::SineBelow, Positive),
        (Known::Exponential, Positive),
        (Known::Sum, NotNegative),
    ] {
        let decision = asked(function, compared, (0, 1), (1, 1));
        assert!(matches!(decision, Decision::Fails(_)), "{decision:?}");
    }
}
