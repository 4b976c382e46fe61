use flockproof::ledger::Options;
#[test]
fn probe() {
    let ledger = flockproof::claims::ledger().unwrap();
    let want = std::env::var("CLAIMS").unwrap_or_default();
    let ids: Vec<String> = ledger
        .ids()
        .filter(|id| want.split(',').any(|w| !w.is_empty() && id.starts_with(w)))
        .map(String::from)
        .collect();
    let report = ledger.verify(&ids, &Options::default(), |_| {});
    for e in &report.entries {
        let grades: Vec<_> = e.grades().iter().map(|g| g.word()).collect();
        println!(
            "{}\t{}\t{}\t{}/{}\t{:.3}",
            e.id,
            e.verdict.word(),
            grades.join(","),
            e.controls.refuted,
            e.controls.total,
            e.seconds
        );
        if let Some(c) = &e.counterexample {
            println!("    CE {c}");
        }
        if let Some(c) = &e.why {
            println!("    WHY {c}");
        }
        for c in &e.surviving_controls {
            println!("    SURVIVES {c}");
        }
        for (k, v) in &e.values {
            println!("    {k} = {v}");
        }
    }
}
