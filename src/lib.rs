//! medax turns samples of a surface into the structures that tell a solid's shape.
//!
//! Data flows one way:
//!
//! ```text
//! files -> io -> Points -> Triangulation -> Dual -> Poles -> PowerCrust -> Complex -> io -> files
//!                                            \-> Cocone, Labels, Medial -> Complex
//! ```
//!
//! Every structure is immutable once built, and every build takes a [`Job`] that says how to
//! run it: threads, memory ceiling, progress, cancel. The answer is a function of the *set* of
//! input points: predicates are exact, ties are broken by a symbolic perturbation, vertices are
//! numbered by spatial rank, and input rows appear only in maps.
//!
//! The C ABI in [`capi`] translates and does nothing else; see `include/medax.h`.

mod boxes;
pub mod capi;
pub mod cocone;
pub mod complex;
pub mod crust;
pub mod distance;
pub mod dual;
mod error;
pub mod figure;
pub mod flow;
mod index;
pub mod io;
mod job;
pub mod labels;
pub mod medial;
pub mod pair;
pub mod points;
pub mod poles;
pub mod predicates;
pub mod sample;
mod sort;
pub mod triangulation;
mod validation;
mod vector;

pub use cocone::Cocone;
pub use complex::Complex;
pub use crust::PowerCrust;
pub use dual::Dual;
pub use error::{ElementKind, Error, Result, Status};
pub use figure::Figure;
pub use index::NONE;
pub use job::{Charge, Job, JobOptions, Progress, Run, Stage, StageTime};
pub use labels::Labels;
pub use medial::Medial;
pub use pair::PairMesh;
pub use points::Points;
pub use poles::Poles;
pub use triangulation::Triangulation;
pub use validation::Validation;

/// The program of the manual's page, compiled with the examples of the documentation.
#[cfg(doctest)]
#[doc = include_str!("../docs/hosts/rust.md")]
struct ManualPage;
