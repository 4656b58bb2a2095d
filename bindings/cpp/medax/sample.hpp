// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Samples of built-in shapes and of meshes.

#include <medax/complex.hpp>

namespace medax {

using SampleOptions = detail::Options<medax_sample_options, medax_sample_options_init>;
using ShapeFacts = medax_shape_facts;

/// The name of a shape, such as `torus`.
inline const char *name(medax_shape shape) { return medax_shape_name(shape); }

/// What is known of a shape.
inline ShapeFacts describe(medax_shape shape) {
    ShapeFacts facts;
    facts.struct_size = sizeof facts;
    detail::check(medax_shape_describe(shape, &facts));
    return facts;
}

/// Samples of a surface with its normals.
class Samples : public detail::Handle<medax_samples, medax_samples_clone, medax_samples_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Samples(const medax_samples *owned) noexcept : Handle(owned) {}

    static Samples of(medax_shape shape, const SampleOptions &options = {},
                      const Job &job = Job::fresh()) {
        const medax_samples *samples = nullptr;
        job.check(medax_samples_build(shape, &options, job.get(), &samples));
        return Samples(samples);
    }
    static Samples of(const Complex &mesh, const SampleOptions &options = {},
                      const Job &job = Job::fresh()) {
        const medax_samples *samples = nullptr;
        job.check(medax_samples_build_from_mesh(mesh.get(), &options, job.get(), &samples));
        return Samples(samples);
    }

    View<double> coords() const noexcept { return detail::view(medax_samples_coords(get())); }
    View<double> normals() const noexcept { return detail::view(medax_samples_normals(get())); }
    double spacing() const noexcept { return medax_samples_spacing(get()); }
    double area() const noexcept { return medax_samples_area(get()); }
    /// The samples as vertices with the attribute `normal`.
    Complex complex() const {
        const medax_complex *complex = nullptr;
        detail::check(medax_samples_complex(get(), &complex));
        return Complex(complex);
    }
    Points points(const PointsOptions &options = {}, const Job &job = Job::fresh()) const {
        return Points::from(coords().data(), coords().rows(), 0, options, job);
    }
};

}  // namespace medax
