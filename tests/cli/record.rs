//! What `verify --record` writes is what the program is compared with.

use super::{flockproof, folder, stdout};
use flockproof::claims::{EVIDENCE, RECORDED};

#[test]
fn the_tables_are_those_that_come_with_the_program() {
    let folder = folder("record");
    let claims = ["tanner1.Omega.bounded", "veerman.lem1"];
    let out = folder.to_str().expect("UTF-8");
    let output =
        flockproof(&["verify", "--claim", claims[0], "--claim", claims[1], "--seed", "other", "--record", out]);
    assert!(output.status.success(), "{}", stdout(&output));
    for (name, table) in [("recorded.tsv", RECORDED), ("evidence.tsv", EVIDENCE)] {
        let of_them = |line: &&str| claims.iter().any(|id| line.starts_with(&format!("{id}\t")));
        let rows: Vec<&str> = table.lines().filter(of_them).collect();
        let written = std::fs::read_to_string(folder.join(name)).expect("it is written");
        assert_eq!(written.lines().next(), table.lines().next(), "{name}");
        assert_eq!(written.lines().skip(1).collect::<Vec<_>>(), rows, "{name}");
    }
}
