//! Rows of long integers against big integers.

use algebra::matrix::{AverageRow, IntegerRows};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{ToPrimitive, Zero};

/// Signed integers of up to so many bits, with those around powers of `2^64` among them.
fn values(count: usize, bits: u64, seed: u64) -> Vec<BigInt> {
    let mut state = seed;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state >> 33
    };
    let mut value = |_| {
        let sign = if next() % 2 == 0 { 1 } else { -1 };
        let edge = BigInt::from(1) << (64 * (next() % (bits / 64 + 1)));
        let long =
            (0..bits / 31 + 1).fold(BigInt::zero(), |x, _| (x << 31u32) + next()) >> (bits / 31 * 31 + 31 - bits);
        match next() % 6 {
            0 => BigInt::zero(),
            1 => edge * sign,
            2 => (edge - 1) * sign,
            _ => long * sign,
        }
    };
    (0..count).map(&mut value).collect()
}

fn read(rows: &IntegerRows) -> Vec<BigInt> {
    (0..rows.count()).map(|i| rows.value(i)).collect()
}

#[test]
fn values_and_differences_are_kept() {
    for bits in [1, 62, 63, 64, 65, 127, 128, 200] {
        let list = values(9, bits, bits);
        let rows = IntegerRows::new(&list);
        assert_eq!((rows.count(), read(&rows)), (9, list.clone()));
        let longest = list.iter().map(BigInt::bits).max().unwrap_or(0);
        assert_eq!(rows.width() as u64, longest / 64 + 2);
        for (i, j) in (0..9).flat_map(|i| (0..9).map(move |j| (i, j))) {
            assert_eq!(rows.difference(i, j), &list[i] - &list[j], "{bits}: {i} {j}");
        }
        assert_eq!((rows.value(9), rows.difference(9, 0)), (BigInt::zero(), BigInt::zero()));
    }
    let zero = IntegerRows::new(&[BigInt::zero()]);
    assert_eq!((zero.width(), zero.bits(0)), (2, 1));
}

#[test]
fn windows_are_floors_where_they_fit() {
    for bits in [5, 64, 127, 128, 129, 190, 300] {
        let list = values(12, bits, 3 * bits + 1);
        let rows = IntegerRows::new(&list);
        for (i, value) in list.iter().enumerate() {
            for shift in (0..330).step_by(7).chain([63, 64, 65, 127, 128, 129, 191, 192]) {
                let floor = value.div_floor(&(BigInt::from(1) << shift));
                assert_eq!(rows.window(i, shift), floor.to_i128(), "{value} {shift}");
            }
            let exact = value.bits();
            assert!((exact..=exact + 1).contains(&rows.bits(i)), "{value}: {} {exact}", rows.bits(i));
        }
    }
    // Both sides of the limits.
    for shift in [0u64, 1, 64, 100] {
        let edge = BigInt::from(1) << (127 + shift);
        let list = [&edge - 1, edge.clone(), -&edge, -&edge - 1, -&edge * 3, &edge << 64u32, -&edge << 64u32];
        let rows = IntegerRows::new(&list);
        let fits: Vec<bool> = (0..list.len()).map(|i| rows.window(i, shift).is_some()).collect();
        let expected: Vec<bool> =
            list.iter().map(|x| x.div_floor(&(BigInt::from(1) << shift)).to_i128().is_some()).collect();
        assert_eq!(fits, expected, "{shift}");
    }
}

/// `x -> factor x + y`, again and again, so that rows grow over many limbs; some rows are only multiplied.
#[test]
fn rows_are_scaled_and_added() {
    let factors = [
        "1",
        "3",
        "4611686018427387903",
        "4611686018427387904",
        "9223372036854775808",
        "340282366920938463463374607431768211455",
    ];
    for factor in factors.map(|text| text.parse::<BigInt>().expect("a number")) {
        for (bits, added) in [(60, 60), (64, 200), (200, 64), (128, 128)] {
            let mut list = values(8, bits, bits + 5);
            let mut rows = IntegerRows::new(&list);
            for round in 0..5 {
                let more = values(5, added, round + added);
                rows.scale_and_add(&factor, &IntegerRows::new(&more));
                list.iter_mut().for_each(|x| *x *= &factor);
                list.iter_mut().zip(&more).for_each(|(x, y)| *x += y);
                assert_eq!(read(&rows), list, "{factor} {bits} {added} {round}");
                assert!(list.iter().all(|x| x.bits() <= 64 * (rows.width() as u64 - 1)), "the top is sign only");
            }
        }
    }
    // Once and a sum that is one limb longer; its sign.
    let edge: BigInt = (BigInt::from(1) << 63u32) - 1;
    let mut rows = IntegerRows::new(&[edge.clone(), -&edge - 1]);
    rows.scale_and_add(&BigInt::from(1), &IntegerRows::new(&[edge.clone(), -&edge - 1]));
    assert_eq!(read(&rows), [&edge * 2, (-&edge - 1) * 2]);
}

/// Averages with none, one, two and many neighbours, of short coefficients and long ones, step after step.
#[test]
fn rows_are_averaged() {
    let near = [vec![], vec![0], vec![2, 0], vec![0, 1, 2, 4], vec![3, 3, 1], vec![4]];
    for coefficients in [(1, 0), (1, 1), (5, 3), ((1 << 59) - 1, 1 << 59), (1 << 61, 1), (i64::MAX, i64::MAX)] {
        for long in [0u32, 70] {
            let (own, other) = (BigInt::from(coefficients.0) << long, BigInt::from(coefficients.1));
            let rule: Vec<AverageRow> =
                near.iter().map(|near| AverageRow::new(own.clone(), other.clone(), near.clone())).collect();
            for bits in [1, 63, 64, 130] {
                let mut list = values(6, bits, bits + 9);
                let mut from = IntegerRows::new(&list);
                let mut to = IntegerRows::new(&values(6, 90, 4));
                for round in 0..4 {
                    to.average(&mut from, &rule);
                    let sum = |i: usize| near[i].iter().map(|&j| &list[j]).sum::<BigInt>();
                    list = (0..6).map(|i| &list[i] * &own + sum(i) * &other).collect();
                    assert_eq!(read(&to), list, "{own} {other} {bits} {round}");
                    std::mem::swap(&mut from, &mut to);
                }
            }
        }
    }
}

/// The largest short coefficients with the largest rows that have their width: nothing is lost on the way.
#[test]
fn the_largest_short_coefficients_fit() {
    for width in [1u32, 2, 3] {
        let edge: BigInt = (BigInt::from(1) << (64 * width)) - 1;
        let list = [edge.clone(), -edge.clone(), edge.clone(), -edge.clone()];
        let (own, other) = (BigInt::from((1u64 << 62) - 1), BigInt::from(((1u64 << 62) - 1) / 3));
        for near in [vec![1usize], vec![1, 3], vec![1, 2, 3]] {
            // own + other (number of neighbours) is below 2^62, and just not.
            for own in [&own - &other * near.len(), own.clone(), BigInt::zero()] {
                let rule: Vec<AverageRow> =
                    (0..4).map(|_| AverageRow::new(own.clone(), other.clone(), near.clone())).collect();
                let (mut from, mut to) = (IntegerRows::new(&list), IntegerRows::new(&list));
                to.average(&mut from, &rule);
                let sum = near.iter().map(|&j| &list[j]).sum::<BigInt>();
                let expected: Vec<BigInt> = list.iter().map(|x| x * &own + &sum * &other).collect();
                assert_eq!(read(&to), expected);
                assert!(expected.iter().all(|x| x.bits() <= 64 * (to.width() as u64 - 1)));
            }
        }
    }
}
