//! A system from a TOML text; every error says where.

use crate::condition;
use crate::platoon::{Platoon, WRITTEN_OUT};
use crate::system::{Check, Input, Mode, Range, Stay, Switching, System};
use algebra::graph::AnyGraph;
use arithmetic::{Rational, shown};
use models::platoon::{Communication, CommunicationGraph, Gains, Line, Parameter};
use num_traits::{Signed, Zero};
use scenario::source::{Entry, Section, Source};
use scenario::{ConfigError, Problem, with_graph};

/// Most states, constant inputs included.
const STATES: usize = 200;
/// Most inputs, modes and checks.
const OTHERS: usize = 200;
/// Most modes in turn.
const TURNS: usize = 1000;

type Read<T> = Result<T, ConfigError>;

impl System {
    /// Reads a system that names no file.
    ///
    /// # Errors
    /// [`ConfigError`] with the line at fault.
    pub fn read(text: &str) -> Result<System, ConfigError> {
        System::read_beside(text, &|_| Err("no files are read here".to_string()))
    }

    /// Reads a system; `files` gives the text of a file by its name, for a platoon whose graph is `file:NAME`.
    ///
    /// # Errors
    /// [`ConfigError`] with the line at fault.
    pub fn read_beside(text: &str, files: &dyn Fn(&str) -> Result<String, String>) -> Result<System, ConfigError> {
        of_few_states(text)?;
        let text = &with_graph(text, files)?;
        let source = Source::parse(text)?;
        let top = source.top();
        top.allow(&["system", "platoon", "mode", "switching", "run", "check"], "")?;
        if let Some(section) = source.section("platoon")? {
            top.allow(&["platoon", "run", "check"], " beside [platoon]")?;
            return of_platoon(&source, &section);
        }
        let section = source.needed("system")?;
        section.allow(&["states", "inputs", "start", "name"], "")?;
        let states = states(&section)?;
        let inputs = inputs(&section)?;
        let start = start(&section, &states)?;
        let constants = inputs.iter().filter(|input| input.constant).count();
        if states.len() + constants > STATES {
            return Err(
                section.problem(Problem::Range(format!("a system of at most {STATES} states and constant inputs")))
            );
        }
        let modes = modes(&top, states.len(), inputs.len())?;
        let switching = switching(source.section("switching")?, &modes)?;
        let run = source.needed("run")?;
        run.allow(&["until"], "")?;
        let until = until(&run)?;
        followed(&top, &switching, until.as_ref())?;
        let checks = checks(&top, &states, until.as_ref())?;
        Ok(System { states, inputs, start, modes, switching, until, checks, platoon: None })
    }
}

/// Too many states are refused before the matrices are read, which of a large file are all but a few lines, wherever the section stands.
fn of_few_states(text: &str) -> Read<()> {
    let is_header = |line: &str, header: &str| line.trim_start().starts_with(header);
    let Some(before) = text.split_inclusive('\n').position(|line| is_header(line, "[system]")) else { return Ok(()) };
    let mut lines = text.split_inclusive('\n').skip(before);
    // Empty lines before it, so that what is said names the right one.
    let section = lines.next().into_iter().chain(lines.take_while(|line| !is_header(line, "[[")));
    let head: String = std::iter::repeat_n("\n", before).chain(section).collect();
    let Ok(source) = Source::parse(&head) else { return Ok(()) };
    let Ok(Some(section)) = source.section("system") else { return Ok(()) };
    let count = section.get("states").and_then(|entry| entry.items("").map(|items| items.len()).ok());
    if count.is_some_and(|count| count > STATES) { states(&section).map(drop) } else { Ok(()) }
}

/// A platoon stands for a system of one mode.
fn of_platoon(source: &Source, section: &Section) -> Read<System> {
    let platoon = platoon(section)?;
    let run = source.needed("run")?;
    run.allow(&["until"], "")?;
    let until = until(&run)?;
    let mut checks = checks(&source.top(), &platoon.names(), until.as_ref())?;
    checks.iter_mut().flat_map(|check| &mut check.conditions).for_each(|c| c.row = platoon.row(&c.row));
    let m = platoon.graph.followers();
    let only_lags = checks.iter().flat_map(|check| &check.conditions).all(|c| c.row[m..].iter().all(Zero::is_zero));
    if m > WRITTEN_OUT && !(only_lags && platoon.way().is_some()) {
        return Err(section.problem(Problem::Range(format!(
            "of at most {WRITTEN_OUT} followers, not {m}, unless followers track each other nowhere in a circle, or everywhere in both directions, the gains are below 0, the acceleration may be 0, and \
             checks are about lags and gaps"
        ))));
    }
    let (states, inputs, start, modes) = platoon.system();
    let switching = Switching::Windows { order: vec![0], windows: Vec::new() };
    Ok(System { states, inputs, start, modes, switching, until, checks, platoon: Some(platoon) })
}

/// Most pairs of a follower and an agent that it tracks.
const LINKS: usize = 100_000;

/// Most followers of a platoon.
const FOLLOWERS: usize = 2000;

fn platoon(section: &Section) -> Read<Platoon> {
    section.allow(&["followers", "graph", "tracks", "ahead", "behind", "f", "g", "acceleration"], "")?;
    let gain = |key: &'static str| section.need(key, "the gain, a number")?.exact();
    let gains = Gains { f: gain("f")?, g: gain("g")? };
    let acceleration = range(&section.need("acceleration", "a list of two numbers")?)?;
    let graph = if section.get("ahead").or(section.get("behind")).is_some() {
        on_a_line(section, &gains)?
    } else {
        tracked(section)?
    };
    if graph.followers() > FOLLOWERS {
        return Err(
            section.problem(Problem::Range(format!("of at most {FOLLOWERS} followers, not {}", graph.followers())))
        );
    }
    let links: usize = (1..=graph.followers()).map(|k| graph.tracked_by(k).len()).sum();
    if links > LINKS {
        return Err(section.problem(Problem::Range(format!("one of at most {LINKS} links, not {links}"))));
    }
    if let Some(k) = graph.reached_by_leader().iter().position(|reached| !reached) {
        return Err(section.problem(Problem::Range(format!(
            "one whose followers all hear of the leader, which car {k} does not, so that its lag has no worst case"
        ))));
    }
    Ok(Platoon { graph, gains, acceleration })
}

/// The cars ahead and behind with weights, a number for all followers or one for each.
fn on_a_line(section: &Section, gains: &Gains<Rational>) -> Read<CommunicationGraph> {
    if let Some(other) = section.get("graph").or(section.get("tracks")) {
        return Err(other.problem(Problem::Both("ahead and behind", "a graph")));
    }
    let followers = section.need("followers", "the number of followers")?.count(1, FOLLOWERS)?;
    let mut line = Line::default().with(Parameter::F, vec![gains.f.clone()]).with(Parameter::G, vec![gains.g.clone()]);
    for parameter in [Parameter::Ahead, Parameter::Behind] {
        if let Some(entry) = section.get(parameter.name()) {
            line = line.with(parameter, entry.one_or_each()?);
        }
    }
    let refused = |error: &dyn std::fmt::Display| section.problem(Problem::Range(format!("a platoon, but {error}")));
    line.platoon(followers).map(|platoon| platoon.positions().clone()).map_err(|error| refused(&error))
}

/// Who tracks whom: two graphs with a number of followers, a graph with a name, whose first vertex leads, or lists of agents.
fn tracked(section: &Section) -> Read<CommunicationGraph> {
    let count = || section.need("followers", "the number of followers")?.count(1, FOLLOWERS);
    let refused = |error: &dyn std::fmt::Display| section.problem(Problem::Range(format!("a platoon, but {error}")));
    if let Some(entry) = section.get("tracks") {
        if let Some(other) = section.get("graph").or(section.get("followers")) {
            return Err(other.problem(Problem::Both("tracks", "graph or followers")));
        }
        let agents = |entry: &Entry| entry.items("a list of agents")?.iter().map(|e| e.count(0, FOLLOWERS)).collect();
        let rows: Vec<Vec<usize>> =
            entry.items("a list of lists of agents")?.iter().map(agents).collect::<Read<_>>()?;
        return CommunicationGraph::with_equal_weights(&rows)
            .map_err(|error| entry.range(format!("a platoon, but {error}")));
    }
    let entry = section.get("graph");
    let communication = match entry.as_ref().map(Entry::word).transpose()? {
        None | Some("front-and-back") => Communication::FrontAndBack,
        Some("front") => Communication::Front,
        Some(name) => {
            let must = |error: &dyn std::fmt::Display| {
                entry.as_ref().map_or_else(
                    || refused(error),
                    |entry| entry.range(format!("front, front-and-back or a graph, but {error}")),
                )
            };
            let graph: AnyGraph = name.parse().map_err(|error| must(&error))?;
            if let Some(followers) = section.get("followers") {
                return Err(followers.range("left out: the graph says how many there are"));
            }
            if graph.order() > FOLLOWERS + 1 {
                return Err(must(&format!("it has {} vertices, more than {}", graph.order(), FOLLOWERS + 1)));
            }
            return CommunicationGraph::behind(&graph.weighted(), 0).map_err(|error| must(&error));
        }
    };
    CommunicationGraph::of(communication, count()?).map_err(|error| refused(&error))
}

fn states(section: &Section) -> Read<Vec<String>> {
    let entry = section.need("states", "a list of names")?;
    let items = entry.items("a list of names")?;
    if items.is_empty() || items.len() > STATES {
        return Err(entry.range(format!("a list of 1 to {STATES} names, not {}", items.len())));
    }
    let names: Vec<String> = items.iter().map(name).collect::<Read<_>>()?;
    distinct(&names, &items)?;
    Ok(names)
}

/// A name that conditions can use.
fn name(entry: &Entry) -> Read<String> {
    let word = entry.word()?;
    let letters = word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let starts = word.starts_with(|c: char| c.is_ascii_alphabetic());
    match letters && starts && word.len() <= 60 && !expressions::KEYWORDS.contains(&word) {
        true => Ok(word.to_string()),
        false => Err(entry.range("a name of letters and digits that starts with a letter and is no keyword")),
    }
}

fn distinct(names: &[String], items: &[Entry]) -> Read<()> {
    for (i, entry) in items.iter().enumerate() {
        if names[..i].contains(&names[i]) {
            return Err(entry.range(format!("another name than `{}`, which is taken", shown(&names[i]))));
        }
    }
    Ok(())
}

fn inputs(section: &Section) -> Read<Vec<Input>> {
    let Some(entry) = section.get("inputs") else { return Ok(Vec::new()) };
    let found = entry.table("system.inputs")?.entries();
    if found.len() > OTHERS {
        return Err(entry.range(format!("at most {OTHERS} inputs, not {}", found.len())));
    }
    found.iter().map(|(name, entry)| input(name, entry)).collect()
}

fn input(name: &str, entry: &Entry) -> Read<Input> {
    if !entry.is_table() {
        return Ok(Input { name: name.to_string(), range: range(entry)?, constant: false });
    }
    let table = entry.table("system.inputs")?;
    table.allow(&["box", "constant"], " of an input")?;
    let constant = table.get("constant").map_or(Ok(false), |entry| entry.flag())?;
    Ok(Input { name: name.to_string(), range: range(&table.need("box", "a list of two numbers")?)?, constant })
}

/// A number, or a list of two.
fn range(entry: &Entry) -> Read<Range> {
    if !entry.is_list() {
        return Ok(Range::point(entry.exact()?));
    }
    let ends: Vec<Rational> =
        entry.items("a number or a list of two")?.iter().map(Entry::exact).collect::<Read<_>>()?;
    match <[Rational; 2]>::try_from(ends) {
        Ok([lo, hi]) if lo <= hi => Ok(Range { lo, hi }),
        Ok([lo, hi]) => Err(entry.range(format!("an interval, but [{lo}, {hi}] is empty"))),
        Err(ends) => Err(entry.range(format!("a number or a list of two, not of {}", ends.len()))),
    }
}

fn start(section: &Section, states: &[String]) -> Read<Vec<Range>> {
    let entry = section.need("start", "a table with a number or an interval for each state")?;
    let table = entry.table("system.start")?;
    let names: Vec<&str> = states.iter().map(String::as_str).collect();
    table.allow(&names, " (the states)")?;
    let missing = |state: &str| entry.range(format!("a table with every state, but `{state}` is missing"));
    states.iter().map(|state| range(&table.get(state).ok_or_else(|| missing(state))?)).collect()
}

fn modes(top: &Section, states: usize, inputs: usize) -> Read<Vec<Mode>> {
    let expected = "[[mode]] with name, A and B";
    let entry = top.need("mode", expected)?;
    let items = entry.items(expected)?;
    if items.is_empty() || items.len() > OTHERS {
        return Err(entry.range(format!("a list of 1 to {OTHERS} modes, not {}", items.len())));
    }
    let tables: Vec<Section> = items.iter().map(|item| item.table("mode")).collect::<Read<_>>()?;
    let named: Vec<Entry> =
        tables.iter().map(|table| table.need("name", "the name of the mode")).collect::<Read<_>>()?;
    let names: Vec<String> = named.iter().map(name).collect::<Read<_>>()?;
    distinct(&names, &named)?;
    tables.iter().zip(names).map(|(table, name)| mode(table, name, states, inputs)).collect()
}

fn mode(table: &Section, name: String, states: usize, inputs: usize) -> Read<Mode> {
    table.allow(&["name", "A", "B", "c"], "")?;
    let a = matrix(&table.need("A", "the matrix of the mode, a list of rows")?, states, states)?;
    let b = match table.get("B") {
        None if inputs == 0 => vec![Vec::new(); states],
        _ => matrix(&table.need("B", "the matrix of the inputs, a list of rows")?, states, inputs)?,
    };
    let c = table.get("c").map_or(Ok(vec![Rational::ZERO; states]), |entry| row(&entry, states))?;
    Ok(Mode { name, a, b, c })
}

fn matrix(entry: &Entry, rows: usize, columns: usize) -> Read<Vec<Vec<Rational>>> {
    let items = entry.items("a list of rows")?;
    if items.len() != rows {
        return Err(entry.range(format!("a list of {rows} rows, one for each state, not {}", items.len())));
    }
    items.iter().map(|item| row(item, columns)).collect()
}

fn row(entry: &Entry, columns: usize) -> Read<Vec<Rational>> {
    let items = entry.items("a list of numbers")?;
    if items.len() != columns {
        return Err(entry.range(format!("a list of {columns} numbers, not {}", items.len())));
    }
    items.iter().map(Entry::exact).collect()
}

fn which(entry: &Entry, modes: &[Mode]) -> Read<usize> {
    let names: Vec<(&str, usize)> = modes.iter().enumerate().map(|(i, mode)| (mode.name.as_str(), i)).collect();
    entry.choice(&names)
}

fn order(section: &Section, modes: &[Mode]) -> Read<Vec<usize>> {
    let entry = section.need("order", "a list of names of modes")?;
    let items = entry.items("a list of names of modes")?;
    if items.is_empty() || items.len() > TURNS {
        return Err(entry.range(format!("a list of 1 to {TURNS} modes, not {}", items.len())));
    }
    items.iter().map(|item| which(item, modes)).collect()
}

fn switching(section: Option<Section>, modes: &[Mode]) -> Read<Switching> {
    let constant = |mode| Switching::Windows { order: vec![mode], windows: Vec::new() };
    let Some(section) = section else {
        return match modes {
            [_] => Ok(constant(0)),
            _ => Err(ConfigError::MissingSection("switching")),
        };
    };
    let kind = section.need("kind", "constant, periodic, windows, dwell or arbitrary")?;
    let kinds = ["constant", "periodic", "windows", "dwell", "arbitrary"].map(|kind| (kind, kind));
    match kind.choice(&kinds)? {
        "constant" => {
            section.allow(&["kind", "mode"], " of the kind constant")?;
            match section.get("mode") {
                Some(entry) => Ok(constant(which(&entry, modes)?)),
                None if modes.len() == 1 => Ok(constant(0)),
                None => section.need("mode", "the mode that is on").map(|_| constant(0)),
            }
        }
        "periodic" => {
            section.allow(&["kind", "order", "period"], " of the kind periodic")?;
            let entry = section.need("period", "how long each mode lasts")?;
            let period = entry.exact()?;
            match period.is_positive() {
                true => Ok(match order(&section, modes)? {
                    // An order of one mode, or of modes that are all alike, is that mode.
                    order if order.iter().all(|&mode| alike(&modes[mode], &modes[order[0]])) => constant(order[0]),
                    order => Switching::Periodic { order, period },
                }),
                false => Err(entry.range("a time above 0")),
            }
        }
        "windows" => {
            section.allow(&["kind", "order", "windows"], " of the kind windows")?;
            let order = order(&section, modes)?;
            let windows = windows(&section.need("windows", "a list of intervals of time")?, order.len())?;
            Ok(Switching::Windows { order, windows })
        }
        "dwell" => {
            section.allow(&["kind", "first", "at_least", "at_most"], " of the kind dwell")?;
            let first = section.get("first").map(|entry| which(&entry, modes)).transpose()?;
            Ok(Switching::Dwell { first, stays: stays(&section, modes)? })
        }
        _ => {
            section.allow(&["kind"], " of the kind arbitrary")?;
            Ok(if modes.iter().all(|mode| alike(mode, &modes[0])) { constant(0) } else { Switching::Arbitrary })
        }
    }
}

/// Whether two modes differ by their names at most.
fn alike(a: &Mode, b: &Mode) -> bool {
    (&a.a, &a.b, &a.c) == (&b.a, &b.b, &b.c)
}

fn windows(entry: &Entry, modes: usize) -> Read<Vec<Range>> {
    let items = entry.items("a list of intervals of time")?;
    if items.len() + 1 != modes {
        return Err(entry.range(format!(
            "a list of {} intervals, one for each switch, not {}",
            modes - 1,
            items.len()
        )));
    }
    let windows: Vec<Range> = items.iter().map(range).collect::<Read<_>>()?;
    let mut last = Rational::ZERO;
    for (window, item) in windows.iter().zip(&items) {
        if window.lo < last {
            return Err(item.range(format!("an interval from {last} on: windows do not overlap and start after 0")));
        }
        last = window.hi.clone();
    }
    Ok(windows)
}

fn stays(section: &Section, modes: &[Mode]) -> Read<Vec<Stay>> {
    let mut stays = vec![Stay { least: Rational::ZERO, most: None }; modes.len()];
    let names: Vec<&str> = modes.iter().map(|mode| mode.name.as_str()).collect();
    for (key, longest) in [("at_least", false), ("at_most", true)] {
        let Some(entry) = section.get(key) else { continue };
        if !entry.is_table() {
            let first = names.first().copied().unwrap_or("mode");
            return Err(entry.range(format!("a table with times of modes, such as {{ {first} = 2 }}")));
        }
        let table = entry.table("switching")?;
        table.allow(&names, " (names of modes)")?;
        for (name, stay) in names.iter().zip(&mut stays) {
            let Some(entry) = table.get(name) else { continue };
            let time = entry.exact()?;
            if time.is_negative() || longest && time < stay.least {
                return Err(entry
                    .range(format!("a time from {} on", if longest { stay.least.clone() } else { Rational::ZERO })));
            }
            if longest { stay.most = Some(time) } else { stay.least = time }
        }
    }
    Ok(stays)
}

/// A single mode that has to end before the last time leaves nothing to look at.
fn followed(top: &Section, switching: &Switching, until: Option<&Rational>) -> Read<()> {
    let Switching::Dwell { stays, .. } = switching else { return Ok(()) };
    let [Stay { most: Some(most), .. }] = &stays[..] else { return Ok(()) };
    match (until.is_none_or(|until| until > most), top.get("switching")) {
        (true, Some(entry)) => {
            Err(entry.range(format!("`at_most` from `until` on, not {most}: there is no other mode")))
        }
        _ => Ok(()),
    }
}

fn until(run: &Section) -> Read<Option<Rational>> {
    let entry = run.need("until", "the last time, or \"inf\"")?;
    if matches!(entry.word(), Ok("inf")) {
        return Ok(None);
    }
    let until = entry.exact()?;
    if until.is_negative() { Err(entry.range("a time that is not negative, or \"inf\"")) } else { Ok(Some(until)) }
}

fn checks(top: &Section, states: &[String], until: Option<&Rational>) -> Read<Vec<Check>> {
    let entry = top.need("check", "[[check]] with `holds`")?;
    let items = entry.items("[[check]] with `holds`")?;
    if items.is_empty() || items.len() > OTHERS {
        return Err(entry.range(format!("a list of 1 to {OTHERS} checks, not {}", items.len())));
    }
    items.iter().map(|item| check(&item.table("check")?, states, until)).collect()
}

fn check(table: &Section, states: &[String], until: Option<&Rational>) -> Read<Check> {
    table.allow(&["holds", "at"], "")?;
    let entry = table.need("holds", "an inequality between states")?;
    let text = entry.word()?.to_string();
    let conditions = condition::read(&text, states).map_err(|(at, problem)| entry.in_text(Some(at), problem))?;
    let at = match table.get("at") {
        None => None,
        Some(entry) => {
            let at = entry.exact()?;
            if at.is_negative() || until.is_some_and(|until| at > *until) {
                return Err(entry.range("a time from 0 to `until`"));
            }
            Some(at)
        }
    };
    Ok(Check { text, conditions, at })
}
