//! The object angle of each pole.

use crate::complex::Rows;
use crate::error::Result;
use crate::job::{PART, Room, Run, parts};
use crate::vector::{add, dot, length, sub};

/// For each pole the largest angle at its centre between two samples on its ball, in radians; 0 where there is but one
/// sample, or none.
///
/// Given the samples' places, the balls, and the samples on each. Cost: O(k^2) for the k samples of a ball, which are four nearly
/// always.
pub(super) fn object_angles(
    coords: &[[f64; 3]],
    balls: &[[f64; 4]],
    samples_on_balls: &Rows,
    room: &mut Room<'_>,
    run: &Run<'_>,
) -> Result<Vec<f64>> {
    let mut angles = room.filled(balls.len(), 0.0)?;
    let chunks = angles.chunks_mut(PART).zip(parts(balls.len())).collect();
    run.in_parallel(chunks, |(angles, range)| {
        run.poll()?;
        for (angle, pole) in angles.iter_mut().zip(range) {
            let samples = samples_on_balls.row(pole);
            let at = |sample: u32| coords[sample as usize];
            // All are on one sphere: the largest angle has the longest chord.
            let (mut longest, mut ends) = (0.0, None);
            for (i, &a) in samples.iter().enumerate() {
                if i % 64 == 63 {
                    run.poll()?;
                }
                for &b in &samples[i + 1..] {
                    let chord = sub(at(a), at(b));
                    let square = dot(chord, chord);
                    if square > longest {
                        (longest, ends) = (square, Some([at(a), at(b)]));
                    }
                }
            }
            if let Some([a, b]) = ends {
                let [x, y, z, _] = balls[pole];
                let middle = add(sub(a, [x, y, z]), sub(b, [x, y, z]));
                // Of vectors of one length the difference and the sum are as the sine and the cosine of half the
                // angle (Kahan 2006, How futile are mindless assessments of roundoff): no digits are lost near 0 nor near pi.
                *angle = 2.0 * libm::atan2(longest.sqrt(), length(middle));
            }
        }
        Ok(())
    })?;
    Ok(angles)
}
