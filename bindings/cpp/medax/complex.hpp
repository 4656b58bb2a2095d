// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Complexes: what surfaces, axes and crusts come as.

#include <medax/points.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace medax {

using ComplexParts = detail::Options<medax_complex_parts, medax_complex_parts_init>;

/// Values with a name on one kind of element; one of the two views has no row. The name lives as long as the views do.
struct Attribute {
    const char *name;
    medax_element element;
    medax_value_type value_type;
    View<double> f64_values;
    View<std::uint32_t> u32_values;

    explicit Attribute(const medax_attribute &found) noexcept
        : name(found.name),
          element(static_cast<medax_element>(found.element)),
          value_type(static_cast<medax_value_type>(found.value_type)),
          f64_values(detail::view(found.f64_values)),
          u32_values(detail::view(found.u32_values)) {}
};

using Topology = medax_topology;
using Comparison = medax_comparison;
using CompareOptions = detail::Options<medax_compare_options, medax_compare_options_init>;
using DecimateOptions = detail::Options<medax_decimate_options, medax_decimate_options_init>;
using FlattenOptions = detail::Options<medax_flatten_options, medax_flatten_options_init>;

class Flattened;

/// The pairs of triangles of a complex that intersect.
class Intersections
    : public detail::Handle<medax_intersections, medax_intersections_clone, medax_intersections_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Intersections(const medax_intersections *owned) noexcept : Handle(owned) {}

    /// Two triangles a row, the less one first; rows ascend.
    View<std::uint32_t> pairs() const noexcept {
        return detail::view(medax_intersections_pairs(get()));
    }
};

/// Vertices, polygons, loose edges, volume cells and named attributes.
class Complex : public detail::Handle<medax_complex, medax_complex_clone, medax_complex_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Complex(const medax_complex *owned) noexcept : Handle(owned) {}

    static Complex from(const ComplexParts &parts) {
        const medax_complex *complex = nullptr;
        detail::check(medax_complex_create(&parts, &complex));
        return Complex(complex);
    }
    static Complex read(const std::string &path_utf8, const Job &job = Job::fresh()) {
        const medax_complex *complex = nullptr;
        job.check(medax_complex_read(path_utf8.c_str(), job.get(), &complex));
        return Complex(complex);
    }
    Warnings write(const std::string &path_utf8, const WriteOptions &options = {},
                   const Job &job = Job::fresh()) const {
        const medax_warnings *warnings = nullptr;
        job.check(medax_complex_write(get(), path_utf8.c_str(), &options, job.get(), &warnings));
        return Warnings(warnings);
    }

    std::uint32_t dimension() const noexcept { return medax_complex_dimension(get()); }
    View<double> vertices() const noexcept { return detail::view(medax_complex_vertices(get())); }
    Rows faces() const noexcept { return Rows(medax_complex_faces(get())); }
    View<std::uint32_t> edges() const noexcept { return detail::view(medax_complex_edges(get())); }
    Rows cells() const noexcept { return Rows(medax_complex_cells(get())); }
    View<std::uint32_t> cell_types() const noexcept {
        return detail::view(medax_complex_cell_types(get()));
    }
    View<std::uint32_t> triangles() const noexcept {
        return detail::view(medax_complex_triangles(get()));
    }
    View<std::uint32_t> face_of_triangle() const noexcept {
        return detail::view(medax_complex_face_of_triangle(get()));
    }

    Topology topology(const Job &job = Job::fresh()) const {
        Topology report;
        report.struct_size = sizeof report;
        job.check(medax_complex_topology(get(), job.get(), &report));
        return report;
    }
    struct Measure {
        double area, volume;
    };
    Measure measure(const Job &job = Job::fresh()) const {
        Measure measure;
        job.check(medax_complex_measure(get(), job.get(), &measure.area, &measure.volume));
        return measure;
    }
    Intersections self_intersections(const Job &job = Job::fresh()) const {
        const medax_intersections *found = nullptr;
        job.check(medax_complex_self_intersections(get(), job.get(), &found));
        return Intersections(found);
    }
    /// How often the faces wind round each point.
    std::vector<double> winding_numbers(const std::vector<Point> &queries,
                                        const Job &job = Job::fresh()) const {
        std::vector<double> numbers(queries.size());
        const double *xyz = queries.empty() ? nullptr : queries.front().data();
        job.check(medax_complex_winding_numbers(get(), xyz, queries.size(), job.get(),
                                                numbers.data()));
        return numbers;
    }
    /// The normals of the surface at its vertices.
    std::vector<Point> vertex_normals(const Job &job = Job::fresh()) const {
        std::vector<Point> normals(vertices().rows());
        double *xyz = normals.empty() ? nullptr : normals.front().data();
        job.check(medax_complex_vertex_normals(get(), job.get(), normals.size(), xyz));
        return normals;
    }
    Complex oriented(const Job &job = Job::fresh()) const {
        const medax_complex *oriented = nullptr;
        job.check(medax_complex_orient(get(), job.get(), &oriented));
        return Complex(oriented);
    }
    Complex decimate(const DecimateOptions &options = {}, const Job &job = Job::fresh()) const {
        const medax_complex *decimated = nullptr;
        job.check(medax_complex_decimate(get(), &options, job.get(), &decimated));
        return Complex(decimated);
    }
    /// Flat tetrahedra collapsed to their triangles.
    inline Flattened flatten(const FlattenOptions &options = {}, const Job &job = Job::fresh()) const;
    Comparison compare(const Complex &other, const CompareOptions &options = {},
                       const Job &job = Job::fresh()) const {
        Comparison report;
        report.struct_size = sizeof report;
        job.check(medax_complex_compare(get(), other.get(), &options, job.get(), &report));
        return report;
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_complex_validate, get(), job);
    }

    std::size_t attribute_count() const noexcept { return medax_complex_attribute_count(get()); }
    Attribute attribute(std::size_t index) const {
        medax_attribute found;
        detail::check(medax_complex_attribute_at(get(), index, &found));
        return Attribute(found);
    }
    /// The attribute of this name, which must be there.
    Attribute attribute(medax_element element, const std::string &name) const {
        medax_attribute found;
        detail::check(medax_complex_attribute(get(), element, name.c_str(), &found));
        return Attribute(found);
    }
};

/// A complex without its flat tetrahedra, and what became of them.
class Flattened
    : public detail::Handle<medax_flattened, medax_flattened_clone, medax_flattened_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Flattened(const medax_flattened *owned) noexcept : Handle(owned) {}

    Complex complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_flattened_complex(get(), &complex));
        return Complex(complex);
    }
    /// Rows of two: a tetrahedron that went, and its vertex opposite the triangle that went with it.
    View<std::uint32_t> collapses() const noexcept {
        return detail::view(medax_flattened_collapses(get()));
    }
    /// The number of flat tetrahedra that could not go.
    std::size_t left_count() const noexcept { return medax_flattened_left_count(get()); }
};

inline Flattened Complex::flatten(const FlattenOptions &options, const Job &job) const {
    const medax_flattened *flattened = nullptr;
    job.check(medax_complex_flatten(get(), &options, job.get(), &flattened));
    return Flattened(flattened);
}

}  // namespace medax
