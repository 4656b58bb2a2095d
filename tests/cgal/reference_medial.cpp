// MEDIAL written plainly on CGAL, straight from the paper: Dey, Zhao 2004, Approximating the medial axis from the Voronoi diagram
// with a convergence guarantee, sections 2 and 3.
#include "reference.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using reference::Axis;
using reference::Edge;
using reference::Point;

using Vertices = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Inexact>;
using Cells = CGAL::Triangulation_cell_base_with_info_3<std::uint32_t, Inexact, CGAL::Delaunay_triangulation_cell_base_3<Inexact>>;
using Plain = CGAL::Delaunay_triangulation_3<Inexact, CGAL::Triangulation_data_structure_3<Vertices, Cells>>;

template <class Kernel>
typename Kernel::Point_3 at(const Inexact::Point_3& p) {
    return {p.x(), p.y(), p.z()};
}

double seconds_since(std::chrono::steady_clock::time_point begun) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

// Steps 3 to 10 of MEDIAL, with the Voronoi vertices as points of a kernel.
template <class Kernel>
class Filter {
public:
    Filter(const Plain& t, const std::vector<Point>& directions, double theta, double rho)
        : t(t), directions(directions), sine(std::sin(theta)), rho(rho) {
        std::uint32_t count = 0;
        for (auto cell : t.finite_cell_handles()) {
            cell->info() = count++;
            centres.push_back(CGAL::circumcenter(at<Kernel>(cell->vertex(0)->point()), at<Kernel>(cell->vertex(1)->point()),
                                                 at<Kernel>(cell->vertex(2)->point()), at<Kernel>(cell->vertex(3)->point())));
        }
    }

    void run(Axis& axis) const {
        std::set<Edge> chosen, near;
        std::vector<Plain::Cell_handle> cells;
        std::vector<Plain::Vertex_handle> neighbours;
        for (auto p : t.finite_vertex_handles()) {
            cells.clear();
            t.incident_cells(p, std::back_inserter(cells));
            const auto umbrella = umbrella_of(p, cells);
            if (umbrella.empty()) continue;
            neighbours.clear();
            t.finite_adjacent_vertices(p, std::back_inserter(neighbours));
            for (auto q : neighbours) scan(p, q, umbrella, chosen, near);
        }
        axis.edges.assign(chosen.begin(), chosen.end());
        axis.near.assign(near.begin(), near.end());
    }

private:
    using Triangle = std::array<Plain::Vertex_handle, 2>;  // besides p

    // Definition 1: the direction to the farthest Voronoi vertex, of equal ones the lexicographically least; the mean of the infinite
    // edges' directions where the cell is unbounded.
    typename Kernel::Vector_3 pole_vector(Plain::Vertex_handle p, const std::vector<Plain::Cell_handle>& cells) const {
        const auto at_p = at<Kernel>(p->point());
        const typename Kernel::Point_3* pole = nullptr;
        for (auto cell : cells) {
            if (t.is_infinite(cell)) {
                const auto& [x, y, z] = directions[p->info()];
                return {x, y, z};
            }
            const auto& centre = centres[cell->info()];
            if (pole == nullptr) {
                pole = &centre;
                continue;
            }
            const auto order = CGAL::compare_distance_to_point(at_p, centre, *pole);
            if (order == CGAL::LARGER || (order == CGAL::EQUAL && CGAL::compare_lexicographically(centre, *pole) == CGAL::SMALLER))
                pole = &centre;
        }
        return *pole - at_p;
    }

    // Definition 3: the triangles at p whose dual Voronoi edges the tangent plane cuts. A vertex in the plane is beyond it.
    std::vector<Triangle> umbrella_of(Plain::Vertex_handle p, const std::vector<Plain::Cell_handle>& cells) const {
        const auto at_p = at<Kernel>(p->point());
        const auto towards = pole_vector(p, cells);
        const auto is_below = [&](Plain::Cell_handle cell, Plain::Cell_handle from) {
            if (!t.is_infinite(cell)) return CGAL::sign((centres[cell->info()] - at_p) * towards) == CGAL::NEGATIVE;
            // The edge goes to infinity across the hull facet between the two.
            const int facet = from->index(cell);
            const auto a = at<Kernel>(from->vertex((facet + 1) % 4)->point()), b = at<Kernel>(from->vertex((facet + 2) % 4)->point()),
                       c = at<Kernel>(from->vertex((facet + 3) % 4)->point()), d = at<Kernel>(from->vertex(facet)->point());
            auto outward = CGAL::cross_product(b - a, c - a);
            if (outward * (d - a) > 0) outward = -outward;
            return CGAL::sign(outward * towards) == CGAL::NEGATIVE;
        };
        std::vector<Triangle> umbrella;
        for (auto cell : cells) {
            if (t.is_infinite(cell)) continue;
            for (int facet = 0; facet < 4; ++facet) {
                const auto neighbour = cell->neighbor(facet);
                if (cell->vertex(facet) == p || (!t.is_infinite(neighbour) && neighbour->info() < cell->info())) continue;
                if (is_below(cell, cell) == is_below(neighbour, cell)) continue;
                Triangle others;
                int count = 0;
                for (int i = 0; i < 4; ++i)
                    if (i != facet && cell->vertex(i) != p) others[count++] = cell->vertex(i);
                umbrella.push_back(others);
            }
        }
        return umbrella;
    }

    // The two conditions for the edge pq, from p.
    void scan(Plain::Vertex_handle p, Plain::Vertex_handle q, const std::vector<Triangle>& umbrella, std::set<Edge>& chosen,
              std::set<Edge>& near) const {
        double least_sine = 1, least_ratio = INFINITY;
        const auto edge = q->point() - p->point();
        const double length = std::sqrt(edge.squared_length());
        for (const auto& [v, w] : umbrella) {
            if (v == q || w == q) return;
            const auto to_v = v->point() - p->point(), to_w = w->point() - p->point();
            const auto normal = CGAL::cross_product(to_v, to_w);
            const double size = std::sqrt(normal.squared_length());
            least_sine = std::min(least_sine, std::abs(normal * edge) / size / length);
            const double radius = std::sqrt(to_v.squared_length() * to_w.squared_length() * (to_w - to_v).squared_length()) / (2 * size);
            least_ratio = std::min(least_ratio, length / radius);
        }
        const Edge name{std::min(p->info(), q->info()), std::max(p->info(), q->info())};
        if (least_sine > sine || least_ratio > rho) chosen.insert(name);
        if (std::abs(least_sine - sine) < 1e-9 || std::abs(least_ratio / rho - 1) < 1e-9) near.insert(name);
    }

    const Plain& t;
    const std::vector<Point>& directions;
    double sine, rho;
    std::vector<typename Kernel::Point_3> centres;  // by the number of the cell
};

}  // namespace

namespace reference {

Axis medial(const std::vector<Point>& points, const std::vector<Point>& directions, double theta, double rho) {
    std::vector<std::pair<Inexact::Point_3, std::uint32_t>> rows;
    for (std::uint32_t i = 0; i < points.size(); ++i) rows.push_back({{points[i][0], points[i][1], points[i][2]}, i});
    Axis axis;
    auto begun = std::chrono::steady_clock::now();
    const Plain t(rows.begin(), rows.end());
    axis.delaunay_seconds = seconds_since(begun);
    begun = std::chrono::steady_clock::now();
    Filter<Inexact>(t, directions, theta, rho).run(axis);
    axis.filter_seconds = seconds_since(begun);
    // The same, decided exactly.
    Filter<Exact>(t, directions, theta, rho).run(axis);
    return axis;
}

}  // namespace reference
