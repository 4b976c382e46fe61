//! Questions: a box of gains to one percent, all small graphs, a motion enclosed.

use criterion::{Criterion, criterion_group, criterion_main};
use flockproof::arithmetic::Unwatched;
use flockproof::question::{Question, Verdict, decide};

/// The highest peak of the box is 73.368.., that of f = -4 and g = -2: one percent is left.
const GAINS: &str = "[question]\nid = \"gains\"\n[for]\nfollowers = \"64\"\nf = \"[-4, -1]\"\ng = \"[-4, -2]\"\n[holds]\n\
    property = \"stable and peak < 101/100*73.368\"\ncontrols = [\"peak < 73.368\"]\n";

const GRAPHS: &str = "[question]\nid = \"fiedler\"\n[for]\ngraph = \"all(8)\"\n[holds]\n\
    property = \"lambda(2) <= n*min_degree/(n - 1)\"\ncontrols = [\"lambda(2) <= min_degree - 1\"]\n";

fn answers(c: &mut Criterion) {
    let mut group = c.benchmark_group("questions");
    group.sample_size(10);
    for (name, text) in [("a box of gains, M = 64, to 1 percent", GAINS), ("all graphs on 8 vertices", GRAPHS)] {
        let none = |_: &str| Err("there are no files".to_string());
        group.bench_function(name, |b| {
            b.iter(|| {
                let question = Question::read(text, &none).expect("a question");
                let answer = decide(&question, &Unwatched).expect("an answer");
                assert_eq!(answer.verdict, Verdict::Holds, "{}", answer.why);
            })
        });
    }
    group.finish();
}

criterion_group!(benches, answers);
criterion_main!(benches);
