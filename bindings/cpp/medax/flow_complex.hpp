// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Unstable flow complexes.

#include <medax/flow.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medax {

/// A vertex, an edge or a face of a flow complex.
using FlowElement = medax_flow_element;

/// The unstable flow complex of a sample, and its flow DAG.
class FlowComplex : public detail::Handle<medax_flow_complex, medax_flow_complex_clone,
                                          medax_flow_complex_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit FlowComplex(const medax_flow_complex *owned) noexcept : Handle(owned) {}

    /// All of it.
    static FlowComplex of(const Flow &flow, const Job &job = Job::fresh()) {
        const medax_flow_complex *made = nullptr;
        job.check(medax_flow_complex_build(flow.get(), job.get(), &made));
        return FlowComplex(made);
    }

    Flow flow() const {
        const medax_flow *flow = nullptr;
        detail::check(medax_flow_complex_flow(get(), &flow));
        return Flow(flow);
    }
    std::size_t vertex_count() const noexcept { return medax_flow_complex_vertex_count(get()); }
    /// The vertices that come after the Voronoi vertices.
    View<double> points() const noexcept { return detail::view(medax_flow_complex_points(get())); }
    View<std::uint32_t> triangle_of_point() const noexcept {
        return detail::view(medax_flow_complex_triangle_of_point(get()));
    }
    /// The two ends of each edge; `none` at infinity.
    View<std::uint32_t> edges() const noexcept {
        return detail::view(medax_flow_complex_edges(get()));
    }
    /// The triangle whose Voronoi edge each edge is a part of; the edges beyond these are cuts.
    View<std::uint32_t> triangle_of_edge() const noexcept {
        return detail::view(medax_flow_complex_triangle_of_edge(get()));
    }
    /// The vertices of each face; `none` at infinity.
    Rows faces() const noexcept { return Rows(medax_flow_complex_faces(get())); }
    /// The edges of each face, each where it begins.
    Rows face_edges() const noexcept { return Rows(medax_flow_complex_face_edges(get())); }
    /// Where the faces of each Voronoi facet begin.
    View<std::uint32_t> faces_of_facet() const noexcept {
        return detail::view(medax_flow_complex_faces_of_facet(get()));
    }
    /// The edge into which each vertex flows; `none` for critical points.
    View<std::uint32_t> edge_of_vertex() const noexcept {
        return detail::view(medax_flow_complex_edge_of_vertex(get()));
    }
    /// The face into which each edge flows; `none` for those that flow along themselves.
    View<std::uint32_t> face_of_edge() const noexcept {
        return detail::view(medax_flow_complex_face_of_edge(get()));
    }

    /// The elements of a Voronoi facet, edge or vertex.
    std::vector<FlowElement> elements_of(Simplex simplex) const {
        std::vector<FlowElement> elements(8);
        std::size_t count = 0;
        detail::check(medax_flow_complex_elements_of(get(), simplex, elements.size(),
                                                     elements.data(), &count));
        const bool all = count <= elements.size();
        elements.resize(count);
        if (!all)
            detail::check(
                medax_flow_complex_elements_of(get(), simplex, count, elements.data(), &count));
        return elements;
    }
    /// The elements that can be reached from some, these included.
    std::vector<FlowElement> closure(const std::vector<FlowElement> &elements,
                                     const Job &job = Job::fresh()) const {
        return reached(medax_flow_complex_closure, elements, job);
    }
    /// The elements from which some can be reached, these included.
    std::vector<FlowElement> upstream(const std::vector<FlowElement> &elements,
                                      const Job &job = Job::fresh()) const {
        return reached(medax_flow_complex_upstream, elements, job);
    }
    /// The critical points in whose unstable manifolds each element lies.
    std::vector<std::vector<std::uint32_t>> critical_sets(const std::vector<FlowElement> &elements,
                                                          const Job &job = Job::fresh()) const {
        std::vector<std::uint32_t> offsets(elements.size() + 1), rows(16 * elements.size());
        std::size_t count = 0;
        const auto find = [&] {
            job.check(medax_flow_complex_critical_sets(get(), elements.data(), elements.size(),
                                                       job.get(), offsets.data(), rows.size(),
                                                       rows.data(), &count));
        };
        find();
        if (count > rows.size()) {
            rows.resize(count);
            find();
        }
        std::vector<std::vector<std::uint32_t>> sets;
        for (std::size_t i = 0; i < elements.size(); ++i)
            sets.emplace_back(rows.begin() + offsets[i], rows.begin() + offsets[i + 1]);
        return sets;
    }
    /// All that is bounded.
    Complex complex(const Job &job = Job::fresh()) const {
        const medax_complex *complex = nullptr;
        job.check(medax_flow_complex_complex(get(), job.get(), &complex));
        return Complex(complex);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_flow_complex_validate, get(), job);
    }

private:
    std::vector<FlowElement> reached(decltype(&medax_flow_complex_closure) reach,
                                     const std::vector<FlowElement> &elements,
                                     const Job &job) const {
        std::vector<FlowElement> found(vertex_count() + edges().rows() + faces().rows());
        std::size_t count = 0;
        job.check(reach(get(), elements.data(), elements.size(), job.get(), found.size(),
                        found.data(), &count));
        found.resize(count);
        return found;
    }
};

}  // namespace medax
