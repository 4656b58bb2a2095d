// Pair-meshes through the C++ layer.
#include "check.hpp"

#include <cmath>

/// A grid, of which all cells are inner: a block with one sample inside.
static medax::Pair block() {
    std::vector<medax::Point> points;
    for (int i = 0; i < 27; ++i)
        points.push_back({1.0 * (i % 3), 1.1 * (i / 3 % 3), 1.2 * (i / 9)});
    const medax::Triangulation t = medax::Triangulation::delaunay(medax::Points::from(points));
    medax::DualOptions options;
    options.facets = 1;
    const medax::Dual dual = medax::Dual::of(t, options);
    const std::vector<std::uint8_t> inner(t.cells().rows(), 1);
    return medax::Pair::voronoi(dual, medax::Labels::from(t, inner));
}

void pairs() {
    const medax::Pair pair = block();
    CHECK(pair.validate().is_valid() && pair.removed().rows() == 1);
    CHECK(pair.element_count(MEDAX_PAIR_ELEMENT_VERTEX_FACE) == 48);
    CHECK(pair.element_count() == pair.rings().rows());
    CHECK(std::fabs(pair.enclosed_volume() - 2 * 2.2 * 2.4) < 1e-12);
    double sum = 0;
    for (double volume : pair.volumes()) sum += volume;
    CHECK(std::fabs(sum - pair.enclosed_volume()) < 1e-12);
    CHECK(pair.folded().empty() && pair.centroids().size() == pair.element_count());
    CHECK(pair.boundary().vertices().rows() == 26);
    CHECK(pair.iso_surface(0.5).vertices().rows() == pair.nodes().rows());
    CHECK(pair.solid().cells().rows() == pair.element_count());
    CHECK(pair.inner().vertices().rows() == pair.inner_vertices().rows());
    for (std::uint32_t shell : pair.shells()) CHECK(shell == 0);

    const medax::Pair spine = pair.onto(medax::Complex::from({}));
    CHECK(spine.validate().is_valid());
    CHECK(spine.inner_vertices().rows() <= pair.inner_vertices().rows());
    CHECK(spine.missing() == 0);
    CHECK(THROWN(spine.onto(spine.inner())).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    for (std::uint32_t reason : spine.reasons()) CHECK(reason != MEDAX_PAIR_REASON_ASKED);
    for (std::uint32_t reason : pair.reasons()) CHECK(reason == MEDAX_PAIR_REASON_ASKED);
    medax::PairOntoOptions onto;
    onto.subdivide = 2;
    CHECK(THROWN(pair.onto(pair.inner(), onto)).status() == MEDAX_STATUS_INVALID_ARGUMENT);

    const std::vector<medax::Point> queries = {{0.3, 0.4, 0.5}, {9, 9, 9}};
    const std::vector<medax::Place> places = pair.locate(queries);
    CHECK(places[1].element == medax::none && places[0].t > 0 && places[0].t < 1);
    const medax::Point back = pair.positions({places[0]})[0];
    for (int k = 0; k < 3; ++k) CHECK(std::fabs(back[k] - queries[0][k]) < 1e-12);
    CHECK(pair.piece(places[0].element, places[0].piece)[0] < 1000);
    CHECK(THROWN(pair.piece(0, 77)).status() == MEDAX_STATUS_INVALID_ARGUMENT);

    std::vector<medax::Point> moved;
    for (std::size_t i = 0; i < pair.inner_vertices().rows(); ++i) {
        const auto p = pair.inner_vertices()[i];
        moved.push_back({p[0] + 1, p[1], p[2]});
    }
    const medax::Pair there = pair.with_inner(moved);
    CHECK(std::fabs(there.boundary_vertices()[0][0] - pair.boundary_vertices()[0][0] - 1) < 1e-12);
    CHECK(THROWN(pair.with_boundary(moved)).status() == MEDAX_STATUS_MISMATCH);

    const medax::HalfFaces halves = medax::HalfFaces::of(pair);
    CHECK(halves.of_element().rows() == pair.element_count() + 1);
    CHECK(halves.offsets().rows() == halves.duals().rows() + 1);
    CHECK(halves.opposites().rows() == halves.origins().rows());
    CHECK(halves.partners().rows() == halves.origins().rows());
}
