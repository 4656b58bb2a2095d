// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Power crusts.

#include <medax/poles.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace medax {

using PowerCrustOptions =
    detail::Options<medax_power_crust_options, medax_power_crust_options_init>;

using SimplifyOptions = detail::Options<medax_simplify_options, medax_simplify_options_init>;
using HoleOptions = detail::Options<medax_hole_options, medax_hole_options_init>;

class Simplified;

/// Lengths at some points, in input units.
struct Sizes {
    std::vector<double> feature_size;
    std::vector<double> thickness;
};

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
    /// The power shape of one side, with `radius`, `pole`, `label` and `object_angle`, and `flatness` of its tetrahedra.
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
    /// How much the labels contradict each other.
    double conflict() const noexcept { return medax_power_crust_conflict(get()); }
    /// Whether labels were changed to lessen their conflict.
    bool is_settled() const noexcept { return medax_power_crust_is_settled(get()); }
    /// The poles as vertices with `radius`, `object_angle` and `label`, for writing.
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
    /// The same poles with other labels, one for each.
    PowerCrust with_labels(const std::vector<std::uint32_t> &labels,
                           const Job &job = Job::fresh()) const {
        const medax_power_crust *crust = nullptr;
        job.check(medax_power_crust_with_labels(get(), labels.data(), labels.size(), job.get(),
                                                &crust));
        return PowerCrust(crust);
    }
    /// The same poles, inner where the faces of a mesh wind round them.
    PowerCrust labelled_by_mesh(const Complex &mesh, const Job &job = Job::fresh()) const {
        const medax_power_crust *crust = nullptr;
        job.check(medax_power_crust_labelled_by_mesh(get(), mesh.get(), job.get(), &crust));
        return PowerCrust(crust);
    }
    /// An approximate offset surface: outside for a positive distance, inside for a negative one.
    PowerCrust offset(double distance, const Job &job = Job::fresh()) const {
        const medax_power_crust *offset = nullptr;
        job.check(medax_power_crust_offset(get(), distance, job.get(), &offset));
        return PowerCrust(offset);
    }
    /// The axis of one side's balls, grown by a factor, with the balls shrunk back.
    Complex scale_axis(medax_label side, double factor, const Job &job = Job::fresh()) const {
        const medax_complex *axis = nullptr;
        job.check(medax_power_crust_scale_axis(get(), side, factor, job.get(), &axis));
        return Complex(axis);
    }
    /// The power crust of stable poles that are not redundant.
    inline Simplified simplify(const SimplifyOptions &options = {},
                               const Job &job = Job::fresh()) const;
    /// The surface without the faces that fill holes, and these.
    std::pair<Complex, Complex> open(const HoleOptions &options = {},
                                     const Job &job = Job::fresh()) const {
        const medax_complex *surface = nullptr, *left_out = nullptr;
        job.check(medax_power_crust_open(get(), &options, job.get(), &surface, &left_out));
        return {Complex(surface), Complex(left_out)};
    }
    /// The local feature size and the thickness at each point.
    Sizes sizes_at(const std::vector<Point> &queries, const Job &job = Job::fresh()) const {
        Sizes sizes{std::vector<double>(queries.size()), std::vector<double>(queries.size())};
        const double *xyz = queries.empty() ? nullptr : queries.front().data();
        job.check(medax_power_crust_sizes_at(get(), xyz, queries.size(), job.get(),
                                             sizes.feature_size.data(), sizes.thickness.data()));
        return sizes;
    }
    /// The samples as vertices with `feature_size`, `thickness` and `row`.
    Complex samples_complex(const Job &job = Job::fresh()) const {
        const medax_complex *complex = nullptr;
        job.check(medax_power_crust_samples_complex(get(), job.get(), &complex));
        return Complex(complex);
    }
    /// Any complex with `feature_size` and `thickness` at its vertices.
    Complex with_sizes(const Complex &complex, const Job &job = Job::fresh()) const {
        const medax_complex *sized = nullptr;
        job.check(medax_power_crust_with_sizes(get(), complex.get(), job.get(), &sized));
        return Complex(sized);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_power_crust_validate, get(), job);
    }
};

/// A simplified power crust, and what became of the poles.
class Simplified
    : public detail::Handle<medax_simplified, medax_simplified_clone, medax_simplified_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Simplified(const medax_simplified *owned) noexcept : Handle(owned) {}

    PowerCrust crust() const {
        const medax_power_crust *crust = nullptr;
        detail::check(medax_simplified_crust(get(), &crust));
        return PowerCrust(crust);
    }
    double epsilon() const noexcept { return medax_simplified_epsilon(get()); }
    double delta() const noexcept { return medax_simplified_delta(get()); }
    View<std::uint32_t> unstable() const noexcept {
        return detail::view(medax_simplified_unstable(get()));
    }
    /// Rows of two poles: the one that went, and the one that keeps its place.
    View<std::uint32_t> redundant() const noexcept {
        return detail::view(medax_simplified_redundant(get()));
    }
};

inline Simplified PowerCrust::simplify(const SimplifyOptions &options, const Job &job) const {
    const medax_simplified *simplified = nullptr;
    job.check(medax_power_crust_simplify(get(), &options, job.get(), &simplified));
    return Simplified(simplified);
}

}  // namespace medax
