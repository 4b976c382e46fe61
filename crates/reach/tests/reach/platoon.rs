//! Platoons by their modes against closed forms, and against the same platoon written out as a system.

use super::{close, decided, number, read, worst};
use arithmetic::{Number, Rational, Real, Unwatched, parse_rational, rational};
use reach::{ReachError, System, Verdict, decide};

fn platoon(keys: &str, until: &str, check: &str) -> String {
    format!("[platoon]\n{keys}\n[run]\nuntil = {until}\n[[check]]\nholds = \"{check}\"\n")
}

/// The same from the law: follower `k` accelerates by `f e_k + g e_k'`, `e_k` its deviation from the mean of those that it tracks; states are the deviations from the leader.
fn written_out(tracks: &[&[usize]], f: &str, g: &str, acceleration: &str, until: &str, check: &str) -> String {
    let m = tracks.len();
    let (f, g) = (parse_rational(f).expect("a number"), parse_rational(g).expect("a number"));
    let names: Vec<String> = ["lag", "rate"].iter().flat_map(|x| (1..=m).map(move |k| format!("{x}{k}"))).collect();
    let mut rows: Vec<String> = (0..m)
        .map(|k| {
            let row: Vec<&str> = (0..2 * m).map(|j| if j == k + m { "1" } else { "0" }).collect();
            format!("[{}]", row.join(", "))
        })
        .collect();
    for (k, tracked) in tracks.iter().enumerate() {
        let share = |j: usize| {
            let own = rational(i64::from(j == k + 1), 1);
            let mean = if tracked.contains(&j) { rational(1, tracked.len() as i64) } else { Rational::ZERO };
            own - mean
        };
        let entries =
            [&f, &g].iter().flat_map(|gain| (1..=m).map(|j| format!("\"{}\"", share(j) * *gain))).collect::<Vec<_>>();
        rows.push(format!("[{}]", entries.join(", ")));
    }
    let b: Vec<&str> = (0..2 * m).map(|i| if i < m { "[0]" } else { "[-1]" }).collect();
    let quoted: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    let start: Vec<String> = names.iter().map(|name| format!("{name} = 0")).collect();
    format!(
        "[system]\nstates = [{}]\ninputs = {{ leader = {acceleration} }}\nstart = {{ {} }}\n[[mode]]\nname = \"m\"\nA = [{}]\nB = [{}]\n[run]\nuntil = {until}\n[[check]]\nholds = \"{check}\"\n",
        quoted.join(", "),
        start.join(", "),
        rows.join(", "),
        b.join(", ")
    )
}

#[test]
fn one_follower_has_its_closed_forms() {
    // Response e^(-t/2) sin (sqrt 3/2 t): (1 + q)/(1 - q).
    let q = (-number("1").pi() * number("1/3").sqrt().expect("finite")).exp().expect("finite");
    let exact = (number("1") + &q) * (number("1") - &q).recip_of();
    close(
        &worst(&platoon("followers = 1\nf = -1\ng = -1\nacceleration = [-1, 1]", "\"inf\"", "lag1 <= 2"), 10),
        &exact,
        9,
    );
    // A double root: the integral of t e^-t is 1; overdamped: 1/|f| = 1; only one side of the acceleration: the same.
    for (g, range) in [("-2", "[-1, 1]"), ("-3", "[-1, 1]"), ("-3", "[-1, 0]"), ("-50", "[-1, \"1/2\"]")] {
        let keys = format!("followers = 1\nf = -1\ng = {g}\nacceleration = {range}");
        close(&worst(&platoon(&keys, "\"inf\"", "lag1 <= 2"), 10), &number("1"), 9);
    }
}

trait Inverse {
    fn recip_of(self) -> Self;
}

impl Inverse for arithmetic::Interval {
    fn recip_of(self) -> Self {
        use arithmetic::Field;
        self.recip().expect("not zero")
    }
}

/// Who tracks whom as keys and as lists, gains, acceleration, what is asked.
type Case = (&'static str, &'static [&'static [usize]], &'static str, &'static str, &'static str, &'static str);

#[test]
fn modes_are_what_the_written_out_system_is() {
    let cases: [Case; 6] = [
        ("followers = 2", &[&[0, 2], &[1]], "-1", "-1", "[-1, 1]", "lag2 - lag1 <= 9"),
        ("followers = 3\ngraph = \"front-and-back\"", &[&[0, 2], &[1, 3], &[2]], "-1", "-3", "[-9, 1]", "lag3 >= -90"),
        ("graph = \"platoon2:3\"", &[&[0, 2], &[1, 3], &[2]], "-2", "-1/3", "[-1, 2]", "2*lag1 - lag3 <= 90"),
        ("tracks = [[0, 2], [1], [0]]", &[&[0, 2], &[1], &[0]], "-1", "-2", "[-1, 1]", "lag3 + lag2 <= 9"),
        ("tracks = [[0, 2, 3], [1, 3], [1, 2]]", &[&[0, 2, 3], &[1, 3], &[1, 2]], "-1", "-5/2", "[-1, 3]", "lag3 <= 9"),
        ("graph = \"star:4\"", &[&[0], &[0], &[0]], "-3", "-1", "[0, 1]", "lag1 + lag2 - 2*lag3 <= 9"),
    ];
    for (graph, tracks, f, g, range, check) in cases {
        for until in ["3", "\"17/3\"", "12"] {
            let keys = format!("{graph}\nf = \"{f}\"\ng = \"{g}\"\nacceleration = {range}");
            let modes = worst(&platoon(&keys, until, check), 8);
            let other = worst(&written_out(tracks, f, g, range, until, check), 8);
            let slack = rational(1, 1_000_000_000);
            assert!(
                modes.0 <= &other.1 + &slack && other.0 <= &modes.1 + &slack,
                "{keys} {until}: {modes:?} {other:?}"
            );
            assert!(&modes.1 - &modes.0 < rational(1, 10_000_000), "{keys} {until}: {modes:?}");
        }
    }
}

#[test]
fn gaps_are_differences_of_lags() {
    let keys = "followers = 4\nf = -1\ng = -1\nacceleration = [-1, 1]";
    let of = |check: &str| worst(&platoon(keys, "9", check), 8);
    assert_eq!(of("gap3 <= 1"), of("lag3 - lag2 <= 1"));
    assert_eq!(of("gap1 <= 1"), of("lag1 <= 1"));
}

#[test]
fn what_the_others_do_is_all_that_counts() {
    // A follower more that nobody tracks changes nothing; eigenvectors from floats against sines.
    let line = worst(&platoon("followers = 6\nf = -1\ng = -1\nacceleration = [-1, 1]", "\"inf\"", "lag6 <= 1"), 8);
    let more = "tracks = [[0, 2], [1, 3], [2, 4], [3, 5], [4, 6], [5], [0]]\nf = -1\ng = -1\nacceleration = [-1, 1]";
    let other = worst(&platoon(more, "\"inf\"", "lag6 <= 1"), 8);
    assert!(line.0 <= other.1 && other.0 <= line.1, "{line:?} {other:?}");
    assert!(
        &line.1 - &line.0 < rational(1, 1_000_000) && &other.1 - &other.0 < rational(1, 1000),
        "{line:?} {other:?}"
    );
}

#[test]
fn lags_of_long_platoons_grow_with_the_cube() {
    let of = |m: usize| {
        let keys = format!("followers = {m}\nf = -1\ng = -1\nacceleration = [-1, 1]");
        worst(&platoon(&keys, "\"inf\"", &format!("lag{m} <= 1")), 8)
    };
    let (ten, twenty) = (of(10), of(20));
    let ratio = &twenty.0 / &ten.1;
    assert!(ratio > rational(79, 10) && ratio < rational(81, 10), "{ratio}");
    assert!(&twenty.1 - &twenty.0 < rational(1, 100_000), "{twenty:?}");
}

#[test]
fn the_leader_that_is_shown_attains_it() {
    let text = platoon("followers = 3\nf = -1\ng = -1\nacceleration = [-2, 1]", "20", "lag3 - lag1 <= 1");
    let system = read(&text);
    let found = decided(&text, 8).remove(0);
    let part = &found.parts[0];
    let witness = part.witness.as_ref().expect("a motion");
    let value = witness.value_of(&system, &part.condition.row, 200);
    use arithmetic::Enclosure;
    let (lo, hi) = value.ends().expect("bounded");
    let slack = rational(1, 100_000_000);
    assert!(lo >= &witness.value.lo - &slack && hi <= &witness.value.hi + &slack, "{value} {:?}", witness.value);
    assert!(&witness.value.hi - &witness.value.lo < rational(1, 1_000_000), "{:?}", witness.value);
    // Statements that miss it by little.
    let bound = part.hi.clone().expect("a bound");
    let verdict = |bound: Rational| {
        let check = format!("lag3 - lag1 <= {bound}");
        decided(&platoon("followers = 3\nf = -1\ng = -1\nacceleration = [-2, 1]", "20", &check), 8)[0].verdict
    };
    assert_eq!(verdict(&bound + rational(1, 1_000_000)), Verdict::Holds);
    assert_eq!(verdict(&bound - rational(1, 1_000_000)), Verdict::False);
}

#[test]
fn directed_platoons_are_written_out() {
    let keys = "followers = 2\ngraph = \"front\"\nf = -1\ng = -1\nacceleration = [-1, 1]";
    let found = worst(&platoon(keys, "\"inf\"", "gap2 <= 3"), 6);
    assert!(found.0 > rational(2_0999, 10_000) && found.1 < rational(2_1001, 10_000), "{found:?}");
    let rate = worst(&platoon("followers = 1\nf = -1\ng = -2\nacceleration = [-1, 1]", "\"inf\"", "rate1 <= 3"), 6);
    // The integral of |(1 - t) e^-t|: 2/e.
    let exact = number("2") * (-number("1")).exp().expect("finite");
    close(&rate, &exact, 5);
}

#[test]
fn what_is_no_platoon_is_refused() {
    for (keys, said) in [
        ("followers = 0\nf = -1\ng = -1\nacceleration = [-1, 1]", "from 1 to 2000"),
        ("followers = 2\nf = -1\ng = -1\nacceleration = [1, -1]", "is empty"),
        ("followers = 2\ngraph = \"back\"\nf = -1\ng = -1\nacceleration = [-1, 1]", "front, front-and-back or a graph"),
        ("followers = 2\ngraph = \"star:3\"\nf = -1\ng = -1\nacceleration = [-1, 1]", "the graph says how many"),
        ("tracks = [[0], [3]]\nf = -1\ng = -1\nacceleration = [-1, 1]", "follower 2 cannot keep track of agent 3"),
        ("tracks = [[0], [3], [2]]\nf = -1\ng = -1\nacceleration = [-1, 1]", "which car 2 does not"),
        (
            "followers = 101\ngraph = \"front\"\nf = -1\ng = -1\nacceleration = [-1, 1]",
            "of at most 100 followers, not 101",
        ),
        ("followers = 101\nf = 1\ng = -1\nacceleration = [-1, 1]", "the gains are below 0"),
    ] {
        let error = System::read(&platoon(keys, "9", "lag1 <= 1")).expect_err(keys).to_string();
        assert!(error.contains(said), "{error}\ninstead of\n{said}");
    }
    let unstable = read(&platoon("followers = 2\nf = 1\ng = -1\nacceleration = [-1, 1]", "\"inf\"", "lag1 <= 1"));
    assert!(matches!(decide(&unstable, 8, &Unwatched), Err(ReachError::Unstable { .. })));
}
