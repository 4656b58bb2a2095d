// SPDX-License-Identifier: MIT OR Apache-2.0
#include "layers.hpp"

#include <vcg/complex/algorithms/update/color.h>

#include <cstdint>

namespace medax_meshlab {

namespace {

using Allocator = vcg::tri::Allocator<CMeshO>;
using Element = std::uint32_t;

/// The vertices of a complex that go to one layer.
class Part {
public:
    explicit Part(const medax::Complex &complex)
        : complex_(complex), number_(complex.vertices().rows(), medax::none) {}

    void use(Element vertex) { number_[vertex] = 0; }
    bool uses(Element vertex) const { return number_[vertex] != medax::none; }
    /// The number of a vertex in the layer.
    Element operator[](Element vertex) const { return number_[vertex]; }

    /// The layer, with its vertices.
    MeshModel &add(MeshDocument &document, const MeshModel &source, const QString &label,
                   const char *quality) {
        std::vector<Element> used;
        for (Element v = 0; v < number_.size(); ++v) {
            if (!uses(v)) continue;
            number_[v] = static_cast<Element>(used.size());
            used.push_back(v);
        }
        MeshModel &layer = *document.addNewMesh("", label, false);
        layer.cm.Tr = source.cm.Tr;
        Allocator::AddVertices(layer.cm, used.size());
        const auto vertices = complex_.vertices();
        for (std::size_t v = 0; v < used.size(); ++v)
            for (int k = 0; k < 3; ++k)
                layer.cm.vert[v].P()[k] = static_cast<MESHLAB_SCALAR>(vertices[used[v]][k]);
        if (quality != nullptr) {
            const auto found = complex_.attribute(MEDAX_ELEMENT_VERTEX, quality).f64_values;
            std::vector<double> values;
            for (const Element v : used) values.push_back(found[v][0]);
            set_quality(layer, values, true);
        }
        return layer;
    }

private:
    const medax::Complex &complex_;
    std::vector<Element> number_;
};

}  // namespace

Input input(const MeshModel &layer) {
    const CMeshO &cm = layer.cm;
    Input input;
    input.points.reserve(cm.vn);
    std::vector<Element> number(cm.vert.size(), medax::none);
    for (std::size_t v = 0; v < cm.vert.size(); ++v) {
        if (cm.vert[v].IsD()) continue;
        const auto &p = cm.vert[v].cP();
        number[v] = static_cast<Element>(input.points.size());
        input.points.push_back({p[0], p[1], p[2]});
    }
    input.corners.reserve(3 * static_cast<std::size_t>(cm.fn));
    for (const CFaceO &face : cm.face) {
        if (face.IsD()) continue;
        for (int k = 0; k < 3; ++k)
            input.corners.push_back(number[vcg::tri::Index(cm, face.cV(k))]);
    }
    return input;
}

int add_layers(MeshDocument &document, const MeshModel &source, const QString &label,
               const medax::Complex &complex, const char *quality) {
    const auto triangles = complex.triangles();
    const auto edges = complex.edges();
    Part of_faces(complex), of_edges(complex), loose(complex);
    for (const Element v : triangles) of_faces.use(v);
    for (const Element v : edges) of_edges.use(v);
    bool is_any_loose = false;
    for (Element v = 0; v < complex.vertices().rows(); ++v) {
        if (of_faces.uses(v) || of_edges.uses(v)) continue;
        loose.use(v);
        is_any_loose = true;
    }

    std::vector<MeshModel *> layers;
    const auto add = [&](Part &part, const char *kind) -> CMeshO & {
        const QString name = layers.empty() ? label : label + kind;
        layers.push_back(&part.add(document, source, name, quality));
        return layers.back()->cm;
    };
    if (!triangles.empty()) {
        CMeshO &cm = add(of_faces, "");
        Allocator::AddFaces(cm, triangles.rows());
        for (std::size_t t = 0; t < triangles.rows(); ++t)
            for (int k = 0; k < 3; ++k) cm.face[t].V(k) = &cm.vert[of_faces[triangles[t][k]]];
    }
    if (!edges.empty()) {
        CMeshO &cm = add(of_edges, " (edges)");
        for (std::size_t e = 0; e < edges.rows(); ++e)
            Allocator::AddEdge(cm, of_edges[edges[e][0]], of_edges[edges[e][1]]);
    }
    if (is_any_loose) add(loose, " (points)");
    for (MeshModel *layer : layers) layer->UpdateBoxAndNormals();
    if (!layers.empty()) document.setCurrentMesh(layers.front()->id());
    return static_cast<int>(layers.size());
}

void set_quality(MeshModel &layer, const std::vector<double> &values, bool colour) {
    layer.updateDataMask(MeshModel::MM_VERTQUALITY);
    std::size_t next = 0;
    for (CVertexO &vertex : layer.cm.vert)
        if (!vertex.IsD()) vertex.Q() = static_cast<float>(values[next++]);
    if (!colour) return;
    layer.updateDataMask(MeshModel::MM_VERTCOLOR);
    vcg::tri::UpdateColor<CMeshO>::PerVertexQualityRamp(layer.cm);
}

}  // namespace medax_meshlab
