//! dual

/// To come.
pub struct Dual;
