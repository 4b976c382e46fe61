//! The same clause in other numbers: what its functions have in common as one number, exponentials in the place of logarithms, powers in the place of numbers under roots.

use super::goals::held_at_points;
use super::image::Image;
use super::local::{Signs, enclosed_on};
use super::places::{Place, free, has_value, truth};
use super::{Decision, Effort, Extended, FIRST_BOXES, Proof, on_rest};
use crate::function::{Compared, Function, Literal, Side};
use crate::symbolic::{Extension, Part, Settled, Symbolic};
use arithmetic::{Cancelled, Field, Number, Progress, Rational, Ring, rational};
use num_traits::Zero;

/// More common parts are not looked at.
const MOST_PARTS: usize = 6;

/// A rewritten question takes this share of the boxes: so many that it is rewritten once more at most on a side of the domain.
const SHARE: u64 = 16;

/// Boxes for the sign of a part.
const FEW: u64 = 100;

/// Largest power in the place of a number under roots.
const MOST_POWER: u64 = 24;

/// A clause that implies the given one, and its domain.
struct Rewritten {
    clause: Vec<Literal<Settled>>,
    domain: Vec<Side>,
    /// What has a number of its own there.
    common: Option<Common>,
}

/// A function of some of the numbers of a domain, in the place of these.
struct Common {
    function: Settled,
    arguments: Vec<usize>,
    /// Its place in the other domain.
    slot: usize,
    /// How many places of the other domain come before those of the given one.
    before: usize,
    /// Which literals depend on it and the other numbers only.
    kept: Vec<bool>,
}

impl Common {
    /// A point of the given domain at which all literals are false, from one of the other domain at which those are that are left there.
    fn fails<F: Function>(&self, clause: &[Literal<F>], domain: &[Side], at: &[Place]) -> Option<Vec<Place>> {
        let image = Image {
            function: &self.function,
            value: &at[self.slot],
            arguments: &self.arguments,
            point: at[self.before..].to_vec(),
        };
        image.point(domain, |places| {
            let is_in = places.iter().zip(domain).all(|(place, side)| place.is_in(side) || place.is_enclosed());
            let is_false = |(literal, kept): (&Literal<F>, &bool)| match kept {
                true => has_value(&literal.function, places),
                false => truth(std::slice::from_ref(literal), places) == Signs::Fails,
            };
            is_in && clause.iter().zip(&self.kept).all(is_false)
        })
    }
}

/// Decides the clause in other numbers; `None` where there are none, or where it stays open there.
pub(super) fn decided<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Option<Decision>, Cancelled> {
    let boxes = effort.boxes / SHARE;
    let is_asked = !free(domain).is_empty() && free(domain).iter().all(|&k| !domain[k].integer);
    // Whoever asks decides separately where there is a value: simplified functions may have one where the given ones have none.
    if boxes < FIRST_BOXES || !is_asked || !clause.iter().all(|literal| literal.guarded) {
        return Ok(None);
    }
    let given = Effort { boxes, ..effort };
    // Literals may be left out, and with them what says where the others have a value.
    let effort = Effort { conditions: false, ..given };
    let one_at_a_time = |rewritten: Vec<Rewritten>| -> Result<Option<Decision>, Cancelled> {
        for own in rewritten {
            let places = match on_rest(&own.clause, &own.domain, effort, progress)? {
                Decision::Holds(proof) => return Ok(Some(Decision::Holds(proof.without_points()))),
                Decision::Fails(point) => point.into_iter().map(Place::of).collect(),
                Decision::FailsAt(places) => places,
                Decision::Undecided(_) => continue,
            };
            if let Some(places) = own.common.and_then(|common| common.fails(clause, domain, &places)) {
                return Ok(Some(Decision::FailsAt(places)));
            }
        }
        Ok(None)
    };
    if let Some(decision) = by_summands(clause, domain, effort, progress)? {
        return Ok(Some(decision));
    }
    if let Some(decision) = one_at_a_time(without_logarithms(clause, domain).into_iter().collect())? {
        return Ok(Some(decision));
    }
    let few = Effort { boxes: FEW, ..effort };
    let is_signed = |own: Rewritten| matches!(on_rest(&own.clause, &own.domain, few, progress), Ok(Decision::Holds(_)));
    if let Some(decision) = one_at_a_time(by_parts(clause, domain, &is_signed))? {
        return Ok(Some(decision));
    }
    if let Some(decision) = one_at_a_time(without_roots(clause, domain).into_iter().collect())? {
        return Ok(Some(decision));
    }
    by_exponential(clause, domain, given, progress)
}

/// The functions of a clause at these arguments, numbers where the domain has one only.
fn functions<F: Function>(clause: &[Literal<F>], arguments: &[Symbolic], domain: &[Side]) -> Vec<Option<Symbolic>> {
    let arguments = held_at_points(arguments, domain);
    clause.iter().map(|literal| literal.function.value(&arguments).ok()).collect()
}

fn literal<F>(own: &Literal<F>, function: Settled) -> Literal<Settled> {
    Literal { function, compared: own.compared, guarded: true }
}

/// The literals of which something is known at these arguments.
fn at<F: Function>(clause: &[Literal<F>], arguments: &[Symbolic], domain: &[Side]) -> Vec<Literal<Settled>> {
    let values = functions(clause, arguments, domain);
    clause.iter().zip(values).filter_map(|(own, value)| Some(literal(own, value?.known()?))).collect()
}

/// `exp(f) >= 1` in the place of `f >= 0`, where `f` is a sum with multiples of logarithms.
fn without_logarithms<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> Option<Rewritten> {
    let extension = Extension::new(domain.len());
    let values = functions(clause, &extension.arguments(), domain);
    let mut is_new = false;
    let mut without = |(own, value): (&Literal<F>, Option<Symbolic>)| {
        let value = value?;
        let product = value.exponentiated();
        is_new |= product.is_some();
        let function = product.map_or_else(|| value.clone(), |product| product - value.one());
        Some(literal(own, function.known()?))
    };
    let clause: Vec<_> = clause.iter().zip(values).filter_map(&mut without).collect();
    is_new.then(|| Rewritten { clause, domain: domain.to_vec(), common: None })
}

/// The clause as one of a number that its functions have in common, and of fewer others.
fn by_parts<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    is_signed: &dyn Fn(Rewritten) -> bool,
) -> Vec<Rewritten> {
    let extension = Extension::listening(domain.len());
    let values = functions(clause, &extension.arguments(), domain);
    let mut found: Vec<Symbolic> = Vec::new();
    let exponents = values.iter().flatten().flat_map(Symbolic::exponents);
    for own in extension.heard().into_iter().chain(exponents).filter_map(|own| own.without_constant()) {
        if !own.depends_on().is_empty() && !found.iter().any(|other| own.is_multiple_of(other)) {
            found.push(own);
        }
    }
    let of_polynomials =
        found.iter().filter_map(|part| of_polynomial(clause, domain, &part.known()?, &part.depends_on(), is_signed));
    let functions = extension.functions();
    let of_functions = functions.iter().filter_map(|part| of_function(clause, &values, domain, part));
    of_polynomials.chain(of_functions).take(MOST_PARTS).collect()
}

/// What a function is on a domain.
pub(super) fn range<F: Function>(function: &F, domain: &[Side]) -> Option<Side> {
    let value = enclosed_on(function, domain)?;
    Some(Side { lo: Rational::from_float(value.lo), hi: Rational::from_float(value.hi), integer: false })
}

/// With these numbers held, since nothing depends on them any more.
fn held(domain: &[Side], arguments: &[usize]) -> Vec<Side> {
    let own = |(k, side): (usize, &Side)| match arguments.contains(&k) {
        true => Side::point(side.middle()),
        false => side.clone(),
    };
    domain.iter().enumerate().map(own).collect()
}

/// With a function, a polynomial in numbers and other functions, as the first of the numbers: its leading monomial is replaced.
fn of_polynomial<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    part: &Settled,
    gone: &[usize],
    is_signed: &dyn Fn(Rewritten) -> bool,
) -> Option<Rewritten> {
    let extension = Extension::new(domain.len() + 1);
    let arguments = extension.arguments();
    (part.value(&arguments[1..]).ok()? - &arguments[0]).is_zero_from_now();
    let values = functions(clause, &arguments[1..], domain);
    let own = |(own, value): (&Literal<F>, Option<Symbolic>)| {
        let value = value?;
        let direct = value.depends_on();
        let function = value.known().filter(|_| !gone.iter().any(|k| direct.contains(&(k + 1))))?;
        Some(literal(own, function))
    };
    let rewritten: Vec<Option<_>> = clause.iter().zip(values).map(own).collect();
    let kept: Vec<bool> = rewritten.iter().map(Option::is_some).collect();
    let mut whole = range(part, domain)?;
    // Enclosures lose signs that sums of squares know.
    let zero = rational(0, 1);
    let keeps = |negative: bool| {
        let like = Extension::new(domain.len());
        let value = part.value(&like.arguments()).ok();
        let function = value.and_then(|value| if negative { (-value).known() } else { value.known() });
        let of = |function| Literal { function, compared: Compared::NotNegative, guarded: true };
        function.is_some_and(|function| {
            is_signed(Rewritten { clause: vec![of(function)], domain: domain.to_vec(), common: None })
        })
    };
    if whole.lo.as_ref().is_none_or(|lo| *lo < zero) && keeps(false) {
        whole.lo = Some(zero.clone());
    }
    if whole.hi.as_ref().is_none_or(|hi| *hi > zero) && keeps(true) {
        whole.hi = Some(zero);
    }
    let mut sides = vec![whole];
    sides.extend(held(domain, gone));
    let clause: Vec<_> = rewritten.into_iter().flatten().collect();
    let common = Some(Common { function: part.clone(), arguments: gone.to_vec(), slot: 0, before: 1, kept });
    (!clause.is_empty()).then_some(Rewritten { clause, domain: sides, common })
}

/// With the value of a function in the place of one of its arguments.
fn of_function<F: Function>(
    clause: &[Literal<F>],
    values: &[Option<Symbolic>],
    domain: &[Side],
    part: &Part,
) -> Option<Rewritten> {
    let own = |(own, value): (&Literal<F>, &Option<Symbolic>)| {
        value.as_ref()?.as_function_of(part).map(|function| literal(own, function))
    };
    let rewritten: Vec<Option<_>> = clause.iter().zip(values).map(own).collect();
    let kept: Vec<bool> = rewritten.iter().map(Option::is_some).collect();
    let mut rewritten: Vec<_> = rewritten.into_iter().flatten().collect();
    if rewritten.is_empty() {
        return None;
    }
    let slot = part.arguments[0];
    let mut sides = held(domain, &part.arguments);
    sides[slot] = range(&part.function, domain)?;
    if part.is_positive {
        let extension = Extension::new(domain.len());
        let function = (-extension.arguments().swap_remove(slot)).settled();
        rewritten.push(Literal { function, compared: Compared::NotNegative, guarded: true });
    }
    let (function, arguments) = (part.function.clone(), part.arguments.clone());
    let common = Some(Common { function, arguments, slot, before: 0, kept });
    Some(Rewritten { clause: rewritten, domain: sides, common })
}

/// `x = a^n` for numbers that are not negative and stand in products under roots of degrees that divide `n`.
fn without_roots<F: Function>(clause: &[Literal<F>], domain: &[Side]) -> Option<Rewritten> {
    let arity = domain.len();
    let extension = Extension::new(arity);
    functions(clause, &extension.arguments(), domain);
    let is_not_negative = |k: &usize| domain[*k].lo.as_ref().is_some_and(|lo| *lo >= rational(0, 1));
    let mut powers: Vec<u64> = vec![1; arity];
    for (k, degree) in extension.degrees_of_roots() {
        powers[k] = num_integer::lcm(powers[k], degree);
    }
    let changed: Vec<usize> = (0..arity).filter(|&k| powers[k] > 1).collect();
    if changed.is_empty() || !changed.iter().all(is_not_negative) || changed.iter().any(|&k| powers[k] > MOST_POWER) {
        return None;
    }
    let extension = Extension::new(arity);
    extension.are_not_negative((0..arity).filter(is_not_negative).collect());
    let arguments: Vec<Symbolic> =
        extension.arguments().iter().zip(&powers).map(|(x, power)| x.power(*power)).collect();
    let mut rewritten = at(clause, &arguments, domain);
    let mut sides = domain.to_vec();
    for k in changed {
        let (lo, hi) = (domain[k].lo.clone()?, domain[k].hi.clone());
        let outside = [(Some(lo.clone()), -1), (hi.clone(), 1)];
        for (end, sign) in outside {
            let Some(end) = end.filter(|end| !end.is_zero() && end.root(powers[k]).is_err()) else { continue };
            let beyond = (arguments[k].clone() - arguments[k].rational(&end)) * arguments[k].integer(sign);
            rewritten.push(Literal { function: beyond.settled(), compared: Compared::Positive, guarded: true });
        }
        let root = |end: &Rational| Extended::of(end).root(powers[k]).ok();
        let exact = |end: &Rational| end.root(powers[k]).ok();
        sides[k].lo = exact(&lo).or_else(|| Rational::from_float(root(&lo)?.lo));
        sides[k].hi = match hi {
            Some(hi) => Some(exact(&hi).or_else(|| Rational::from_float(root(&hi)?.hi))?),
            None => None,
        };
    }
    Some(Rewritten { clause: rewritten, domain: sides, common: None })
}

/// `x = exp(t)` for numbers that are not negative and of which logarithms or roots are taken; the sides with `x = 0` are looked at by themselves.
fn by_exponential<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Option<Decision>, Cancelled> {
    let arity = domain.len();
    let extension = Extension::new(arity);
    functions(clause, &extension.arguments(), domain);
    let zero = rational(0, 1);
    let is_not_negative = |k: usize| domain[k].lo.as_ref().is_some_and(|lo| *lo >= zero);
    let inside = extension.inside_logarithms();
    let changed: Vec<usize> = free(domain).into_iter().filter(|&k| inside.contains(&k) && is_not_negative(k)).collect();
    if changed.is_empty() {
        return Ok(None);
    }
    for &k in changed.iter().filter(|&&k| domain[k].contains(&zero)) {
        let mut face = domain.to_vec();
        face[k] = Side::point(zero.clone());
        if !matches!(on_rest(clause, &face, effort, progress)?, Decision::Holds(_)) {
            return Ok(None);
        }
    }
    let extension = Extension::new(arity);
    let mut arguments = extension.arguments();
    let mut sides = domain.to_vec();
    let logarithm = |end: &Rational| Extended::of(end).ln().ok();
    for &k in &changed {
        let Ok(exponential) = arguments[k].exp() else { return Ok(None) };
        arguments[k] = exponential;
        let lo = domain[k].lo.as_ref().filter(|lo| !lo.is_zero());
        sides[k] = Side {
            lo: lo.and_then(|lo| Rational::from_float(logarithm(lo)?.lo)),
            hi: domain[k].hi.as_ref().and_then(|hi| Rational::from_float(logarithm(hi)?.hi)),
            integer: false,
        };
    }
    let rewritten = at(clause, &arguments, domain);
    Ok(match on_rest(&rewritten, &sides, Effort { conditions: false, ..effort }, progress)? {
        Decision::Holds(proof) => Some(Decision::Holds(proof.without_points())),
        Decision::Fails(at) => {
            let place = |(k, q): (usize, Rational)| match changed.contains(&k) {
                true => Place::exponential(q),
                false => Place::of(q),
            };
            let places: Vec<Place> = at.into_iter().enumerate().map(place).collect();
            let is_in = places.iter().zip(domain).all(|(place, side)| place.is_in(side));
            (is_in && truth(clause, &places) == Signs::Fails).then_some(Decision::FailsAt(places))
        }
        _ => None,
    })
}

/// A function that is a sum of functions of different numbers, each of which is least where the sum has a known value that is not negative.
fn by_summands<F: Function>(
    clause: &[Literal<F>],
    domain: &[Side],
    effort: Effort,
    progress: &dyn Progress,
) -> Result<Option<Decision>, Cancelled> {
    'literals: for own in clause.iter().filter(|own| own.compared == Compared::NotNegative) {
        let extension = Extension::new(domain.len());
        let Some(value) = functions(std::slice::from_ref(own), &extension.arguments(), domain).remove(0) else {
            continue;
        };
        let summands = value.summands();
        if summands.len() < 2 {
            continue;
        }
        let Some(places) = super::attained::zero(own, domain) else { continue };
        let like = extension.unit();
        let Ok(at) = places.iter().map(|place| place.value(&like)).collect::<Result<Vec<Symbolic>, _>>() else {
            continue;
        };
        let mut all = Proof::default();
        for summand in &summands {
            let Some(function) = summand.known() else { continue 'literals };
            let Ok(least) = function.value(&at) else { continue 'literals };
            let rest = (summand.clone() - least).settled();
            let others: Vec<usize> = (0..domain.len()).filter(|k| !summand.depends_on().contains(k)).collect();
            match on_rest(&[literal(own, rest)], &held(domain, &others), effort, progress)? {
                Decision::Holds(proof) => all.add(proof.without_points()),
                _ => continue 'literals,
            }
        }
        all.places = vec![places];
        return Ok(Some(Decision::Holds(all)));
    }
    Ok(None)
}
