//! The comparison of a recording with null models: by hand where fish swim straight, and against naive twins.

use super::measures::{Asked, setting};
use arithmetic::random::{generator, uniform};
use arithmetic::{Cancelled, Progress, Unwatched};
use models::tracks::{
    Analysis, Choices, Comparison, Histogram, NearestRule, NullKind, Scale, School, Statistics, Tracks, analyse,
    null_models, synthetic_school, uniform_draw, uniform_draws,
};
use std::sync::Mutex;
use std::sync::atomic::AtomicUsize;

fn analysed(tracks: &Tracks) -> Analysis {
    let choices = Choices { window: 1, rule: NearestRule::Nearest, ..Choices::of_sidebar(tracks.step) };
    analyse(tracks, &choices, &Unwatched).expect("analysed")
}

/// Fish that swim along the x axis, each to its own side, at heights that may change from frame to frame in steps that are small beside
/// the speed.
fn along(directions: &[f64], heights: impl Fn(usize) -> Vec<f64>, frames: usize) -> Analysis {
    let mut text = String::from("t,id,x,y\n");
    for i in 0..frames {
        for (k, (way, y)) in directions.iter().zip(heights(i)).enumerate() {
            text.push_str(&format!("{i},{k},{},{y}\n", way * i as f64 / 64.0));
        }
    }
    analysed(&Tracks::from_csv(&text).expect("a recording"))
}

/// What was told, in the order of the numbers.
#[derive(Default)]
pub struct Told(Mutex<Vec<(u64, String, Option<u64>)>>);

impl Told {
    pub fn all(self) -> Vec<(u64, String, Option<u64>)> {
        let mut all = self.0.into_inner().expect("no test has failed");
        all.sort();
        all
    }
}

impl Progress for Told {
    fn is_cancelled(&self) -> bool {
        false
    }

    fn tell(&self, stage: &str, done: u64, total: Option<u64>) {
        self.0.lock().expect("no test has failed").push((done, stage.to_string(), total));
    }
}

/// Headings that never change are the same after every shift: whatever is observed, all shifts have it.
#[test]
fn fish_on_straight_ways_look_like_themselves_with_headings_shifted() {
    // Two swim to the right and two to the left, each beside the other of its direction.
    let analysis = along(&[1.0, 1.0, -1.0, -1.0], |_| vec![0.0, 1.0, 3.0, 4.5], 22);
    let null = null_models(&analysis.sample(), 7, "straight", &Unwatched).expect("to its end");
    assert_eq!((null.shifts, null.shifted.len()), (7, 2));
    // W_1 for n = 3 is (4/2)(1 - 0). For n = 1 the neighbours are 2, 1, 4, 3, and agree.
    let known = Scale::ALL.map(|scale| 2.0 * scale.factor(3));
    assert_eq!((null.observed.positive, null.observed.order, null.in_pairs), ([1.0; 3], 0.0, 1.0));
    assert!(null.observed.difference.iter().zip(known).all(|(a, b)| (a - b).abs() < 1e-14), "{:?}", null.observed);
    let (kind, comparisons, histogram) = &null.shifted[0];
    assert_eq!(*kind, NullKind::Headings);
    for (found, observed) in comparisons.iter().zip(null.observed.values()) {
        // Nothing to compare: no arcs, or distances, which stay.
        let (Some(found), Some(observed)) = (found, observed) else {
            assert!(found.is_none());
            continue;
        };
        assert!((found.mean - observed).abs() < 1e-14);
        let known = Comparison {
            observed,
            mean: found.mean,
            range: (observed, observed),
            at_least: (7, 7),
            share_at_least: 1.0,
            share_at_most: 1.0,
        };
        assert_eq!(*found, known);
    }
    // Twenty frames have a velocity, and the difference of the figure is 1 in all of them.
    assert_eq!((histogram.total(), histogram.counts.last()), (7 * 20, Some(&140)));
    assert_eq!(histogram.range, (-1.0, 1.0));
}

/// The share of frames in which each fish is the neighbour of its neighbour.
#[test]
fn fish_form_pairs_where_they_are_neighbours_of_each_other() {
    let share = |analysis: &Analysis| null_models(&analysis.sample(), 0, "pairs", &Unwatched).expect("done").in_pairs;
    // Two pairs, until the third fish comes nearer to the second than to the fourth.
    let four = |i: usize| if i < 6 { vec![0.0, 1e-3, 3e-3, 4e-3] } else { vec![0.0, 2e-3, 3e-3, 6e-3] };
    // Frames 1 to 16 have velocities.
    assert_eq!(share(&along(&[1.0; 4], four, 18)), 5.0 / 16.0);
    // Of three fish one is always left over: the third, the first, the one between the others by number.
    let lists = [[0.0, 1e-3, 3e-3], [0.0, 2e-3, 3e-3], [0.0, 3e-3, 1e-3]];
    for list in lists {
        assert_eq!(share(&along(&[1.0; 3], |_| list.to_vec(), 12)), 0.0);
    }
    assert_eq!(share(&along(&[1.0; 3], |i| lists[i % 3].to_vec(), 12)), 0.0);
    assert_eq!(share(&along(&[1.0; 2], |_| vec![0.0, 1.0], 12)), 1.0);
}

/// Ranks, sums and counts of sorted lists.
fn twin(observed: f64, mut list: Vec<f64>) -> Comparison {
    // Of 41 values the second from each end: 2.5% and 97.5% of the way from the first to the last.
    assert_eq!(list.len(), 41);
    let at_least = list.iter().filter(|x| **x > observed - 2e-12).count();
    let mean = list.iter().sum::<f64>() / 41.0;
    list.sort_by(f64::total_cmp);
    let share_at_least = (at_least as f64 + 1.0) / 42.0;
    let share_at_most = (list.iter().filter(|x| **x < observed + 2e-12).count() as f64 + 1.0) / 42.0;
    Comparison { observed, mean, range: (list[1], list[39]), at_least: (at_least, 41), share_at_least, share_at_most }
}

/// Every fish is shifted by a number of frames of its own, anything from 0 to one less than there are.
#[test]
fn shifts_are_compared_as_by_a_naive_twin() {
    let (fish, shifts) = (5, 41);
    for school in [School::Coupled, School::Independent] {
        let sample = analysed(&synthetic_school(school, &setting(fish, 34))).sample();
        assert_eq!(sample.frames(), 32);
        let told = Told::default();
        let null = null_models(&sample, shifts, "twin", &told).expect("to its end");
        let observed = null.observed.values();
        assert_eq!(
            null.shifted.iter().map(|(kind, ..)| *kind).collect::<Vec<_>>(),
            [NullKind::Headings, NullKind::Tracks]
        );
        for (kind, comparisons, histogram) in &null.shifted {
            let mut all = Vec::new();
            let mut counts = Histogram::new(-1.0, 1.0, histogram.counts.len());
            for replicate in 0..shifts {
                let mut random = generator("twin", kind.name(), replicate as u64);
                let shift: Vec<usize> = (0..fish).map(|_| (32.0 * uniform(&mut random)).floor() as usize).collect();
                let statistics = sample.statistics(*kind, &shift);
                counts.merge(&statistics.histogram);
                all.push(statistics.values());
            }
            assert_eq!((histogram, counts.total()), (&counts, 41 * 32));
            for (c, found) in comparisons.iter().enumerate() {
                // Distances stay where headings are shifted, and are not compared.
                let stays = *kind == NullKind::Headings && Statistics::NAMES[c] == "nearest_distance";
                assert_eq!(found.is_none(), stays);
                let (Some(found), Some(known)) = (*found, observed[c]) else { continue };
                let twin = twin(known, all.iter().map(|row| row[c].expect("a number")).collect());
                assert!((found.mean - twin.mean).abs() < 1e-12);
                assert_eq!(found, Comparison { mean: found.mean, ..twin }, "{c} of {}", kind.name());
            }
        }
        // Each shift of both kinds is told once.
        assert_eq!(told.all(), (1..=82).map(|done| (done, "shifts".to_string(), Some(82))).collect::<Vec<_>>());
        // Work that is stopped has no result.
        for asked in [0, 1, 81] {
            let stopped = null_models(&sample, shifts, "twin", &Asked(AtomicUsize::new(asked)));
            assert_eq!(stopped.expect_err("stopped"), Cancelled);
        }
    }
}

/// `W_1` for all neighbours and for one.
type Draw = (f64, f64);

/// At least 20000 draws, as often on the network of each frame.
#[test]
fn uniform_headings_are_drawn_on_each_network_as_often() {
    for frames in [40, 33] {
        let analysis = analysed(&synthetic_school(School::Coupled, &setting(3, frames + 2)));
        let shares = null_models(&analysis.sample(), 0, "drawn", &Unwatched).expect("to its end").uniform;
        let networks: Vec<&Vec<usize>> = analysis.groups().map(|(_, group)| &group.partners).collect();
        assert_eq!(networks.len(), frames);
        let rounds = 20_000usize.div_ceil(frames);
        assert_eq!(shares.draws, rounds * frames);
        let mut random = generator("drawn", "tracks.uniform", 0);
        let draws: Vec<Draw> = (0..rounds * frames).map(|d| uniform_draw(networks[d % frames], &mut random)).collect();
        for (scale, positive) in Scale::ALL.iter().zip(shares.positive) {
            assert_eq!(draws.iter().filter(|(all, one)| scale.difference(3, *all, *one) > 1e-12).count(), positive);
        }
        // The figure scales both potentials to [0, 1], here by 2/3 and 1; all three histograms have bins of one width.
        let values: [fn(&Draw) -> f64; 3] =
            [|(all, _)| 2.0 / 3.0 * all, |(_, one)| *one, |(all, one)| 2.0 / 3.0 * all - one];
        for (found, (value, low)) in shares.histograms.iter().zip(values.into_iter().zip([0.0, 0.0, -1.0])) {
            let bins = (20.0 * (1.0 - low)) as usize;
            assert_eq!(*found, Histogram::of(low, 1.0, bins, draws.iter().map(value)));
            assert_eq!(found.outside, (0, 0));
        }
    }
}

/// `W_1` of independent uniform headings has the mean `n/2`. Over 16000 draws of eight fish the standard deviation of the mean is below
/// 0.0015 for one neighbour, where at most four pairs count twice, and below 0.005 for seven.
#[test]
fn independent_uniform_headings_have_the_mean_potentials_of_the_circle() {
    let mut random = generator("test", "uniform", 0);
    let draws = uniform_draws(8, 16_000, &mut random);
    assert_eq!(draws.len(), 16_000);
    let mean = |of: fn(&Draw) -> f64| draws.iter().map(of).sum::<f64>() / 16_000.0;
    let (all, one) = (mean(|d| d.0), mean(|d| d.1));
    assert!((all - 3.5).abs() < 0.02 && (one - 0.5).abs() < 0.006, "{all} {one}");
    assert!(draws.iter().all(|(all, one)| (0.0..=4.0).contains(all) && (0.0..=1.0).contains(one)));
}
