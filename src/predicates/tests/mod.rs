//! The parts that predicates are made of, each against exact rationals. The predicates
//! themselves are tested through the public API, in `tests/predicates`.

mod arithmetic;
mod bounds;
#[path = "../../../tests/predicates/sets.rs"]
mod sets;

use num_rational::BigRational;
use num_traits::Zero;

/// The number of random cases; few under Miri, which is a thousand times slower.
const CASES: usize = if cfg!(miri) { 3 } else { 400 };

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).expect("a finite number")
}

/// The determinant of the rows (p - e, |p - e|^2 - (w_p - w_e)), and its permanent.
fn lifted(points: &[[f64; 4]; 5], weighted: bool) -> BigRational {
    let rows: [[BigRational; 4]; 4] = std::array::from_fn(|i| {
        let [x, y, z, w] = std::array::from_fn(|k| rational(points[i][k]) - rational(points[4][k]));
        let square = &x * &x + &y * &y + &z * &z;
        let lift = if weighted { square - w } else { square };
        [x, y, z, lift]
    });
    determinant(&rows, &[0, 1, 2, 3])
}

/// The determinant of the given columns of as many last rows, by cofactors of the first of them.
fn determinant(rows: &[[BigRational; 4]], columns: &[usize]) -> BigRational {
    let Some(row) = rows.len().checked_sub(columns.len()).and_then(|i| rows.get(i)) else {
        return BigRational::from_integer(1.into());
    };
    let mut sum = BigRational::zero();
    for (i, &column) in columns.iter().enumerate() {
        let others: Vec<usize> = columns.iter().copied().filter(|&other| other != column).collect();
        let term = &row[column] * determinant(rows, &others);
        sum = if i % 2 == 0 { sum + term } else { sum - term };
    }
    sum
}
