// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// What a file holds.

#include <medax/complex.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace medax {

/// What a file holds, before points or a complex are made of it.
class File : public detail::Handle<medax_file, medax_file_clone, medax_file_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit File(const medax_file *owned) noexcept : Handle(owned) {}

    static File read(const std::string &path_utf8, const Job &job = Job::fresh()) {
        const medax_file *file = nullptr;
        job.check(medax_file_read(path_utf8.c_str(), job.get(), &file));
        return File(file);
    }

    bool is_mesh() const noexcept { return medax_file_is_mesh(get()); }
    View<double> vertices() const noexcept { return detail::view(medax_file_vertices(get())); }
    Rows faces() const noexcept { return Rows(medax_file_faces(get())); }
    View<std::uint32_t> edges() const noexcept { return detail::view(medax_file_edges(get())); }
    std::size_t attribute_count() const noexcept { return medax_file_attribute_count(get()); }
    Attribute attribute(std::size_t index) const {
        medax_attribute found;
        detail::check(medax_file_attribute_at(get(), index, &found));
        return Attribute(found);
    }
    /// The attribute of this name, which must be there.
    Attribute attribute(medax_element element, const std::string &name) const {
        medax_attribute found;
        detail::check(medax_file_attribute(get(), element, name.c_str(), &found));
        return Attribute(found);
    }
    Warnings warnings() const {
        const medax_warnings *warnings = nullptr;
        detail::check(medax_file_warnings(get(), &warnings));
        return Warnings(warnings);
    }
    Points points(const PointsOptions &options = {}, const Job &job = Job::fresh()) const {
        const medax_points *points = nullptr;
        job.check(medax_file_points(get(), &options, job.get(), &points));
        return Points(points);
    }
    Complex complex(const Job &job = Job::fresh()) const {
        const medax_complex *complex = nullptr;
        job.check(medax_file_complex(get(), job.get(), &complex));
        return Complex(complex);
    }
};

}  // namespace medax
