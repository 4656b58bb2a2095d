// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Cocone and Tight Cocone: surfaces through the samples.

#include <medax/complex.hpp>
#include <medax/dual.hpp>

#include <cstddef>
#include <cstdint>

namespace medax {

/// The settings, with their defaults.
using CoconeOptions = detail::Options<medax_cocone_options, medax_cocone_options_init>;

/// The surfaces of a sample that are made of Delaunay triangles.
class Cocone : public detail::Handle<medax_cocone, medax_cocone_clone, medax_cocone_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Cocone(const medax_cocone *owned) noexcept : Handle(owned) {}

    /// Of the Voronoi diagram of a sample.
    static Cocone of(const Dual &dual, const CoconeOptions &options = {},
                     const Job &job = Job::fresh()) {
        const medax_cocone *cocone = nullptr;
        job.check(medax_cocone_build(dual.get(), &options, job.get(), &cocone));
        return Cocone(cocone);
    }

    /// The watertight one.
    Complex surface() const {
        const medax_complex *surface = nullptr;
        detail::check(medax_cocone_surface(get(), &surface));
        return Complex(surface);
    }
    /// That of Cocone alone, open where the sample is too sparse.
    Complex open_surface() const {
        const medax_complex *surface = nullptr;
        detail::check(medax_cocone_open_surface(get(), &surface));
        return Complex(surface);
    }
    /// Whether each cell of the triangulation is inside the watertight surface.
    View<std::uint8_t> is_inner() const noexcept {
        return detail::view(medax_cocone_is_inner(get()));
    }
    /// Whether each sample is too sparse beside its neighbours.
    View<std::uint8_t> is_undersampled() const noexcept {
        return detail::view(medax_cocone_is_undersampled(get()));
    }
    /// Whether the triangles round each sample are a disk that divides inside from outside.
    View<std::uint8_t> is_well_sampled() const noexcept {
        return detail::view(medax_cocone_is_well_sampled(get()));
    }
    /// The number of cells that well sampled vertices mark as inner or outer.
    std::size_t marked_count() const noexcept { return medax_cocone_marked_count(get()); }
    /// The number of samples that the watertight surface has.
    std::size_t used_count() const noexcept { return medax_cocone_used_count(get()); }
    /// Checks the surfaces.
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_cocone_validate, get(), job);
    }
};

}  // namespace medax
