// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Plane figures.

#include <medax/job.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace medax {

/// A point of the plane in input units.
using PlanePoint = std::array<double, 2>;
/// A centre and a radius.
using Circle = std::array<double, 3>;

/// What a figure is made of.
struct FigureParts {
    /// Each polygon a list of rings, the outer one first.
    std::vector<std::vector<std::vector<PlanePoint>>> polygons;
    std::vector<std::vector<PlanePoint>> polylines;
    std::vector<PlanePoint> points;
    std::vector<Circle> circles;
};

/// Which features of a file make up a figure.
struct FigureReadOptions : detail::Options<medax_figure_read_options, medax_figure_read_options_init> {
    /// The features of this name; the text must live until the file is read.
    static FigureReadOptions named(const char *feature_name) {
        FigureReadOptions options;
        options.feature_name = feature_name;
        return options;
    }
};

/// Polygons with holes, open polylines, points and circles in the plane.
class Figure : public detail::Handle<medax_figure, medax_figure_clone, medax_figure_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Figure(const medax_figure *owned) noexcept : Handle(owned) {}

    static Figure from(const FigureParts &parts, medax_crossings crossings = MEDAX_CROSSINGS_REFUSE,
                       const Job &job = Job::fresh()) {
        Rows rings, polylines;
        std::vector<std::uint32_t> polygons = {0};
        for (const auto &polygon : parts.polygons) {
            for (const auto &ring : polygon) rings.add(ring);
            polygons.push_back(static_cast<std::uint32_t>(rings.count()));
        }
        for (const auto &polyline : parts.polylines) polylines.add(polyline);
        detail::Options<medax_figure_parts, medax_figure_parts_init> all;
        all.ring_vertices = data(rings.vertices);
        all.ring_vertex_count = rings.vertices.size();
        all.ring_offsets = rings.offsets.data();
        all.ring_count = rings.count();
        all.polygon_offsets = polygons.data();
        all.polygon_count = polygons.size() - 1;
        all.polyline_vertices = data(polylines.vertices);
        all.polyline_vertex_count = polylines.vertices.size();
        all.polyline_offsets = polylines.offsets.data();
        all.polyline_count = polylines.count();
        all.points = data(parts.points);
        all.point_count = parts.points.size();
        all.circles = data(parts.circles);
        all.circle_count = parts.circles.size();
        all.crossings = crossings;
        const medax_figure *figure = nullptr;
        job.check(medax_figure_create(&all, job.get(), &figure));
        return Figure(figure);
    }
    static Figure read(const std::string &path_utf8, const FigureReadOptions &options = {},
                       const Job &job = Job::fresh()) {
        const medax_figure *figure = nullptr;
        job.check(medax_figure_read(path_utf8.c_str(), &options, job.get(), &figure));
        return Figure(figure);
    }

    View<double> vertices() const noexcept { return detail::view(medax_figure_vertices(get())); }
    medax::Rows chains() const noexcept { return medax::Rows(medax_figure_chains(get())); }
    View<std::uint32_t> kinds() const noexcept { return detail::view(medax_figure_kinds(get())); }
    View<std::uint32_t> parts_of_chains() const noexcept {
        return detail::view(medax_figure_parts_of_chains(get()));
    }
    View<double> circles() const noexcept { return detail::view(medax_figure_circles(get())); }
    std::size_t part_count() const noexcept { return medax_figure_part_count(get()); }
    /// The smallest box round all: its least corner and its greatest.
    std::array<PlanePoint, 2> bounds() const {
        std::array<PlanePoint, 2> bounds;
        detail::check(medax_figure_bounds(get(), bounds[0].data(), bounds[1].data()));
        return bounds;
    }
    medax_normalised normalised() const {
        medax_normalised report{};
        report.struct_size = sizeof report;
        detail::check(medax_figure_normalised(get(), &report));
        return report;
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_figure_validate, get(), job);
    }

private:
    /// Rows one after the other, and where they begin.
    struct Rows {
        std::vector<PlanePoint> vertices;
        std::vector<std::uint32_t> offsets = {0};

        void add(const std::vector<PlanePoint> &row) {
            vertices.insert(vertices.end(), row.begin(), row.end());
            offsets.push_back(static_cast<std::uint32_t>(vertices.size()));
        }
        std::size_t count() const noexcept { return offsets.size() - 1; }
    };

    template <class T>
    static const double *data(const std::vector<T> &rows) noexcept {
        return rows.empty() ? nullptr : rows.front().data();
    }
};

}  // namespace medax
