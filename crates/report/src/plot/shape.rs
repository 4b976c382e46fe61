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
    /// Lengths of dashes and of the gaps between them in turn; none for a whole line.
    pub dashes: &'static [f64],
}

/// Ways in which lines are told apart without their colour, in the order of the palette; the first is a whole line.
pub(super) const DASHES: [&[f64]; 8] = [
    &[],
    &[6.0, 4.0],
    &[2.0, 2.5],
    &[9.0, 3.0, 2.0, 3.0],
    &[4.0, 2.0],
    &[12.0, 4.0],
    &[9.0, 3.0, 2.0, 3.0, 2.0, 3.0],
    &[1.5, 4.0],
];

/// Writing.
#[derive(Debug, Clone)]
pub(super) struct Text {
    /// Of the base line, at the start, middle or end of the text.
    pub at: Place,
    pub anchor: Anchor,
    pub size: f64,
    /// Upwards, by a quarter turn about the place.
    pub turned: bool,
    /// Grey, not black.
    pub faint: bool,
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
    pub level: Level,
}

/// Where a part of a text stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Level {
    Line,
    Exponent,
    Index,
}

impl Level {
    /// How far it is raised, and its size where it has one of its own.
    pub fn shift(self) -> (f64, Option<f64>) {
        match self {
            Level::Line => (0.0, None),
            Level::Exponent => (4.5, Some(9.0)),
            Level::Index => (-3.0, Some(9.0)),
        }
    }
}

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
