// A triangle mesh as OpenMesh sees it.
#pragma once

#include "reference.hpp"

#include <cstddef>
#include <string>
#include <vector>

struct Solid {
    std::size_t complex_faces = 0;  // triangles that OpenMesh refused: complex edges or vertices
    std::size_t boundary_edges = 0;
    std::size_t complex_vertices = 0;  // more than one fan
    std::size_t isolated_vertices = 0;
    long euler_characteristic = 0;

    bool closed_manifold() const {
        return complex_faces + boundary_edges + complex_vertices + isolated_vertices == 0;
    }
};

// Loads the mesh into OpenMesh, triangle by triangle.
Solid load_into_openmesh(const std::vector<reference::Point>& vertices,
                         const std::vector<std::array<std::uint32_t, 3>>& triangles);
