// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Labels of cells.

#include <medax/cocone.hpp>
#include <medax/crust.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medax {

/// For each cell of a Delaunay triangulation of samples whether it lies in the solid.
class Labels : public detail::Handle<medax_labels, medax_labels_clone, medax_labels_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Labels(const medax_labels *owned) noexcept : Handle(owned) {}

    /// Given ones: 1 for a cell in the solid, 0 for one outside.
    static Labels from(const Triangulation &triangulation,
                       const std::vector<std::uint8_t> &is_inner) {
        const medax_labels *labels = nullptr;
        detail::check(
            medax_labels_create(triangulation.get(), is_inner.data(), is_inner.size(), &labels));
        return Labels(labels);
    }
    /// The cells that the surface of Tight Cocone encloses are inner.
    static Labels of(const Cocone &cocone, const Job &job = Job::fresh()) {
        const medax_labels *labels = nullptr;
        job.check(medax_labels_of_cocone(cocone.get(), job.get(), &labels));
        return Labels(labels);
    }
    /// A cell is inner where its Voronoi vertex lies in the solid that a power crust bounds.
    static Labels of(const Dual &dual, const PowerCrust &crust,
                     const Job &job = Job::fresh()) {
        const medax_labels *labels = nullptr;
        job.check(medax_labels_of_crust(dual.get(), crust.get(), job.get(), &labels));
        return Labels(labels);
    }
    /// A cell is inner where the faces of a mesh wind round its Voronoi vertex.
    static Labels of(const Dual &dual, const Complex &mesh,
                     const Job &job = Job::fresh()) {
        const medax_labels *labels = nullptr;
        job.check(medax_labels_of_mesh(dual.get(), mesh.get(), job.get(), &labels));
        return Labels(labels);
    }

    Triangulation triangulation() const {
        const medax_triangulation *triangulation = nullptr;
        detail::check(medax_labels_triangulation(get(), &triangulation));
        return Triangulation(triangulation);
    }
    View<std::uint8_t> is_inner() const noexcept {
        return detail::view(medax_labels_is_inner(get()));
    }
    std::size_t inner_count() const noexcept { return medax_labels_inner_count(get()); }
    /// In how many cells other labels differ.
    std::size_t disagreement(const Labels &other) const {
        std::size_t count = 0;
        detail::check(medax_labels_disagreement(get(), other.get(), &count));
        return count;
    }
};

}  // namespace medax
