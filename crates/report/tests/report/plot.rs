//! Pictures: their ticks, their SVG and their pixels.

use report::plot::{Axis, Panel, Picture, PictureError, Series};
use tiny_skia::{Pixmap, PremultipliedColorU8};

fn drawn(picture: &Picture) -> Pixmap {
    Pixmap::decode_png(&picture.png().expect("a picture")).expect("a PNG")
}

/// How many pixels of a part of the PNG, given in pixels of the sheet, are of a kind.
fn count(
    pixels: &Pixmap,
    (left, right): (u32, u32),
    (top, bottom): (u32, u32),
    kind: impl Fn(PremultipliedColorU8) -> bool,
) -> usize {
    let places = (2 * top..2 * bottom).flat_map(|y| (2 * left..2 * right).map(move |x| (x, y)));
    places.filter(|&(x, y)| kind(pixels.pixel(x, y).expect("inside"))).count()
}

fn dark(pixel: PremultipliedColorU8) -> bool {
    pixel.red() < 100 && pixel.green() < 100 && pixel.blue() < 100
}

fn red(pixel: PremultipliedColorU8) -> bool {
    pixel.red() > 200 && pixel.green() < 60 && pixel.blue() < 60
}

fn blue(pixel: PremultipliedColorU8) -> bool {
    pixel.red() < 60 && pixel.green() < 60 && pixel.blue() > 200
}

/// One panel without labels of ticks: its axes go from 41.8 to 386 across and, below a title, from 46 to 260 down.
fn panel() -> Panel {
    let none: [f64; 0] = [];
    let (x, y) = (Axis::linear("across").between(0.0, 1.0), Axis::linear("down").between(0.0, 1.0));
    Panel::new("", x.ticks(none), y.ticks(none))
}

fn picture(title: &str, panel: Panel) -> Picture {
    Picture::new(title).grid(1, (400.0, 270.0)).panel(panel)
}

#[test]
fn a_picture_has_twice_its_size_and_its_texts() {
    let pixels = drawn(&picture("Title", panel()));
    assert_eq!((pixels.width(), pixels.height()), (2 * 408, 2 * 312));
    // The title, the label below the axes, the label on their left, which is taller than wide, and nothing elsewhere.
    assert!(count(&pixels, (180, 230), (10, 30), dark) > 100);
    assert!(count(&pixels, (190, 240), (285, 300), dark) > 100);
    assert!(count(&pixels, (10, 30), (135, 175), dark) > 100);
    assert_eq!(count(&pixels, (0, 408), (0, 8), dark), 0);
    assert_eq!(count(&pixels, (0, 150), (0, 40), dark) + count(&pixels, (260, 408), (0, 40), dark), 0);
    assert_eq!(count(&pixels, (0, 35), (46, 125), dark) + count(&pixels, (0, 35), (185, 312), dark), 0);
}

#[test]
fn lines_are_dashed_and_end_at_the_axes() {
    let across = |height: f64| [(-10.0, height), (10.0, height)];
    let lines = panel()
        .series(Series::line("", across(0.75)).colour("#ff0000").size(2.0))
        .series(Series::dashed("", across(0.25)).colour("#0000ff").size(2.0));
    let pixels = drawn(&picture("", lines));
    let inside = |kind: fn(PremultipliedColorU8) -> bool| count(&pixels, (45, 385), (20, 230), kind);
    // 340 pixels long and 2 wide, of four each.
    assert_eq!(inside(red), 340 * 2 * 4);
    let share = inside(blue) as f64 / (340.0 * 2.0 * 4.0);
    assert!((0.55..0.65).contains(&share), "dashes of 6 with gaps of 4 cover {share}");
    // At most half a pixel beyond the axes, where their frame is.
    let sheet = |kind: fn(PremultipliedColorU8) -> bool| count(&pixels, (0, 408), (0, 284), kind);
    let beside = |kind: fn(PremultipliedColorU8) -> bool| count(&pixels, (41, 387), (20, 230), kind);
    assert_eq!((beside(red), beside(blue)), (sheet(red), sheet(blue)));
}

#[test]
fn an_area_lets_through_what_lies_below() {
    let square = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let pixels = drawn(&picture("", panel().series(Series::area("", square).colour("#ff0000"))));
    let mixed = pixels.pixel(400, 200).expect("inside");
    assert_eq!((mixed.red(), mixed.green(), mixed.blue()), (255, 191, 191));
}

#[test]
fn a_point_that_is_not_finite_breaks_a_line() {
    let points = [(0.0, 0.5), (0.4, 0.5), (f64::NAN, 0.5), (0.6, 0.5), (1.0, 0.5)];
    let broken = picture("", panel().series(Series::line("", points).colour("#ff0000")));
    assert!(broken.svg().contains("d=\"M41.8 125L179.48 125M248.32 125L386 125\""), "{}", broken.svg());
}

#[test]
fn texts_are_escaped_exponents_raised_and_indices_lowered() {
    let labelled = Panel::new("a < b & c > d", Axis::linear("10^−3 m"), Axis::linear(""));
    let svg = picture("K_M <y>", labelled.series(Series::line("R&D", [(0.0, 1.0)]))).svg();
    for part in [
        ">K<tspan dy=\"3\" font-size=\"9\">M</tspan><tspan dy=\"-3\"> &lt;y&gt;</tspan></text>",
        ">a &lt; b &amp; c &gt; d</text>",
        ">10<tspan dy=\"-4.5\" font-size=\"9\">−3</tspan><tspan dy=\"4.5\"> m</tspan></text>",
        ">R&amp;D</text>",
    ] {
        assert!(svg.contains(part), "{part} is missing in {svg}");
    }
}

#[test]
fn a_colour_is_six_hexadecimal_digits() {
    for colour in ["red", "#fff", "#gggggg", "#+12345"] {
        let picture = picture("", panel().series(Series::points("", [(0.5, 0.5)]).colour(colour)));
        assert_eq!(picture.png(), Err(PictureError::Colour(colour.to_string())));
    }
}

/// The labels of the vertical axis of a panel in which five have room.
fn labels(axis: Axis, numbers: &[f64]) -> Vec<String> {
    let series = Series::points("", numbers.iter().map(|y| (0.5, *y)));
    let svg =
        Picture::new("").grid(1, (400.0, 300.0)).panel(Panel::new("", Axis::linear(""), axis).series(series)).svg();
    let ends = svg.lines().filter(|line| line.contains("text-anchor=\"end\""));
    // Letters outside of tags.
    ends.map(|line| line.split('<').filter_map(|part| part.split_once('>')).map(|(_, text)| text).collect()).collect()
}

#[test]
fn ticks_are_round_and_labels_short() {
    assert_eq!(labels(Axis::linear("").between(0.0, 1.0), &[]), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
    assert_eq!(labels(Axis::linear("").between(-5.0, 5.0), &[]), ["−4", "−2", "0", "2", "4"]);
    assert_eq!(labels(Axis::linear("").between(0.0, 3e6), &[]), ["0", "106", "2·106", "3·106"]);
    let decades = ["10−6", "10−5", "10−4", "10−3", "10−2", "10−1", "100"];
    assert_eq!(labels(Axis::log("").between(1e-6, 1.0), &[]), decades);
    assert_eq!(labels(Axis::log("").between(0.1, 10.0), &[]), ["0.1", "0.2", "0.5", "1", "2", "5", "10"]);
    assert_eq!(labels(Axis::log("").ticks([4.0, 16.0]), &[3.0, 128.0]), ["4", "16"]);
}

#[test]
fn empty_and_constant_data_have_ticks() {
    for axis in [Axis::linear(""), Axis::log("")] {
        for numbers in [&[][..], &[2.0][..], &[f64::NAN, -0.0][..]] {
            assert!(labels(axis.clone(), numbers).len() > 1, "{axis:?} {numbers:?}");
        }
    }
}

#[test]
fn legends_stand_above_the_axes_and_lines_differ_in_more_than_colour() {
    let curve = |name: &str, y: f64| Series::line(name, [(0.0, y), (1.0, y)]);
    let named = panel().series(curve("one", 0.2)).series(curve("two", 0.4)).series(curve("three", 0.6));
    let svg = picture("", named).svg();
    let frame = svg.lines().find(|line| line.starts_with("<rect") && line.contains("#333333")).expect("the axes");
    // Room for one row of the legend, clear of the highest tick.
    assert!(frame.contains(" y=\"45\""), "{frame}");
    assert_eq!(svg.matches("stroke-dasharray=\"6 4\"").count(), 2, "a line and its place in the legend");
    assert_eq!(svg.matches("stroke-dasharray=\"2 2.5\"").count(), 2);
}

#[test]
fn names_of_others_have_no_index_and_no_exponent() {
    let title = |text: &str| picture(text, panel()).svg();
    assert!(title("K_M").contains("tspan"));
    let literal = title(&report::plot::literal("my_long_tracks_2024^2.csv"));
    assert!(literal.contains("my_long_tracks_2024^2.csv") && !literal.contains("tspan"), "{literal}");
}
