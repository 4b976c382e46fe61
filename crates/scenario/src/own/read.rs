//! From the tables of a law to the law, with the place of what is wrong.

use super::start::{Ranges, start};
use crate::error::{ConfigError, Problem};
use crate::network::{Abilities, Kind as NetworkKind, Network};
use crate::source::{Entry, Section, Source};
use arithmetic::random::generator;
use arithmetic::{Rational, rational};
use expressions::{Kind, Law, LawError, LawText, Parameter, Time};
use rand_chacha::ChaCha8Rng;
use std::sync::Arc;

const KINDS: [(&str, Kind); 3] = [("vector", Kind::Vector), ("number", Kind::Number), ("angle", Kind::Angle)];
const TIMES: [(&str, Time); 2] = [("continuous", Time::Continuous), ("discrete", Time::Discrete)];
const KEYS: [&str; 13] = [
    "name",
    "time",
    "step",
    "dimension",
    "state",
    "position",
    "parameters",
    "define",
    "rates",
    "next",
    "noise",
    "seed",
    "observables",
];

/// A law of one's own with everything that a run needs.
#[derive(Clone)]
pub(crate) struct Described {
    pub law: Arc<Law>,
    /// The start: exact, in the order of the law's state.
    pub state: Vec<Rational>,
    pub network: Network,
    /// Exact, where links are those within a radius.
    pub radius: Option<Rational>,
    pub time: Time,
    /// The length of a step in discrete time.
    pub step: Rational,
    pub declaration: Vec<String>,
    /// What noise is drawn from.
    pub random: ChaCha8Rng,
}

/// The law of a text with the tables `[law]` and `[law.*]`, without agents, network and start.
///
/// # Errors
/// [`ConfigError`], with the place.
pub fn read_law(text: &str) -> Result<LawText, ConfigError> {
    let source = Source::parse(text)?;
    let section = source.needed("law")?;
    Ok(law_text(&section)?.0)
}

/// What is wrong with a law that was read from a text, with its place there.
pub fn law_problem(text: &str, error: LawError) -> ConfigError {
    let section = Source::parse(text).ok();
    let section = section.as_ref().and_then(|source| source.needed("law").ok());
    match section {
        Some(section) => {
            let rates = if section.get("next").is_some() { "next" } else { "rates" };
            refused(&section, rates, error)
        }
        None => ConfigError::MissingSection("law"),
    }
}

/// The law, and the length of its steps.
fn law_text(section: &Section) -> Result<(LawText, Rational), ConfigError> {
    section.allow(&KEYS, " of a law of one's own")?;
    let mut text = LawText { dimension: 2, ..LawText::default() };
    text.time = section.get("time").map_or(Ok(Time::Continuous), |entry| entry.choice(&TIMES))?;
    text.dimension = section.get("dimension").map_or(Ok(2), |entry| entry.count(1, 3))?;
    let discrete = text.time == Time::Discrete;
    let (rates, other) = if discrete { ("next", "rates") } else { ("rates", "next") };
    if let Some(entry) = section.get(other) {
        return Err(entry.range(format!(
            "left out: a law in {} time has [law.{rates}]",
            if discrete { "discrete" } else { "continuous" }
        )));
    }
    let step = match section.get("step") {
        None => rational(1, 1),
        Some(entry) if !discrete => return Err(entry.range("left out: time is continuous")),
        Some(entry) => {
            entry.positive()?;
            entry.exact()?
        }
    };
    let what = "a table such as { x = \"vector\", v = \"vector\" }";
    for (name, entry) in section.need("state", what)?.table("law.state")?.leaves() {
        text.state.push((name, entry.choice(&KINDS)?));
    }
    let position = section.get("position").map(|entry| entry.word()).transpose()?;
    text.position = position.map(str::to_string).or_else(|| usual_position(&text));
    if let Some(entry) = section.get("parameters") {
        for (name, entry) in entry.table("law.parameters")?.leaves() {
            let value = if entry.is_list() {
                let each = entry.items("a list with one number for each agent")?;
                Parameter::Each(each.iter().map(Entry::exact).collect::<Result<_, _>>()?)
            } else {
                Parameter::One(entry.exact()?)
            };
            text.parameters.push((name, value));
        }
    }
    text.define = texts(section, "define")?;
    text.rates = texts(section, rates)?;
    text.observables = texts(section, "observables")?;
    if let Some(entry) = section.get("noise").filter(|_| discrete) {
        return Err(entry.range("left out: in discrete time `normal(sigma)` and `uniform(a, b)` stand in [law.next]"));
    }
    text.noise = texts(section, "noise")?;
    Ok((text, step))
}

/// Everything but how it is run.
pub(crate) fn describe(source: &Source) -> Result<Described, ConfigError> {
    describe_open(source, &[])
}

/// The same with the numbers of some parameters behind the state.
pub(crate) fn describe_open(source: &Source, open: &[&str]) -> Result<Described, ConfigError> {
    let section = source.needed("law")?;
    let (mut text, step) = law_text(&section)?;
    let rates = if text.time == Time::Discrete { "next" } else { "rates" };
    let seed = section.get("seed").map_or(Ok(1), |entry| entry.count(0, usize::MAX))?;
    let ranges = Ranges::of(&text);
    let (parts, agents, drawn) = start(source, &ranges)?;
    let can = Abilities {
        model: "own",
        positions: text.position.is_some(),
        directed: true,
        edges: false,
        weighted: false,
        timed: true,
        default: Some(NetworkKind::AllToAll),
    };
    let network = Network::read(source, agents, can)?;
    text.links_change = network.switches() || network.next_time().is_some();
    let law = text.compile_open(agents, open).map_err(|error| refused(&section, rates, error))?;
    let network = network.of_width(law.position().map_or(2, |position| position.width));
    let state = laid_out(&law, &parts);
    let radius = network.exact_radius().cloned();
    let name = section.get("name").map(|entry| entry.word()).transpose()?;
    let mut declaration = declaration(&text, name, &step);
    declaration.push(match &radius {
        None => network.declaration().to_string(),
        Some(radius) => format!("links i-j where the distance is at most {radius}; they come and go with the distance"),
    });
    declaration.extend(drawn);
    if law.is_noisy() || !law.drawn().is_empty() {
        declaration.push(format!("noise: ChaCha8, seed {seed}, anew for every agent and step; the same place of a text draws once for an agent"));
    } else if let Some(entry) = section.get("seed") {
        return Err(entry.range("left out: the law has no noise"));
    }
    let random = generator(&seed.to_string(), "own", source.replica);
    Ok(Described { law: Arc::new(law), state, network, radius, time: text.time, step, declaration, random })
}

/// The law of one's own of a scenario that has one and is in order.
pub fn own_law(source: &Source) -> Option<Arc<Law>> {
    let own = source.top().get("model").is_some_and(|entry| entry.word().is_ok_and(|word| word == "own"));
    if own { describe(source).ok().map(|described| described.law) } else { None }
}

/// The first vector; in one dimension the first part that is no angle.
fn usual_position(text: &LawText) -> Option<String> {
    let is_place = |kind: Kind| kind == Kind::Vector || text.dimension == 1 && kind == Kind::Number;
    text.state.iter().find(|(_, kind)| is_place(*kind)).map(|(name, _)| name.clone())
}

fn texts(section: &Section, key: &'static str) -> Result<Vec<(String, String)>, ConfigError> {
    let Some(entry) = section.get(key) else { return Ok(Vec::new()) };
    let leaves = entry.table(titled(key))?.leaves();
    leaves.into_iter().map(|(name, entry)| Ok((name, entry.word()?.to_string()))).collect()
}

/// The numbers in the order of the law's state.
fn laid_out(law: &Law, parts: &[(String, Vec<Vec<Rational>>)]) -> Vec<Rational> {
    let mut state = vec![rational(0, 1); law.size()];
    state.extend(law.open().iter().flat_map(|parameter| parameter.values.iter().cloned()));
    for variable in law.variables() {
        let rows = parts.iter().find(|(name, _)| *name == variable.name).map(|(_, rows)| rows);
        for (agent, row) in rows.into_iter().flatten().enumerate() {
            let from = variable.start + agent * variable.width;
            state[from..from + row.len()].clone_from_slice(row);
        }
    }
    state
}

/// How a table of the law is called.
fn titled(table: &str) -> &'static str {
    const TITLES: [&str; 7] =
        ["law.state", "law.parameters", "law.define", "law.rates", "law.next", "law.noise", "law.observables"];
    TITLES.into_iter().find(|title| title.strip_prefix("law.") == Some(table)).unwrap_or("law")
}

/// The place of what is wrong with a law.
fn refused(section: &Section, rates: &'static str, error: LawError) -> ConfigError {
    let table = if error.table == "rates" { rates } else { error.table };
    let inner = section.get(table);
    let entry = inner.as_ref().and_then(|entry| {
        let inside = entry.is_table().then(|| entry.table(titled(table)).ok()).flatten()?;
        inside.leaves().into_iter().find(|(name, _)| *name == error.key).map(|(_, entry)| entry)
    });
    match (entry, inner) {
        (Some(entry), _) => entry.in_text(error.at, error.problem),
        (None, Some(inner)) => inner.in_text(None, error.problem),
        (None, None) => section.problem(Problem::Expression(error.problem)),
    }
}

/// The law in words: equations and every choice that is open.
fn declaration(text: &LawText, name: Option<&str>, step: &Rational) -> Vec<String> {
    let mut lines = Vec::new();
    let title = name.map_or(String::new(), |name| format!(" \"{name}\""));
    let discrete = text.time == Time::Discrete;
    lines.push(match discrete {
        true => format!("law of one's own{title}, discrete time in steps of {step}; all agents change at once"),
        false => format!("law of one's own{title}, continuous time"),
    });
    for (name, rate) in &text.rates {
        let kind = text.state.iter().find(|(known, _)| known == name).map_or(Kind::Number, |(_, kind)| *kind);
        let word = match kind {
            Kind::Vector => format!("vector of {} numbers", text.dimension),
            Kind::Number => "number".to_string(),
            Kind::Angle => "angle, radians".to_string(),
        };
        lines.push(match discrete {
            true => format!("{name}(t + {step}) = {rate} ({word})"),
            false => format!("d{name}/dt = {rate} ({word})"),
        });
    }
    lines.extend(text.noise.iter().map(|(name, strength)| {
        format!("noise of {name}: {strength} dW, an independent Wiener process for each number")
    }));
    lines.extend(text.define.iter().map(|(name, body)| format!("{name} = {body}")));
    let value = |parameter: &Parameter| match parameter {
        Parameter::One(q) => q.to_string(),
        Parameter::Each(list) => format!("[{}]", list.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")),
    };
    if !text.parameters.is_empty() {
        let all: Vec<String> =
            text.parameters.iter().map(|(name, given)| format!("{name} = {}", value(given))).collect();
        lines.push(format!("parameters: {}", all.join(", ")));
    }
    lines.extend(text.observables.iter().map(|(name, body)| format!("observable {name} = {body}")));
    lines.push("sum, mean, max, min and count run over the agents that agent i hears in the network, in observables over all agents, inside each other over those whom that agent hears; a mean over none is 0; a mean of angles is the direction of the mean unit vector".to_string());
    if let Some(position) = &text.position {
        lines.push(format!("agents are where `{position}` says; distances are those of `{position}`"));
    }
    lines
}
