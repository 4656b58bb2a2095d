#include "reference.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using reference::Cell;

using DelaunayVertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, K>;
using Delaunay = CGAL::Delaunay_triangulation_3<K, CGAL::Triangulation_data_structure_3<DelaunayVertex>>;

using RegularBase = CGAL::Regular_triangulation_vertex_base_3<K>;
using RegularVertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, K, RegularBase>;
using RegularCell = CGAL::Regular_triangulation_cell_base_3<K>;
using Regular = CGAL::Regular_triangulation_3<K, CGAL::Triangulation_data_structure_3<RegularVertex, RegularCell>>;

K::Point_3 at(const reference::Point& p) { return {p[0], p[1], p[2]}; }

template <class T>
std::vector<Cell> finite_cells(const T& triangulation) {
    std::vector<Cell> cells;
    cells.reserve(triangulation.number_of_finite_cells());
    for (auto cell : triangulation.finite_cell_handles()) {
        Cell ids;
        for (int i = 0; i < 4; ++i) ids[i] = cell->vertex(i)->info();
        std::sort(ids.begin(), ids.end());
        cells.push_back(ids);
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

}  // namespace

namespace reference {

Triangulation delaunay(const std::vector<Point>& points) {
    std::vector<std::pair<K::Point_3, std::uint32_t>> input;
    for (const Point& p : points) input.emplace_back(at(p), input.size());
    Delaunay triangulation(input.begin(), input.end());
    if (triangulation.dimension() != 3 || triangulation.number_of_vertices() != points.size())
        throw std::logic_error("the reference takes distinct points that are not flat");
    return {finite_cells(triangulation), {}};
}

Triangulation regular(const std::vector<Point>& rows, const std::vector<double>& weights) {
    using Key = std::tuple<double, double, double, double>;
    std::map<Key, std::uint32_t> first_row;  // -0 and 0 compare equal
    std::vector<K::Weighted_point_3> input;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& [x, y, z] = rows[i];
        input.emplace_back(at(rows[i]), weights[i]);
        first_row.emplace(Key{x, y, z, weights[i]}, i);
    }
    Regular triangulation(input.begin(), input.end());
    if (triangulation.dimension() != 3) throw std::logic_error("the reference takes points that are not flat");

    std::vector<bool> shown(rows.size());
    for (auto vertex : triangulation.finite_vertex_handles()) {
        const auto& p = vertex->point();
        vertex->info() = first_row.at({p.x(), p.y(), p.z(), p.weight()});
        shown[vertex->info()] = true;
    }
    Triangulation result{finite_cells(triangulation), {}};
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!shown[i]) result.hidden.push_back(i);

    // CGAL keeps a hidden point in the cell that hides it; of equal rows it may drop the later ones.
    std::vector<bool> kept(rows.size());
    for (auto cell : triangulation.all_cell_handles())
        for (auto p = cell->hidden_points_begin(); p != cell->hidden_points_end(); ++p)
            kept[first_row.at({p->x(), p->y(), p->z(), p->weight()})] = true;
    for (std::uint32_t i : result.hidden) {
        const auto& [x, y, z] = rows[i];
        bool repeats = first_row.at({x, y, z, weights[i]}) != i;
        if (!repeats && !kept[i]) throw std::logic_error("CGAL lost a point without hiding it");
    }
    return result;
}

int orientation(const Point& p, const Point& q, const Point& r, const Point& s) {
    return CGAL::orientation(at(p), at(q), at(r), at(s));
}

bool is_flat(const std::vector<Point>& points) {
    std::vector<K::Point_3> input;
    for (const Point& p : points) input.push_back(at(p));
    return Delaunay(input.begin(), input.end()).dimension() < 3;
}

}  // namespace reference
