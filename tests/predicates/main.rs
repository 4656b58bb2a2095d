//! The predicates against exact rationals, and the perturbation against brute force.

mod consistency;
mod definition;
mod diametral;
mod rational;
mod sets;
#[cfg(feature = "count-stages")]
mod stages;
mod ties;
