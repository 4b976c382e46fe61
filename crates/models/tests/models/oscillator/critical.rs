//! The critical points of `U_1` that are listed are critical, of their kind, and stable as the theorem says.

use models::oscillator::critical::{
    Kind, arrangements, critical_points, is_critical, is_on_a_line, linearisation, two_clusters,
};

#[test]
fn what_is_listed_is_critical_and_of_its_kind() {
    for particles in 2..=7 {
        for point in critical_points(particles) {
            assert_eq!(is_critical(&point.phasors), Ok(true), "{}", point.name);
            assert_eq!(Kind::of(&point.phasors), Ok(point.kind), "{}", point.name);
            // K < 0 makes the synchronised one stable, K > 0 none but the balanced ones; one rotation is neutral.
            let stable = |gain| linearisation(&point.phasors, gain).expect("exact numbers").positive == 0;
            assert_eq!(stable(-1), point.kind == Kind::Synchronised, "{}", point.name);
            assert_eq!(stable(1), point.kind == Kind::Balanced, "{}", point.name);
        }
    }
    assert!(Kind::of::<arithmetic::Rational>(&[]).is_err());
}

#[test]
fn clusters_are_on_a_line_and_few_arrangements_are_critical() {
    for (particles, minority, z) in two_clusters(6) {
        assert!(is_on_a_line(&z) && z.len() == particles && 2 * minority < particles);
    }
    for (name, z) in arrangements() {
        let listed = is_on_a_line(&z) || Kind::of(&z) == Ok(Kind::Balanced);
        assert_eq!(is_critical(&z), Ok(listed), "{name}");
    }
}
