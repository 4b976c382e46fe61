//! Where agents with a law of one's own start: numbers, or drawn.

use crate::error::{ConfigError, Problem};
use crate::source::{Entry, Section, Source};
use crate::start::{MOST_AGENTS, check_count, rows};
use arithmetic::random::uniform;
use arithmetic::{Rational, rational};
use expressions::{Kind, LawText};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// What has to be given for each agent.
pub(super) struct Ranges {
    /// Names, what they are, and how many numbers each has.
    parts: Vec<(String, Kind, usize)>,
    /// The part that says where an agent is.
    position: Option<String>,
}

impl Ranges {
    pub fn of(text: &LawText) -> Self {
        let width = |kind: Kind| if kind == Kind::Vector { text.dimension } else { 1 };
        let parts = text.state.iter().map(|(name, kind)| (name.clone(), *kind, width(*kind))).collect();
        Ranges { parts, position: text.position.clone() }
    }

    fn names(&self) -> Vec<&str> {
        self.parts.iter().map(|(name, ..)| name.as_str()).collect()
    }
}

/// The parts of the state with a row for each agent, the number of agents, and how they were drawn.
type Started = (Vec<(String, Vec<Vec<Rational>>)>, usize, Option<String>);

/// Reads `[state]`.
pub(super) fn start(source: &Source, ranges: &Ranges) -> Result<Started, ConfigError> {
    let section = source.needed("state")?;
    let names = ranges.names();
    section.allow(&[&names[..], &["random"]].concat(), " of this law")?;
    if let Some(entry) = section.get("random") {
        if let Some(other) = names.iter().find_map(|name| section.get(name)) {
            return Err(other.range("left out: `random` draws the whole start"));
        }
        return drawn(source, &entry.table("state.random")?, ranges);
    }
    let mut agents = None;
    let mut parts = Vec::new();
    for (name, kind, width) in &ranges.parts {
        let Some(entry) = section.get(name) else {
            return Err(section.problem(Problem::Range(format!("complete: `{name}` has one entry for each agent"))));
        };
        let list = if *kind == Kind::Vector {
            rows(&entry, *width, &mut agents)?
        } else {
            let items = entry.items("a list with one number for each agent")?;
            let list: Vec<Vec<Rational>> =
                items.iter().map(|item| Ok(vec![item.finite()?])).collect::<Result<_, ConfigError>>()?;
            check_count(&entry, list.len(), &mut agents)?;
            list
        };
        parts.push((name.clone(), list));
    }
    Ok((parts, agents.unwrap_or(0), None))
}

/// `{ agents = 50, seed = 1, x = 10, v = ["0", "1"] }`: numbers uniform in `[-10, 10]`, in `[0, 1]`; angles on the whole circle where nothing is said.
fn drawn(source: &Source, section: &Section, ranges: &Ranges) -> Result<Started, ConfigError> {
    let (names, replica) = (ranges.names(), source.replica);
    section.allow(&[&names[..], &["agents", "seed", "hard"]].concat(), "")?;
    let agents = section.need("agents", "the number of agents")?.count(1, MOST_AGENTS)?;
    let seed = section.get("seed").map_or(Ok(1), |entry| entry.count(0, usize::MAX))?;
    let mut random = ChaCha8Rng::seed_from_u64(seed as u64);
    random.set_stream(replica);
    let mut words = format!("{agents} agents drawn by ChaCha8 with seed {seed}");
    if replica > 0 {
        words += &format!(", replica {}", replica + 1);
    }
    let mut parts = Vec::new();
    for (name, kind, width) in &ranges.parts {
        let (from, to) = match section.get(name) {
            Some(entry) => ends(&entry)?,
            None if *kind == Kind::Angle => (-std::f64::consts::PI, std::f64::consts::PI),
            None => (-1.0, 1.0),
        };
        let mut number = || Rational::from_float(from + (to - from) * uniform(&mut random)).unwrap_or_default();
        parts.push((name.clone(), (0..agents).map(|_| (0..*width).map(|_| number()).collect()).collect()));
        words += &format!(", {name} uniform in [{from:?}, {to:?}]");
    }
    if section.get("hard").map_or(Ok(false), |entry| entry.flag())? {
        let radius = match source.section("graph")?.and_then(|graph| graph.get("radius")) {
            Some(entry) => entry.exact()?,
            None => rational(1, 1),
        };
        words += &format!("; a hard start: {}", harden(&mut parts, ranges, &radius, &mut random));
    }
    Ok((parts, agents, Some(words)))
}

/// Makes a drawn start one of those at which laws are likely to fail; which one.
fn harden(
    parts: &mut [(String, Vec<Vec<Rational>>)],
    ranges: &Ranges,
    radius: &Rational,
    random: &mut ChaCha8Rng,
) -> &'static str {
    let is_place = |name: &str| ranges.position.as_deref() == Some(name);
    let is_angle = |name: &str| ranges.parts.iter().any(|(own, kind, _)| own == name && *kind == Kind::Angle);
    let which = random.next_u32() % 6;
    // 0, or a power of ten down to 10^-15 with either sign.
    let power = Rational::from_integer(10.into()).pow(random.next_u32() as i32 % 16);
    let small = [power.recip(), rational(0, 1), -power.recip()][random.next_u32() as usize % 3].clone();
    let rows = parts.iter_mut().map(|(name, rows)| (name.as_str(), rows));
    match which {
        0 | 1 => {
            for (_, rows) in rows.filter(|(name, rows)| is_place(name) && rows.len() > 1) {
                let mut row = rows[0].clone();
                row[0] += if which == 0 { radius + &small } else { small.clone() };
                rows[1] = row;
            }
            if which == 0 { "two agents at nearly the radius" } else { "two agents at nearly one place" }
        }
        2 => {
            for (_, rows) in rows.filter(|(name, _)| !is_place(name)) {
                let first = rows[0].clone();
                rows.fill(first);
            }
            "agents alike but for their places"
        }
        3 => {
            for (_, rows) in rows {
                for pair in rows.chunks_exact_mut(2) {
                    pair[1] = pair[0].iter().map(|x| -x.clone()).collect();
                }
            }
            "agents in opposite pairs"
        }
        4 => {
            for (_, rows) in rows.filter(|(name, _)| !is_angle(name)) {
                rows.iter_mut().flatten().for_each(|x| *x = (&*x * rational(2, 1)).round() / rational(2, 1));
            }
            "whole and half numbers"
        }
        _ => {
            for (_, rows) in rows.filter(|(name, _)| is_place(name)) {
                rows[0].iter_mut().for_each(|x| *x *= rational(1000, 1));
            }
            "one agent far away"
        }
    }
}

/// A number `w` for `[-w, w]`, or the two ends.
fn ends(entry: &Entry) -> Result<(f64, f64), ConfigError> {
    if !entry.is_list() {
        let half = entry.not_negative()?;
        return Ok((-half, half));
    }
    let list = entry.items("two numbers")?;
    match &list[..] {
        [from, to] if from.number()? <= to.number()? => Ok((from.number()?, to.number()?)),
        [_, _] => Err(entry.range("two numbers, the smaller one first")),
        _ => Err(entry.problem(Problem::Shape("a number, or a list of two".to_string()))),
    }
}
