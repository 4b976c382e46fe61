//! What is decided, and how, does not depend on the number of threads.

use super::expression::{Said, at_least, c, decided, lines, sides, x, y};
use polynomials::Side;
use polynomials::decide::Effort;

#[test]
fn the_number_of_threads_changes_nothing() {
    let questions: Vec<(Vec<Side>, Vec<Said>)> = vec![
        // Attained inside, at an irrational number, along a line, false, open.
        (sides(&[(-2, 2)]), vec![at_least(x().call("exp"), c(1, 1) + x())]),
        (sides(&[(0, 2)]), vec![at_least(x().call("exp"), c(2, 1) * x() + c(2, 1) - c(2, 1) * c(2, 1).call("log"))]),
        (lines(2), vec![at_least((x() - y()).to(2), c(0, 1))]),
        (sides(&[(-1, 1), (-1, 1)]), vec![at_least((x() - y()).to(2), c(1, 1000))]),
        (
            sides(&[(1, 2), (1, 2)]),
            vec![at_least((x() * y()).call("sin"), x().call("sin") * y().call("sin") - c(1, 2))],
        ),
        (
            sides(&[(1, 2), (1, 2)]),
            vec![at_least((x() + y()).call("log") - y().call("log"), (x() / y() + c(1, 1)).call("log"))],
        ),
    ];
    for (domain, clause) in questions {
        let effort = Effort { boxes: 4000, squares: false, certified: false, conditions: false };
        let of = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
            pool.install(|| format!("{:?}", decided(clause.clone(), &domain, effort)))
        };
        let alone = of(1);
        for threads in [2, 5] {
            assert_eq!(alone, of(threads), "{threads} threads");
        }
    }
}
