//! The one sentinel that every index array shares.

/// "No such element": the only sentinel in any index array, `MEDAX_NONE` in C.
pub const NONE: u32 = u32::MAX;
