//! Matrices of digits against matrices of long integers.

use super::*;
use arithmetic::Unwatched;
use num_traits::Zero;

/// Long integers of so many digits at most: pseudorandom ones, zeros, and those whose digits are all as large as they can be.
fn entries(count: usize, digits: usize, seed: u64) -> Vec<BigUint> {
    let mut state = seed;
    let mut next = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state >> 33
    };
    let largest = (BigUint::from(1u8) << (digits * DIGIT_BITS as usize)) - 1u8;
    let mut entry = |_| match next() % 5 {
        0 => BigUint::zero(),
        1 => largest.clone(),
        2 => &largest - 1u8 - (&largest >> 1),
        _ => BigUint::new((0..digits).map(|_| next() as u32).collect()) & &largest,
    };
    (0..count).map(&mut entry).collect()
}

fn assert_product(rows: usize, inner: usize, cols: usize, digits: (usize, usize)) {
    let (a, b) = (entries(rows * inner, digits.0, 1 + digits.0 as u64), entries(inner * cols, digits.1, 77));
    let (left, right) = (DigitMatrix::from_entries(rows, inner, &a), DigitMatrix::from_entries(inner, cols, &b));
    let found = left.times(&right, &Unwatched).expect("not stopped");
    let naive =
        (0..rows * cols).map(|at| (0..inner).map(|k| &a[at / cols * inner + k] * &b[k * cols + at % cols]).sum());
    let naive: Vec<BigUint> = naive.collect();
    assert_eq!((found.rows, found.cols), (rows, cols));
    assert!(found.entries().eq(naive.iter().cloned()), "{rows} x {inner} x {cols}, {digits:?} digits");
    // No plane of zeros on top, but for the zero matrix.
    let bits = naive.iter().map(BigUint::bits).max().unwrap_or(0).max(1);
    assert_eq!(found.planes.len(), rows * cols * bits.div_ceil(u64::from(DIGIT_BITS)) as usize);
}

#[test]
fn entries_are_kept_digit_by_digit() {
    for digits in [1, 2, 3, 7, 8, 9, 16, 17] {
        for (rows, cols) in [(1, 1), (2, 3), (3, 1)] {
            let list = entries(rows * cols, digits, digits as u64);
            let matrix = DigitMatrix::from_entries(rows, cols, &list);
            assert!(matrix.entries().eq(list.iter().cloned()));
            for (at, entry) in list.iter().enumerate() {
                assert_eq!(matrix.is_zero(at / cols, at % cols), entry.is_zero());
                for (l, plane) in matrix.planes.chunks(rows * cols).enumerate() {
                    let digit = (entry >> (l as u32 * DIGIT_BITS) as usize) % (1u32 << DIGIT_BITS);
                    assert_eq!(BigUint::from(plane[at]), digit);
                }
            }
        }
    }
    let zero = DigitMatrix::from_entries(1, 2, &[BigUint::zero(), BigUint::zero()]);
    assert_eq!(zero.planes, [0, 0]);
    // Only a high digit: not zero.
    let high = DigitMatrix::from_entries(1, 2, &[BigUint::from(1u8) << 60, BigUint::zero()]);
    assert!(!high.is_zero(0, 0) && high.is_zero(0, 1));
}

#[test]
fn products_agree_in_all_shapes() {
    // Tiles of four rows and several columns, sums of up to 256 products and more.
    for rows in [1, 3, 4, 5, 9] {
        for cols in [1, 2, 4, 5, 8, 9, 17] {
            assert_product(rows, 2, cols, (2, 3));
        }
    }
    for inner in [1, 7, 255, 256, 257, 520] {
        assert_product(2, inner, 3, (1, 2));
    }
}

/// Around 32 digits, and around lengths of which one is two thirds of the other; more than 64 of them together.
#[test]
fn products_of_long_entries_agree() {
    for digits in [(1, 90), (31, 31), (31, 33), (32, 32), (32, 48), (32, 49), (33, 47), (48, 32), (65, 66), (70, 130)] {
        assert_product(1, 2, 1, digits);
        assert_product(2, 1, 3, digits);
    }
    assert_product(1, 1, 1, (140, 131));
    for count in 1..70 {
        assert_product(1, 1, 1, (count, count));
    }
}

#[test]
fn the_largest_excess_is_that_of_all_pairs() {
    for digits in [1, 2, 5, 9, 16] {
        for (rows, cols) in [(1, 3), (2, 1), (2, 4), (5, 3)] {
            for seed in 0..4 {
                let list = entries(rows * cols, digits, seed + digits as u64);
                let row = |i: usize| &list[i * cols..(i + 1) * cols];
                let more = |a: &BigUint, b: &BigUint| if a > b { a - b } else { BigUint::zero() };
                let excess = |i: usize, j: usize| row(i).iter().zip(row(j)).map(|(a, b)| more(a, b)).sum::<BigUint>();
                let pairs = (0..rows).flat_map(|i| (0..rows).map(move |j| (i, j)));
                let naive = pairs.map(|(i, j)| excess(i, j)).max().unwrap_or_default();
                let found = DigitMatrix::from_entries(rows, cols, &list).largest_excess(&Unwatched);
                assert_eq!(found, Ok(naive), "{rows} x {cols}, {digits} digits");
            }
        }
    }
}

/// Eight differences of almost `2^128`: the sum has a limb more.
#[test]
fn sums_of_differences_carry() {
    let largest: BigUint = (BigUint::from(1u8) << 128) - 1u8;
    let list = [vec![largest.clone(); 8], vec![BigUint::from(1u8); 8]].concat();
    let found = DigitMatrix::from_entries(2, 8, &list).largest_excess(&Unwatched);
    assert_eq!(found, Ok((largest - 1u8) * 8u8));
    let mut sum = vec![u64::MAX, 0];
    add_difference(&mut sum, &[5], &[3]);
    assert_eq!(sum, [1, 1]);
    add_difference(&mut sum, &[0], &[1]);
    assert_eq!(sum, [0, 1]);
    add_difference(&mut sum, &[0], &[1]);
    assert_eq!(sum, [u64::MAX, 0]);
    assert!(is_greater(&[0, 2], &[9, 1]) && !is_greater(&[9, 1], &[0, 2]) && !is_greater(&[4, 4], &[4, 4]));
}

#[test]
fn products_and_excesses_can_be_stopped() {
    struct Stopped;
    impl Progress for Stopped {
        fn is_cancelled(&self) -> bool {
            true
        }
    }
    for digits in [1, 40] {
        let matrix = DigitMatrix::from_entries(2, 2, &entries(4, digits, 5));
        assert_eq!(matrix.times(&matrix, &Stopped).err(), Some(Cancelled));
        assert_eq!(matrix.largest_excess(&Stopped), Err(Cancelled));
    }
}
