//! One number: signs between the exact roots of polynomials.

use super::places::Place;
use crate::function::Side;
use crate::multivariate::Multivariate;
use crate::univariate::{Polynomial, RealRoot};
use arithmetic::{Cancelled, Progress, Rational, rational};
use num_traits::Signed;

/// A polynomial in one variable that stands in the place `variable`, as integers.
fn integers(p: &Multivariate<Rational>, variable: usize) -> Option<(Polynomial, Vec<Rational>)> {
    let parts = p.in_variable(variable);
    let coefficients = parts.iter().map(Multivariate::as_constant).collect::<Option<Vec<Rational>>>()?;
    Some((Polynomial::from_rationals(&coefficients), coefficients))
}

fn value(coefficients: &[Rational], x: &Rational) -> Rational {
    coefficients.iter().rev().fold(rational(0, 1), |sum, c| sum * x + c)
}

/// A root of a polynomial in the only variable that stands for many numbers, within its range: a number, or one that is enclosed.
pub(super) fn one_in(p: &Multivariate<Rational>, variable: usize, side: &Side) -> Option<Place> {
    const BITS: u32 = 60;
    let (own, _) = integers(p, variable).filter(|(own, _)| !own.is_zero())?;
    let reach = bound(&own);
    let lo = side.lo.clone().unwrap_or_else(|| -reach.clone());
    let hi = side.hi.clone().unwrap_or(reach);
    let place = |factor: &Polynomial, root: &mut RealRoot| {
        factor.refine(root, BITS);
        match root.exact() {
            Some(q) => side.contains(q).then(|| Place::of(q.clone())),
            None => {
                let inside = side.contains(root.lo()) && side.contains(root.hi());
                inside.then(|| Place::between(root.lo().clone(), root.hi().clone()))
            }
        }
    };
    own.square_free_factors().into_iter().filter(|(factor, _)| factor.degree() > 0).find_map(|(factor, _)| {
        factor.roots_in(&(&lo - rational(1, 1)), &hi).iter_mut().find_map(|root| place(&factor, root))
    })
}

/// Beyond it nothing changes: Cauchy's bound.
fn bound(p: &Polynomial) -> Rational {
    let sizes = p.coefficients().iter().map(Signed::abs);
    let lead = p.coefficients().last().map_or_else(|| 1.into(), Signed::abs);
    sizes.map(|c| Rational::new(c, lead.clone())).fold(rational(2, 1), |most, c| most.max(c + rational(2, 1)))
}

/// Whether `target >= 0` (or `> 0`) wherever all constraints are at least 0; `None` where a polynomial has other variables, or where only roots
/// tell.
pub(super) fn holds(
    target: &Multivariate<Rational>,
    strict: bool,
    constraints: &[Multivariate<Rational>],
    (variable, side): (usize, &Side),
    progress: &dyn Progress,
) -> Result<Option<bool>, Cancelled> {
    let Some((own, coefficients)) = integers(target, variable) else { return Ok(None) };
    let Some(others) = constraints.iter().map(|p| integers(p, variable)).collect::<Option<Vec<_>>>() else {
        return Ok(None);
    };
    if own.is_zero() {
        return Ok(Some(!strict));
    }
    let reach = others
        .iter()
        .map(|(p, _)| p)
        .chain([&own])
        .filter(|p| !p.is_zero())
        .map(bound)
        .fold(rational(2, 1), Rational::max);
    let lo = side.lo.clone().unwrap_or_else(|| {
        -(reach.clone().max(side.hi.clone().map_or(rational(0, 1), |hi| hi.abs() + rational(1, 1))))
    });
    let hi = side.hi.clone().unwrap_or_else(|| reach.max(lo.abs() + rational(1, 1)));
    let mut product = vec![own.clone()];
    product.extend(others.iter().map(|(p, _)| p.clone()).filter(|p| !p.is_zero()));
    let mut roots = Vec::new();
    // Without common roots, so that roots in order are apart.
    let mut known: Vec<Polynomial> = Vec::new();
    for p in product {
        for (mut factor, _) in p.square_free_factors() {
            for before in &known {
                let common = factor.gcd(before);
                if common.degree() > 0 {
                    factor = factor.divided_by(&common);
                }
            }
            if factor.degree() > 0 {
                known.push(factor);
            }
        }
    }
    for factor in &known {
        for mut root in factor.roots_in_watched(&(&lo - rational(1, 1)), &hi, progress)? {
            factor.refine(&mut root, 8);
            roots.push((factor, root));
        }
    }
    // Intervals of different roots are made narrow until they are apart.
    let mut bits = 8;
    loop {
        roots.sort_by(|a, b| a.1.lo().cmp(b.1.lo()).then_with(|| a.1.hi().cmp(b.1.hi())));
        let apart = roots.windows(2).all(|pair| pair[0].1.hi() < pair[1].1.lo());
        if apart {
            break;
        }
        progress.checkpoint()?;
        bits *= 2;
        const MOST_BITS: u32 = 1 << 14;
        if bits > MOST_BITS {
            return Ok(None);
        }
        for (factor, root) in &mut roots {
            factor.refine(root, bits);
        }
    }
    let admitted = |x: &Rational| others.iter().all(|(_, c)| !value(c, x).is_negative());
    let good = |x: &Rational| {
        let sign = value(&coefficients, x);
        if strict { sign.is_positive() } else { !sign.is_negative() }
    };
    let mut points = vec![lo.clone(), hi.clone()];
    let mut from = lo.clone();
    for (_, root) in &roots {
        points.extend(root.exact().cloned());
        points.push((&from + root.lo()) * rational(1, 2));
        from = root.hi().clone();
    }
    points.push((from + &hi) * rational(1, 2));
    let inside = points.iter().filter(|x| **x >= lo && **x <= hi);
    if inside.clone().any(|x| admitted(x) && !good(x)) {
        return Ok(Some(false));
    }
    // Irrational roots: at one of the target a strict sign fails, unless a constraint forbids it; where only the root itself is admitted, nothing is
    // said here.
    for (place, (_, root)) in roots.iter().enumerate().filter(|(_, (_, root))| root.exact().is_none()) {
        let before = if place == 0 { lo.clone() } else { roots[place - 1].1.hi().clone() };
        let after = roots.get(place + 1).map_or_else(|| hi.clone(), |(_, next)| next.lo().clone());
        if *root.hi() < lo || *root.lo() > hi {
            continue;
        }
        let sides = [(&before + root.lo()) * rational(1, 2), (root.hi() + &after) * rational(1, 2)];
        let near_good = sides.iter().any(good);
        if strict || !near_good {
            // Constraints that are negative on both sides and do not vanish there keep the root out.
            let vanishes = |c: &(Polynomial, Vec<Rational>)| c.0.sign_at(root.lo()) != c.0.sign_at(root.hi());
            let kept_out = others.iter().any(|c| {
                !vanishes(c)
                    && c.0.gcd(roots[place].0).degree() == 0
                    && sides.iter().all(|x| value(&c.1, x).is_negative())
            });
            let own_root = own.gcd(roots[place].0).degree() > 0;
            if !kept_out && (own_root || !near_good) {
                return Ok(None);
            }
        }
    }
    Ok(Some(true))
}
