//! How cores, cores extended by MEDIAL's facets, and orbits that begin on these near the exact axis.

use super::surfaces::Surface;
use super::{by_value, certified, distances, inner_axis, print, samples};
use medax::flow::{Core, CoreOptions, Flow};
use medax::medial::MedialFilter;
use medax::{Complex, Job, Medial};

/// The most orbits that are followed from one axis.
const ORBITS: usize = 20_000;

pub fn convergence(epsilons: &[f64]) {
    let job = Job::default();
    for surface in Surface::ALL {
        let exact = surface.axis();
        let diagonal = surface.shape().bounds().diagonal();
        for &epsilon in epsilons {
            let rows = samples(surface, epsilon);
            let [bound, _] = certified(surface, &rows, epsilon).expect("an epsilon-sample");
            let (axis, medial) = inner_axis(&rows, &by_value(|p| surface.shape().value(p)));
            let (core, extended, orbits) = cores(&axis, &medial, &job);
            let mut fields = vec!["flow".into(), surface.shape().name().into()];
            fields.push(rows.len().to_string());
            fields.extend([epsilon, bound].map(|x| format!("{x:.9e}")));
            for core in [&core, &extended] {
                let complex = core.complex();
                let betti = complex.topology(&job).unwrap().betti;
                fields.push(betti.map(|b| b.to_string()).join(", "));
                let found = distances(complex, &exact);
                for part in [found.a_to_b, found.b_to_a] {
                    fields.extend([part.max, part.mean].map(|x| format!("{:.6e}", x / diagonal)));
                }
            }
            let starts = distances(&axis, &exact).a_to_b;
            let along = distances(&orbits, &exact).a_to_b;
            fields.extend([starts.max, along.max].map(|x| format!("{:.6e}", x / diagonal)));
            print(&fields);
        }
    }
}

/// The core, not repaired; that extended by MEDIAL's facets; and the orbits of corners of these facets.
fn cores(axis: &Complex, medial: &Medial, job: &Job) -> (Core, Core, Complex) {
    let labels = medial.labels().unwrap();
    let flow = Flow::new(medial.dual(), labels, Default::default(), job).unwrap();
    let options = CoreOptions { repair: false, ..Default::default() };
    let core = flow.core(options, &[], job).unwrap();
    let facets = medial.selected(&MedialFilter::default(), job).unwrap();
    let extended = flow.core(options, &facets, job).unwrap();
    let step = axis.vertices().len().div_ceil(ORBITS);
    let starts: Vec<_> = axis.vertices().iter().copied().step_by(step).collect();
    let orbits = flow.orbits(&starts, job).unwrap();
    (core, extended, orbits.complex(job).unwrap())
}
