#include "measure.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <stdexcept>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;

K::Point_3 bare(const K::Point_3& p) { return p; }
K::Point_3 bare(const K::Weighted_point_3& p) { return p.point(); }

template <class T>
void describe(const T& triangulation, const Workload& workload, Measured& measured) {
    for (auto cell : triangulation.finite_cell_handles()) {
        std::uint64_t of[4];
        for (int i = 0; i < 4; ++i) {
            const auto p = bare(cell->vertex(i)->point());
            of[i] = fingerprint(p.x(), p.y(), p.z());
        }
        measured.fingerprint += fingerprint(of[0], of[1], of[2], of[3]);
        ++measured.cells;
    }
    measured.hidden = workload.points.size() - triangulation.number_of_vertices();
}

std::vector<K::Point_3> points_of(const Workload& workload) {
    std::vector<K::Point_3> points;
    points.reserve(workload.points.size());
    for (const auto& p : workload.points) points.emplace_back(p[0], p[1], p[2]);
    return points;
}

std::vector<K::Weighted_point_3> weighted_points_of(const Workload& workload) {
    std::vector<K::Weighted_point_3> points;
    points.reserve(workload.points.size());
    for (std::size_t i = 0; i < workload.points.size(); ++i) {
        const auto& p = workload.points[i];
        points.emplace_back(K::Point_3(p[0], p[1], p[2]), workload.weights[i]);
    }
    return points;
}

// Builds T from the rows with whatever else its constructor takes, and measures that.
template <class T, class Rows, class... More>
Measured build(const Workload& workload, const Rows& rows, More... more) {
    Measured measured;
    const Meter meter;
    const T triangulation(rows.begin(), rows.end(), more...);
    meter.stop(measured);
    describe(triangulation, workload, measured);
    return measured;
}

}  // namespace

Measured build_with_cgal(const Workload& workload) {
    if (workload.weights.empty()) return build<CGAL::Delaunay_triangulation_3<K>>(workload, points_of(workload));
    return build<CGAL::Regular_triangulation_3<K>>(workload, weighted_points_of(workload));
}

#ifdef CGAL_LINKED_WITH_TBB
namespace {

template <class Vertex, class Cell>
using Concurrent = CGAL::Triangulation_data_structure_3<Vertex, Cell, CGAL::Parallel_tag>;
using ParallelDelaunay = CGAL::Delaunay_triangulation_3<
    K, Concurrent<CGAL::Triangulation_vertex_base_3<K>, CGAL::Delaunay_triangulation_cell_base_3<K>>>;
using ParallelRegular = CGAL::Regular_triangulation_3<
    K, Concurrent<CGAL::Regular_triangulation_vertex_base_3<K>, CGAL::Regular_triangulation_cell_base_3<K>>>;

}  // namespace

bool has_parallel_cgal() { return true; }

Measured build_with_parallel_cgal(const Workload& workload, unsigned threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CGAL::Bbox_3 box;
    for (const auto& p : workload.points) box += K::Point_3(p[0], p[1], p[2]).bbox();
    if (workload.weights.empty()) {
        ParallelDelaunay::Lock_data_structure locks(box, 50);
        return build<ParallelDelaunay>(workload, points_of(workload), &locks);
    }
    ParallelRegular::Lock_data_structure locks(box, 50);
    return build<ParallelRegular>(workload, weighted_points_of(workload), &locks);
}
#else
bool has_parallel_cgal() { return false; }

Measured build_with_parallel_cgal(const Workload&, unsigned) {
    throw std::logic_error("built without TBB");
}
#endif
