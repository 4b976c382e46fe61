//! Delays against sums over frames, planted leaders, and fish that do not know each other.

use super::measures::setting;
use arithmetic::Unwatched;
use arithmetic::random::{generator, normal};
use models::tracks::{Delays, DelaysError, Motion, School, Smoothing, Tracks, delays, synthetic_school};

/// Fish whose headings turn at random, each by a given number of frames behind the first, at unit speed, 20 frames a second.
fn followers(behind: &[usize], frames: usize, noise: f64) -> Tracks {
    let mut random = generator("test", "leaders", behind.len() as u64);
    let longest = behind.iter().max().copied().unwrap_or(0);
    let (mut angle, mut turn, mut way) = (0.0, 0.0, Vec::new());
    for _ in 0..frames + longest {
        turn = 0.9 * turn + 0.05 * normal(&mut random);
        angle += turn;
        way.push(angle);
    }
    let mut text = String::from("t,id,x,y\n");
    for (k, late) in behind.iter().enumerate() {
        let (mut x, mut y) = (10.0 * k as f64, 0.0);
        for i in 0..frames {
            let angle: f64 = way[i + longest - late] + noise * normal(&mut random);
            x += angle.cos();
            y += angle.sin();
            text += &format!("{},{k},{x},{y}\n", i as f64 / 20.0);
        }
    }
    Tracks::from_csv(&text).expect("a recording")
}

fn of(tracks: &Tracks, seconds: f64) -> Delays {
    let motion = Motion::new(tracks, Smoothing::Mean, 3, 0.0);
    delays(tracks, &motion, seconds, &Unwatched).expect("delays")
}

#[test]
fn planted_leaders_are_found() {
    let tracks = followers(&[0, 4, 11], 3000, 0.05);
    let found = of(&tracks, 1.0);
    assert_eq!(found.largest, 20);
    let lags: Vec<_> = found.pairs.iter().map(|pair| (pair.pair, pair.frames)).collect();
    assert_eq!(lags, [([0, 1], 4), ([0, 2], 11), ([1, 2], 7)]);
    assert_eq!(found.lead, [Some(7.5), Some(1.5), Some(-9.0)]);
    for pair in &found.pairs {
        assert!(pair.correlation > 0.9 && pair.share_at_least().is_some_and(|p| p < 0.05), "{pair:?}");
    }
    // The other way round, and beyond the largest lag.
    let turned = of(&followers(&[11, 0], 3000, 0.05), 1.0);
    assert_eq!((turned.pairs[0].frames, &turned.lead[..]), (-11, &[Some(-11.0), Some(11.0)][..]));
    let late = of(&followers(&[0, 40], 3000, 0.0), 1.0);
    assert_eq!(late.pairs[0].frames, 20);
}

/// The sums of the definition, with holes in the recording.
#[test]
fn correlations_are_those_of_sums_over_frames() {
    let whole = synthetic_school(School::Coupled, &setting(3, 300)).to_csv();
    let kept = |(line, row): &(usize, &str)| {
        *line == 0 || !((line * 7) % 31 < 2 || (400..460).contains(line)) || row.is_empty()
    };
    let text: String = whole.lines().enumerate().filter(kept).map(|(_, row)| format!("{row}\n")).collect();
    let tracks = Tracks::from_csv(&text).expect("a recording");
    let motion = Motion::new(&tracks, Smoothing::Mean, 1, 0.0);
    let found = delays(&tracks, &motion, 2.0, &Unwatched).expect("delays");
    let largest = found.largest as i64;
    let by_number = |fish: usize, number: i64| {
        let i = tracks.frames.iter().position(|frame| frame.number as i64 == number)?;
        motion.headings[fish][i].clone()
    };
    let naive = |i: usize, j: usize, lag: i64| {
        let terms: Vec<f64> = (0..tracks.recorded_frames() as i64)
            .filter_map(|t| {
                let (a, b) = (by_number(i, t)?, by_number(j, t + lag)?);
                Some(a.re * b.re + a.im * b.im)
            })
            .collect();
        (terms.len() >= 10).then(|| terms.iter().sum::<f64>() / terms.len() as f64)
    };
    assert_eq!(found.pairs.len(), 3);
    for pair in &found.pairs {
        let [i, j] = pair.pair;
        assert_eq!(pair.curve.len() as i64, 2 * largest + 1);
        for (lag, value) in (-largest..=largest).zip(&pair.curve).step_by(3) {
            let known = naive(i, j, lag);
            assert_eq!(known.is_some(), value.is_some());
            assert!((known.unwrap_or(0.0) - value.unwrap_or(0.0)).abs() < 1e-9, "{lag}: {known:?} {value:?}");
        }
        let best = (-largest..=largest).filter_map(|lag| naive(i, j, lag)).fold(f64::MIN, f64::max);
        assert!((best - pair.correlation).abs() < 1e-9);
        assert!((naive(i, j, pair.frames).expect("known") - best).abs() < 1e-9);
        // Windows of 41 lags from 21 to 150, on both sides.
        let high = |lags: std::ops::Range<i64>| lags.filter_map(|lag| naive(i, j, lag)).fold(f64::MIN, f64::max);
        let windows: Vec<f64> =
            (0..3).flat_map(|k| [high(21 + 41 * k..62 + 41 * k), high(-61 - 41 * k..-20 - 41 * k)]).collect();
        assert_eq!(pair.beyond, (windows.iter().filter(|c| **c >= best - 1e-9).count(), 6));
        assert_eq!(pair.share_at_least(), None);
    }
}

/// Fish alone: the shares are those of chance. Equal correlations give the lag 0, and lags that make no sense are refused.
#[test]
fn fish_alone_have_no_leader() {
    let mut small = 0;
    for seed in 0..30 {
        let setting = models::tracks::Setting { seed: seed.to_string(), ..setting(2, 3000) };
        let found = of(&synthetic_school(School::Independent, &setting), 1.0);
        small += usize::from(found.pairs[0].share_at_least().expect("windows") <= 0.1);
    }
    assert!(small <= 8, "{small} of 30 pairs with p at most 0.1");
    let straight: String = (0..60).map(|i| format!("{i},a,{i},0\n{i},b,{i},1\n")).collect();
    let tracks = Tracks::from_csv(&format!("t,id,x,y\n{straight}")).expect("a recording");
    let found = of(&tracks, 5.0);
    assert_eq!((found.pairs[0].frames, found.pairs[0].at_once.map(|c| (c - 1.0).abs() < 1e-9)), (0, Some(true)));
    assert_eq!(found.lead, [Some(0.0), Some(0.0)]);
    let motion = Motion::new(&tracks, Smoothing::Mean, 3, 0.0);
    for seconds in [0.0, 0.4, 16.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(delays(&tracks, &motion, seconds, &Unwatched), Err(DelaysError::Longest { .. })), "{seconds}");
    }
}
