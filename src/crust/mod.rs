//! crust

/// To come.
pub struct PowerCrust;
