// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Voronoi and power diagrams.

#include <medax/triangulation.hpp>

#include <cstdint>

namespace medax {

using DualOptions = detail::Options<medax_dual_options, medax_dual_options_init>;

/// The Voronoi or power diagram that is dual to a triangulation.
class Dual : public detail::Handle<medax_dual, medax_dual_clone, medax_dual_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Dual(const medax_dual *owned) noexcept : Handle(owned) {}

    static Dual of(const Triangulation &triangulation, const DualOptions &options = {},
                   const Job &job = Job::fresh()) {
        const medax_dual *dual = nullptr;
        job.check(medax_dual_build(triangulation.get(), &options, job.get(), &dual));
        return Dual(dual);
    }

    Triangulation triangulation() const {
        const medax_triangulation *triangulation = nullptr;
        detail::check(medax_dual_triangulation(get(), &triangulation));
        return Triangulation(triangulation);
    }
    View<double> centers() const noexcept { return detail::view(medax_dual_centers(get())); }
    View<double> radii_squared() const noexcept {
        return detail::view(medax_dual_radii_squared(get()));
    }
    View<std::uint32_t> ray_facets() const noexcept {
        return detail::view(medax_dual_ray_facets(get()));
    }
    View<double> ray_directions() const noexcept {
        return detail::view(medax_dual_ray_directions(get()));
    }
    Rows facets() const noexcept { return Rows(medax_dual_facets(get())); }
    View<std::uint32_t> facet_edges() const noexcept {
        return detail::view(medax_dual_facet_edges(get()));
    }
    View<std::uint32_t> facet_rays() const noexcept {
        return detail::view(medax_dual_facet_rays(get()));
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_dual_validate, get(), job);
    }
};

}  // namespace medax
