use super::{answer, asked, read, refusal, verdict};
use question::Verdict;

#[test]
fn numbers_are_exact() {
    let holds = |property: &str| {
        assert_eq!(answer(&asked("n = \"1..3\"", property, "n < 0")).verdict, Verdict::Holds, "{property}")
    };
    holds("0.1 + 0.2 = 3/10");
    holds("2^-3 = 1/8 and (-2)^2 = 4 and -2^2 = -4");
    holds("1 - 2 - 3 = -4 and 12/2/3 = 2");
    holds("n^2 >= n and not n < 1 or n > 100");
    holds("n > 5 implies n > 4");
    holds("1 < 2 <= 2 != 3");
    holds("gcd(12, 18) = 6 and max(1, n, 2) >= 2 and min(n, 0) = 0 and abs(-n) = n");
    holds("1e-2 = 1/100 and 1.5e1 = 15");
}

#[test]
fn algebraic_numbers_are_compared_exactly() {
    let holds = |property: &str| assert_eq!(verdict("", property), Verdict::Holds, "{property}");
    holds("sqrt(2)*sqrt(3) = sqrt(6)");
    holds("sqrt(2) + sqrt(3) = sqrt(5 + 2*sqrt(6))");
    holds("cos(pi/5) = (1 + sqrt(5))/4");
    holds("sin(pi/12) = (sqrt(6) - sqrt(2))/4");
    holds("cos(2*pi/7) + cos(4*pi/7) + cos(6*pi/7) = -1/2");
    holds("1/(sqrt(3) - sqrt(2)) = sqrt(3) + sqrt(2)");
    holds("cos(pi) = -1 and sin(pi/6) = 1/2 and cos(7*pi/3) = 1/2 and cos(100*pi) = 1");
    // Near misses.
    holds("sqrt(2) != 1.41421356237309504880168872420969807856967187537694807317667973799");
    holds("abs(exp(pi*sqrt(163)) - 262537412640768744) < 1e-12 and exp(pi*sqrt(163)) != 262537412640768744");
    holds("log(exp(1)) > 0.999 and exp(log(2)) < 2.001");
}

#[test]
fn what_no_precision_decides_stays_undecided() {
    assert_eq!(verdict("", "log(1 + sqrt(2)) + log(sqrt(2) - 1) = 0"), Verdict::Undecided);
}

#[test]
fn equal_questions_have_equal_canonical_texts() {
    let one =
        read(&asked("n = \"2 .. 7\"\ngraph = \"connected( n )\"", "(lambda(2)) >= 0.5", "1<0")).expect("a question");
    let two = read(&asked("n = \"2..7\"  # integers\ngraph = \"connected(n)\"", "lambda(2)>=1/2", "1 < 0"))
        .expect("a question");
    assert_eq!(one.canonical(), two.canonical());
    let other = read(&asked("n = \"2..7\"\ngraph = \"connected(n)\"", "lambda(2) > 1/2", "1 < 0")).expect("a question");
    assert_ne!(one.canonical(), other.canonical());
}

#[test]
fn the_canonical_text_keeps_the_meaning() {
    for property in [
        "1 - (2 - 3) = 2",
        "-(2^2) = -4",
        "(-2)^2 = 4",
        "2/(3/4) = 8/3",
        "not (1 < 0 and 0 < 1)",
        "(0 < 1 implies 1 < 0) implies 1 < 0",
    ] {
        let question = read(&asked("", property, "1 < 0")).expect("a question");
        let canonical = question.canonical();
        let own = canonical.lines().find_map(|line| line.strip_prefix("property = ")).expect("a property");
        let again = read(&asked("", own, "1 < 0")).expect("a question");
        assert_eq!(again.canonical(), canonical, "{property}");
        assert_eq!(answer(&asked("", own, "1 < 0")).verdict, Verdict::Holds, "{property}");
    }
}

#[test]
fn powers_with_fractions_and_small_exponentials() {
    let holds = |property: &str| assert_eq!(verdict("", property), Verdict::Holds, "{property}");
    holds("8^(1/3) = 2 and 4^(3/2) = 8 and (8/27)^(-2/3) = 9/4 and 0^(1/3) = 0 and 32^0.2 = 2");
    holds("2^(1/3)*4^(1/3) = 2 and (2^(1/3))^3 = 2 and 2^(1/2) = sqrt(2) and 5^(2/3)*5^(1/3) = 5");
    holds("10^(1/3) != 2.15443469003188372175929356651935 and 2^(1/3) < 1.26 and 2^(-1/3) > 0.79");
    holds("exp(-1000000000) > 0 and exp(-10^30) > 0 and -exp(-10^30) < 0 and 3*exp(-10^9) > 0");
    holds("exp(-10^9) < 10^-100 and exp(-10^9) != 0 and abs(-exp(-10^9)) > 0");
    let refused = |property: &str| refusal(&asked("", property, "1 < 0"));
    assert!(refused("(-8)^(1/3) < 0").ends_with("an exponent that is not an integer"), "{}", refused("(-8)^(1/3) < 0"));
    assert!(refused("0^(-1/2) > 0").ends_with("division by zero"));
    let boxed = verdict("x = \"[-1000000000, 5]\"", "exp(x) > 0 and exp(x) < 149");
    assert_eq!(boxed, Verdict::Holds);
}
