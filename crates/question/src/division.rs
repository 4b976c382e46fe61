//! A continuum: decided where the property is attained, as far as it is one of numbers alone, and on boxes.

mod boxes;
mod downhill;
mod peak;

use crate::bindings::{Bindings, Value};
use crate::case::Case;
use crate::error::QuestionError;
use crate::failure::Failure;
use crate::formula::{Clause, Clauses, clauses, text, without_kinks};
use crate::outcome::{Decided, Judged, Spot, Unsettled};
use crate::point::FIRST_BITS;
use crate::question::{Expression, Question};
use crate::syntax::Kind;
use crate::truth::{Doubt, Margin, Truth};
use arithmetic::{Progress, Rational};
use motion::sets::Range;
use num_traits::{Signed, ToPrimitive};
use polynomials::decide::{Decision, Effort, Open, Place, Proof, is_true_at, is_true_in_closed_form, zero};
use polynomials::sums::{Certificate, Statement};
use polynomials::{Compared, Literal, Side};

/// A continuum that is divided until every box is decided.
pub(crate) struct Division<'a> {
    pub question: &'a Question,
    pub expression: &'a Expression,
    pub progress: &'a dyn Progress,
    pub most: u64,
}

/// What is known on a box.
pub(crate) struct OnBox {
    /// `None` where `where` leaves all of it out.
    pub truth: Option<Truth>,
    pub margin: Margin,
    /// Those of its inequalities.
    pub inequalities: Vec<Margin>,
    /// Whether something was asked for that no box has.
    pub points_only: bool,
}

/// Points without a value: the first one found, and how many there were.
#[derive(Default)]
struct Missing {
    first: Option<QuestionError>,
    count: u64,
}

/// Boxes before a property of numbers alone is decided where it is attained.
const FIRST_BOXES: u64 = 64;

/// Most boxes then.
const MOST_SHARP: u64 = 20_000;

/// Open boxes that are told.
const TOLD: usize = 64;

/// A box of the domain; a side without an end stays as it is.
fn boxed(whole: &Bindings, places: &[usize], sides: &[Side]) -> Bindings {
    let mut bindings = whole.clone();
    for (place, side) in places.iter().zip(sides) {
        if let (Some(lo), Some(hi)) = (&side.lo, &side.hi) {
            let integers = lo.to_integer().to_i64().zip(hi.to_integer().to_i64()).filter(|_| side.integer);
            bindings.set(
                *place,
                match integers {
                    _ if lo == hi => Value::Number(lo.clone()),
                    Some((from, to)) => Value::Integers(from, to),
                    None => Value::Box(Range { lo: lo.clone(), hi: hi.clone() }),
                },
            );
        }
    }
    bindings
}

/// False at a number that the language cannot tell; margins are those of other points.
fn fails_exactly(found: Decided, at: Spot) -> Decided {
    let inequalities = found.inequalities.iter().map(|_| Margin::ANY).collect();
    Decided { truth: Truth::False, closed: Some(at), margin: Margin::ANY, inequalities, ..found }
}

/// A clause with its domain, as the checker of certificates reads it.
fn statement(whole: &Bindings, clause: &Clause) -> Option<Statement> {
    let range = |value: &Value| match value {
        Value::Any => Some("R".to_string()),
        value => value.ends().map(|Range { lo, hi }| format!("[{lo}, {hi}]")),
    };
    let ranges: Vec<(&str, String)> = whole.iter().filter_map(|(name, value)| Some((name, range(value)?))).collect();
    let names: Vec<&str> = ranges.iter().map(|(name, _)| *name).collect();
    let domain: Vec<String> = ranges.iter().map(|(name, range)| format!("{name} in {range}")).collect();
    let text = format!("for all {}: {}", domain.join(", "), text(clause, &names)?);
    Some(Statement { variables: names.len(), text })
}

/// What is left open, in words.
fn told(open: &Open, first: Option<&Bindings>) -> String {
    let mut text = open.why.clone();
    if !open.degrees.is_empty() {
        let degrees: Vec<String> = open.degrees.iter().map(ToString::to_string).collect();
        text += &format!("; sums of squares were looked for in vain, of degree {}", degrees.join(", "));
    }
    if let Some(share) = open.share {
        text += &format!("; open is a share of {share:.3e} of the volume");
    }
    first.map_or(text.clone(), |bindings| format!("{text} (a box: {bindings})"))
}

/// Numbers in closed form, or enclosed, in the place of names that stand for more than one number.
fn spot(whole: &Bindings, places: &[usize], domain: &[Side], list: &[Place]) -> Spot {
    let free = places.iter().zip(domain).zip(list).filter(|((_, side), _)| side.as_point().is_none());
    let texts: Vec<(usize, String)> = free.map(|((place, _), own)| (*place, own.to_string())).collect();
    Spot::of(whole, &texts)
}

impl Division<'_> {
    /// Boxes first; what they leave open is decided where it is attained, as far as the property is one of numbers alone.
    pub fn decide(&self, whole: &Bindings) -> Result<Decided, QuestionError> {
        let Some(clauses) = self.clauses(whole) else {
            if whole.has_line() {
                let why = "over all reals only properties of numbers and functions of them are decided";
                return Ok(Decided { truth: Truth::unknown(why, None), open: 1, boxes: 1, ..Decided::nothing() });
            }
            return match self.fails_at_peak(whole) {
                Some(found) => Ok(found),
                None => Ok(self.at_peak(whole, self.by_boxes(whole, self.most)?)),
            };
        };
        if whole.has_line() {
            return self.where_attained(whole, &clauses, Decided::nothing());
        }
        match self.by_boxes(whole, self.most.min(FIRST_BOXES)) {
            Ok(found) if matches!(found.truth, Truth::Unknown(_)) => self.where_attained(whole, &clauses, found),
            // What boxes prove needs no certificate, but has one where there is one.
            Ok(found) if found.truth == Truth::True && self.is_certified() => {
                let again = self.where_attained(whole, &clauses, found.clone())?;
                let kept = Decided { uncertified: 1, ..found };
                Ok(if matches!(again.truth, Truth::Unknown(_)) { self.attained(whole, &clauses, kept) } else { again })
            }
            Ok(found) if found.truth == Truth::True => Ok(self.attained(whole, &clauses, found)),
            // What is false somewhere is false, whatever has no value elsewhere.
            Err(error @ QuestionError::At { .. }) => {
                let found = self.where_attained(whole, &clauses, Decided::nothing());
                found.ok().filter(|found| found.truth == Truth::False).ok_or(error)
            }
            decided => decided,
        }
    }

    /// The property with what `where` says, as clauses of functions of the names that stand for many numbers.
    fn clauses(&self, whole: &Bindings) -> Option<Clauses> {
        let restriction = self.question.restriction.as_ref().map(|own| &own.node);
        clauses(whole, restriction, &self.expression.node)
    }

    /// Whether certificates are wanted, which is of the property itself only.
    fn is_certified(&self) -> bool {
        let own = self.question.property.as_ref().is_some_and(|property| property.base == self.expression.base);
        own && self.question.certified
    }

    /// Whether the property, one of numbers alone, holds on all of a box, with little effort.
    pub fn holds_where_attained(&self, whole: &Bindings) -> Result<bool, QuestionError> {
        let effort = Effort { boxes: 64, squares: false, certified: false, conditions: false };
        let Some(clauses) = self.clauses(whole) else { return Ok(false) };
        let domain: Vec<Side> = whole.sides().into_iter().map(|(_, side)| side).collect();
        for clause in &clauses.list {
            let decision = polynomials::decide::decide(clause, &domain, effort, self.progress)?;
            if !matches!(decision, Decision::Holds(_)) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// A property of single numbers that enclosures leave open, by what is known of them exactly.
    pub fn at_numbers(&self, whole: &Bindings) -> Result<Option<bool>, QuestionError> {
        let Some(clauses) = clauses(whole, None, &self.expression.node) else { return Ok(None) };
        let nowhere = [Rational::default()];
        let domain = [Side::point(Rational::default())];
        let effort = Effort { boxes: 1, squares: false, certified: false, conditions: false };
        let has_value = clauses.conditions.iter().all(|own| is_true_at(std::slice::from_ref(own), &nowhere));
        let mut holds = true;
        for clause in &clauses.list {
            match polynomials::decide::decide(clause, &domain, effort, self.progress)? {
                Decision::Holds(_) => {}
                Decision::Fails(_) if has_value => return Ok(Some(false)),
                _ => holds = false,
            }
        }
        Ok((holds && has_value).then_some(true))
    }

    /// A clause, in one number by its parts without absolute values, minima and maxima where it is not decided as a whole.
    fn decided(&self, clause: &Clause, domain: &[Side], effort: Effort) -> Result<Decision, QuestionError> {
        let whole = polynomials::decide::decide(clause, domain, effort, self.progress)?;
        let several = domain.iter().filter(|side| side.as_point().is_none()).count() > 1;
        let Decision::Undecided(open) = whole else { return Ok(whole) };
        let Some(parts) = without_kinks(clause).filter(|_| !several) else { return Ok(Decision::Undecided(open)) };
        let mut proof = Proof { boxes: open.looked, ..Proof::default() };
        for part in &parts {
            match polynomials::decide::decide(part, domain, effort, self.progress)? {
                Decision::Holds(own) => {
                    proof.boxes += own.boxes;
                    proof.methods.extend(own.methods);
                    proof.zeros.extend(own.zeros);
                    proof.certificates.extend(own.certificates);
                }
                Decision::Undecided(_) => return Ok(Decision::Undecided(open)),
                fails => return Ok(fails),
            }
        }
        Ok(Decision::Holds(proof))
    }

    /// Every clause by itself.
    fn where_attained(
        &self,
        whole: &Bindings,
        clauses: &Clauses,
        mut found: Decided,
    ) -> Result<Decided, QuestionError> {
        let (places, domain): (Vec<usize>, Vec<Side>) = whole.sides().into_iter().unzip();
        let at = |point: &[Rational]| {
            let mut bindings = whole.clone();
            places.iter().zip(point).for_each(|(place, q)| bindings.set(*place, Value::Number(q.clone())));
            bindings
        };
        let effort = Effort {
            boxes: self.most.min(MOST_SHARP),
            certified: self.is_certified(),
            conditions: true,
            ..Effort::default()
        };
        let mut missing = Missing::default();
        let mut left: Option<Open> = None;
        let mut closed: Option<Spot> = None;
        let spot = |list: &Vec<Place>| spot(whole, &places, &domain, list);
        (found.open, found.truth) = (0, Truth::True);
        for clause in &clauses.list {
            match self.decided(clause, &domain, effort)? {
                Decision::Holds(proof) => {
                    found.boxes += proof.boxes;
                    found.uncertified += u64::from(proof.certificates.is_empty());
                    let statement = statement(whole, clause);
                    let stated = |own: Certificate| Certificate { statement: statement.clone(), ..own };
                    found.certificates.extend(proof.certificates.into_iter().map(stated));
                    if let ([literal], None) = (&clause[..], &closed)
                        && !clauses.conditions.iter().any(|own| own.function == literal.function)
                    {
                        let rational = || proof.zeros.first().map(|zero| Spot::of(&at(zero), &[]));
                        closed = proof.places.first().map(spot).or_else(rational);
                    }
                    for zero in proof.zeros {
                        let point = at(&zero);
                        let judged = self.judged_at(&point);
                        // Of several clauses another one may have the smallest margin, elsewhere.
                        let is_least = matches!(&judged, Ok(Some(own)) if own.margin.hi == 0.0);
                        if Self::fails(point.clone(), judged, &mut found, &mut missing)? {
                            return Ok(found);
                        }
                        if is_least && found.attained.is_none() {
                            found.attained = Some(Spot::of(&point, &[]));
                        }
                    }
                }
                // The property fails there if all of it has a value.
                Decision::FailsAt(list) => {
                    let is_true = |own: &Literal<_>| is_true_in_closed_form(std::slice::from_ref(own), &list);
                    if clauses.conditions.iter().all(is_true) {
                        return Ok(fails_exactly(found, spot(&list)));
                    }
                    let why = format!("whether there is a value at ({}) could not be told", spot(&list));
                    left.get_or_insert_with(|| Open::at_point(why));
                }
                Decision::Fails(point) => {
                    // The language itself has the last word, unless it cannot tell what an identity does.
                    let at = at(&point);
                    if self.fails_at(at.clone(), &mut found, &mut missing)? {
                        return Ok(found);
                    }
                    let judged = self.judged_at(&at);
                    let is_unknown = matches!(judged, Ok(Some(Judged { truth: Truth::Unknown(_), .. })));
                    let is_true = |own: &Literal<_>| is_true_at(std::slice::from_ref(own), &point);
                    if is_unknown && clauses.conditions.iter().all(is_true) {
                        return Ok(fails_exactly(found, Spot::of(&at, &[])));
                    }
                    left.get_or_insert_with(|| Open::at_point(format!("the two sides may be equal at {at}")));
                }
                Decision::Undecided(open) => {
                    found.boxes += open.looked;
                    found.open += open.boxes.len() as u64;
                    left.get_or_insert(open);
                }
            }
        }
        if let Some(error) = missing.first {
            return Err(error);
        }
        // Over all reals margins are known at some points only, and nothing bounds the smallest one from below.
        if whole.has_line() {
            let all = std::iter::once(&mut found.margin).chain(&mut found.inequalities);
            all.for_each(|own| own.lo = f64::NEG_INFINITY);
        }
        found.boxes = found.boxes.max(1);
        if let Some(open) = left {
            found.open = found.open.max(1);
            found.attained = None;
            let boxes: Vec<Bindings> = open.boxes.iter().take(TOLD).map(|sides| boxed(whole, &places, sides)).collect();
            let why = told(&open, boxes.first());
            found.unsettled = Some(Unsettled { share: open.share, boxes });
            found.truth = Truth::Unknown(Doubt { why, bits: None });
            return Ok(found);
        }
        // A literal is 0 at a number in closed form: where it is the only one, so is the margin.
        if found.attained.is_none() && clauses.list.iter().all(|clause| clause.len() == 1) && closed.is_some() {
            (found.attained, found.margin.hi) = (closed, 0.0);
        }
        let mut found = self.attained(whole, clauses, found);
        // True everywhere: no inequality that has to be true misses.
        let least = |margin: Margin| Margin { lo: margin.lo.max(0.0).min(margin.hi.max(0.0)), ..margin };
        found.margin = least(found.margin);
        if !matches!(self.expression.node.kind, Kind::Or(_) | Kind::Implies(..) | Kind::Not(_))
            && self.question.restriction.is_none()
        {
            found.inequalities.iter_mut().for_each(|own| *own = least(*own));
        }
        Ok(found)
    }

    /// With a point at which the margin of a property that holds is 0, where one is proved: that of a literal which is the only one of its clause.
    fn attained(&self, whole: &Bindings, clauses: &Clauses, found: Decided) -> Decided {
        let may_be_zero = found.margin.lo <= 0.0 && found.margin.hi > 0.0 || whole.has_line();
        let single = clauses.list.iter().all(|clause| clause.len() == 1);
        if found.attained.is_some() || !may_be_zero || !single {
            return found;
        }
        let (places, domain): (Vec<usize>, Vec<Side>) = whole.sides().into_iter().unzip();
        let own = |literal: &&Literal<_>| {
            literal.compared == Compared::NotNegative
                && !clauses.conditions.iter().any(|own| own.function == literal.function)
        };
        let zero = clauses.list.iter().flatten().filter(own).find_map(|literal| zero(literal, &domain));
        match zero {
            Some(list) => {
                let attained = Some(spot(whole, &places, &domain, &list));
                let lo = found.margin.lo.min(0.0);
                Decided { attained, margin: Margin { lo, hi: 0.0 }, ..found }
            }
            None => found,
        }
    }

    /// What was found, or nothing where a value is missing, which is kept; the first one is told. A value that is too long is not missing: it is not known.
    fn unless_missing<T>(found: Result<T, QuestionError>, missing: &mut Missing) -> Result<Option<T>, QuestionError> {
        match found {
            Err(QuestionError::At { problem, .. }) if problem.is_length() => Ok(None),
            Err(error @ QuestionError::At { .. }) => {
                missing.first.get_or_insert(error);
                missing.count += 1;
                Ok(None)
            }
            found => found.map(Some),
        }
    }

    /// What is known on a box.
    pub fn on_box(&self, bindings: &Bindings) -> Result<OnBox, QuestionError> {
        // Of a range of integers a single one is left in the end.
        if bindings.boxes().is_empty() {
            let decided = self.question.decide_expression(self.expression, bindings, 1, self.progress)?;
            let truth = (!decided.excluded).then_some(decided.truth);
            let (margin, inequalities) = (decided.margin, decided.inequalities);
            return Ok(OnBox { truth, margin, inequalities, points_only: false });
        }
        let case = Case::new(self.question, bindings.clone(), self.progress);
        // What is missing at some points is looked for at points; here it is not known.
        let judged = |expression: &Expression| match self.question.judged(&case, expression, FIRST_BITS) {
            Err(Failure::Refused(_, problem)) => Ok((Truth::unknown(problem.to_string(), None), Margin::ANY)),
            judged => judged.map_err(|failure| self.question.refused(failure, expression.base)),
        };
        let kept =
            self.question.restriction.as_ref().map_or(Ok(Truth::True), |own| judged(own).map(|(truth, _)| truth))?;
        if kept == Truth::False {
            let margin = Margin::of_truth(true);
            return Ok(OnBox { truth: None, margin, inequalities: Vec::new(), points_only: false });
        }
        let (truth, margin) = judged(self.expression)?;
        let inequalities = self.question.each_margin(&case, self.expression, FIRST_BITS, margin)?;
        let truth = match (truth, kept) {
            (Truth::False, Truth::Unknown(doubt)) => Truth::Unknown(doubt),
            (truth, _) => truth,
        };
        Ok(OnBox { truth: Some(truth), margin, inequalities, points_only: case.points_only.get() })
    }

    /// Whether the property fails at a point, exactly or by enclosure; its margin bounds the smallest one from above. A value that is missing there is kept.
    fn fails_at(&self, point: Bindings, found: &mut Decided, missing: &mut Missing) -> Result<bool, QuestionError> {
        let judged = self.judged_at(&point);
        Self::fails(point, judged, found, missing)
    }

    /// The property at a point; nothing where `where` leaves it out.
    fn judged_at(&self, point: &Bindings) -> Result<Option<Judged>, QuestionError> {
        let kept = self.question.kept(point, self.progress);
        match &kept {
            Err(QuestionError::At { .. }) | Ok(Truth::True) => {}
            _ => return kept.map(|_| None),
        }
        let decided = self.question.decide_point(self.expression, point, self.progress);
        // Where the property is true it does not matter whether `where` keeps the point.
        match (kept, decided) {
            (Err(_), Ok(judged)) if judged.truth == Truth::True => Ok(None),
            (Err(error), _) => Err(error),
            (Ok(_), decided) => decided.map(Some),
        }
    }

    /// Notes what is known at a point, and whether the property fails there.
    fn fails(
        point: Bindings,
        judged: Result<Option<Judged>, QuestionError>,
        found: &mut Decided,
        missing: &mut Missing,
    ) -> Result<bool, QuestionError> {
        let Some(Some(Judged { truth, margin, inequalities })) = Self::unless_missing(judged, missing)? else {
            return Ok(false);
        };
        // Of the smallest margins these are upper bounds.
        let below = |margin: Margin| Margin { lo: f64::INFINITY, ..margin };
        let bounds: Vec<Margin> = inequalities.iter().copied().map(below).collect();
        found.margin = found.margin.least(below(margin));
        found.margin.lo = found.margin.lo.min(found.margin.hi);
        Margin::least_of_each(&mut found.inequalities, &bounds);
        found.inequalities.iter_mut().for_each(|own| own.lo = own.lo.min(own.hi));
        if truth != Truth::False {
            return Ok(false);
        }
        found.margin = found.margin.least(margin);
        Margin::least_of_each(&mut found.inequalities, &inequalities);
        found.truth = Truth::False;
        found.counterexample = Some(point);
        Ok(true)
    }
}

/// The place of a side and the two halves of a box across it: the side along which margins became narrowest (the shares, one for each side), and of equal ones
/// the one that is widest compared with its numbers; `None` where all have become too thin.
pub(crate) fn halved(
    bindings: &Bindings,
    original: &[(usize, Range)],
    shares: &[f64],
) -> Option<(usize, [Bindings; 2])> {
    const THINNEST: f64 = 1e-12;
    let relative = |(place, Range { lo, hi }): &(usize, Range)| {
        let width = (hi - lo).to_f64().unwrap_or(0.0);
        let size = lo.abs().max(hi.abs()).to_f64().unwrap_or(1.0);
        let whole = original
            .iter()
            .find(|(other, ..)| other == place)
            .map_or(1.0, |(_, all)| (&all.hi - &all.lo).to_f64().unwrap_or(1.0));
        if lo.is_positive() || hi.is_negative() { width / size } else { width / whole }
    };
    let boxes = bindings.boxes();
    let number = |side: &(usize, Range)| original.iter().position(|(place, ..)| *place == side.0);
    let share = |side: &(usize, Range)| number(side).and_then(|k| shares.get(k)).copied().unwrap_or(0.5);
    let wide = boxes.iter().filter(|side| relative(side) >= THINNEST);
    let best = wide.max_by(|a, b| share(b).total_cmp(&share(a)).then(relative(a).total_cmp(&relative(b))))?;
    Some((number(best)?, bindings.halves(best.0)?))
}
