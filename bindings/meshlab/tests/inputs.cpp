// SPDX-License-Identifier: MIT OR Apache-2.0
// Writes what the tests open in MeshLab: points of a torus, a box as a mesh, and a file without vertices.

#include <medax.hpp>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <vector>

namespace {

/// The surface of the box from the origin to (4, 3, 1), cut into squares of side 0.1 and these into triangles.
medax::Complex box() {
    const std::array<int, 3> steps{40, 30, 10};
    std::map<std::array<int, 3>, std::uint32_t> number;
    std::vector<medax::Point> vertices;
    std::vector<std::uint32_t> corners, offsets{0};
    const auto vertex = [&](const std::array<int, 3> &at) {
        const auto added = number.emplace(at, static_cast<std::uint32_t>(vertices.size()));
        if (added.second) vertices.push_back({at[0] / 10.0, at[1] / 10.0, at[2] / 10.0});
        return added.first->second;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (const int end : {0, steps[axis]}) {
            for (int i = 0; i < steps[u]; ++i) {
                for (int j = 0; j < steps[v]; ++j) {
                    const auto corner = [&](int du, int dv) {
                        std::array<int, 3> at;
                        at[axis] = end;
                        at[u] = i + du;
                        at[v] = j + dv;
                        return vertex(at);
                    };
                    const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                                        d = corner(0, 1);
                    // Seen from outside, counterclockwise.
                    if (end == 0)
                        corners.insert(corners.end(), {a, c, b, a, d, c});
                    else
                        corners.insert(corners.end(), {a, b, c, a, c, d});
                }
            }
        }
    }
    while (offsets.back() < corners.size()) offsets.push_back(offsets.back() + 3);
    medax::ComplexParts parts;
    parts.vertices = vertices.front().data();
    parts.vertex_count = vertices.size();
    parts.face_offsets = offsets.data();
    parts.face_indices = corners.data();
    parts.face_count = offsets.size() - 1;
    return medax::Complex::from(parts);
}

}  // namespace

int main(int, char **argv) try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    medax::Samples::of(MEDAX_SHAPE_TORUS).complex().write((folder / "torus.ply").string());
    box().write((folder / "box.ply").string());
    std::ofstream(folder / "empty.ply")
        << "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
           "property float z\nend_header\n";
    return 0;
} catch (const std::exception &error) {
    std::cerr << error.what() << '\n';
    return 1;
}
