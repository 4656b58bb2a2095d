// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file medax_cgal.hpp
/// Between CGAL and medax: Surface_mesh, and ranges of Point_3, of any kernel whose numbers CGAL::to_double takes.
/// Header only; the program that includes it uses CGAL, under CGAL's licence.
///
/// - Rows and vertices are in the order of the range, or of the mesh's vertices without removed ones: where none is
///   removed, vertex i on one side is vertex i on the other.
/// - Coordinates are rounded to double.
/// - A Surface_mesh holds faces and their corners. Loose edges and cells of a complex have no place in it.

#include <medax/convert.hpp>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/number_utils.h>

#include <type_traits>

namespace medax::cgal {

namespace detail {

/// Of a point or a vector.
template <class V>
Point point(const V &v) {
    return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}
/// Of a point with its normal.
template <class P, class V>
Point point(const std::pair<P, V> &oriented) {
    return point(oriented.first);
}

template <class P>
using Vector = typename CGAL::Kernel_traits<P>::Kernel::Vector_3;

/// Gives each element the values of its row.
template <class V, class Mesh, class Index>
void carry(Mesh &mesh, const std::string &name, const Attribute &attribute, const std::vector<Index> &elements,
           const std::vector<std::uint32_t> &rows) {
    const auto fill = [&](auto none, auto &&make) {
        auto property = mesh.template add_property_map<Index>(name, none).first;
        for (std::size_t i = 0; i < elements.size(); ++i) property[elements[i]] = make(rows[i]);
    };
    const View<double> f = attribute.f64_values;
    const View<std::uint32_t> u = attribute.u32_values;
    using Numbers = std::vector<double>;
    using Indices = std::vector<std::uint32_t>;
    if (attribute.value_type == MEDAX_VALUE_TYPE_U32 && u.cols() == 1)
        fill(std::uint32_t(), [&](std::size_t row) { return u[row][0]; });
    else if (attribute.value_type == MEDAX_VALUE_TYPE_U32)
        fill(Indices(), [&](std::size_t row) { return Indices(u[row].begin(), u[row].end()); });
    else if (f.cols() == 1)
        fill(double(), [&](std::size_t row) { return f[row][0]; });
    else if (f.cols() == 3)
        fill(V(0, 0, 0), [&](std::size_t row) { return V(f[row][0], f[row][1], f[row][2]); });
    else
        fill(Numbers(), [&](std::size_t row) { return Numbers(f[row].begin(), f[row].end()); });
}

}  // namespace detail

/// The places of points, of points paired with normals, or the components of vectors.
template <class Range>
std::vector<Point> coordinates(const Range &range) {
    std::vector<Point> places;
    for (const auto &element : range) places.push_back(detail::point(element));
    return places;
}
/// The places of the vertices.
template <class P>
std::vector<Point> coordinates(const CGAL::Surface_mesh<P> &mesh) {
    std::vector<Point> places;
    places.reserve(mesh.number_of_vertices());
    for (const auto v : mesh.vertices()) places.push_back(detail::point(mesh.point(v)));
    return places;
}

/// The normals of points that are paired with them. For the order of points: medax::by_vertex.
template <class P, class V>
std::vector<Point> normals(const std::vector<std::pair<P, V>> &oriented) {
    std::vector<Point> normals;
    normals.reserve(oriented.size());
    for (const auto &[place, normal] : oriented) normals.push_back(detail::point(normal));
    return normals;
}
/// The normals of the vertices, the property `v:normal`; none if the mesh has no such property.
template <class P>
std::vector<Point> normals(const CGAL::Surface_mesh<P> &mesh) {
    using Vertex = typename CGAL::Surface_mesh<P>::Vertex_index;
    std::vector<Point> normals;
    const auto [property, found] = mesh.template property_map<Vertex, detail::Vector<P>>("v:normal");
    if (!found) return normals;
    normals.reserve(mesh.number_of_vertices());
    for (const Vertex v : mesh.vertices()) normals.push_back(detail::point(property[v]));
    return normals;
}

/// A range of points, or the vertices of a Surface_mesh, as points, one row each.
template <class Range>
Points points(const Range &range, const PointsOptions &options = {}, const Job &job = Job::fresh()) {
    return Points::from(coordinates(range), options, job);
}

/// The mesh as a complex, with the attribute `normal` if it has the property `v:normal`, and with those properties of
/// vertices that are named, without `v:`, of type double. Throws std::invalid_argument where there is no such property.
template <class P>
Complex complex(const CGAL::Surface_mesh<P> &mesh, const std::vector<std::string> &properties = {}) {
    using Vertex = typename CGAL::Surface_mesh<P>::Vertex_index;
    medax::detail::Parts parts;
    parts.vertices = coordinates(mesh);
    std::vector<std::uint32_t> number(mesh.num_vertices());
    std::uint32_t next = 0;
    for (const Vertex v : mesh.vertices()) number[v] = next++;
    for (const auto f : mesh.faces()) {
        const auto first = mesh.halfedge(f);
        auto side = first;
        do {
            parts.indices.push_back(number[mesh.target(side)]);
            side = mesh.next(side);
        } while (side != first);
        parts.end_face();
    }
    const std::vector<Point> its_normals = normals(mesh);
    if (!its_normals.empty()) parts.add("normal", its_normals);
    for (const std::string &name : properties) {
        const auto [property, found] = mesh.template property_map<Vertex, double>("v:" + name);
        if (!found) throw std::invalid_argument("the vertices have no property 'v:" + name + "' of type double");
        std::vector<double> values;
        values.reserve(mesh.number_of_vertices());
        for (const Vertex v : mesh.vertices()) values.push_back(property[v]);
        parts.add(name, std::move(values));
    }
    return parts.complex();
}

/// The vertices and faces of a complex as a Surface_mesh. Attributes become properties `v:NAME` of vertices and `f:NAME` of faces:
/// double, Vector_3 or std::vector<double>, std::uint32_t or std::vector<std::uint32_t>.
///
/// A face that does not fit is left out, and its number put into `left_out`; without that list medax::NotManifold is
/// thrown, and medax::soup<Point_3> serves instead, for CGAL::Polygon_mesh_processing.
template <class Mesh>
Mesh mesh(const Complex &complex, std::vector<std::uint32_t> *left_out = nullptr) {
    using P = typename Mesh::Point;
    Mesh mesh;
    const View<double> xyz = complex.vertices();
    std::vector<typename Mesh::Vertex_index> vertices, ring;
    std::vector<typename Mesh::Face_index> faces;
    std::vector<std::uint32_t> rows, face_rows;
    vertices.reserve(xyz.rows());
    for (std::size_t v = 0; v < xyz.rows(); ++v) {
        vertices.push_back(mesh.add_vertex(P(xyz[v][0], xyz[v][1], xyz[v][2])));
        rows.push_back(static_cast<std::uint32_t>(v));
    }
    const Rows rings = complex.faces();
    medax::detail::Fitting fitting(xyz.rows(), rings);
    for (std::uint32_t f = 0; f < rings.rows(); ++f) {
        auto added = Mesh::null_face();
        if (fitting.take(rings[f])) {
            ring.clear();
            for (const std::uint32_t v : rings[f]) ring.push_back(vertices[v]);
            added = mesh.add_face(ring);
        }
        if (added == Mesh::null_face()) {
            medax::detail::left_out(f, left_out);
            continue;
        }
        faces.push_back(added);
        face_rows.push_back(f);
    }
    for (std::size_t i = 0; i < complex.attribute_count(); ++i) {
        const Attribute attribute = complex.attribute(i);
        const std::string name = attribute.name;
        if (attribute.element == MEDAX_ELEMENT_VERTEX)
            detail::carry<detail::Vector<P>>(mesh, "v:" + name, attribute, vertices, rows);
        else if (attribute.element == MEDAX_ELEMENT_FACE)
            detail::carry<detail::Vector<P>>(mesh, "f:" + name, attribute, faces, face_rows);
    }
    return mesh;
}

/// Balls as weighted points of a kernel, for its regular triangulations: rows of a centre and a radius, and squared
/// radii, as medax::Poles has them.
template <class Kernel>
std::vector<typename Kernel::Weighted_point_3> weighted_points(View<double> balls, View<double> radii_squared) {
    std::vector<typename Kernel::Weighted_point_3> points;
    points.reserve(balls.rows());
    for (std::size_t i = 0; i < balls.rows(); ++i) {
        const Span<double> ball = balls[i];
        points.emplace_back(typename Kernel::Point_3(ball[0], ball[1], ball[2]), radii_squared[i][0]);
    }
    return points;
}

}  // namespace medax::cgal
