//! The sides of a surface, as options name them.

/// On which side of the surface.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Side {
    Inner,
    Outer,
    Both,
}

impl Side {
    pub fn name(self) -> &'static str {
        match self {
            Side::Inner => "inner",
            Side::Outer => "outer",
            Side::Both => "both",
        }
    }
}
