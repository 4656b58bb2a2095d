//! poles

/// To come.
pub struct Poles;
