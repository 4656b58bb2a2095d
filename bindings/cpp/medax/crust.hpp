// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Power crusts.

#include <medax/poles.hpp>

#include <cstddef>
#include <cstdint>

namespace medax {

using PowerCrustOptions =
    detail::Options<medax_power_crust_options, medax_power_crust_options_init>;

/// A power crust with all that it was made from.
class PowerCrust
    : public detail::Handle<medax_power_crust, medax_power_crust_clone, medax_power_crust_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit PowerCrust(const medax_power_crust *owned) noexcept : Handle(owned) {}

    static PowerCrust of(const Points &points, const PowerCrustOptions &options = {},
                         const Job &job = Job::fresh()) {
        const medax_power_crust *crust = nullptr;
        job.check(medax_power_crust_build(points.get(), &options, job.get(), &crust));
        return PowerCrust(crust);
    }
    static PowerCrust of(const Poles &poles, const PowerCrustOptions &options = {},
                         const Job &job = Job::fresh()) {
        const medax_power_crust *crust = nullptr;
        job.check(medax_power_crust_build_from_poles(poles.get(), &options, job.get(), &crust));
        return PowerCrust(crust);
    }

    Complex surface() const {
        const medax_complex *surface = nullptr;
        detail::check(medax_power_crust_surface(get(), &surface));
        return Complex(surface);
    }
    Complex shape(medax_label label) const {
        const medax_complex *shape = nullptr;
        detail::check(medax_power_crust_shape(get(), label, &shape));
        return Complex(shape);
    }
    Poles poles() const {
        const medax_poles *poles = nullptr;
        detail::check(medax_power_crust_poles(get(), &poles));
        return Poles(poles);
    }
    /// The regular triangulation of the polar balls.
    Triangulation regular() const {
        const medax_triangulation *regular = nullptr;
        detail::check(medax_power_crust_regular(get(), &regular));
        return Triangulation(regular);
    }
    View<std::uint32_t> labels() const noexcept {
        return detail::view(medax_power_crust_labels(get()));
    }
    bool is_visible(std::uint32_t pole) const noexcept {
        return medax_power_crust_is_visible(get(), pole);
    }
    std::size_t unreached_count() const noexcept {
        return medax_power_crust_unreached_count(get());
    }
    std::size_t forced_count() const noexcept { return medax_power_crust_forced_count(get()); }
    /// The poles as vertices with `radius` and `label`, for writing.
    Complex poles_complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_power_crust_poles_complex(get(), &complex));
        return Complex(complex);
    }
    /// The power shapes of both sides in one complex, the inner one first.
    Complex both_shapes() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_power_crust_both_shapes(get(), &complex));
        return Complex(complex);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_power_crust_validate, get(), job);
    }
};

}  // namespace medax
