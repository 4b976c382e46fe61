//! Why a picture could not be made.

/// Why a picture could not be made.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PictureError {
    /// Nothing to be seen, or more than memory can hold.
    #[error("the picture cannot be {width} pixels wide and {height} high")]
    Size {
        /// Its width.
        width: u32,
        /// Its height.
        height: u32,
    },
    /// Not of the form `#rrggbb`.
    #[error("the picture has no colour {0:?}: colours are written #rrggbb")]
    Colour(String),
    /// The font that is built in.
    #[error("the font of pictures cannot be read: {0}")]
    Font(String),
    /// Writing the pixels.
    #[error("the picture could not be written: {0}")]
    Writing(String),
}
