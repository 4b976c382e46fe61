use super::{asked, refusal};

/// The sentence names the place and what is wrong.
fn refused(text: &str, place: &str, named: &str) {
    let message = refusal(text);
    assert!(message.starts_with(place) && message.contains(named), "{message}");
    assert!(!message.contains('\n'));
}

#[test]
fn names_that_are_not_known() {
    let graph = "graph = \"ring:5\"";
    refused(&asked(graph, "lamda(2) > 0", "1 < 0"), "line 6, column 13: ", "`lambda`");
    refused(&asked(graph, "2 < maxdegree", "1 < 0"), "line 6, column 17: ", "`max_degree`");
    refused(&asked("graph = \"conected(4)\"", "1 > 0", "1 < 0"), "line 4, column 10: ", "`connected`");
    refused(&asked("n = \"1..m\"", "1 > 0", "1 < 0"), "line 4, column 9: ", "`m`");
    refused(&asked(graph, "peak < 3", "1 < 0"), "line 6, column 13: ", "a platoon");
    refused("[qestion]\nid = \"x\"", "line 1, column 2: ", "`question`");
    refused("[question]\nid = \"x\"\nkin = \"walk\"", "line 3, column 1: ", "`kind`");
    refused("[question]\nid = \"x\"\nkind = \"wlak\"", "line 3, column 8: ", "`walk`");
}

#[test]
fn families_that_are_empty_or_too_large() {
    refused(&asked("n = \"7..2\"", "n > 0", "1 < 0"), "line 4", "empty");
    refused(&asked("n = \"2..5\"\nwhere = \"n > 7\"", "n > 0", "1 < 0"), "line 4", "`where` leaves out every member");
    refused(&asked("x = \"[2, 1]\"", "x > 0", "1 < 0"), "line 4", "ends before it begins");
    refused(&asked("graph = \"connected(12)\"", "edges > 0", "1 < 0"), "line 4", "164059830476");
    refused(&asked("graph = \"connected(40)\"", "edges > 0", "1 < 0"), "line 4", "more than 164059830476");
    refused(&asked("n = \"1..10000000\"", "n > 0", "1 < 0"), "line 4", "10000000 members");
    refused(&asked("n = \"1..100000\"\nm = \"1..n\"", "m > 0", "1 < 0"), "line 4", "at least");
    refused(&asked("m = \"products(4, 10, 4)\"", "tau_1 > 0", "1 < 0"), "line 4", "members");
}

#[test]
fn reals_where_integers_are_needed() {
    refused(&asked("n = \"1/2..7\"", "n > 0", "1 < 0"), "line 4, column 6: ", "1/2");
    refused(&asked("graph = \"connected(5/2)\"", "edges > 0", "1 < 0"), "line 4, column 20: ", "5/2");
    refused(&asked("graph = \"ring:5\"", "lambda(3/2) > 0", "1 < 0"), "line 6, column 13: ", "integer");
    refused(&asked("graph = \"ring:5\"", "lambda(1.5) > 0", "1 < 0"), "line 6, column 20: ", "3/2");
    refused(&asked("x = \"[1, 2]\"\ngraph = \"ring:5\"", "lambda(x) > 0", "1 < 0"), "line 7, column 20: ", "`x`");
    refused(&asked("x = \"[3, 4]\"\ngraph = \"connected(x)\"", "edges > 0", "1 < 0"), "line 5, column 20: ", "integer");
    refused(&asked("followers = \"[1, 5]\"\nf = \"-1\"\ng = \"-1\"", "peak < 3", "1 < 0"), "line 8", "`followers`");
    refused(&asked("graph = \"ring:5\"", "lambda(6) > 0", "1 < 0"), "line 6, column 13: ", "between 1 and 5");
    let many = asked("followers = \"10^20\"\nf = \"-1\"\ng = \"-1\"", "peak < 3", "1 < 0");
    refused(&many, "line 8, column 13: ", "but it is 100000000000000000000");
    // The one 64-bit integer whose size is none.
    refused(&asked("n = \"integers(-9223372036854775808, 5)\"", "n > 0", "1 < 0"), "line 4, column 15: ", "2^60");
}

#[test]
fn division_by_zero() {
    refused(&asked("x = \"[-1, 2]\"", "1/x != 0", "1 < 0"), "line 6, column 15: ", "x = 0");
    refused(&asked("x = \"[-1, 2]\"", "(3*x - 1)/(3*x - 1) < 3", "1 < 0"), "line 6, column 23: ", "x = 1/3");
    refused(&asked("n = \"1..4\"", "1/(n - 2) < 3", "1 < 0"), "line 6, column 15: ", "n = 2");
    refused(&asked("n = \"1..4\"", "sqrt(n - 2) < 3", "1 < 0"), "line 6, column 18: ", "n = 1");
}

#[test]
fn time_where_nothing_moves() {
    refused(&asked("graph = \"ring:5\"", "always[0, 1](edges > 0)", "1 < 0"), "line 6, column 13: ", "`always`");
    refused(&asked("n = \"1..2\"", "n > 0 until[0, 1] n > 1", "1 < 0"), "line 6, column 13: ", "`until`");
}

#[test]
fn controls_that_are_no_controls() {
    refused(&asked("n = 1", "n > 0", "n>0"), "line 7", "the property itself");
}

#[test]
fn sections_that_are_missing() {
    refused("", "line 1, column 1: ", "[question] is missing");
    refused("[holds]\nproperty = \"1 > 0\"\ncontrols = [\"1 < 0\"]", "line 1, column 1: ", "[question] is missing");
    refused("\n[question]\nid = \"x\"\n[for]\nn = 1", "line 2, column 1: ", "[holds]");
    refused("[question]\nid = \"x\"\n[for]\nn = 1\n[values]\ntwice = \"2*n\"", "line 5, column 1: ", "`sweep`");
}

#[test]
fn what_would_exhaust_the_program() {
    let deep = |open: &str, close: &str| format!("{}1{} > 0", open.repeat(1000), close.repeat(1000));
    refused(&asked("n = 1", &deep("(", ")"), "1 < 0"), "line 6", "nested");
    refused(&asked("n = 1", &deep("sqrt(", ")"), "1 < 0"), "line 6", "nested");
    // What is far deeper must not exhaust the stack either.
    for open in ["(", "[", "max(", "not ", "2^", "-", "1 < 2 implies "] {
        refused(&asked("n = 1", &open.repeat(100_000), "1 < 0"), "line 6", "nested");
    }
    refused(&asked(&format!("n = \"{}1\"", "[".repeat(100_000)), "n > 0", "1 < 0"), "line 4", "nested");
    refused(&asked(&format!("n = {}", "[".repeat(100_000)), "n > 0", "1 < 0"), "line 4", "nested");
    refused(&asked("n = 1", &format!("{}n > 1", "more.".repeat(100_000)), "1 < 0"), "line 6", "at most 200 letters");
    refused(&asked("n = 1", &format!("{} 1 > 0", "not ".repeat(1000)), "1 < 0"), "line 6", "nested");
    refused(&asked("n = 1", &format!("{}1 > 0", "-".repeat(1000)), "1 < 0"), "line 6", "nested");
    refused(&asked("n = 1", &format!("1{} > 0", "^2".repeat(1000)), "1 < 0"), "line 6", "nested");
    refused(&asked("n = 1", &format!("1{} > 0", "+1".repeat(20_000)), "1 < 0"), "line 6", "parts");
    refused(&asked("n = 1", &format!("{} > 0", "7".repeat(1_000_000)), "1 < 0"), "line 6", "digits");
    refused(&asked(&format!("n = \"{}\"", "7".repeat(1_000_000)), "n > 0", "1 < 0"), "line 4", "digits");
    refused(&asked("", "10^10^10 > 0", "1 < 0"), "line 6", "digits");
    refused(&asked("n = 1", "1e999999999 > 0", "1 < 0"), "line 6", "digits");
    refused(&asked("", "exp(-10^30) < exp(10^30)", "1 < 0"), "line 6", "digits");
}

#[test]
fn sentences_have_lines_and_columns() {
    refused(&asked("n = 1", "n > ", "1 < 0"), "line 6, column 17: ", "a number, a name or a bracket");
    refused(&asked("n = 1", "n > (1", "1 < 0"), "line 6, column 19: ", "`)` is expected");
    refused(&asked("n = 1", "n", "1 < 0"), "line 6, column 13: ", "something true or false");
    refused(&asked("n = 1", "(n > 0) + 1 > 0", "1 < 0"), "line 6, column 13: ", "a number is expected");
    refused(&asked("n = 1", "n > 0 n", "1 < 0"), "line 6, column 19: ", "`n`");
    refused(&asked("n = 1", "min() > 0", "1 < 0"), "line 6, column 13: ", "`min`");
    refused("[question]\nid = \"x\"\n[for\n", "line 3", "TOML");
    refused("[question]\nid = \"a b\"\n", "line 2, column 6: ", "an id");
}
