//! Golden sections against closed forms.

use motion::golden;

#[test]
fn minima_are_found() {
    for place in [-0.7, 0.0, 0.3, 1.9] {
        let Ok((at, least)) =
            golden::<std::convert::Infallible>((-1.0, 2.0), 60, 0.0, |x| Ok((x - place).powi(2) - 1.0));
        assert!((at - place).abs() < 1e-7 && (least + 1.0).abs() < 1e-14, "{place}: {at}");
    }
    let Ok((at, _)) = golden::<std::convert::Infallible>((0.0, 4.0), 100, 1e-3, |x| Ok((x - 3.0).abs()));
    assert!((at - 3.0).abs() < 1e-2);
}

#[test]
fn errors_are_passed_on() {
    assert_eq!(golden((0.0, 1.0), 5, 0.0, |_| Err::<f64, &str>("no value")), Err("no value"));
}
