//! Platoons by their modes against closed forms, and against the same platoon written out as a system.

use super::{close, consistent, decided, number, read, worst};
use arithmetic::{Enclosure, Number, Rational, Real, Unwatched, parse_rational, rational};
use num_traits::Signed;
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
fn weights_ahead_and_behind_are_those_of_the_law() {
    // Car 1 tracks the leader with 2/3 and car 2 with 1/3; car 2 has nobody behind.
    let keys = |weights: &str| format!("followers = 2\n{weights}\nf = -1\ng = -2\nacceleration = [-1, 1]");
    let other = super::one_mode(
        "[\"x\", \"y\", \"p\", \"q\"]",
        "{ u = [-1, 1] }",
        "{ x = 0, y = 0, p = 0, q = 0 }",
        "[[0, 0, 1, 0], [0, 0, 0, 1], [-1, \"1/3\", -2, \"2/3\"], [1, -1, 2, -2]]",
        "[[0], [0], [-1], [-1]]",
        "15",
        &["y - x <= 9"],
    );
    let other = worst(&other, 8);
    for weights in ["ahead = \"2/3\"", "behind = \"1/3\"", "ahead = 2\nbehind = 1", "ahead = [2, 1]\nbehind = [1, 7]"] {
        let modes = worst(&platoon(&keys(weights), "15", "gap2 <= 9"), 8);
        let slack = rational(1, 1_000_000_000);
        assert!(modes.0 <= &other.1 + &slack && other.0 <= &modes.1 + &slack, "{weights}: {modes:?} {other:?}");
        assert!(&modes.1 - &modes.0 < rational(1, 10_000_000), "{weights}: {modes:?}");
    }
    // Cars that look ahead more do better, and floats separate the modes of a few only.
    let of = |ahead: &str| {
        let keys = format!("followers = 12\nahead = \"{ahead}\"\nf = -1\ng = -1\nacceleration = [-1, 1]");
        worst(&platoon(&keys, "\"inf\"", "gap1 <= 1"), 8)
    };
    let (same, more) = (of("1/2"), of("3/5"));
    assert!(more.1 < same.0 && &more.1 - &more.0 < rational(1, 10_000), "{same:?} {more:?}");
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

/// The one-sided platoon by the same keys, and from the law.
fn one_sided(m: usize, f: &str, g: &str, range: &str, until: &str, check: &str) -> [String; 2] {
    let keys = format!("followers = {m}\ngraph = \"front\"\nf = \"{f}\"\ng = \"{g}\"\nacceleration = {range}");
    let tracks: Vec<Vec<usize>> = (0..m).map(|k| vec![k]).collect();
    let tracks: Vec<&[usize]> = tracks.iter().map(Vec::as_slice).collect();
    let gap = |k: usize| if k > 1 { format!("lag{k} - lag{}", k - 1) } else { "lag1".to_string() };
    let written =
        (1..=m).rev().fold(check.to_string(), |text, k| text.replace(&format!("gap{k} "), &format!("{} ", gap(k))));
    [platoon(&keys, until, check), written_out(&tracks, f, g, range, until, &written)]
}

#[test]
fn cars_one_by_one_are_what_the_written_out_system_is() {
    let cases = [
        (2, "-1", "-1", "[-1, 1]", "\"inf\"", "gap2 <= 9"),
        (2, "-1", "-1", "[-1, 1]", "\"inf\"", "lag2 >= -9"),
        (3, "-1", "-2", "[-9, 1]", "12", "gap3 >= -9"),
        (3, "-2", "-1/3", "[-1, 2]", "\"17/3\"", "2*lag1 - lag3 <= 9"),
        (4, "-1/2", "-5", "[0, 1]", "30", "gap4 >= -9"),
        (5, "-3", "-2", "[-1, 1]", "9", "lag5 - 3*lag2 <= 9"),
        (3, "-1", "-1", "[-1, 1]", "\"1/100\"", "gap2 <= 9"),
    ];
    for (m, f, g, range, until, check) in cases {
        let [one, other] = one_sided(m, f, g, range, until, check).map(|text| worst(&text, 8));
        let slack = rational(1, 1_000_000_000);
        assert!(one.0 <= &other.1 + &slack && other.0 <= &one.1 + &slack, "{m} {f} {g} {until}: {one:?} {other:?}");
        assert!(&one.1 - &one.0 < rational(1, 100_000_000), "{m} {f} {g} {until}: {one:?}");
    }
}

#[test]
fn one_sided_gaps_have_their_closed_forms() {
    // f = -1, g = -2: the response of gap 2 is (t^2 - t^3/6) e^-t, and the integral of its absolute value 1 + 22 e^-6.
    let [text, _] = one_sided(2, "-1", "-2", "[-1, 1]", "\"inf\"", "gap2 <= 3");
    close(&worst(&text, 10), &(number("1") + number("22") * (-number("6")).exp().expect("finite")), 10);
    // Any gap k: (1 + 2 s)^(k-1)/(1 + s)^(2 k), summed on a grid.
    let naive = |k: i32| {
        let binomial = |n: i32, i: i32| (0..i).fold(1.0, |x, j| x * f64::from(n - j) / f64::from(j + 1));
        let factorial = |n: i32| (1..=n).fold(1.0, |x, j| x * f64::from(j));
        let h = |t: f64| -> f64 {
            let term = |i: i32| {
                let sign = if (k - 1 - i) % 2 == 0 { 1.0 } else { -1.0 };
                sign * binomial(k - 1, i) * 2f64.powi(i) * t.powi(2 * k - i - 1) / factorial(2 * k - i - 1)
            };
            (0..k).map(term).sum::<f64>() * (-t).exp()
        };
        (1..120_000).map(|i| h(f64::from(i) * 1e-3).abs() * 1e-3).sum::<f64>()
    };
    for k in [3, 7, 13] {
        let [text, _] = one_sided(k as usize, "-1", "-2", "[-1, 1]", "\"inf\"", &format!("gap{k} <= 3"));
        let (lo, hi) = worst(&text, 10);
        let near = Rational::from_float(naive(k)).expect("finite");
        assert!((&lo - &near).abs() < rational(1, 100_000), "{k}: {lo} {near}");
        assert!(&hi - &lo < rational(1, 1_000_000_000), "{k}: {lo} {hi}");
    }
}

#[test]
fn each_car_more_costs_the_resonance_of_one() {
    // The worst gap is a constant times max |Gamma|^k in the end, and at least max |Gamma|^(k-1) |1/(f + i w g - w^2)|; 1.46789 for f = g = -1.
    let of = |m: usize| worst(&one_sided(m, "-1", "-1", "[-1, 1]", "\"inf\"", &format!("gap{m} <= 9"))[0], 8);
    let (before, last) = (of(119), of(120));
    let ratio = &last.0 / &before.1;
    assert!(ratio > rational(14_678, 10_000) && ratio < rational(14_680, 10_000), "{ratio}");
    assert!(&last.1 - &last.0 < &last.1 * rational(1, 100_000_000), "{last:?}");
    // The statement that it is a little better is false, with a leader who shows it.
    let bound = &last.0 * rational(999_999, 1_000_000);
    let text = &one_sided(120, "-1", "-1", "[-1, 1]", "\"inf\"", &format!("gap120 <= {bound}"))[0];
    let found = decided(text, 8).remove(0);
    assert_eq!(found.verdict, Verdict::False);
}

#[test]
fn cars_that_track_cars_before_them_are_what_the_written_out_system_is() {
    let cases: [Case; 6] = [
        ("tracks = [[0], [0, 1]]", &[&[0], &[0, 1]], "-1", "-1", "[-1, 1]", "lag2 - lag1 <= 9"),
        ("tracks = [[0], [1], [1]]", &[&[0], &[1], &[1]], "-1", "-2", "[-9, 1]", "lag2 + lag3 >= -90"),
        ("tracks = [[0], [0, 1], [0, 1, 2]]", &[&[0], &[0, 1], &[0, 1, 2]], "-3", "-1", "[-1, 2]", "lag3 <= 9"),
        ("tracks = [[3], [0], [2, 0]]", &[&[3], &[0], &[2, 0]], "-1", "-1/3", "[-1, 2]", "2*lag1 - lag3 <= 90"),
        (
            "tracks = [[0], [1], [1, 2], [2, 3]]",
            &[&[0], &[1], &[1, 2], &[2, 3]],
            "-2",
            "-3",
            "[-1, 1]",
            "lag4 - lag3 >= -9",
        ),
        ("tracks = [[0], [0], [1, 2], [0]]", &[&[0], &[0], &[1, 2], &[0]], "-1", "-5", "[0, 1]", "lag3 - lag4 <= 9"),
    ];
    for (graph, tracks, f, g, range, check) in cases {
        for until in ["\"1/100\"", "3", "\"17/3\"", "12"] {
            let keys = format!("{graph}\nf = \"{f}\"\ng = \"{g}\"\nacceleration = {range}");
            let one = worst(&platoon(&keys, until, check), 8);
            let other = worst(&written_out(tracks, f, g, range, until, check), 8);
            let slack = rational(1, 1_000_000_000);
            assert!(one.0 <= &other.1 + &slack && other.0 <= &one.1 + &slack, "{keys} {until}: {one:?} {other:?}");
            assert!(&one.1 - &one.0 < rational(1, 100_000_000), "{keys} {until}: {one:?}");
        }
    }
    // A car more that nobody tracks makes of the line another graph, whose lags are followed themselves.
    let line = worst(&one_sided(30, "-1", "-1", "[-1, 1]", "\"inf\"", "lag30 <= 9")[0], 8);
    let tracks: Vec<String> = (0..31).map(|k| format!("[{}]", if k == 30 { 3 } else { k })).collect();
    let keys = format!("tracks = [{}]\nf = -1\ng = -1\nacceleration = [-1, 1]", tracks.join(", "));
    let more = worst(&platoon(&keys, "\"inf\"", "lag30 <= 9"), 8);
    assert!(line.0 <= more.1 && more.0 <= line.1, "{line:?} {more:?}");
    assert!(&more.1 - &more.0 < &more.1 * rational(1, 100_000_000), "{more:?}");
}

#[test]
fn a_thousand_cars_on_a_directed_graph() {
    // Car k tracks car k/2 and the one before that: at most ten deep.
    let tracked = |k: usize| if k == 1 { "[0]".to_string() } else { format!("[{}, {}]", k / 2, k / 4) };
    let tracks: Vec<String> = (1..=1000).map(tracked).collect();
    let keys = format!("tracks = [{}]\nf = -1\ng = -1\nacceleration = [-1, 1]", tracks.join(", "));
    let (lo, hi) = worst(&platoon(&keys, "\"inf\"", "lag1000 <= 9"), 8);
    assert!(lo.is_positive() && &hi - &lo < &hi * rational(1, 100_000_000), "{lo} {hi}");
    // All cars of a star are alike, and each is the first one of a line.
    let star =
        worst(&platoon("graph = \"star:1001\"\nf = -1\ng = -1\nacceleration = [-1, 1]", "\"inf\"", "lag1000 <= 2"), 8);
    let one = worst(&platoon("followers = 1\nf = -1\ng = -1\nacceleration = [-1, 1]", "\"inf\"", "lag1 <= 2"), 8);
    assert!(star.0 <= one.1 && one.0 <= star.1 && &star.1 - &star.0 < rational(1, 1_000_000_000), "{star:?} {one:?}");
}

#[test]
fn tiny_times_and_weights_that_vanish_are_enclosed() {
    // From rest the first gap is t^2/2 at most, and those behind less: whether floats can hold that or not.
    let power = |x: u32| format!("\"1/1{}\"", "0".repeat(x as usize));
    for digits in [3, 100, 155, 200] {
        let most = (0..2 * digits).fold(rational(1, 2), |x, _| x * rational(1, 10));
        for (m, range) in [(1, "[-1, 1]"), (2, "[-1, 1]"), (3, "[0, 1]")] {
            let (lo, hi) = worst(&one_sided(m, "-1", "-2", range, &power(digits), &format!("gap{m} <= 9"))[0], 8);
            assert!(!lo.is_negative() && lo <= most, "{digits} {m}: {lo}");
            assert!(m > 1 || hi >= &most * rational(99, 100), "{digits}: {hi}");
        }
    }
}

/// Asked so many times before it stops.
struct Later(std::sync::atomic::AtomicUsize);

impl arithmetic::Progress for Later {
    fn is_cancelled(&self) -> bool {
        use std::sync::atomic::Ordering::Relaxed;
        self.0.fetch_update(Relaxed, Relaxed, |left| left.checked_sub(1)).is_err()
    }
}

#[test]
fn eigenvectors_of_many_cars_can_be_left() {
    // A line in which cars 1 and 3 track each other as well.
    let tracked = |k: usize| match k {
        1 => "[0, 2, 3]".to_string(),
        3 => "[1, 2, 4]".to_string(),
        400 => "[399]".to_string(),
        _ => format!("[{}, {}]", k - 1, k + 1),
    };
    let tracks: Vec<String> = (1..=400).map(tracked).collect();
    let keys = format!("tracks = [{}]\nf = -1\ng = -1\nacceleration = [-1, 1]", tracks.join(", "));
    let system = read(&platoon(&keys, "\"inf\"", "lag1 <= 1"));
    for asked in [0, 1, 2, 4] {
        let stopped = decide(&system, 8, &Later(asked.into()));
        assert!(matches!(stopped, Err(ReachError::Cancelled(_))), "{asked}: {stopped:?}");
    }
}

#[test]
fn directed_platoons_are_written_out() {
    let keys = "tracks = [[0, 3], [1], [2]]\nf = -1\ng = -1\nacceleration = [-1, 1]";
    let other = written_out(&[&[0, 3], &[1], &[2]], "-1", "-1", "[-1, 1]", "9", "lag2 - lag1 <= 3");
    assert_eq!(worst(&platoon(keys, "9", "gap2 <= 3"), 6), worst(&other, 6));
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
            "followers = 101\ngraph = \"front\"\nf = -1\ng = 1\nacceleration = [-1, 1]",
            "of at most 100 followers, not 101",
        ),
        (
            "followers = 2\nahead = 1\nbehind = 1\ngraph = \"front\"\nf = -1\ng = -1\nacceleration = [-1, 1]",
            "ahead and behind",
        ),
        ("followers = 2\nahead = [1, 2, 3]\nf = -1\ng = -1\nacceleration = [-1, 1]", "a platoon, but"),
        ("followers = 101\nf = 1\ng = -1\nacceleration = [-1, 1]", "the gains are below 0"),
    ] {
        let error = System::read(&platoon(keys, "9", "lag1 <= 1")).expect_err(keys).to_string();
        assert!(error.contains(said), "{error}\ninstead of\n{said}");
    }
    let pushed = read(&platoon("followers = 2\nf = 1\ng = -1\nacceleration = [-1, 1]", "1", "lag1 <= 1"));
    let text = reach::answer::text(&pushed, &decide(&pushed, 8, &Unwatched).expect("an answer"), 8);
    assert!(text.contains("f = 1 is not below 0: the law is"), "{text}");
    let unstable = read(&platoon("followers = 2\nf = 1\ng = -1\nacceleration = [-1, 1]", "\"inf\"", "lag1 <= 1"));
    assert!(matches!(decide(&unstable, 8, &Unwatched), Err(ReachError::Unstable { .. })));
}

/// A graph stands in a file, whose vertex `leader` leads, and weights in a text as on the command line.
#[test]
fn graphs_stand_in_files_and_weights_in_texts() {
    let gains = "f = -1\ng = -1\nacceleration = [-1, 1]";
    let text = |keys: &str| platoon(&format!("{keys}\n{gains}"), "9", "lag1 <= 1");
    let files = |name: &str| match name {
        "net" => Ok("a b\nb leader\n".to_string()),
        _ => Err(format!("no {name}")),
    };
    let lag = |system: &System| {
        let found = decide(system, 12, &Unwatched).expect("an answer");
        (found[0].parts[0].lo.clone(), found[0].parts[0].hi.clone())
    };
    let of_file = System::read_beside(&text("graph = \"file:net\""), &files).expect("a system");
    // The leader first, then a, which tracks b, and b, which tracks both.
    let written = read(&text("tracks = [[2], [0, 1]]"));
    assert_eq!(lag(&of_file), lag(&written));
    let error = System::read_beside(&text("graph = \"file:other\""), &files).expect_err("no file").to_string();
    assert!(error.contains("line 2: `platoon.graph`") && error.contains("no other"), "{error}");
    let error = System::read(&text("graph = \"file:net\"")).expect_err("no files").to_string();
    assert!(error.contains("no files are read here"), "{error}");
    let each = read(&text("followers = 3\nahead = \"1/2, 2/3, 1\"\nbehind = \"each:1/2,1/3,0\""));
    let listed = read(&text("followers = 3\nahead = [\"1/2\", \"2/3\", 1]\nbehind = [\"1/2\", \"1/3\", 0]"));
    assert_eq!(lag(&each), lag(&listed));
}

/// A motion that is asked for at a late time rests until it has to begin.
#[test]
fn motions_at_one_time_last_until_then() {
    let text =
        format!("{}at = 500\n", platoon("followers = 3\nf = -1\ng = -1\nacceleration = [-1, 1]", "600", "lag3 <= 100"));
    let part = decided(&text, 8).remove(0).parts.remove(0);
    consistent(&part);
    let witness = part.witness.as_ref().expect("a motion");
    assert_eq!(witness.at, rational(500, 1));
    assert!(witness.inputs[0].windows(2).all(|pair| pair[0].0 < pair[1].0), "{:?}", witness.inputs[0]);
    let row: Vec<Rational> = (0..6).map(|i| rational(i64::from(i == 2), 1)).collect();
    let value = witness.value_of(&read(&text), &row, 300);
    let (lo, hi) = value.ends().expect("bounded");
    let (low, high) = (part.lo.as_ref().expect("lo"), part.hi.as_ref().expect("hi"));
    let slack = rational(1, 1_000_000);
    assert!(lo <= high + &slack && hi >= low - &slack, "{value} {low} {high}");
}
