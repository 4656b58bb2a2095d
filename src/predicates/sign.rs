//! The sign of a determinant: what a predicate answers.

use std::ops::{Mul, Neg};

/// The exact sign of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(i8)]
pub enum Sign {
    /// Less than zero.
    Negative = -1,
    /// Zero, exactly.
    Zero = 0,
    /// Greater than zero.
    Positive = 1,
}

impl Sign {
    /// The sign of a float; zero for either zero, and for NaN.
    #[inline]
    pub fn of(x: f64) -> Self {
        if x > 0.0 {
            Sign::Positive
        } else if x < 0.0 {
            Sign::Negative
        } else {
            Sign::Zero
        }
    }

    /// Whether the number is greater than zero.
    #[inline]
    pub fn is_positive(self) -> bool {
        self == Sign::Positive
    }

    /// Whether the number is less than zero.
    #[inline]
    pub fn is_negative(self) -> bool {
        self == Sign::Negative
    }

    /// Whether the number is zero.
    #[inline]
    pub fn is_zero(self) -> bool {
        self == Sign::Zero
    }
}

impl Neg for Sign {
    type Output = Sign;

    #[inline]
    fn neg(self) -> Sign {
        match self {
            Sign::Negative => Sign::Positive,
            Sign::Zero => Sign::Zero,
            Sign::Positive => Sign::Negative,
        }
    }
}

impl Mul for Sign {
    type Output = Sign;

    /// The sign of the product.
    #[inline]
    fn mul(self, other: Sign) -> Sign {
        match self {
            Sign::Negative => -other,
            Sign::Zero => Sign::Zero,
            Sign::Positive => other,
        }
    }
}
