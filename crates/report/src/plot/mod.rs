//! The one plotting layer: pictures of panels with axes, ticks, legends, lines and points, as SVG and PNG.
//!
//! Coordinates are those of the data; a point with a coordinate that is not finite breaks a line. What lies outside the
//! axes is clipped.

mod draw;
mod error;
mod font;
mod png;
mod shape;
mod svg;
mod ticks;

pub use error::PictureError;

/// A name that somebody gave, shown as it is: in other texts `K_M` has an index and `10^3` an exponent.
pub fn literal(name: &str) -> String {
    name.replace('_', &format!("{AS_IT_IS}_")).replace('^', &format!("{AS_IT_IS}^"))
}

/// Stands before a character that begins neither index nor exponent, and is not shown: the word joiner, which has no width.
const AS_IT_IS: char = '\u{2060}';

/// A colour as `#rrggbb`.
pub type Colour = &'static str;

/// Colours that stay apart for most eyes and in print; series take them in this order.
pub const PALETTE: [Colour; 8] =
    ["#0b5fa5", "#d1580b", "#138a5e", "#a3247a", "#c79a00", "#3aa6d0", "#8a4a20", "#6b6b6b"];

/// Panels under a common title.
#[derive(Debug, Clone)]
pub struct Picture {
    title: String,
    columns: usize,
    panel_size: (f64, f64),
    panels: Vec<Panel>,
    caption: String,
}

impl Picture {
    /// A picture without panels, one panel in a row.
    pub fn new(title: impl Into<String>) -> Self {
        Picture {
            title: title.into(),
            columns: 1,
            panel_size: (700.0, 420.0),
            panels: Vec::new(),
            caption: String::new(),
        }
    }

    /// So many panels in a row, each of this width and height in pixels, with its axis labels.
    pub fn grid(mut self, columns: usize, panel_size: (f64, f64)) -> Self {
        (self.columns, self.panel_size) = (columns.max(1), panel_size);
        self
    }

    /// Adds a panel.
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// Adds to what is written below the panels: what its signs mean, where the picture belongs.
    pub fn caption(mut self, sentence: &str) -> Self {
        if !self.caption.is_empty() {
            self.caption.push(' ');
        }
        self.caption.push_str(sentence);
        self
    }

    /// Writes before the title of which paper it speaks.
    pub fn of(mut self, paper: &str) -> Self {
        if self.title.starts_with("Figure") || self.title.starts_with("Table") {
            self.title = format!("{paper}, {}", self.title);
        }
        self
    }

    /// The picture as an SVG document.
    pub fn svg(&self) -> String {
        svg::svg(&draw::draw(self))
    }

    /// The picture as a PNG of twice the size.
    ///
    /// # Errors
    /// [`PictureError`].
    pub fn png(&self) -> Result<Vec<u8>, PictureError> {
        png::png(&draw::draw(self))
    }
}

/// One pair of axes with what is drawn between them.
#[derive(Debug, Clone)]
pub struct Panel {
    title: String,
    x: Axis,
    y: Axis,
    equal_scales: bool,
    series: Vec<Series>,
}

impl Panel {
    /// A panel with nothing in it; an empty title takes no room. The legend stands above the axes, where it covers nothing.
    pub fn new(title: impl Into<String>, x: Axis, y: Axis) -> Self {
        Panel { title: title.into(), x, y, equal_scales: false, series: Vec::new() }
    }

    /// One unit is equally long on both axes: for pictures of a plane.
    pub fn equal_scales(mut self) -> Self {
        self.equal_scales = true;
        self
    }

    /// Adds a series.
    pub fn series(mut self, series: Series) -> Self {
        self.series.push(series);
        self
    }

    /// Adds a series that is drawn below the others.
    pub fn below(mut self, series: Series) -> Self {
        self.series.insert(0, series);
        self
    }
}

/// An axis: its label with the unit, its kind, and its range and ticks where the data should not choose them.
#[derive(Debug, Clone)]
pub struct Axis {
    label: String,
    logarithmic: bool,
    range: Option<(f64, f64)>,
    ticks: Option<Vec<f64>>,
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: impl Into<String>) -> Self {
        Axis { label: label.into(), logarithmic: false, range: None, ticks: None }
    }

    /// A logarithmic axis; numbers that are not positive are left out.
    pub fn log(label: impl Into<String>) -> Self {
        Axis { logarithmic: true, ..Axis::linear(label) }
    }

    /// From `low` to `high`.
    pub fn between(mut self, low: f64, high: f64) -> Self {
        self.range = Some((low, high));
        self
    }

    /// Ticks with labels at these numbers.
    pub fn ticks(mut self, ticks: impl Into<Vec<f64>>) -> Self {
        self.ticks = Some(ticks.into());
        self
    }
}

/// How the points of a series are marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mark {
    Line,
    Dashed,
    Points,
    Crosses,
    Joined,
    /// Tails and heads in turn.
    Arrows,
    Area,
}

/// A series of points.
#[derive(Debug, Clone)]
pub struct Series {
    name: String,
    points: Vec<(f64, f64)>,
    mark: Mark,
    colour: Option<Colour>,
    size: f64,
}

impl Series {
    fn new(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>, mark: Mark, size: f64) -> Self {
        Series { name: name.into(), points: points.into_iter().collect(), mark, colour: None, size }
    }

    /// A line through the points. A series with an empty name is not in the legend.
    pub fn line(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Series::new(name, points, Mark::Line, 1.6)
    }

    /// A dashed line.
    pub fn dashed(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Series::new(name, points, Mark::Dashed, 1.6)
    }

    /// Discs.
    pub fn points(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Series::new(name, points, Mark::Points, 3.2)
    }

    /// Crosses, to be seen over discs.
    pub fn crosses(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Series::new(name, points, Mark::Crosses, 4.0)
    }

    /// Discs joined by a line.
    pub fn joined(name: impl Into<String>, points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Series::new(name, points, Mark::Joined, 3.2)
    }

    /// Arrows from tails to heads.
    pub fn arrows(name: impl Into<String>, arrows: impl IntoIterator<Item = ((f64, f64), (f64, f64))>) -> Self {
        Series::new(name, arrows.into_iter().flat_map(|(tail, head)| [tail, head]), Mark::Arrows, 1.2)
    }

    /// The inside of a closed line, through which the rest is seen.
    pub fn area(name: impl Into<String>, outline: impl IntoIterator<Item = (f64, f64)>) -> Self {
        Series::new(name, outline, Mark::Area, 0.0)
    }

    /// Another colour than the next of the palette; it does not use one up.
    pub fn colour(mut self, colour: Colour) -> Self {
        self.colour = Some(colour);
        self
    }

    /// Width of a line or an arrow or radius of a disc, in pixels.
    pub fn size(mut self, size: f64) -> Self {
        self.size = size;
        self
    }
}
