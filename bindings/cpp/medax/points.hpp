// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Sets of points.

#include <medax/io.hpp>
#include <medax/job.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace medax {

using PointsOptions = detail::Options<medax_points_options, medax_points_options_init>;

/// An axis-parallel box.
struct Bounds {
    Point min, max;
};

/// Distinct points in spatial order, with maps from and to the input's rows.
class Points : public detail::Handle<medax_points, medax_points_clone, medax_points_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Points(const medax_points *owned) noexcept : Handle(owned) {}

    /// Copies `count` points, `stride_bytes` apart; 0 stands for no gap.
    static Points from(const double *xyz, std::size_t count, std::size_t stride_bytes = 0,
                       const PointsOptions &options = {}, const Job &job = Job::fresh()) {
        const medax_points *points = nullptr;
        job.check(medax_points_create_f64(xyz, count, stride_bytes, &options, job.get(), &points));
        return Points(points);
    }
    static Points from(const float *xyz, std::size_t count, std::size_t stride_bytes = 0,
                       const PointsOptions &options = {}, const Job &job = Job::fresh()) {
        const medax_points *points = nullptr;
        job.check(medax_points_create_f32(xyz, count, stride_bytes, &options, job.get(), &points));
        return Points(points);
    }
    static Points from(const std::vector<Point> &xyz, const PointsOptions &options = {},
                       const Job &job = Job::fresh()) {
        return from(xyz.empty() ? nullptr : xyz.front().data(), xyz.size(), 0, options, job);
    }
    static Points read(const std::string &path_utf8, const PointsOptions &options = {},
                       const Job &job = Job::fresh()) {
        const medax_points *points = nullptr;
        job.check(medax_points_read(path_utf8.c_str(), &options, job.get(), &points));
        return Points(points);
    }
    Warnings write(const std::string &path_utf8, const WriteOptions &options = {},
                   const Job &job = Job::fresh()) const {
        const medax_warnings *warnings = nullptr;
        job.check(medax_points_write(get(), path_utf8.c_str(), &options, job.get(), &warnings));
        return Warnings(warnings);
    }

    View<double> coords() const noexcept { return detail::view(medax_points_coords(get())); }
    View<std::uint32_t> vertex_of_row() const noexcept {
        return detail::view(medax_points_vertex_of_row(get()));
    }
    View<std::uint32_t> row_of_vertex() const noexcept {
        return detail::view(medax_points_row_of_vertex(get()));
    }
    View<std::uint32_t> duplicate_of() const noexcept {
        return detail::view(medax_points_duplicate_of(get()));
    }
    std::size_t count() const noexcept { return medax_points_count(get()); }
    std::size_t row_count() const noexcept { return medax_points_row_count(get()); }
    std::size_t duplicate_count() const noexcept { return medax_points_duplicate_count(get()); }
    std::size_t skipped_count() const noexcept { return medax_points_skipped_count(get()); }
    Bounds bounds() const {
        Bounds bounds;
        detail::check(medax_points_bounds(get(), bounds.min.data(), bounds.max.data()));
        return bounds;
    }
};

}  // namespace medax
