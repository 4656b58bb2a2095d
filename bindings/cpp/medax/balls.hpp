// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Unions of balls.

#include <medax/complex.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace medax {

using BoundaryOptions = detail::Options<medax_boundary_options, medax_boundary_options_init>;

/// Balls, whose union is a solid: those of a medial axis, or any.
class Balls : public detail::Handle<medax_balls, medax_balls_clone, medax_balls_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Balls(const medax_balls *owned) noexcept : Handle(owned) {}

    /// Balls by their centres and radii, of which there must be as many.
    static Balls from(const std::vector<Point> &centers, const std::vector<double> &radii,
                      const Job &job = Job::fresh()) {
        const medax_balls *balls = nullptr;
        job.check(medax_balls_create(xyz(centers), centers.size(), radii.data(), radii.size(),
                                     job.get(), &balls));
        return Balls(balls);
    }
    /// Balls round the vertices of a complex, which carry `radius`.
    static Balls of(const Complex &complex, const Job &job = Job::fresh()) {
        const medax_balls *balls = nullptr;
        job.check(medax_balls_of_complex(complex.get(), job.get(), &balls));
        return Balls(balls);
    }

    std::size_t count() const noexcept { return medax_balls_count(get()); }
    View<double> centers() const noexcept { return detail::view(medax_balls_centers(get())); }
    View<double> radii() const noexcept { return detail::view(medax_balls_radii(get())); }
    /// The smallest box that holds all balls: its least corner and its greatest.
    std::array<Point, 2> bounds() const {
        std::array<Point, 2> bounds;
        detail::check(medax_balls_bounds(get(), bounds[0].data(), bounds[1].data()));
        return bounds;
    }

    /// For each point the distance from the union; inside, negative, how deep it is in a ball.
    std::vector<double> distances(const std::vector<Point> &queries,
                                  const Job &job = Job::fresh()) const {
        std::vector<double> distances(queries.size());
        job.check(medax_balls_distances(get(), xyz(queries), queries.size(), job.get(),
                                        distances.data()));
        return distances;
    }
    /// The boundary of the union as a mesh of triangles.
    Complex boundary(const BoundaryOptions &options = {}, const Job &job = Job::fresh()) const {
        const medax_complex *mesh = nullptr;
        job.check(medax_balls_boundary(get(), &options, job.get(), &mesh));
        return Complex(mesh);
    }

private:
    static const double *xyz(const std::vector<Point> &points) noexcept {
        return points.empty() ? nullptr : points.front().data();
    }
};

}  // namespace medax
