#include "measure.hpp"

#include <medax.hpp>

Measured build_with_medax(const Workload& workload, unsigned threads) {
    Measured measured;
    medax::JobOptions options;
    options.threads = threads;
    const Meter meter;
    const medax::Job job(options);
    // Everything: validation, merging, spatial order, cells, canonical order, maps.
    const auto points = medax::Points::from(workload.points, {}, job);
    const auto triangulation = workload.weights.empty()
                                   ? medax::Triangulation::delaunay(points, {}, job)
                                   : medax::Triangulation::regular(points, workload.weights, {}, job);
    meter.stop(measured);
    std::vector<std::uint64_t> of(triangulation.coords().rows());
    for (std::size_t v = 0; v < of.size(); ++v) {
        const auto p = triangulation.coords()[v];
        of[v] = fingerprint(p[0], p[1], p[2]);
    }
    const auto cells = triangulation.cells();
    for (std::size_t c = 0; c < cells.rows(); ++c) {
        const auto cell = cells[c];
        measured.fingerprint += fingerprint(of[cell[0]], of[cell[1]], of[cell[2]], of[cell[3]]);
    }
    measured.cells = cells.rows();
    const std::size_t duplicates = workload.points.size() - of.size();
    measured.hidden = duplicates + triangulation.hidden().rows();
    return measured;
}
