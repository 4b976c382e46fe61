//! What is refused, and in which words.

use algebra::graph::Graph;
use arithmetic::{Unwatched, rational};
use models::double_integrator::{
    Alignment, Flock, HeadingDifference, InputError, MotionError, Network, Options, Potential, State,
};
use motion::Tolerance;

fn potential() -> Potential {
    Potential::inverse_square_log(&rational(1, 1))
}

fn state(positions: &[[f64; 2]], velocities: &[[f64; 2]]) -> State<f64> {
    State { positions: positions.to_vec(), velocities: velocities.to_vec() }
}

fn pair(distance: f64) -> State<f64> {
    state(&[[0.0, 0.0], [distance, 0.0]], &[[1.0, 0.0], [0.0, 1.0]])
}

fn refusal(alignment: Alignment, network: Network, start: State<f64>) -> String {
    Flock::new(alignment, potential(), network, start).expect_err("refused").to_string()
}

#[test]
fn bad_flocks_are_refused_in_one_sentence() {
    let linked = || Network::Fixed(Graph::path(2));
    let within = Network::Within;
    let of = |network, start| refusal(Alignment::Velocity, network, start);
    assert_eq!(of(within(1.0), state(&[], &[])), "there are no agents");
    assert_eq!(of(within(1.0), state(&[[0.0, 0.0]], &[])), "there are 1 positions but 0 velocities");
    assert_eq!(of(within(1.0), pair(f64::NAN)), "the position of agent 2 is not a number below 1e150 in size");
    assert_eq!(of(within(1.0), pair(1e200)), "the position of agent 2 is not a number below 1e150 in size");
    let rushing = state(&[[0.0, 0.0]], &[[0.0, f64::INFINITY]]);
    assert_eq!(of(within(1.0), rushing), "the velocity of agent 1 is not a number below 1e150 in size");
    for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(
            of(within(radius), pair(1.0)),
            format!("the radius R must be a positive number below 1e150, but it is {radius}")
        );
    }
    let triangle = Network::Fixed(Graph::from_fn(3, |_, _| true));
    assert_eq!(of(triangle, pair(1.0)), "the graph has 3 vertices, but there are 2 agents");
    assert_eq!(of(Network::Fixed(Graph::path(1)), pair(1.0)), "the graph has 1 vertices, but there are 2 agents");
    assert_eq!(
        of(linked(), pair(0.0)),
        "agents 1 and 2 are linked and in the same place, where the potential is infinite"
    );
    assert_eq!(
        of(within(1.0), pair(0.0)),
        "agents 1 and 2 are linked and in the same place, where the potential is infinite"
    );
    let close = of(linked(), pair(1e-100));
    assert_eq!(close, "agents 1 and 2 are linked at distance 1e-100, where the potential or its slope is not finite");
    // At the bounds themselves; of several agents the first is told.
    for bound in [1e150, 1e-150] {
        assert!(of(within(bound), pair(1.0)).ends_with(&format!("but it is {bound}")), "{bound}");
    }
    let far = state(&[[0.0, 0.0], [0.0, -1e150], [-1e200, 0.0]], &[[0.0; 2]; 3]);
    assert_eq!(of(within(1.0), far), "the position of agent 2 is not a number below 1e150 in size");
    assert_eq!(of(within(1e-100), pair(1.0)), "the potential or its slope is not finite at the radius R = 1e-100");
}

#[test]
fn headings_are_needed_by_heading_alignment_only() {
    let still = || state(&[[0.0, 0.0], [1.0, 0.0]], &[[1.0, 0.0], [0.0, 0.0]]);
    let most = state(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]], &[[1.0, 0.0], [0.0, 0.0], [0.0, 0.0]]);
    let first = refusal(Alignment::Heading(HeadingDifference::Raw), Network::Fixed(Graph::path(3)), most);
    assert!(first.starts_with("agent 2 is at rest"), "{first}");
    let heading = |difference| Alignment::Heading(difference);
    let linked = || Network::Fixed(Graph::path(2));
    let raw = HeadingDifference::Raw;
    assert_eq!(
        refusal(heading(raw), linked(), still()),
        "agent 2 is at rest and has no heading, which heading alignment needs"
    );
    assert!(Flock::new(Alignment::Velocity, potential(), linked(), still()).is_ok());
    assert_eq!(
        Flock::new(heading(raw), potential(), Network::Within(1.0), pair(2.0)).unwrap_err(),
        InputError::HeadingWithin
    );
    let followed = Flock::new(heading(HeadingDifference::Unwrapped), potential(), linked(), pair(1.0));
    assert_eq!(followed.unwrap_err(), InputError::Unwrapped);
}

#[test]
fn bad_runs_are_refused() {
    let flock = Flock::new(Alignment::Velocity, potential(), Network::Within(1.5), pair(1.0)).unwrap();
    let options = Options::default();
    assert!(matches!(flock.run(f64::NAN, &[], &options, &Unwatched), Err(MotionError::Until(_))));
    assert_eq!(flock.run(-1.0, &[], &options, &Unwatched), Err(MotionError::Until(-1.0)));
    for samples in [vec![2.0], vec![0.5, 0.25], vec![-1.0], vec![f64::NAN], vec![0.1, f64::NAN]] {
        assert!(
            matches!(flock.run(1.0, &samples, &options, &Unwatched), Err(MotionError::Samples { .. })),
            "{samples:?}"
        );
    }
    for (relative, absolute) in [(0.0, 1e-9), (1e-9, 0.0), (f64::NAN, 1e-9), (2.0, 1e-9)] {
        let options = Options { tolerance: Tolerance { relative, absolute }, ..options };
        assert!(matches!(flock.run(1.0, &[], &options, &Unwatched), Err(MotionError::Tolerance(_))));
    }
    assert_eq!(flock.run(0.0, &[0.0, 0.0], &options, &Unwatched).unwrap().samples.len(), 2);
    let few = Options { most_events: 0, ..options };
    let fast = state(&[[0.0, 0.0], [3.0, 0.0]], &[[1.0, 0.0], [0.0, 0.0]]);
    let flock = Flock::new(Alignment::Velocity, potential(), Network::Within(1.5), fast).unwrap();
    let stopped = flock.run(5.0, &[], &few, &Unwatched).unwrap_err().to_string();
    assert!(stopped.ends_with(", the last of agents 1 and 2"), "{stopped}");
}

#[test]
fn singular_motions_stop_with_the_agents_named() {
    // A potential without repulsion: two agents fall into one another. V' = 1/s.
    let falling = Potential::new(vec![(-1, rational(1, 1))], (rational(1, 1), rational(0, 1)));
    let start = state(&[[0.0, 0.0], [5.0, 0.0], [1.0, 0.0]], &[[0.0, 0.0]; 3]);
    let network = Network::Fixed(Graph::from_edges(3, &[(0, 2)]).unwrap());
    let flock = Flock::new(Alignment::Velocity, falling, network, start).unwrap();
    match flock.run(10.0, &[], &Options::default(), &Unwatched) {
        Err(error @ MotionError::Stuck { .. }) => {
            assert!(error.to_string().contains("agents 1 and 3"), "{error}");
        }
        other => panic!("{other:?}"),
    }
}
