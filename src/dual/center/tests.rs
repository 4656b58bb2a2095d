use super::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use proptest::prelude::*;

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

/// The centre and squared radius by Gaussian elimination over the rationals.
fn reference(points: Cell, weights: [f64; 4]) -> Option<([BigRational; 3], BigRational)> {
    let p = points.map(|p| p.map(rational));
    let w = weights.map(rational);
    let norm = |i: usize| p[i].iter().map(|x| x * x).sum::<BigRational>() - &w[i];
    let mut rows: Vec<Vec<BigRational>> = (1..4)
        .map(|i| {
            let two = BigRational::from(BigInt::from(2));
            let mut row: Vec<_> = (0..3).map(|k| (&p[i][k] - &p[0][k]) * &two).collect();
            row.push(norm(i) - norm(0));
            row
        })
        .collect();
    for k in 0..3 {
        let pivot = (k..3).find(|&i| !rows[i][k].is_zero())?;
        rows.swap(k, pivot);
        let lead = rows[k][k].clone();
        rows[k].iter_mut().for_each(|x| *x /= &lead);
        for i in (0..3).filter(|&i| i != k) {
            let (row, factor) = (rows[k].clone(), rows[i][k].clone());
            rows[i].iter_mut().zip(row).for_each(|(x, y)| *x -= y * &factor);
        }
    }
    let center: [BigRational; 3] = std::array::from_fn(|k| rows[k][3].clone());
    let square: BigRational =
        (0..3).map(|k| (&center[k] - &p[0][k]) * (&center[k] - &p[0][k])).sum();
    Some((center, square - &w[0]))
}

/// Whether no f64 is nearer to `exact`, and none as near is even where `x` is odd.
fn is_nearest(x: f64, exact: &BigRational) -> bool {
    let limit = rational(f64::MAX);
    if exact.abs() >= limit {
        return x.abs() == f64::MAX && (x > 0.0) == exact.is_positive();
    }
    if !x.is_finite() || (x == 0.0 && x.is_sign_negative()) {
        return false;
    }
    let distance = (rational(x) - exact).abs();
    [x.next_up(), x.next_down()].iter().filter(|y| y.is_finite()).all(|&y| {
        let other = (rational(y) - exact).abs();
        distance < other || (distance == other && x.to_bits() & 1 == 0)
    })
}

fn check(points: Cell, weights: Option<[f64; 4]>) -> Result<(), TestCaseError> {
    let found = match weights {
        Some(weights) => orthocenter(points, weights),
        None => circumcenter(points),
    };
    let Some((center, square)) = reference(points, weights.unwrap_or_default()) else {
        prop_assert_eq!(found, None);
        return Ok(());
    };
    let found = found.unwrap();
    let weight = weights.map(|w| [w]);
    let [from_first] = centers::<1, true>(&[points], weight.as_ref(), &[[0.0; 3]]);
    let offset = from_first.unwrap().position;
    for k in 0..3 {
        prop_assert!(is_nearest(found.position[k], &center[k]), "coordinate {k}: {found:?}");
        let exact = &center[k] - rational(points[0][k]);
        prop_assert!(is_nearest(offset[k], &exact), "offset {k}: {offset:?}");
    }
    prop_assert!(is_nearest(found.radius_squared, &square), "{found:?}, exactly {square}");
    let mut turned = points;
    turned.rotate_left(1);
    let weights = weights.map(|mut w| {
        w.rotate_left(1);
        [w; 3]
    });
    let three = centers::<3, true>(&[turned; 3], weights.as_ref(), &[turned[0]; 3]);
    prop_assert_eq!(three, [Some(found); 3]);
    // What the first stage is sure of is right, by fused operations too.
    let bases = [turned[0]; 3];
    for first in [
        estimate::<3, true, false>(&[turned; 3], weights.as_ref(), &bases),
        estimate::<3, true, true>(&[turned; 3], weights.as_ref(), &bases),
    ] {
        let position = first.position.map(|x| x[0]);
        let same = (position, first.radius_squared[0]) == (found.position, found.radius_squared);
        prop_assert!(same || !first.sure[0]);
    }
    Ok(())
}

fn cells(coordinate: impl Strategy<Value = f64>) -> impl Strategy<Value = Cell> {
    proptest::array::uniform4(proptest::array::uniform3(coordinate))
}

/// Coordinates of lattices with and without rounding, in a cube, and over all scales.
fn coordinates() -> BoxedStrategy<f64> {
    prop_oneof![
        -1.0..1.0f64,
        (-3i32..4).prop_map(f64::from),
        (-3i32..4).prop_map(|i| f64::from(i) * 0.1),
        (0i32..5).prop_map(|i| 1e6 + f64::from(i) * 1e-3),
        (1.0..2.0f64, -160..200i32).prop_map(|(x, e)| x * power_of_two(e)),
    ]
    .boxed()
}

/// Cells with one kind of coordinates, or a mixture.
fn any_cell() -> BoxedStrategy<Cell> {
    prop_oneof![
        cells(-1.0..1.0f64),
        cells((-3i32..4).prop_map(f64::from)),
        cells((-3i32..4).prop_map(|i| f64::from(i) * 0.1)),
        cells((0i32..5).prop_map(|i| 1e6 + f64::from(i) * 1e-3)),
        cells((0.0..1.0f64).prop_map(|x| 1e6 + x)),
        cells((-1.0..1.0f64).prop_map(|x| x * 1e-9)),
        cells((-1.0..1.0f64).prop_map(|x| x * 1e9)),
        cells((-1.0..1.0f64).prop_map(|x| x * power_of_two(199))),
        cells((1.0..2.0f64).prop_map(|x| x * power_of_two(-160))),
        cells(coordinates()),
    ]
    .boxed()
}

/// Four points in a plane but for rounding, and then moved by some ulps.
fn flat_cell() -> impl Strategy<Value = Cell> {
    let numbers = proptest::array::uniform3(-1.0..1.0f64);
    let ulps = proptest::array::uniform3(-1i32..2);
    (cells(-1.0..1.0f64), numbers, ulps).prop_map(|(mut cell, [s, t, _], ulps)| {
        for (k, ulp) in ulps.into_iter().enumerate() {
            let [a, b, c] = [cell[0][k], cell[1][k], cell[2][k]];
            let x = a + s * (b - a) + t * (c - a);
            cell[3][k] = match ulp {
                -1 => x.next_down(),
                1 => x.next_up(),
                _ => x,
            };
        }
        cell
    })
}

fn weights() -> impl Strategy<Value = [f64; 4]> {
    proptest::array::uniform4(prop_oneof![
        -1.0..1.0f64,
        (-3i32..4).prop_map(f64::from),
        (1.0..2.0f64, -300..300i32).prop_map(|(x, e)| x * power_of_two(e)),
        Just(0.1),
    ])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn circumcenters_are_correctly_rounded(cell in any_cell()) {
        check(cell, None)?;
    }

    #[test]
    fn orthocenters_are_correctly_rounded(cell in any_cell(), weights in weights()) {
        check(cell, Some(weights))?;
    }

    #[test]
    fn centers_of_cells_an_ulp_from_flat_are_correctly_rounded(cell in flat_cell()) {
        check(cell, None)?;
    }

    #[test]
    fn weighted_centers_of_cells_an_ulp_from_flat_too(cell in flat_cell(), weights in weights()) {
        check(cell, Some(weights))?;
    }
}

#[test]
fn a_coplanar_cell_has_no_center() {
    let points = [[0.0, 0.0, 0.1], [1.0, 0.0, 0.1], [0.0, 1.0, 0.1], [1.0, 1.0, 0.1]];
    assert_eq!(circumcenter(points), None);
    assert_eq!(orthocenter(points, [1.0, 2.0, 3.0, 4.0]), None);
}

#[test]
fn what_is_too_large_is_the_largest_number() {
    let tiny = f64::from_bits(1);
    let points = [[0.0; 3], [1e300, 0.0, 0.0], [0.0, 1e300, 0.0], [1e300, 1e300, tiny]];
    // The center is half of 1e300, 1e300, -1e600 / tiny.
    let center = circumcenter([points[0], points[1], points[2], [1e300, 0.9e300, tiny]]).unwrap();
    assert_eq!(center.position, [0.5e300, 0.5e300, -f64::MAX]);
    assert_eq!(center.radius_squared, f64::MAX);
    let negative = orthocenter(
        [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        [f64::MAX, -f64::MAX, 0.0, 0.0],
    );
    let negative = negative.unwrap();
    assert_eq!(negative.position, [f64::MAX, f64::MAX / 2.0, f64::MAX / 2.0]);
    assert_eq!(negative.radius_squared, f64::MAX);
}

#[test]
fn results_below_the_normal_numbers_are_rounded_once() {
    // The radius is 3/4 h² with h² = 2^-1073 + ...: three quarters of the squares do not fit.
    for h in [power_of_two(-536), power_of_two(-537) * 1.75, power_of_two(-530) * 1.3] {
        let points = [[0.0; 3], [h, 0.0, 0.0], [0.0, h, 0.0], [0.0, 0.0, h]];
        check(points, None).unwrap();
        check(points, Some([0.0, h * power_of_two(-500), 0.0, 0.0])).unwrap();
    }
}

/// The cells of a cube, split as a triangulation of a lattice splits it.
fn lattice_cells(x: [f64; 2], y: [f64; 2], z: [f64; 2]) -> Vec<Cell> {
    let corner = |i: usize| [x[i & 1], y[i >> 1 & 1], z[i >> 2]];
    [[0, 1, 2, 4], [1, 2, 4, 7], [1, 3, 2, 7], [1, 4, 5, 7], [2, 6, 4, 7]]
        .map(|cell| cell.map(corner))
        .into()
}

/// Whether the first stage suffices.
fn is_sure(points: Cell) -> bool {
    estimate::<1, true, false>(&[points], None, &[points[0]]).sure[0]
}

#[test]
fn cells_of_lattices_are_correctly_rounded() {
    for step in [1.0, 0.1, 1e-9, 12345.678] {
        let at = |i: i32| [f64::from(i) * step, f64::from(i + 1) * step];
        for (i, j, k) in [(0, 0, 0), (-1, 2, 5), (-3, -1, 40), (17, 63, 99)] {
            for points in lattice_cells(at(i), at(j), at(k)) {
                check(points, None).unwrap();
                check(points, Some([step * step; 4])).unwrap();
            }
        }
    }
    // Around the origin every coordinate of the center is 0, which no error bound can show.
    for points in lattice_cells([-0.1, 0.1], [-0.3, 0.3], [-0.7, 0.7]) {
        assert_eq!(circumcenter(points).unwrap().position, [0.0; 3]);
        assert!(!is_sure(points));
    }
}

#[test]
fn random_cells_need_no_integers() {
    let mut state = 1u64;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    for _ in 0..10_000 {
        let points: Cell = std::array::from_fn(|_| std::array::from_fn(|_| next()));
        assert!(is_sure(points));
        assert_eq!(circumcenter(points), exact::center::<true>(points, None, points[0]));
    }
}

#[test]
fn the_error_bound_holds_and_is_not_idle() {
    // Against rationals: the true error of each coordinate stays below the bound, and the bound is
    // not so wide that it says nothing.
    let runner = ProptestConfig::with_cases(1000);
    proptest!(runner, |(cell in any_cell())| {
        let estimate = Estimates::new::<false>(&[cell], None);
        if !estimate.certain[0] {
            return Ok(());
        }
        let (center, _) = reference(cell, [0.0; 4]).unwrap();
        for k in 0..3 {
            let scale = rational(estimate.scale[0]);
            let exact = (&center[k] - rational(cell[0][k])) * scale;
            let Pairs { hi: [hi], lo: [lo] } = estimate.offset[k];
            let error = (rational(hi) + rational(lo) - exact).abs();
            prop_assert!(error <= rational(estimate.error[k][0]));
        }
    });
    assert!(BigRational::one() > rational(DETERMINANT_ERROR));
}
