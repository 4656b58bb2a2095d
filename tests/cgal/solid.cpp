#include "solid.hpp"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

}  // namespace

Solid load_into_openmesh(const std::vector<reference::Point>& vertices,
                         const std::vector<std::array<std::uint32_t, 3>>& triangles) {
    omerr().disable();  // what it refuses is counted
    Mesh mesh;
    std::vector<Mesh::VertexHandle> handles;
    for (const auto& [x, y, z] : vertices) handles.push_back(mesh.add_vertex({x, y, z}));
    Solid solid;
    for (const auto& [a, b, c] : triangles)
        if (!mesh.add_face(handles[a], handles[b], handles[c]).is_valid()) ++solid.complex_faces;
    for (const auto edge : mesh.edges()) solid.boundary_edges += mesh.is_boundary(edge);
    for (const auto vertex : mesh.vertices()) {
        solid.isolated_vertices += mesh.is_isolated(vertex);
        solid.complex_vertices += !mesh.is_manifold(vertex);
    }
    solid.euler_characteristic = long(mesh.n_vertices()) - long(mesh.n_edges()) + long(mesh.n_faces());
    return solid;
}
