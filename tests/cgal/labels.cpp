#include "labels.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace reference {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Point& p) { return {p[0], p[1], p[2]}; }

double squared_distance(const Point& p, const Point& q) {
    double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
    return x * x + y * y + z * z;
}

double minus_cosine(const Point& at, const Point& p, const Point& q) {
    double dot = 0;
    for (int i = 0; i < 3; ++i) dot += (p[i] - at[i]) * (q[i] - at[i]);
    return -dot / std::sqrt(squared_distance(p, at) * squared_distance(q, at));
}

std::vector<Edge> edges_of(const std::vector<Cell>& cells) {
    std::vector<Edge> edges;
    for (const Cell& cell : cells)
        for (int i = 0; i < 4; ++i)
            for (int j = i + 1; j < 4; ++j) edges.push_back({cell[i], cell[j]});
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

// Balls whose power cell is unbounded: those on the hull of the triangulation.
std::vector<bool> unbounded(std::size_t count, const std::vector<Cell>& cells) {
    std::vector<std::array<std::uint32_t, 3>> sides;
    for (const auto& [i, j, k, l] : cells) sides.insert(sides.end(), {{j, k, l}, {i, k, l}, {i, j, l}, {i, j, k}});
    std::sort(sides.begin(), sides.end());
    std::vector<bool> result(count);
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (i + 1 < sides.size() && sides[i] == sides[i + 1])
            ++i;
        else
            for (std::uint32_t v : sides[i]) result[v] = true;
    return result;
}

// The values `in` and `out` of every ball, and the queue of those that have been reached but not labelled.
class Queue {
public:
    explicit Queue(std::size_t count) : in(count), out(count), labelled(count) {}
    bool empty() const { return queue.empty(); }
    void raise(std::vector<double>& values, std::uint32_t p, double value) {
        if (labelled[p] || value <= values[p]) return;
        queue.erase({-priority(p), p});
        values[p] = value;
        queue.emplace(-priority(p), p);
    }
    std::uint32_t pop() {
        std::uint32_t p = queue.begin()->second;
        queue.erase(queue.begin());
        labelled[p] = true;
        return p;
    }

    std::vector<double> in, out;

private:
    double priority(std::uint32_t p) const {
        return in[p] > 0 && out[p] > 0 ? std::abs(in[p] - out[p]) - 1 : std::max(in[p], out[p]);
    }
    std::vector<bool> labelled;
    std::set<std::pair<double, std::uint32_t>> queue;  // the greatest priority first, then the least ball
};

// The ball that hides each hidden one: the heaviest at its place, or if that is itself the one of least power there.
std::vector<Edge> hiding(const Balls& balls, const Triangulation& regular) {
    const std::size_t count = balls.sites.size();
    std::vector<bool> hidden(count);
    for (std::uint32_t p : regular.hidden) hidden[p] = true;
    std::map<Point, std::uint32_t> heaviest;
    for (std::uint32_t p = 0; p < count; ++p) {
        const auto [place, is_new] = heaviest.try_emplace(balls.sites[p], p);
        if (!is_new && balls.weights[p] > balls.weights[place->second]) place->second = p;
    }
    std::vector<Edge> links;
    for (std::uint32_t p : regular.hidden) {
        std::uint32_t nearest = heaviest.at(balls.sites[p]);
        if (nearest == p) {
            nearest = none;
            const Kernel::Point_3 at = point(balls.sites[p]);
            for (std::uint32_t q = 0; q < count; ++q) {
                if (hidden[q]) continue;
                const auto order = nearest == none ? CGAL::SMALLER
                                                   : Kernel().compare_power_distance_3_object()(
                                                         at, Kernel::Weighted_point_3(point(balls.sites[q]), balls.weights[q]),
                                                         Kernel::Weighted_point_3(point(balls.sites[nearest]), balls.weights[nearest]));
                if (order == CGAL::SMALLER || (order == CGAL::EQUAL && balls.rank[q] < balls.rank[nearest])) nearest = q;
            }
        }
        links.push_back({p, nearest});
    }
    return links;
}

}  // namespace

Crust power_crust(const Balls& balls, const Triangulation& regular, double deep) {
    struct Link {
        std::uint32_t to;
        double weight;
    };
    const std::size_t count = balls.centres.size();
    std::vector<std::vector<Link>> same(count), opposite(count);
    const std::vector<Edge> edges = edges_of(regular.cells);
    std::vector<Edge> meeting = edges;
    for (const Edge& link : hiding(balls, regular)) meeting.push_back(link);
    for (const auto& [p, q] : meeting) {
        const double r = balls.radii[p], t = balls.radii[q];
        double cosine = (r * r + t * t - squared_distance(balls.centres[p], balls.centres[q])) / (2 * r * t);
        double weight = std::clamp(cosine, -1.0, 1.0);
        if (!(weight > deep)) continue;
        same[p].push_back({q, weight});
        same[q].push_back({p, weight});
    }
    for (std::size_t s = 0; s < balls.samples.size(); ++s) {
        const auto& [p, q] = balls.pole_of_sample[s];
        if (p == none || q == none) continue;
        double weight = std::min(minus_cosine(balls.samples[s], balls.centres[p], balls.centres[q]), 1.0);
        // Centres are rounded: what is exactly an obtuse angle may not be one, or there is none at all.
        if (!(weight > 0)) continue;
        opposite[p].push_back({q, weight});
        opposite[q].push_back({p, weight});
    }

    Crust crust;
    crust.inner.resize(count);  // outer, as what nothing reaches
    Queue queue(count);
    for (std::uint32_t p = 0; p < count; ++p)
        if (balls.seed[p]) queue.raise(queue.out, p, 1);
    while (!queue.empty()) {
        const std::uint32_t p = queue.pop();
        const bool inner = queue.in[p] > queue.out[p];
        const double belief = std::max(queue.in[p], queue.out[p]);
        crust.inner[p] = inner;
        for (const Link& link : opposite[p]) queue.raise(inner ? queue.out : queue.in, link.to, belief * link.weight);
        for (const Link& link : same[p]) queue.raise(inner ? queue.in : queue.out, link.to, belief * link.weight);
    }
    const std::vector<bool> open = unbounded(count, regular.cells);
    for (std::uint32_t p = 0; p < count; ++p) {
        crust.forced += open[p] && crust.inner[p];
        crust.inner[p] = crust.inner[p] && !open[p];
    }
    for (const auto& [p, q] : edges)
        if (crust.inner[p] != crust.inner[q])
            crust.facets.push_back(crust.inner[p] ? Edge{p, q} : Edge{q, p});
    std::sort(crust.facets.begin(), crust.facets.end());
    return crust;
}

}  // namespace reference
