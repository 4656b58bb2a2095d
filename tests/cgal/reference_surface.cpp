// Closed surfaces and their self-intersections by CGAL's polygon mesh processing.
#include "reference.hpp"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/shape_predicates.h>
#include <CGAL/Surface_mesh.h>

#include <iterator>
#include <map>

namespace processing = CGAL::Polygon_mesh_processing;

namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

}  // namespace

namespace reference {

Surface surface(const std::vector<Point>& points, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    using Mesh = CGAL::Surface_mesh<Inexact::Point_3>;
    Surface found;
    found.oriented_manifold = processing::is_polygon_soup_a_polygon_mesh(triangles);
    if (!found.oriented_manifold) return found;
    Mesh mesh;
    std::vector<Mesh::Vertex_index> vertices;
    for (const auto& [x, y, z] : points) vertices.push_back(mesh.add_vertex({x, y, z}));
    // Faces are numbered as they come.
    for (const auto& [a, b, c] : triangles) mesh.add_face(vertices[a], vertices[b], vertices[c]);
    found.closed = CGAL::is_closed(mesh);
    found.volume = found.closed ? CGAL::to_double(processing::volume(mesh)) : 0;
    found.euler_characteristic = long(mesh.number_of_vertices()) - long(mesh.number_of_edges()) + long(mesh.number_of_faces());
    for (const auto face : mesh.faces())
        if (processing::is_degenerate_triangle_face(face, mesh)) found.meeting.push_back({face, face});
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    processing::self_intersections(mesh, std::back_inserter(pairs));
    for (const auto& [a, b] : pairs) found.meeting.push_back({a, b});
    return found;
}

bool meet(const std::array<Between, 6>& corners, const std::array<std::uint32_t, 6>& names) {
    CGAL::Surface_mesh<Exact::Point_3> mesh;
    std::map<std::uint32_t, CGAL::SM_Vertex_index> vertices;
    for (std::size_t i = 0; i < 6; ++i) {
        const auto& [from, to, t] = corners[i];
        const Exact::Point_3 p(from[0], from[1], from[2]), q(to[0], to[1], to[2]);
        if (vertices.count(names[i]) == 0) vertices[names[i]] = mesh.add_vertex(p + Exact::FT(t) * (q - p));
    }
    for (std::size_t i = 0; i < 6; i += 3) {
        if (i == 3 && std::equal(names.begin(), names.begin() + 3, names.begin() + 3)) break;
        const auto face = mesh.add_face(vertices[names[i]], vertices[names[i + 1]], vertices[names[i + 2]]);
        if (processing::is_degenerate_triangle_face(face, mesh)) return true;
    }
    return processing::does_self_intersect(mesh);
}

}  // namespace reference
