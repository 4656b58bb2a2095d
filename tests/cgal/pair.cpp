// The surfaces of pair-meshes in CGAL: closed, oriented, of the genus of the boundary, without self-intersections.
//
// Where tetrahedra are as small as rounding, so is what lies between their triangles, and between those of their neighbours: there the rounded corners of triangles
// that do not meet may make them meet. All that meet are told, and looked at again with corners that are not rounded: these must not meet anywhere.
//
// usage: cgal_pair [--all | NAME...]
// The shapes and the small models; with --all also those that take minutes, or only those that are named.
#include "models.hpp"
#include "reference.hpp"
#include "report.hpp"
#include "subject.hpp"

#include <medax.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

namespace fs = std::filesystem;

namespace {

using reference::Point;
using Triangle = std::array<std::uint32_t, 3>;

constexpr double times[] = {0.001, 0.01, 0.05, 0.1, 0.3, 0.5, 0.75, 0.9};
// Tetrahedra below this share of the volume are as small as rounding, and exempt.
constexpr double least_share = 1e-12;

Point place(medax::Span<double> p) { return {p[0], p[1], p[2]}; }

// The faces of a surface as fans from their first corners, as the tetrahedra of a pyramid are.
struct Fans {
    std::vector<Point> vertices;
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> face;  // of each triangle

    explicit Fans(const medax::Complex& surface) {
        const auto places = surface.vertices();
        for (std::size_t i = 0; i < places.rows(); ++i) vertices.push_back(place(places[i]));
        const auto faces = surface.faces();
        for (std::uint32_t f = 0; f < faces.rows(); ++f) {
            const auto ring = faces[f];
            const std::vector<std::uint32_t> corners(ring.begin(), ring.end());
            for (std::size_t i = 2; i < corners.size(); ++i) {
                triangles.push_back({corners[0], corners[i - 1], corners[i]});
                face.push_back(f);
            }
        }
    }
};

// The pair-mesh of samples, and that of their medial axis.
std::array<medax::Pair, 2> pairs_of(const std::vector<Point>& points) {
    medax::DualOptions with_facets;
    with_facets.facets = 1;
    const auto dual = medax::Dual::of(medax::Triangulation::delaunay(medax::Points::from(points)), with_facets);
    const auto labels = medax::Labels::of(medax::Cocone::of(dual));
    const auto pair = medax::Pair::voronoi(dual, labels);
    return {pair, pair.onto(medax::Medial::of(dual, labels).axis())};
}

// The tetrahedra to which the triangles of a surface belong, and which of them are exempt.
class Tetrahedra {
public:
    Tetrahedra(const medax::Pair& pair, const Fans& fans) : triangles_(fans.triangles), next_(pair.nodes().rows() + pair.inner_vertices().rows(), reference::none) {
        const auto boundary = pair.boundary_vertices(), inner = pair.inner_vertices();
        const auto at = [&](std::uint32_t v) { return v < boundary.rows() ? boundary[v] : inner[v - boundary.rows()]; };
        const auto nodes = pair.nodes();
        const double all = pair.enclosed_volume();
        const std::size_t pyramids = pair.element_count(MEDAX_PAIR_ELEMENT_FACE_VERTEX);
        std::uint32_t piece = 0;
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const std::uint32_t element = fans.face[i];
            piece = element < pyramids && i > 0 && fans.face[i - 1] == element ? piece + 1 : 0;
            const auto corners = pair.piece(element, piece);
            double u[3][3];
            for (int j = 0; j < 3; ++j)
                for (int k = 0; k < 3; ++k) u[j][k] = at(corners[j + 1])[k] - at(corners[0])[k];
            const double volume = (u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) + u[0][1] * (u[1][2] * u[2][0] - u[1][0] * u[2][2]) +
                                   u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0])) / 6;
            shares_.push_back(volume / all);
            if (!is_exempt(i)) continue;
            for (const std::uint32_t node : triangles_[i]) {
                join(node, triangles_[i][0]);
                join(node, std::uint32_t(nodes.rows()) + nodes[node][1]);
            }
        }
    }
    double share(std::size_t triangle) const { return shares_[triangle]; }
    bool is_exempt(std::size_t triangle) const { return shares_[triangle] < least_share; }
    // Whether exempt tetrahedra lead from one triangle to another: then nothing is left between the two but rounding.
    bool are_parted_by_exempt(std::size_t one, std::size_t other) {
        std::set<std::uint32_t> reached;
        for (const std::uint32_t node : triangles_[one]) reached.insert(first(node));
        reached.erase(reference::none);
        const Triangle& corners = triangles_[other];
        return std::any_of(corners.begin(), corners.end(), [&](std::uint32_t node) { return reached.count(first(node)) != 0; });
    }

private:
    // The same for all nodes of exempt tetrahedra that hang together in nodes or, on whatever side of the inner structure, in inner vertices, which count after
    // the nodes; none for a node of no exempt one.
    std::uint32_t first(std::uint32_t node) {
        if (next_[node] == reference::none) return reference::none;
        while (next_[node] != node) node = next_[node] = next_[next_[node]];
        return node;
    }
    void join(std::uint32_t one, std::uint32_t other) {
        for (const std::uint32_t node : {one, other})
            if (next_[node] == reference::none) next_[node] = node;
        next_[first(one)] = first(other);
    }

    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> next_;
    std::vector<double> shares_;
};

void compare_one(const std::string& name, const medax::Pair& pair, Report& report) {
    const Fans boundary(pair.boundary());
    const reference::Surface last = reference::surface(boundary.vertices, boundary.triangles);
    Tetrahedra tetrahedra(pair, Fans(pair.iso_surface(0.5)));
    std::map<std::uint32_t, double> exempt;
    for (const double t : times) {
        const Fans fans(pair.iso_surface(t));
        const reference::Surface found = reference::surface(fans.vertices, fans.triangles);
        // Where a node is before it is rounded.
        const auto corner = [&](std::uint32_t node) {
            const auto ends = pair.nodes()[node];
            return reference::Between{place(pair.inner_vertices()[ends[1]]), place(pair.boundary_vertices()[ends[0]]), t};
        };
        double off = 0;
        for (std::uint32_t node = 0; node < fans.vertices.size(); ++node) {
            const auto [from, to, share] = corner(node);
            for (int k = 0; k < 3; ++k)
                off = std::max(off, std::abs(from[k] + share * (to[k] - from[k]) - fans.vertices[node][k]) / (std::abs(from[k]) + std::abs(to[k])));
        }
        std::size_t wrong = 0, small = 0, beside_small = 0;
        for (const auto& [a, b] : found.meeting) {
            const Triangle p = fans.triangles[a], q = fans.triangles[b];
            const bool is_rounding = !reference::meet({corner(p[0]), corner(p[1]), corner(p[2]), corner(q[0]), corner(q[1]), corner(q[2])},
                                                      {p[0], p[1], p[2], q[0], q[1], q[2]});
            if (is_rounding && (tetrahedra.is_exempt(a) || tetrahedra.is_exempt(b))) {
                ++small;
                for (const std::uint32_t triangle : {a, b})
                    if (tetrahedra.is_exempt(triangle)) exempt[fans.face[triangle]] = tetrahedra.share(triangle);
                continue;
            }
            const bool is_beside = is_rounding && tetrahedra.are_parted_by_exempt(a, b);
            ++(is_beside ? beside_small : wrong);
            std::printf("       elements %u and %u: tetrahedra of %.1e and %.1e of the volume meet %s%s\n", fans.face[a], fans.face[b], tetrahedra.share(a),
                        tetrahedra.share(b), is_rounding ? "by rounding" : "exactly", is_beside ? ", parted by exempt ones" : "");
        }
        char text[200];
        std::snprintf(text, sizeof text, "t = %-5g %zu triangles, genus %ld; meeting: %zu exempt, %zu parted by these, %zu others; nodes off by %.0e", t,
                      fans.triangles.size(), 1 - found.euler_characteristic / 2, small, beside_small, wrong, off);
        const bool good = found.oriented_manifold && found.closed && found.volume > 0 && last.closed &&
                          found.euler_characteristic == last.euler_characteristic && off < 1e-15 && wrong == 0;
        report.line(good, name, text);
    }
    if (exempt.empty()) return;
    std::printf("       elements with exempt tetrahedra, and their share of the volume:");
    for (const auto& [element, share] : exempt) std::printf(" %u (%.1e)", element, share);
    std::printf("\n");
}

void compare(const std::string& name, const std::vector<Point>& points, Report& report) {
    const auto [pair, medial] = pairs_of(points);
    compare_one(name, pair, report);
    compare_one(name + ", medial", medial, report);
}

}  // namespace

int main(int count, char** arguments) {
    const std::set<std::string> named(arguments + 1, arguments + count);
    const bool is_all = named.count("--all") != 0;
    Report report;
    for (const Model& shape : shapes())
        if (named.empty() || is_all || named.count(shape.name) != 0) compare(shape.name, shape.points, report);
    const fs::path directory = MEDAX_DATA_DIR;
    const std::vector<std::pair<const char*, bool>> files = {
        {"3holes.off", true},  {"kitten.xyz", true},            {"rocker-arm.obj", false}, {"mannequin.off", false},
        {"foot.off", false},   {"refined_elephant.off", false}, {"igea.ply", false},
    };
    for (const auto& [file, is_small] : files) {
        const fs::path path = directory / file;
        if (named.empty() ? !is_small : !is_all && named.count(file) == 0) continue;
        if (!fs::exists(path))
            std::printf("skipped: there is no %s\n", path.c_str());
        else
            compare(file, subject::read(path.string()), report);
    }
    return report.finish("surfaces of pair-meshes in CGAL");
}
