//! Synthetic schools are what their documentation says: speed, spacing, circles and walls.

use arithmetic::Complex;
use models::tracks::{School, Setting, Tracks, Vector, synthetic_school};
use std::f64::consts::TAU;

const BODY: f64 = 2.0;
/// Half the width of the tank.
const WALL: f64 = 9.4 * BODY;

fn school(school: School, fish: usize, frames: usize, step: f64) -> Tracks {
    synthetic_school(school, &Setting { fish, frames, step, body_length: BODY, seed: "documented".to_string() })
}

fn place(tracks: &Tracks, k: usize, i: usize) -> Vector {
    tracks.positions[k][i].clone().expect("all are seen in all frames")
}

fn length(x: &Vector) -> f64 {
    x.norm_squared().sqrt()
}

fn mean(list: impl Iterator<Item = Vector>) -> Vector {
    let (sum, count) = list.fold((Complex::new(0.0, 0.0), 0.0), |(sum, count), x| (sum + &x, count + 1.0));
    sum.scale(&(1.0 / count))
}

/// The centre goes round a circle of radius 5 at 2 body lengths per second. Around it each fish has its place for ever, 1.8 from the next one
/// of its row and of its column; every second row is moved along by a sixth of that.
#[test]
fn a_polarised_school_is_a_formation_on_a_circle() {
    let (fish, frames, step) = (49, 400, 0.25);
    let tracks = school(School::Polarised, fish, frames, step);
    let centre = |i: usize| {
        let (sin, cos) = (2.0 * step * i as f64 / 5.0).sin_cos();
        Complex::new(5.0 * BODY * cos, 5.0 * BODY * sin)
    };
    // Each fish strays by 0.15, on average over 49 by a fiftieth; the rows that are moved bring the middle along by less than 0.15.
    for i in 0..frames {
        let middle = mean((0..fish).map(|k| place(&tracks, k, i))) - &centre(i);
        assert!((middle.re / BODY - 0.9 / 7.0).abs() < 0.1 && (middle.im / BODY).abs() < 0.1, "{i}: {middle:?}");
    }
    // Over the whole time, which is 33 times that of their memory, by less than 0.04.
    let own: Vec<Vector> = (0..fish)
        .map(|k| mean((0..frames).map(|i| (place(&tracks, k, i) - &centre(i)).scale(&(1.0 / BODY)))))
        .collect();
    for (k, own) in own.iter().enumerate() {
        let (row, column) = (k / 7, k % 7);
        let x = 1.8 * (column as f64 - 3.0) + 0.3 * (row % 2) as f64;
        let y = 1.8 * (row as f64 - 3.0);
        assert!((own.re - x).abs() < 0.2 && (own.im - y).abs() < 0.2, "fish {k}: {:?}, not {x}, {y}", own);
    }
    assert_eq!(tracks.frames[3].time, 0.75);
}

/// Radius, even spacing along the circle, and speed: 1.9 apart with a radius of at least 2.5, or a radius of 7.
#[test]
fn mills_turn_on_their_circles() {
    let chord = |fish: f64| 1.9 / 2.0 / (TAU / 2.0 / fish).sin();
    assert!(chord(6.0) < 2.5 && chord(20.0) > 6.0);
    for (kind, fish, radius) in [
        (School::Milling, 6, 2.5),
        (School::Milling, 20, chord(20.0)),
        (School::DiffuseMilling, 6, 7.0),
        (School::DiffuseMilling, 20, 7.0),
    ] {
        let (frames, step) = (400, 0.25);
        let tracks = school(kind, fish, frames, step);
        for k in 0..fish {
            let at = |i: usize| place(&tracks, k, i).scale(&(1.0 / BODY));
            // In the frame that turns along, the fish stays around its own place.
            let turned = mean((0..frames).map(|i| {
                let (sin, cos) = (2.0 * step * i as f64 / radius + TAU * k as f64 / fish as f64).sin_cos();
                at(i) * Complex::new(cos, -sin)
            }));
            let out = (0..frames).map(|i| length(&at(i))).sum::<f64>() / frames as f64;
            assert!((out - radius).abs() < 0.25, "{kind:?}, fish {k} of {fish}: {out}, not {radius}");
            let angle = turned.im.atan2(turned.re);
            assert!(angle.abs() < 0.3, "{kind:?}, fish {k} of {fish}: {angle}");
        }
    }
}

/// Fish start anywhere in the tank in any direction, swim at 2 body lengths per second, stay in the tank, and turn back where they meet a wall.
#[test]
fn fish_in_a_tank_keep_their_speed_and_their_walls() {
    for kind in [School::Independent, School::Coupled] {
        let (fish, frames, step) = (24, 300, 0.1);
        let tracks = school(kind, fish, frames, step);
        let (mut hits, full) = (0, 2.0 * step * BODY);
        for k in 0..fish {
            for i in 1..frames {
                let (before, now) = (place(&tracks, k, i - 1), place(&tracks, k, i));
                let way = length(&(now.clone() - &before));
                let met = now.re.abs().max(now.im.abs()) >= WALL * (1.0 - 1e-12);
                assert!(now.re.abs().max(now.im.abs()) <= WALL * (1.0 + 1e-12), "{kind:?}, fish {k}: {now:?}");
                assert!(way <= full * (1.0 + 1e-9) && (met || way >= full * (1.0 - 1e-9)), "{kind:?}, fish {k}: {way}");
                hits += usize::from(met);
                // The way back begins at once.
                for (x, next) in [(before.re, now.re), (before.im, now.im)] {
                    assert!(
                        i == 1 || x.abs() < WALL * (1.0 - 1e-12) || next.abs() < x.abs(),
                        "{kind:?}, fish {k}: {x} {next}"
                    );
                }
            }
        }
        assert!(hits > 10, "{kind:?}: {hits}");
    }
}

/// Over 2000 fish: the mean of uniform places is less than 0.03 of the half width from the middle with four times that to spare, and that of
/// directions less than 0.03 from 0.
#[test]
fn fish_in_a_tank_start_anywhere() {
    let fish = 2000;
    let tracks = school(School::Independent, fish, 2, 0.1);
    let start: Vec<Vector> = (0..fish).map(|k| place(&tracks, k, 0).scale(&(1.0 / WALL))).collect();
    let inner = (0..fish).filter(|&k| start[k].re.abs().max(start[k].im.abs()) < 0.9);
    let ways: Vec<Vector> =
        inner.map(|k| (place(&tracks, k, 1) - &place(&tracks, k, 0)).scale(&(1.0 / (0.2 * BODY)))).collect();
    assert!(ways.len() > 1400);
    for (list, square) in [(&start, 1.0 / 3.0), (&ways, 0.5)] {
        let middle = mean(list.iter().cloned());
        let squares = mean(list.iter().map(|x| Complex::new(x.re * x.re, x.im * x.im)));
        assert!(length(&middle) < 0.1, "{middle:?}");
        assert!((squares.re - square).abs() < 0.05 && (squares.im - square).abs() < 0.05, "{squares:?}");
    }
    assert!(start.iter().all(|x| x.re.abs() <= 1.0 && x.im.abs() <= 1.0));
}

/// The noise is in radians per square root of a second: the mean square of a turn is proportional to the step.
#[test]
fn turns_alone_grow_with_the_root_of_time() {
    let rate = |step: f64| {
        let tracks = school(School::Independent, 30, 200, step);
        let (mut sum, mut count) = (0.0, 0.0);
        for k in 0..30 {
            let places: Vec<Vector> = (0..200).map(|i| place(&tracks, k, i)).collect();
            for three in places.windows(3).filter(|three| three.iter().all(|r| r.re.abs().max(r.im.abs()) < 0.9 * WALL))
            {
                let (a, b) = (three[1].clone() - &three[0], three[2].clone() - &three[1]);
                let turn = (a.re * b.im - a.im * b.re).atan2(a.dot(&b));
                sum += turn * turn / step;
                count += 1.0;
            }
        }
        assert!(count > 1000.0);
        sum / count
    };
    let (slow, quick) = (rate(0.1), rate(0.025));
    // Each is known to 5%.
    assert!(slow > 0.1 && (slow / quick - 1.0).abs() < 0.25, "{slow} {quick}");
}

/// What the turns of a coupled fish have to do with the other one, far from the walls, by distance: towards it in the zone of attraction, along
/// with it in that of orientation, away from it in that of repulsion, and nothing beyond the radius of attraction, 8. Each is the slope of the
/// rate of turning over the sine of the angle to the other, or of its heading; from hundreds of turns or more.
#[test]
fn coupled_fish_turn_by_their_zones() {
    let step = 0.1;
    // By fish and by zone: sum of the products and of the squares.
    let mut slopes = [[(0.0, 0.0); 5]; 2];
    for seed in 0..400 {
        let setting = Setting { fish: 2, frames: 40, step, body_length: 1.0, seed: seed.to_string() };
        let tracks = synthetic_school(School::Coupled, &setting);
        for (i, k) in (2..40).flat_map(|i| [(i, 0), (i, 1)]) {
            let [here, next, last] = [i - 2, i - 1, i].map(|i| place(&tracks, k, i));
            let (other, its_next) = (place(&tracks, 1 - k, i - 2), place(&tracks, 1 - k, i - 1));
            let offset = other.clone() - &here;
            let (heading, after, its) = (next.clone() - &here, last - &next, its_next - &other);
            let sine = |a: &Vector, b: &Vector| (a.re * b.im - a.im * b.re) / (length(a) * length(b));
            let distance = length(&offset);
            let blind = heading.dot(&offset) < -0.8 * length(&heading) * distance;
            if here.re.abs().max(here.im.abs()) > 7.0 || blind {
                continue;
            }
            let rate = sine(&heading, &after).asin() / step;
            let mut add = |zone: usize, sine: f64| {
                let (products, squares) = &mut slopes[k][zone];
                (*products, *squares) = (*products + rate * sine, *squares + sine * sine);
            };
            match distance {
                d if d < 1.4 => add(0, sine(&heading, &offset)),
                d if d < 2.4 => add(1, sine(&heading, &its)),
                d if d < 8.0 => add(2, sine(&heading, &offset)),
                _ => {
                    add(3, sine(&heading, &offset));
                    add(4, sine(&heading, &its));
                }
            }
        }
    }
    for slope in slopes.map(|zones| zones.map(|(products, squares)| products / squares)) {
        let [repulsion, orientation, attraction, beyond, along] = slope;
        assert!((-4.0..-1.0).contains(&repulsion) && (0.5..4.0).contains(&orientation), "{slope:?}");
        assert!((0.4..1.0).contains(&attraction) && beyond.abs() < 0.2 && along.abs() < 0.2, "{slope:?}");
    }
}

#[test]
fn schools_without_fish_or_frames_are_empty() {
    for (_, kind) in School::ALL {
        assert_eq!(school(kind, 0, 5, 0.1).positions.len(), 0);
        assert_eq!(school(kind, 3, 0, 0.1).positions, vec![vec![]; 3]);
    }
}
