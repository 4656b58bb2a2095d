// SPDX-License-Identifier: MIT OR Apache-2.0
#include "operations.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace medax_meshlab {

namespace {

/// The triangles of a layer, which are to point out of the solid.
medax::Complex mesh(const Input &input) {
    if (input.corners.empty())
        throw std::invalid_argument("The layer has no faces: let Tight Cocone or the power crust "
                                    "tell inside from outside.");
    std::vector<std::uint32_t> offsets(input.corners.size() / 3 + 1);
    for (std::size_t face = 0; face < offsets.size(); ++face)
        offsets[face] = static_cast<std::uint32_t>(3 * face);
    medax::ComplexParts parts;
    parts.vertices = input.points.front().data();
    parts.vertex_count = input.points.size();
    parts.face_offsets = offsets.data();
    parts.face_indices = input.corners.data();
    parts.face_count = offsets.size() - 1;
    return medax::Complex::from(parts);
}

/// Voronoi diagram and labels, from the beginning to \p percent.
struct Diagram {
    medax::Dual dual;
    medax::Labels labels;
};

medax::Labels labels(const Input &input, const medax::Points &points, const medax::Dual &dual,
                     Inside inside, int percent, Steps &steps) {
    switch (inside) {
        case Inside::crust: {
            const auto crust = medax::PowerCrust::of(
                points, {}, steps.until(percent - 5, "Power crust"));
            return medax::Labels::of(dual, crust, steps.until(percent, "Inside and outside"));
        }
        case Inside::mesh:
            return medax::Labels::of(dual, mesh(input),
                                     steps.until(percent, "Inside and outside"));
        case Inside::cocone: break;
    }
    const auto cocone = medax::Cocone::of(dual, {}, steps.until(percent - 5, "Tight Cocone"));
    return medax::Labels::of(cocone, steps.until(percent, "Inside and outside"));
}

Diagram diagram(const Input &input, Inside inside, int percent, Steps &steps) {
    const auto points = medax::Points::from(input.points, {}, steps.until(2, "Points"));
    const auto triangulation = medax::Triangulation::delaunay(
        points, {}, steps.until(percent / 2 - 10, "Delaunay triangulation"));
    medax::DualOptions facets;
    facets.facets = 1;
    const auto dual =
        medax::Dual::of(triangulation, facets, steps.until(percent / 2, "Voronoi diagram"));
    return {dual, labels(input, points, dual, inside, percent, steps)};
}

void clip(const Input &input, double margin, medax::MedialFilter &filter) {
    double diagonal = 0;
    for (int k = 0; k < 3; ++k) {
        const auto less = [k](const medax::Point &a, const medax::Point &b) {
            return a[k] < b[k];
        };
        const auto extremes =
            std::minmax_element(input.points.begin(), input.points.end(), less);
        filter.clip_min[k] = (*extremes.first)[k];
        filter.clip_max[k] = (*extremes.second)[k];
        diagonal = std::hypot(diagonal, filter.clip_max[k] - filter.clip_min[k]);
    }
    for (int k = 0; k < 3; ++k) {
        filter.clip_min[k] -= margin * diagonal;
        filter.clip_max[k] += margin * diagonal;
    }
    filter.has_clip = 1;
}

}  // namespace

Surface surface(const Input &input, const SurfaceOptions &options, Steps &steps) {
    const auto points = medax::Points::from(input.points, {}, steps.until(2, "Points"));
    const auto crust =
        medax::PowerCrust::of(points, options.crust, steps.until(90, "Power crust"));
    std::optional<medax::Complex> shape;
    if (options.shape) shape = crust.shape(MEDAX_LABEL_INNER);
    if (!options.open) return {crust.surface(), shape};
    return {crust.open({}, steps.until(95, "Holes")).first, shape};
}

medax::Complex axis(const Input &input, AxisOptions options, Steps &steps) {
    const Diagram made = diagram(input, options.inside, 60, steps);
    const auto medial =
        medax::Medial::of(made.dual, made.labels, {}, steps.until(85, "Medial axis"));
    if (options.filter.side != MEDAX_SIDE_INNER) clip(input, options.margin, options.filter);
    return medial.axis(options.filter, steps.until(95, "Facets of the axis"));
}

medax::Core core(const Input &input, const CoreOptions &options, Steps &steps) {
    const Diagram made = diagram(input, options.inside, 50, steps);
    const auto flow = medax::Flow::of(made.dual, made.labels, {}, steps.until(70, "Flow"));
    std::vector<std::uint32_t> facets;
    if (options.extend) {
        const auto medial =
            medax::Medial::of(made.dual, made.labels, {}, steps.until(80, "Medial axis"));
        facets = medial.selected(*options.extend, steps.until(82, "Facets of the axis"));
    }
    return flow.core(options.core, facets, steps.until(95, "Core"));
}

medax::Sizes sizes(const Input &input, const SizesOptions &options, Steps &steps) {
    if (!options.faces) {
        const auto points = medax::Points::from(input.points, {}, steps.until(2, "Points"));
        return medax::PowerCrust::of(points, options.crust, steps.until(80, "Power crust"))
            .sizes_at(input.points, steps.until(95, "Sizes"));
    }
    const auto faces = mesh(input);
    medax::SampleOptions dense;
    dense.spacing = options.spacing;
    const auto samples = medax::Samples::of(faces, dense, steps.until(10, "Samples"));
    const auto points = samples.points({}, steps.until(12, "Points"));
    // The faces know better than the samples what is inside.
    return medax::PowerCrust::of(points, options.crust, steps.until(75, "Power crust"))
        .labelled_by_mesh(faces, steps.until(85, "Inside and outside"))
        .sizes_at(input.points, steps.until(95, "Sizes"));
}

}  // namespace medax_meshlab
