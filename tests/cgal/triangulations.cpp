// Delaunay and regular triangulations: the finite cells of CGAL, and the same hidden points.
#include "clouds.hpp"
#include "models.hpp"
#include "report.hpp"
#include "subject.hpp"

#include <algorithm>
#include <cmath>

namespace {

using reference::Cell;
using reference::none;
using reference::Point;

// The distinct positions in lexicographic order: the numbers by which the two sides are compared.
class Positions {
public:
    explicit Positions(const std::vector<Point>& rows) : points(rows) {
        for (Point& p : points)
            for (double& x : p) x += 0.0;  // -0 is 0
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
    }
    std::uint32_t of(const Point& p) const {
        auto found = std::lower_bound(points.begin(), points.end(), p);
        return found != points.end() && *found == p ? std::uint32_t(found - points.begin()) : none;
    }

    std::vector<Point> points;
};

template <class Name>
std::vector<Cell> renamed(const std::vector<Cell>& cells, Name name) {
    std::vector<Cell> result;
    for (const Cell& cell : cells) {
        Cell ids{name(cell[0]), name(cell[1]), name(cell[2]), name(cell[3])};
        std::sort(ids.begin(), ids.end());
        result.push_back(ids);
    }
    std::sort(result.begin(), result.end());
    return result;
}

// What is wrong with the maps between rows and vertices, or nothing.
std::string wrong_maps(const std::vector<Point>& rows, const subject::Triangulation& medax, const Positions& positions,
                       const std::vector<std::uint32_t>& position_of_vertex) {
    std::vector<std::uint32_t> first_row(positions.points.size(), none);
    for (std::uint32_t r = 0; r < rows.size(); ++r) {
        const std::uint32_t position = positions.of(rows[r]);
        if (position_of_vertex.at(medax.vertex_of_row.at(r)) != position) return "vertex_of_row is wrong";
        if (medax.duplicate_of.at(r) != first_row[position]) return "duplicate_of is wrong";
        if (first_row[position] == none) first_row[position] = r;
    }
    return "";
}

// What is wrong with the cells taken by themselves, or nothing.
std::string wrong_cells(const subject::Triangulation& medax) {
    for (std::uint32_t c = 0; c < medax.cells.size(); ++c) {
        const auto& cell = medax.cells[c];
        const auto& at = medax.vertices;
        if (reference::orientation(at[cell[0]], at[cell[1]], at[cell[2]], at[cell[3]]) <= 0)
            return "cell " + std::to_string(c) + " is not positively oriented";
        for (int i = 0; i < 4; ++i) {
            const std::uint32_t neighbor = medax.neighbors[c][i];
            if (neighbor == none) continue;
            const auto& other = medax.cells.at(neighbor);
            int shared = 0;
            for (int j = 0; j < 4; ++j)
                shared += j != i && std::find(other.begin(), other.end(), cell[j]) != other.end();
            if (neighbor == c || shared != 3) return "neighbor " + std::to_string(i) + " of cell " + std::to_string(c);
        }
    }
    return "";
}

void compare(const Cloud& cloud, Report& report) {
    const bool weighted = !cloud.weights.empty();
    const Positions positions(cloud.rows);
    const subject::Triangulation medax =
        weighted ? subject::regular(cloud.rows, cloud.weights) : subject::delaunay(cloud.rows);
    const reference::Triangulation cgal =
        weighted ? reference::regular(cloud.rows, cloud.weights) : reference::delaunay(positions.points);

    std::vector<std::uint32_t> position_of_vertex;
    for (const Point& p : medax.vertices) position_of_vertex.push_back(positions.of(p));
    std::vector<std::uint32_t> once = position_of_vertex;
    std::sort(once.begin(), once.end());
    const bool same_vertices = once.size() == positions.points.size() &&
                               std::adjacent_find(once.begin(), once.end()) == once.end() &&
                               (once.empty() || once.back() != none);
    if (!same_vertices) return report.line(false, cloud.name, "the vertices are not the distinct points");

    std::vector<Cell> ours(medax.cells.begin(), medax.cells.end());
    ours = renamed(ours, [&](std::uint32_t v) { return position_of_vertex[v]; });
    const std::vector<Cell> theirs =
        weighted ? renamed(cgal.cells, [&](std::uint32_t r) { return positions.of(cloud.rows[r]); }) : cgal.cells;
    std::vector<Cell> differing;
    std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(), std::back_inserter(differing));

    // CGAL hides rows. A position is hidden when none of its rows is shown; at any other one the
    // heaviest row is shown, and that weight is the vertex's.
    std::vector<std::uint32_t> hidden, hidden_by_cgal;
    for (std::uint32_t v : medax.hidden) hidden.push_back(position_of_vertex.at(v));
    std::sort(hidden.begin(), hidden.end());
    std::string weights;
    if (weighted) {
        std::vector<bool> shown(positions.points.size());
        std::vector<double> heaviest(positions.points.size(), -INFINITY);
        std::vector<std::uint32_t> unseen = cgal.hidden;
        for (std::uint32_t r = 0, next = 0; r < cloud.rows.size(); ++r) {
            const std::uint32_t position = positions.of(cloud.rows[r]);
            heaviest[position] = std::max(heaviest[position], cloud.weights[r]);
            if (next < unseen.size() && unseen[next] == r)
                ++next;
            else
                shown[position] = true;
        }
        for (std::uint32_t position = 0; position < shown.size(); ++position)
            if (!shown[position]) hidden_by_cgal.push_back(position);
        for (std::uint32_t v = 0; v < medax.vertices.size(); ++v)
            if (medax.weights.at(v) != heaviest[position_of_vertex[v]]) weights = "; a vertex has not its heaviest row's weight";
    }

    const std::string maps = wrong_maps(cloud.rows, medax, positions, position_of_vertex);
    const std::string cells = wrong_cells(medax);
    const bool good = differing.empty() && hidden == hidden_by_cgal && weights.empty() && maps.empty() && cells.empty();
    std::string text = std::to_string(cloud.rows.size()) + " rows, " + std::to_string(positions.points.size()) +
                       " vertices, " + std::to_string(ours.size()) + " cells, " + std::to_string(hidden.size()) + " hidden";
    if (!differing.empty())
        text += "; CGAL has " + std::to_string(theirs.size()) + " cells, " + std::to_string(differing.size()) + " are in one only";
    if (hidden != hidden_by_cgal) text += "; CGAL hides " + std::to_string(hidden_by_cgal.size()) + ", not the same";
    report.line(good, cloud.name, text + weights + (maps + cells).insert(0, maps.empty() && cells.empty() ? "" : "; "));
}

// Weights that tie, and hide some points: a quarter of the squared spacing times 0, 1 or 2.
std::vector<double> model_weights(const std::vector<Point>& rows) {
    Point low = rows.front(), high = rows.front();
    for (const Point& p : rows)
        for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
    double square = 0;
    for (int i = 0; i < 3; ++i) square += (high[i] - low[i]) * (high[i] - low[i]);
    std::vector<double> weights;
    for (std::size_t i = 0; i < rows.size(); ++i)
        weights.push_back(square / static_cast<double>(rows.size()) * 0.25 * static_cast<double>(i * 7 % 3));
    return weights;
}

}  // namespace

int main() {
    Report report;
    for (const Cloud& cloud : plain_clouds()) compare(cloud, report);
    for (const Cloud& cloud : weighted_clouds()) compare(cloud, report);
    for (const Model& model : models(50000)) {
        compare({model.name, model.points, {}}, report);
        compare({model.name + ", tied weights", model.points, model_weights(model.points)}, report);
    }
    return report.finish("triangulations like CGAL's");
}
