//! Where the vertices of a surface are: at their samples, or where the balls have them.

use super::shards;
use crate::complex::Rows;
use crate::dual::orthocenter_positions;
use crate::error::Result;
use crate::index::NONE;
use crate::job::{PART, Room, Run, parts};
use crate::poles::Poles;
use crate::triangulation::Triangulation;
use crate::vector::{Vec3, cross, dot, sub, unit};

/// The height of a triangle, as a share of its longest side, below which rounding decides which way it turns.
const NEEDLE: f64 = 1e-9;

/// The positions of the vertices of a surface. A vertex with a sample is where the sample is; one without is the
/// orthocentre of its cell.
pub(super) struct Places<'a> {
    poles: &'a Poles,
    regular: &'a Triangulation,
    cells: &'a [u32],
    positions: Vec<Vec3>,
    is_center: Vec<bool>,
}

impl<'a> Places<'a> {
    /// Vertices that are these cells of the regular triangulation; none of them is anywhere before [`Places::settle`].
    pub fn new(
        poles: &'a Poles,
        regular: &'a Triangulation,
        cells: &'a [u32],
        room: &mut Room<'_>,
    ) -> Result<Self> {
        let positions = room.filled(cells.len(), [0.0; 3])?;
        let is_center = room.filled(cells.len(), false)?;
        Ok(Places { poles, regular, cells, positions, is_center })
    }

    /// Puts every vertex where it belongs, given the sample of each or [`NONE`].
    pub fn settle(&mut self, samples: &[u32], progress: [f64; 2], run: &Run<'_>) -> Result<()> {
        let coords = self.poles.triangulation().coords();
        let (regular, all) = (self.regular, self.cells);
        let places = self.positions.chunks_mut(PART).zip(self.is_center.chunks_mut(PART));
        let chunks = places.zip(parts(samples.len())).collect();
        run.in_steps(chunks, progress, |((positions, is_center), range)| {
            run.poll()?;
            let (mut found, mut cells) = (Vec::new(), Vec::new());
            for (i, v) in range.enumerate() {
                match samples[v] {
                    NONE if is_center[i] => {}
                    NONE => {
                        found.push(i);
                        cells.push(all[v]);
                    }
                    sample => positions[i] = coords[sample as usize],
                }
            }
            let mut centers = vec![[0.0; 3]; cells.len()];
            orthocenter_positions(regular, &cells, &mut centers, run)?;
            for (i, center) in found.into_iter().zip(centers) {
                positions[i] = center;
                is_center[i] = true;
            }
            Ok(())
        })?;
        Ok(())
    }

    /// The corners of all triangles that turn clockwise as seen from the outer pole, each by the vertex that stands for it: what is
    /// left of a face is a fan from its first vertex. `poles_of` has the inner and the outer pole of a face.
    pub fn turned(
        &self,
        faces: &Rows,
        roots: &[u32],
        poles_of: impl Fn(usize) -> [u32; 2] + Sync,
        run: &Run<'_>,
    ) -> Result<Vec<u32>> {
        let balls = self.poles.balls();
        let center = |pole: u32| [0, 1, 2].map(|axis| balls[pole as usize][axis]);
        let turned = run.in_parallel(parts(faces.len()), |range| {
            run.poll()?;
            let (mut ring, mut turned) = (Vec::new(), Vec::new());
            for face in range {
                shards::contract(faces.row(face), roots, &mut ring);
                let [inner, outer] = poles_of(face).map(center);
                let outward = unit(sub(outer, inner));
                for i in 2..ring.len() {
                    let corners = [ring[0], ring[i - 1], ring[i]];
                    let [a, b, c] = corners.map(|v| self.positions[v as usize]);
                    let sides = [sub(b, a), sub(c, a), sub(c, b)];
                    let longest = sides.map(|side| dot(side, side)).into_iter().fold(0.0, f64::max);
                    if dot(cross(sides[0], sides[1]), outward) < -NEEDLE * longest {
                        turned.extend(corners);
                    }
                }
            }
            Ok(turned)
        })?;
        Ok(turned.concat())
    }

    /// The positions, one for each vertex.
    pub fn into_positions(self) -> Vec<Vec3> {
        self.positions
    }
}
