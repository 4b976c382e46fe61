//! Certificates of small cases and their Coq files, to the letter; what is refused for its size. The separate checker accepts what is in
//! `certificates.txt`, each by itself.

use algebra::graph::Graph;
use algebra::matrix::{MatrixError, RationalMatrix, StochasticMatrix};
use arithmetic::rational;
use models::averaging::{FlockError, Hysteresis, Start, Weights};
use models::platoon::Gains;
use proofs::certificates::{
    Certificate, CertificateError, CoqTheorem, Inertia, Limit, Peak, Product, Switches, coq_file,
};

type Made = Result<Certificate, CertificateError>;

fn inertia(rows: &[[i64; 3]], over: i64) -> Made {
    Ok(Certificate::Inertia(Inertia::new(&RationalMatrix::from_integers(rows, over)?)?))
}

fn product(factors: &[StochasticMatrix]) -> Made {
    Ok(Certificate::Product(Product::new(factors)?))
}

fn limit(network: &Graph, weights: Weights) -> Made {
    Ok(Certificate::Limit(Limit::new(network, &weights)?))
}

fn switches(start: &Start, until: u64) -> Made {
    Ok(Certificate::Switches(Switches::new(start, until)?))
}

fn peak(followers: u64) -> Made {
    Ok(Certificate::Peak(Peak::new(&Gains { f: rational(-2, 1), g: rational(-1, 3) }, followers)?))
}

fn four_birds(weights: Weights, hysteresis: Hysteresis) -> Start {
    let x = [0, 8, 21, 29].map(|x| rational(x, 16)).to_vec();
    let v = [11, 5, 11, 5].map(|v| rational(v, 24)).to_vec();
    Start::on_the_line(x, v, weights, hysteresis)
}

fn planar() -> Start {
    let row = |x: i64, y: i64| vec![rational(x, 2), rational(y, 5)];
    Start {
        positions: vec![row(0, 0), row(1, 4)],
        velocities: vec![row(0, 0), row(1, 0)],
        weights: Weights::Given(vec![rational(1, 3), rational(1, 4), rational(1, 7)]),
        hysteresis: Hysteresis::Constant(rational(1, 9)),
    }
}

/// A ring of four in space, given with more weights than birds.
fn square() -> Start {
    let row = |x: i64, y: i64| vec![rational(x, 1), rational(y, 1), rational(1, 3)];
    Start {
        positions: vec![row(0, 0), row(1, 0), row(1, 1), row(0, 1)],
        velocities: vec![vec![rational(1, 2); 3]; 4],
        weights: Weights::Given((3..8).map(|k| rational(1, k)).collect()),
        hysteresis: Hysteresis::None,
    }
}

/// `n` birds at rest, far from one another.
fn at_rest(birds: usize, dimension: usize, hysteresis: Hysteresis) -> Start {
    let place = |i: usize| vec![rational(2 * i as i64, 1); dimension];
    Start {
        positions: (0..birds).map(place).collect(),
        velocities: vec![vec![rational(0, 1); dimension]; birds],
        weights: Weights::Vicsek,
        hysteresis,
    }
}

fn examples() -> Vec<Certificate> {
    let first = StochasticMatrix::from_integers(&[[2, 4], [4, 2]], 6).unwrap();
    let second = StochasticMatrix::from_integers(&[[1, 3], [0, 4]], 4).unwrap();
    let wide = StochasticMatrix::from_integers(&[[1, 1, 2], [0, 4, 0]], 4).unwrap();
    let uneven = Weights::Given(vec![rational(1, 5), rational(1, 4), rational(2, 3)]);
    let made = [
        product(&[first.clone(), second]),
        product(&[wide, first]),
        limit(&Graph::path(3), uneven),
        limit(&Graph::path(4), Weights::Lazy),
        switches(&four_birds(Weights::Lazy, Hysteresis::Constant(rational(1, 10))), 6),
        switches(&four_birds(Weights::Vicsek, Hysteresis::None), 4),
        switches(&planar(), 3),
        switches(&square(), 2),
        inertia(&[[0, 1, 2], [1, 2, 0], [2, 0, -1]], 2),
        inertia(&[[0, 0, 0], [0, 4, 4], [0, 4, 4]], 2),
        peak(3),
        peak(16),
        peak(17),
    ];
    made.into_iter().map(Result::unwrap).collect()
}

#[test]
fn certificates_are_written_to_the_letter() {
    let written: Vec<String> = examples().iter().map(Certificate::text).collect();
    assert_eq!(written.join("\n"), include_str!("certificates.txt"));
}

#[test]
fn theorems_are_written_to_the_letter() {
    let named = |(k, certificate)| CoqTheorem { name: format!("example_{k}"), certificate };
    let theorems: Vec<CoqTheorem> = examples().into_iter().enumerate().map(named).collect();
    let kinds = ["product", "limit", "switches", "inertia", "peak"];
    let written: Vec<String> = kinds.iter().filter_map(|kind| coq_file(kind, &theorems)).collect();
    assert_eq!(written.join("\n"), include_str!("theorems.txt"));
    // Rectangular factors, flocks of the plane with given weights, 17 followers: none is stated.
    let mut left_out: Vec<CoqTheorem> = [1, 6, 12].map(|k| theorems[k].clone()).to_vec();
    let two = StochasticMatrix::from_integers(&[[1, 0], [0, 1]], 1).unwrap();
    let three = StochasticMatrix::from_integers(&[[1, 0], [0, 1], [1, 0]], 1).unwrap();
    left_out.push(CoqTheorem { name: "tall".to_string(), certificate: product(&[two, three]).unwrap() });
    assert!(kinds.iter().all(|kind| coq_file(kind, &left_out).is_none()));
    let on_the_line =
        Start::on_the_line(vec![rational(0, 1)], vec![rational(0, 1)], planar().weights, Hysteresis::None);
    let given = switches(&on_the_line, 1).unwrap();
    assert!(coq_file("switches", &[CoqTheorem { name: "given".to_string(), certificate: given }]).is_none());
    let still = switches(&at_rest(1, 2, Hysteresis::None), 1).unwrap();
    assert!(coq_file("switches", &[CoqTheorem { name: "plane".to_string(), certificate: still }]).is_none());
}

/// `L D L^T` of many matrices, with zeros on the diagonal.
#[test]
fn factors_multiply_to_the_matrix() {
    let mut made = 0;
    for k in 0..729i64 {
        let digit = |place: u32| k / 3i64.pow(place) % 3 - 1;
        let rows = [[digit(0), digit(1), digit(2)], [digit(1), digit(3), digit(4)], [digit(2), digit(4), digit(5)]];
        match inertia(&rows, 1) {
            Ok(certificate) => {
                made += 1;
                let text = certificate.text();
                let numbers = |line: &str| -> Vec<i64> { line.split(' ').map(|x| x.parse().unwrap()).collect() };
                let after = |key: &str| {
                    let lines: Vec<&str> = text.lines().skip_while(|line| !line.starts_with(key)).collect();
                    let over: i64 = lines[0].rsplit(' ').next().unwrap().parse().unwrap();
                    (lines[1..].iter().take(3).map(|line| line.to_string()).collect::<Vec<_>>(), over)
                };
                let pivots = text.lines().find_map(|line| line.strip_prefix("pivots ")).map(numbers).unwrap();
                let ((l, over), (d, under)) = (after("L over"), after("D over"));
                let (l, d): (Vec<Vec<i64>>, Vec<i64>) = (l.iter().map(|x| numbers(x)).collect(), numbers(&d[0]));
                for i in 0..3 {
                    assert_eq!(l[i][i], over);
                    assert!(l[i][i + 1..].iter().all(|x| *x == 0));
                    for j in 0..3 {
                        let sum: i64 = (0..3).map(|m| l[i][m] * d[m] * l[j][m]).sum();
                        let entry = rows[pivots[i] as usize - 1][pivots[j] as usize - 1];
                        assert_eq!(sum, entry * over * over * under, "{text}");
                    }
                }
            }
            Err(error) => assert_eq!(error, CertificateError::NoPivot),
        }
    }
    // The others have a block with zeros on the diagonal.
    assert_eq!(made, 651);
}

#[test]
fn matrices_of_one_entry_have_a_sign() {
    for (x, counts) in [(-3, (0, 1, 0)), (0, (0, 0, 1)), (2, (1, 0, 0))] {
        let inertia = Inertia::new(&RationalMatrix::from_integers(&[[x]], 1).unwrap()).unwrap();
        assert_eq!(inertia.counts(), counts);
        assert!(Certificate::Inertia(inertia).text().contains("pivots 1\nL over 1\n1\nD over 1\n"));
    }
}

#[test]
fn what_is_too_large_is_refused() {
    let refused = |made: Made, what: &'static str, most: u64| {
        assert_eq!(made.unwrap_err(), CertificateError::TooMany { what, most, found: most + 1 });
    };
    let one = StochasticMatrix::from_integers(&[[1]], 1).unwrap();
    assert!(product(&vec![one.clone(); 10_000]).is_ok());
    refused(product(&vec![one; 10_001]), "factors", 10_000);
    let column = |rows: usize| StochasticMatrix::from_integers(&vec![[1]; rows], 1).unwrap();
    assert!(product(&[column(128)]).is_ok());
    refused(product(&[column(1), column(129)]), "rows or columns", 128);
    refused(product(&[column(129)]), "rows or columns", 128);
    let mut row = vec![rational(0, 1); 129];
    row[3] = rational(1, 1);
    let row = StochasticMatrix::try_from(&RationalMatrix::from_rows(&[row]).unwrap()).unwrap();
    refused(product(&[row]), "rows or columns", 128);
    assert_eq!(product(&[]).unwrap_err(), CertificateError::Matrix(MatrixError::NoFactors));
    let one = RationalMatrix::identity(129).unwrap();
    refused(Inertia::new(&one).map(Certificate::Inertia), "rows", 128);
    refused(limit(&Graph::path(129), Weights::Lazy), "birds", 128);
    assert!(switches(&at_rest(64, 1, Hysteresis::None), 0).is_ok());
    refused(switches(&at_rest(65, 1, Hysteresis::None), 0), "birds", 64);
    assert!(switches(&at_rest(1, 8, Hysteresis::None), 0).is_ok());
    refused(switches(&at_rest(1, 9, Hysteresis::None), 0), "dimensions", 8);
    assert!(switches(&at_rest(1, 1, Hysteresis::None), 100_000).is_ok());
    refused(switches(&at_rest(1, 1, Hysteresis::None), 100_001), "steps", 100_000);
    refused(peak(97), "followers", 96);
    // Thresholds 9^(-9^4) of 20 798 bits and 10^(-10^4) of 33 220.
    assert!(switches(&at_rest(9, 1, Hysteresis::Paper), 0).is_ok());
    let long = switches(&at_rest(10, 1, Hysteresis::Paper), 0).unwrap_err();
    assert!(matches!(long, CertificateError::Flock(FlockError::ThresholdTooLong { .. })));
}

#[test]
fn what_has_no_certificate_is_refused() {
    let oblong = RationalMatrix::from_integers(&[[1, 2, 3], [2, 1, 1]], 1).unwrap();
    let refused = Inertia::new(&oblong).unwrap_err();
    assert_eq!(refused, CertificateError::Matrix(MatrixError::NotSquare { rows: 2, cols: 3 }));
    assert_eq!(inertia(&[[1, 2, 3], [2, 1, 1], [3, 0, 1]], 1).unwrap_err(), CertificateError::NotSymmetric);
    assert_eq!(inertia(&[[0, 0, 1], [0, 1, 0], [1, 0, 0]], 1).unwrap_err(), CertificateError::NoPivot);
    assert!(limit(&Graph::empty(2), Weights::Lazy).is_err());
    let counts: Vec<(usize, usize, usize)> = examples()
        .iter()
        .filter_map(|certificate| match certificate {
            Certificate::Inertia(inertia) => Some(inertia.counts()),
            _ => None,
        })
        .collect();
    assert_eq!(counts, [(2, 1, 0), (1, 0, 2)]);
}
