//! What a picture is drawn with: shapes on a white sheet, in pixels from its upper left corner.

use super::Colour;

/// Right and down.
pub(super) type Place = (f64, f64);

/// All that is drawn, what comes later over what came before.
#[derive(Debug, Clone)]
pub(super) struct Sheet {
    pub width: f64,
    pub height: f64,
    pub shapes: Vec<Shape>,
}

#[derive(Debug, Clone)]
pub(super) enum Shape {
    /// The fill lies below the stroke.
    Drawn {
        outline: Outline,
        fill: Option<Fill>,
        stroke: Option<Stroke>,
    },
    Text(Text),
    /// Of the shapes only what lies in the window is seen.
    Clipped {
        window: Rectangle,
        shapes: Vec<Shape>,
    },
}

#[derive(Debug, Clone)]
pub(super) enum Outline {
    /// Its corners are round where it is stroked.
    Path(Vec<Step>),
    Rectangle(Rectangle),
    Circle {
        centre: Place,
        radius: f64,
    },
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Step {
    Move(Place),
    Line(Place),
    Close,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Rectangle {
    pub left: f64,
    pub top: f64,
    pub width: f64,
    pub height: f64,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Fill {
    pub colour: Colour,
    /// One hides what lies below.
    pub opacity: f64,
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    pub colour: Colour,
    pub width: f64,
    pub dashed: bool,
}

/// Lengths of the dashes and of the gaps between them.
pub(super) const DASHES: (f64, f64) = (6.0, 4.0);

/// Black writing.
#[derive(Debug, Clone)]
pub(super) struct Text {
    /// Of the base line, at the start, middle or end of the text.
    pub at: Place,
    pub anchor: Anchor,
    pub size: f64,
    /// Upwards, by a quarter turn about the place.
    pub turned: bool,
    pub spans: Vec<Span>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// A part of a text.
#[derive(Debug, Clone)]
pub(super) struct Span {
    pub text: String,
    /// An exponent.
    pub raised: bool,
}

/// How far exponents are raised, and their size.
pub(super) const RAISED: (f64, f64) = (4.5, 9.0);

impl Shape {
    /// A line through places.
    pub fn line(places: impl IntoIterator<Item = Place>, stroke: Stroke) -> Self {
        Shape::Drawn { outline: Outline::Path(steps(places).collect()), fill: None, stroke: Some(stroke) }
    }

    /// The inside of a closed line.
    pub fn area(corners: impl IntoIterator<Item = Place>, fill: Fill) -> Self {
        let outline = Outline::Path(steps(corners).chain([Step::Close]).collect());
        Shape::Drawn { outline, fill: Some(fill), stroke: None }
    }
}

/// From each place to the next.
pub(super) fn steps(places: impl IntoIterator<Item = Place>) -> impl Iterator<Item = Step> {
    places.into_iter().enumerate().map(|(k, place)| if k == 0 { Step::Move(place) } else { Step::Line(place) })
}
