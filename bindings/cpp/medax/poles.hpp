// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Poles.

#include <medax/dual.hpp>

#include <cstdint>
#include <vector>

namespace medax {

using PolesOptions = detail::Options<medax_poles_options, medax_poles_options_init>;

/// The poles of a sample, and their balls.
class Poles : public detail::Handle<medax_poles, medax_poles_clone, medax_poles_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Poles(const medax_poles *owned) noexcept : Handle(owned) {}

    /// The poles of a sample alone, at infinity on its hull.
    static Poles of(const Dual &dual, const PolesOptions &options = {},
                    const Job &job = Job::fresh()) {
        const medax_poles *poles = nullptr;
        job.check(medax_poles_build(dual.get(), &options, job.get(), &poles));
        return Poles(poles);
    }
    /// The poles from which a power crust is made.
    static Poles with_far_box(const Points &points, const PolesOptions &options = {},
                              const Job &job = Job::fresh()) {
        const medax_poles *poles = nullptr;
        job.check(medax_poles_build_with_far_box(points.get(), &options, job.get(), &poles));
        return Poles(poles);
    }

    Triangulation triangulation() const {
        const medax_triangulation *triangulation = nullptr;
        detail::check(medax_poles_triangulation(get(), &triangulation));
        return Triangulation(triangulation);
    }
    bool has_far_box() const noexcept { return medax_poles_has_far_box(get()); }
    View<double> balls() const noexcept { return detail::view(medax_poles_balls(get())); }
    View<double> radii_squared() const noexcept {
        return detail::view(medax_poles_radii_squared(get()));
    }
    View<std::uint32_t> cell_of_pole() const noexcept {
        return detail::view(medax_poles_cell_of_pole(get()));
    }
    View<std::uint8_t> touches_far_box() const noexcept {
        return detail::view(medax_poles_touches_far_box(get()));
    }
    View<std::uint32_t> pole_of_sample() const noexcept {
        return detail::view(medax_poles_pole_of_sample(get()));
    }
    /// The samples on each polar ball.
    Rows samples_on_balls() const noexcept {
        return Rows(medax_poles_samples_on_balls(get()));
    }
    /// The largest angle at each pole's centre between two samples on its ball, in radians.
    View<double> object_angles() const noexcept {
        return detail::view(medax_poles_object_angles(get()));
    }
    /// The lambda by which poles were left out; 0 if that was not asked for.
    double lambda() const noexcept { return medax_poles_lambda(get()); }
    View<double> normals() const noexcept { return detail::view(medax_poles_normals(get())); }

    /// The distance from each point to the nearest pole.
    std::vector<double> feature_size(const std::vector<Point> &queries,
                                     const Job &job = Job::fresh()) const {
        std::vector<double> distances(queries.size());
        const double *xyz = queries.empty() ? nullptr : queries.front().data();
        job.check(medax_poles_feature_size(get(), xyz, queries.size(), job.get(),
                                           distances.data()));
        return distances;
    }
    /// The poles as vertices with `radius` and `object_angle`, for writing.
    Complex complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_poles_complex(get(), &complex));
        return Complex(complex);
    }
    /// The samples as vertices with `normal`, for writing.
    Complex samples_complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_poles_samples_complex(get(), &complex));
        return Complex(complex);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_poles_validate, get(), job);
    }
};

}  // namespace medax
