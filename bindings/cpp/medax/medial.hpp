// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Medial axes straight from Voronoi diagrams.

#include <medax/labels.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace medax {

using MedialOptions = detail::Options<medax_medial_options, medax_medial_options_init>;
using MedialFilter = detail::Options<medax_medial_filter, medax_medial_filter_init>;

/// Every Voronoi facet of a sample with what decides whether it belongs to the medial axis.
class Medial : public detail::Handle<medax_medial, medax_medial_clone, medax_medial_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Medial(const medax_medial *owned) noexcept : Handle(owned) {}

    /// With labels, by which the inner and the outer axis can be told apart. The dual must have its facets.
    static Medial of(const Dual &dual, const Labels &labels, const MedialOptions &options = {},
                     const Job &job = Job::fresh()) {
        return build(dual, labels.get(), options, job);
    }
    /// Without labels: there are only axes of both sides.
    static Medial of(const Dual &dual, const MedialOptions &options = {},
                     const Job &job = Job::fresh()) {
        return build(dual, nullptr, options, job);
    }

    /// The Voronoi facets that a filter lets pass, as convex polygons.
    Complex axis(const MedialFilter &filter = {}, const Job &job = Job::fresh()) const {
        const medax_complex *axis = nullptr;
        job.check(medax_medial_axis(get(), &filter, job.get(), &axis));
        return Complex(axis);
    }
    /// The facets that a filter lets pass, ascending.
    std::vector<std::uint32_t> selected(const MedialFilter &filter = {},
                                        const Job &job = Job::fresh()) const {
        std::vector<std::uint32_t> facets(sines().rows());
        std::size_t count = 0;
        job.check(medax_medial_selected(get(), &filter, job.get(), facets.size(), facets.data(),
                                        &count));
        facets.resize(count);
        return facets;
    }

    Dual dual() const {
        const medax_dual *dual = nullptr;
        detail::check(medax_medial_dual(get(), &dual));
        return Dual(dual);
    }
    /// The labels, if any were given.
    std::optional<Labels> labels() const {
        const medax_labels *labels = nullptr;
        detail::check(medax_medial_labels(get(), &labels));
        return labels == nullptr ? std::nullopt : std::optional(Labels(labels));
    }
    View<double> sines() const noexcept { return detail::view(medax_medial_sines(get())); }
    View<double> ratios() const noexcept { return detail::view(medax_medial_ratios(get())); }
    View<double> reaches() const noexcept { return detail::view(medax_medial_reaches(get())); }
    View<std::uint32_t> least_cell() const noexcept {
        return detail::view(medax_medial_least_cell(get()));
    }
    /// No row unless the options asked for scales.
    View<double> scales() const noexcept { return detail::view(medax_medial_scales(get())); }
    /// Where the triangles of each sample's umbrella begin in umbrella_rims().
    View<std::uint32_t> umbrella_offsets() const noexcept {
        return detail::view(medax_medial_umbrella_offsets(get()));
    }
    /// The two other vertices of each triangle of each umbrella.
    View<std::uint32_t> umbrella_rims() const noexcept {
        return detail::view(medax_medial_umbrella_rims(get()));
    }
    View<std::uint8_t> umbrella_is_disk() const noexcept {
        return detail::view(medax_medial_umbrella_is_disk(get()));
    }
    std::size_t torn_count() const noexcept { return medax_medial_torn_count(get()); }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_medial_validate, get(), job);
    }

private:
    static Medial build(const Dual &dual, const medax_labels *labels, const MedialOptions &options,
                        const Job &job) {
        const medax_medial *medial = nullptr;
        job.check(medax_medial_build(dual.get(), labels, &options, job.get(), &medial));
        return Medial(medial);
    }
};

}  // namespace medax
