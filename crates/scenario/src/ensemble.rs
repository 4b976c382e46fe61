//! Several runs from one file: replicas that differ in what is drawn, and a grid of numbers that are put in.

use super::config::Scenario;
use super::error::{ConfigError, Problem};
use super::path::Path;
use super::source::{Entry, Section, Source};
use arithmetic::Rational;

/// Most runs of one file.
const MOST_MEMBERS: u64 = 1_000_000;
/// Agents of all starts that are read beforehand.
const MOST_READ: usize = 1 << 18;
/// Most values of one number.
const MOST_VALUES: usize = 100_000;
/// The sections whose numbers can be swept.
const SWEPT: [&str; 4] = ["graph", "state", "law", "run"];

/// The runs that the sections `[ensemble]` and `[sweep]` of a file ask for. Members are counted from 0: all replicas of the first point of
/// the grid, then those of the next one, the last number going fastest.
#[derive(Debug, Clone)]
pub struct Ensemble {
    source: Source,
    axes: Vec<(Path, Vec<Rational>)>,
    replicas: u64,
}

impl Ensemble {
    /// Reads a file; nothing where it has neither section.
    ///
    /// # Errors
    /// [`ConfigError`] with the line and key at fault, of the first member too.
    pub fn read(text: &str) -> Result<Option<Self>, ConfigError> {
        let source = Source::parse(text)?;
        let (ensemble, sweep) = (source.section("ensemble")?, source.section("sweep")?);
        if ensemble.is_none() && sweep.is_none() {
            return Ok(None);
        }
        let replicas = ensemble.map_or(Ok(1), |section| replicas(&section))?;
        let mut axes = Vec::new();
        for (place, entry) in sweep.iter().flat_map(Section::leaves) {
            axes.push((swept(&source, place, &entry)?, values(&entry)?));
        }
        let points = axes.iter().try_fold(1u64, |all, (_, values)| all.checked_mul(values.len() as u64));
        let members = points.and_then(|points| points.checked_mul(replicas));
        if members.is_none_or(|members| members > MOST_MEMBERS) {
            let section = sweep.or(ensemble).unwrap_or(source.top());
            return Err(section.problem(Problem::Range(format!("a grid and replicas of at most {MOST_MEMBERS} runs"))));
        }
        let all = Ensemble { source: source.clone(), axes, replicas };
        let first = all.member(0)?;
        // Numbers that make no scenario are refused before the work, as far as that takes no time.
        let points = all.members() / replicas;
        let checked = points.min((MOST_READ / first.agents().max(1)) as u64);
        (1..checked).chain(points.checked_sub(1)).try_for_each(|point| all.sampled(point * replicas).map(|_| ()))?;
        match ensemble.and_then(|section| section.get("replicas")) {
            Some(entry) if first.seed().is_none() && replicas > 1 => {
                Err(entry.range("1: nothing is drawn in this scenario, so that all replicas would be the same"))
            }
            _ => Ok(Some(all)),
        }
    }

    /// The numbers that are put in, by their places in the file, each with its values.
    pub fn axes(&self) -> &[(Path, Vec<Rational>)] {
        &self.axes
    }

    /// Runs for each point of the grid.
    pub fn replicas(&self) -> u64 {
        self.replicas
    }

    /// All runs.
    pub fn members(&self) -> u64 {
        self.replicas * self.axes.iter().map(|(_, values)| values.len() as u64).product::<u64>()
    }

    /// The text that it was read from.
    pub fn text(&self) -> &str {
        self.source.text()
    }

    /// The values of a point of the grid, one for each axis.
    pub fn point(&self, point: u64) -> Vec<Rational> {
        let mut rest = point;
        let mut values: Vec<Rational> = Vec::new();
        for (_, axis) in self.axes.iter().rev() {
            let count = axis.len() as u64;
            values.push(axis[(rest % count) as usize].clone());
            rest /= count;
        }
        values.reverse();
        values
    }

    /// One run with all its rows.
    ///
    /// # Errors
    /// [`ConfigError`] where the numbers that are put in make no scenario.
    pub fn member(&self, member: u64) -> Result<Scenario, ConfigError> {
        self.built(member, true)
    }

    /// One run with its samples only.
    ///
    /// # Errors
    /// As [`Self::member`].
    pub fn sampled(&self, member: u64) -> Result<Scenario, ConfigError> {
        self.built(member, false)
    }

    fn built(&self, member: u64, with_rows: bool) -> Result<Scenario, ConfigError> {
        let numbers: Vec<(&Path, Rational)> =
            self.axes.iter().map(|(place, _)| place).zip(self.point(member / self.replicas)).collect();
        let mut source = self.source.with(numbers.iter().cloned())?;
        source.replica = member % self.replicas;
        let built = Scenario::of_member(&source, with_rows);
        let put_in =
            || numbers.iter().map(|(place, value)| format!("{place} = {value}")).collect::<Vec<_>>().join(", ");
        built.map_err(|error| match numbers.len() {
            0 => error,
            _ => ConfigError::PutIn { numbers: put_in(), error: Box::new(error) },
        })
    }
}

fn replicas(section: &Section) -> Result<u64, ConfigError> {
    section.allow(&["replicas"], "")?;
    let entry = section.need("replicas", "the number of runs")?;
    Ok(entry.count(1, MOST_MEMBERS as usize)? as u64)
}

/// A place that can be swept.
fn swept(source: &Source, place: String, entry: &Entry) -> Result<Path, ConfigError> {
    if !place.split('.').next().is_some_and(|section| SWEPT.contains(&section)) {
        return Err(entry.range(format!("a place in the sections {}, such as \"law.K1\"", SWEPT.join(", "))));
    }
    let path = Path::parse(&place).filter(|path| source.with([(path, Rational::default())]).is_ok());
    path.ok_or_else(|| entry.problem(Problem::NoPlace(place)))
}

/// A list, or `{ from, to, count }` for evenly spaced numbers.
fn values(entry: &Entry) -> Result<Vec<Rational>, ConfigError> {
    const EXPECTED: &str = "a list of numbers or a table such as { from = 0, to = 1, count = 11 }";
    if !entry.is_table() {
        let list: Vec<Rational> = entry.items(EXPECTED)?.iter().map(Entry::exact).collect::<Result<_, _>>()?;
        return match list.len() {
            0 => Err(entry.range("a list with at least one number")),
            count if count > MOST_VALUES => Err(entry.range(format!("a list of at most {MOST_VALUES} numbers"))),
            _ => Ok(list),
        };
    }
    let table = entry.table("sweep")?;
    table.allow(&["from", "to", "count"], "")?;
    let from = table.need("from", "the first number")?.exact()?;
    let to = table.need("to", "the last number")?.exact()?;
    let count = table.need("count", "how many numbers there are")?.count(2, MOST_VALUES)?;
    let step = (&to - &from) / Rational::from_integer((count - 1).into());
    Ok((0..count).map(|k| &from + &step * Rational::from_integer(k.into())).collect())
}
