//! Axis-parallel boxes.

/// An axis-parallel box, closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The least coordinates.
    pub min: [f64; 3],
    /// The greatest coordinates.
    pub max: [f64; 3],
}

impl Bounds {
    /// The smallest box that holds the points; `None` without points.
    pub fn of(points: impl Iterator<Item = [f64; 3]>) -> Option<Self> {
        points.fold(None, |bounds, p| Some(Bounds::with(bounds, p)))
    }

    /// The smallest box that holds another one, if there is one, and a point.
    pub(crate) fn with(bounds: Option<Bounds>, p: [f64; 3]) -> Self {
        let Bounds { min, max } = bounds.unwrap_or(Bounds { min: p, max: p });
        Bounds {
            min: std::array::from_fn(|i| min[i].min(p[i])),
            max: std::array::from_fn(|i| max[i].max(p[i])),
        }
    }

    /// The lengths of the sides.
    pub fn extent(&self) -> [f64; 3] {
        std::array::from_fn(|i| self.max[i] - self.min[i])
    }

    /// The length of the diagonal.
    pub fn diagonal(&self) -> f64 {
        let [x, y, z] = self.extent();
        (x * x + y * y + z * z).sqrt()
    }
}
