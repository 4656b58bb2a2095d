// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file medax_openmesh.hpp
/// Between OpenMesh and medax: TriMesh_ArrayKernelT and PolyMesh_ArrayKernelT, of any traits with three coordinates.
/// Header only; include the header of your mesh's kernel first, and link OpenMesh as ever.
///
/// - Rows and vertices are in the order of the mesh's vertices, without deleted ones: where none is deleted, vertex i
///   on one side is vertex i on the other.
/// - A mesh holds faces and their corners. Loose edges and cells of a complex have no place in it.

#include <medax/convert.hpp>

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Utils/Property.hh>

#include <type_traits>

namespace medax::openmesh {

namespace detail {

template <class V>
Point point(const V &v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

template <class V>
V vector(Span<double> xyz) {
    V v;
    for (int k = 0; k < 3; ++k) v[k] = static_cast<std::decay_t<decltype(v[0])>>(xyz[k]);
    return v;
}

/// Gives each element that is valid the values of its row.
template <template <class> class Property, class Mesh, class Handle>
void carry(Mesh &mesh, const Attribute &attribute, const std::vector<Handle> &elements,
           const std::vector<std::uint32_t> &rows) {
    const auto fill = [&](auto property, auto &&make) {
        mesh.add_property(property, attribute.name);
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (elements[i].is_valid()) mesh.property(property, elements[i]) = make(rows[i]);
    };
    const View<double> f = attribute.f64_values;
    const View<std::uint32_t> u = attribute.u32_values;
    using Numbers = std::vector<double>;
    using Indices = std::vector<std::uint32_t>;
    if (attribute.value_type == MEDAX_VALUE_TYPE_U32 && u.cols() == 1)
        fill(Property<std::uint32_t>(), [&](std::size_t row) { return u[row][0]; });
    else if (attribute.value_type == MEDAX_VALUE_TYPE_U32)
        fill(Property<Indices>(), [&](std::size_t row) { return Indices(u[row].begin(), u[row].end()); });
    else if (f.cols() == 1)
        fill(Property<double>(), [&](std::size_t row) { return f[row][0]; });
    else if (f.cols() == 3)
        fill(Property<OpenMesh::Vec3d>(), [&](std::size_t row) { return vector<OpenMesh::Vec3d>(f[row]); });
    else
        fill(Property<Numbers>(), [&](std::size_t row) { return Numbers(f[row].begin(), f[row].end()); });
}

}  // namespace detail

/// The places of the vertices.
template <class Mesh>
std::vector<Point> coordinates(const Mesh &mesh) {
    std::vector<Point> places;
    places.reserve(mesh.n_vertices());
    for (const typename Mesh::VertexHandle v : mesh.vertices()) places.push_back(detail::point(mesh.point(v)));
    return places;
}

/// The normals of the vertices; none if the mesh has no such property. For the order of points: medax::by_vertex.
template <class Mesh>
std::vector<Point> normals(const Mesh &mesh) {
    std::vector<Point> normals;
    if (!mesh.has_vertex_normals()) return normals;
    normals.reserve(mesh.n_vertices());
    for (const typename Mesh::VertexHandle v : mesh.vertices()) normals.push_back(detail::point(mesh.normal(v)));
    return normals;
}

/// The vertices as points, one row each.
template <class Mesh>
Points points(const Mesh &mesh, const PointsOptions &options = {}, const Job &job = Job::fresh()) {
    return Points::from(coordinates(mesh), options, job);
}

/// The mesh as a complex, with the attribute `normal` if it has normals of vertices, and with those properties of vertices
/// that are named, of type double. Throws std::invalid_argument where there is no such property.
template <class Mesh>
Complex complex(const Mesh &mesh, const std::vector<std::string> &properties = {}) {
    medax::detail::Parts parts;
    parts.vertices = coordinates(mesh);
    std::vector<std::uint32_t> number(mesh.n_vertices());
    std::uint32_t next = 0;
    for (const typename Mesh::VertexHandle v : mesh.vertices()) number[v.idx()] = next++;
    for (const typename Mesh::FaceHandle f : mesh.faces()) {
        for (auto corner = mesh.cfv_iter(f); corner.is_valid(); ++corner) parts.indices.push_back(number[corner->idx()]);
        parts.end_face();
    }
    if (mesh.has_vertex_normals()) parts.add("normal", normals(mesh));
    for (const std::string &name : properties) {
        OpenMesh::VPropHandleT<double> property;
        if (!mesh.get_property_handle(property, name))
            throw std::invalid_argument("the vertices have no property '" + name + "' of type double");
        std::vector<double> values;
        for (const typename Mesh::VertexHandle v : mesh.vertices()) values.push_back(mesh.property(property, v));
        parts.add(name, std::move(values));
    }
    return parts.complex();
}

/// The vertices and faces of a complex as a mesh, as triangles where the mesh has no others. Attributes become properties of their
/// names: double, OpenMesh::Vec3d or std::vector<double>, std::uint32_t or std::vector<std::uint32_t>; `normal` becomes
/// the normals.
///
/// A face that does not fit is left out, and its number put into `left_out`; without that list medax::NotManifold is
/// thrown, and medax::soup serves instead.
template <class Mesh>
Mesh mesh(const Complex &complex, std::vector<std::uint32_t> *left_out = nullptr) {
    using VertexHandle = typename Mesh::VertexHandle;
    using FaceHandle = typename Mesh::FaceHandle;
    Mesh mesh;
    const View<double> xyz = complex.vertices();
    std::vector<VertexHandle> vertices;
    std::vector<FaceHandle> faces;
    std::vector<std::uint32_t> rows, face_rows;
    vertices.reserve(xyz.rows());
    for (std::size_t v = 0; v < xyz.rows(); ++v) {
        vertices.push_back(mesh.add_vertex(detail::vector<typename Mesh::Point>(xyz[v])));
        rows.push_back(static_cast<std::uint32_t>(v));
    }
    std::vector<VertexHandle> ring;
    const auto add_all = [&](const auto &rings, auto &&face_of) {
        medax::detail::Fitting fitting(xyz.rows(), rings);
        for (std::size_t i = 0; i < rings.rows(); ++i) {
            FaceHandle added;
            if (fitting.take(rings[i])) {
                ring.clear();
                for (const std::uint32_t v : rings[i]) ring.push_back(vertices[v]);
                added = mesh.add_face(ring);
            }
            const std::uint32_t face = face_of(i);
            if (added.is_valid()) {
                faces.push_back(added);
                face_rows.push_back(face);
            } else {
                medax::detail::left_out(face, left_out);
            }
        }
    };
    if constexpr (Mesh::IsTriMesh)
        add_all(complex.triangles(), [&](std::size_t t) { return complex.face_of_triangle()[t][0]; });
    else
        add_all(complex.faces(), [](std::size_t f) { return static_cast<std::uint32_t>(f); });
    for (std::size_t i = 0; i < complex.attribute_count(); ++i) {
        const Attribute attribute = complex.attribute(i);
        const bool is_normal = attribute.name == std::string("normal") && attribute.f64_values.cols() == 3;
        if (attribute.element == MEDAX_ELEMENT_VERTEX && is_normal) {
            mesh.request_vertex_normals();
            for (std::size_t v = 0; v < vertices.size(); ++v)
                mesh.set_normal(vertices[v], detail::vector<typename Mesh::Normal>(attribute.f64_values[v]));
        } else if (attribute.element == MEDAX_ELEMENT_VERTEX) {
            detail::carry<OpenMesh::VPropHandleT>(mesh, attribute, vertices, rows);
        } else if (attribute.element == MEDAX_ELEMENT_FACE) {
            detail::carry<OpenMesh::FPropHandleT>(mesh, attribute, faces, face_rows);
        }
    }
    return mesh;
}

}  // namespace medax::openmesh
