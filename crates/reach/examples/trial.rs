fn main() {
    let file = std::env::args().nth(1).expect("a file");
    let digits = std::env::args().nth(2).map_or(10, |d| d.parse().expect("digits"));
    let system = flockproof_reach::System::read(&std::fs::read_to_string(file).expect("readable")).unwrap_or_else(|e| panic!("{e}"));
    let start = std::time::Instant::now();
    let f = |q: &arithmetic::Rational| arithmetic::decimal(q, digits + 4, false);
    match flockproof_reach::decide(&system, digits, &arithmetic::Unwatched) {
        Err(e) => println!("{e}"),
        Ok(all) => for d in all {
            for p in &d.parts {
                println!("{} {:?} [{:?}, {:?}] at {:?} {}", d.check.text, p.verdict, p.lo.as_ref().map(f), p.hi.as_ref().map(f), p.at.as_ref().map(|r| (f(&r.lo), f(&r.hi))), p.why);
                if let Some(w) = &p.witness { println!("   value {} {} at {} modes {:?} inputs {:?}", f(&w.value.lo), f(&w.value.hi), f(&w.at), w.modes.iter().map(|(t, m)| (f(t), m)).collect::<Vec<_>>(), w.inputs.iter().map(|i| i.iter().map(|(t, v)| (f(t), f(v))).collect::<Vec<_>>()).collect::<Vec<_>>()); }
            }
        }
    }
    println!("{:?}", start.elapsed());
}
