//! The predicates against exact rationals, and the perturbation against brute force.

mod definition;
mod rational;
mod sets;
mod ties;
