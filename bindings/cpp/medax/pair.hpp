// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Pair-meshes, and their half-faces.

#include <medax/complex.hpp>
#include <medax/dual.hpp>
#include <medax/labels.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medax {

/// A point of a solid: a tetrahedron of an element, and how much each of its corners weighs.
using Place = medax_place;

using PairOntoOptions = detail::Options<medax_pair_onto_options, medax_pair_onto_options_init>;

/// A solid between an inner structure and its boundary, in pyramids and tetrahedra.
class Pair : public detail::Handle<medax_pair, medax_pair_clone, medax_pair_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Pair(const medax_pair *owned) noexcept : Handle(owned) {}

    /// Between the inner part of a Voronoi diagram and the surface between inner and outer cells.
    static Pair voronoi(const Dual &dual, const Labels &labels, const Job &job = Job::fresh()) {
        const medax_pair *pair = nullptr;
        job.check(medax_pair_voronoi(dual.get(), labels.get(), job.get(), &pair));
        return Pair(pair);
    }

    /// The pair-mesh of the part of the inner structure in which a complex of Voronoi faces lies, such as a medial axis or a core.
    Pair onto(const Complex &part, const PairOntoOptions &options = PairOntoOptions(),
              const Job &job = Job::fresh()) const {
        const medax_pair *pair = nullptr;
        job.check(medax_pair_onto(get(), part.get(), &options, job.get(), &pair));
        return Pair(pair);
    }
    /// How many Voronoi facets and edges asked for the inner structure does not have.
    std::size_t missing() const noexcept { return medax_pair_missing(get()); }
    /// Why each inner face is there, as medax_pair_reason.
    std::vector<std::uint32_t> reasons() const {
        std::vector<std::uint32_t> reasons(inner_faces().rows());
        detail::check(medax_pair_reasons(get(), reasons.data()));
        return reasons;
    }

    /// All elements.
    std::size_t element_count() const noexcept { return medax_pair_element_count(get(), 0); }
    /// Those of one kind.
    std::size_t element_count(medax_pair_element kind) const noexcept {
        return medax_pair_element_count(get(), static_cast<std::uint32_t>(kind));
    }
    View<double> boundary_vertices() const noexcept {
        return detail::view(medax_pair_boundary_vertices(get()));
    }
    View<std::uint32_t> boundary_samples() const noexcept {
        return detail::view(medax_pair_boundary_samples(get()));
    }
    View<double> inner_vertices() const noexcept {
        return detail::view(medax_pair_inner_vertices(get()));
    }
    View<std::uint32_t> inner_cells() const noexcept {
        return detail::view(medax_pair_inner_cells(get()));
    }
    View<double> voronoi_vertices() const noexcept {
        return detail::view(medax_pair_voronoi_vertices(get()));
    }
    Rows inner_faces() const noexcept { return Rows(medax_pair_inner_faces(get())); }
    /// For each node a vertex of the boundary and an inner one.
    View<std::uint32_t> nodes() const noexcept { return detail::view(medax_pair_nodes(get())); }
    /// The nodes of each element.
    Rows rings() const noexcept { return Rows(medax_pair_rings(get())); }
    /// The samples inside the solid, which were removed.
    View<std::uint32_t> removed() const noexcept { return detail::view(medax_pair_removed(get())); }
    double enclosed_volume() const noexcept { return medax_pair_enclosed_volume(get()); }

    std::vector<double> volumes(const Job &job = Job::fresh()) const {
        std::vector<double> volumes(element_count());
        job.check(medax_pair_volumes(get(), job.get(), volumes.data()));
        return volumes;
    }
    std::vector<Point> centroids(const Job &job = Job::fresh()) const {
        std::vector<Point> centroids(element_count());
        job.check(medax_pair_centroids(get(), job.get(), coordinates(centroids)));
        return centroids;
    }
    /// The closed surface that each element is a face of for every t.
    std::vector<std::uint32_t> shells(const Job &job = Job::fresh()) const {
        std::vector<std::uint32_t> shells(element_count());
        job.check(medax_pair_shells(get(), job.get(), shells.data()));
        return shells;
    }
    /// The elements that are turned inside out.
    std::vector<std::uint32_t> folded(const Job &job = Job::fresh()) const {
        std::vector<std::uint32_t> folded(element_count());
        std::size_t count = 0;
        job.check(medax_pair_folded(get(), job.get(), folded.data(), &count));
        folded.resize(count);
        return folded;
    }

    /// The surface on which each node is at t on its way from the inner structure (0) to the boundary (1).
    Complex iso_surface(double t, const Job &job = Job::fresh()) const {
        const medax_complex *surface = nullptr;
        job.check(medax_pair_iso_surface(get(), t, job.get(), &surface));
        return Complex(surface);
    }
    /// The elements as volume cells.
    Complex solid(const Job &job = Job::fresh()) const { return made(medax_pair_solid, job); }
    Complex boundary(const Job &job = Job::fresh()) const { return made(medax_pair_boundary, job); }
    Complex inner(const Job &job = Job::fresh()) const { return made(medax_pair_inner, job); }

    /// The place of each point.
    std::vector<Place> locate(const std::vector<Point> &queries,
                              const Job &job = Job::fresh()) const {
        std::vector<Place> places(queries.size());
        job.check(medax_pair_locate(get(), queries.empty() ? nullptr : queries.front().data(),
                                    queries.size(), job.get(), places.data()));
        return places;
    }
    /// The points at some places.
    std::vector<Point> positions(const std::vector<Place> &places) const {
        std::vector<Point> points(places.size());
        detail::check(
            medax_pair_positions(get(), places.data(), places.size(), coordinates(points)));
        return points;
    }
    /// The corners of a tetrahedron of an element: vertices of the boundary count first.
    std::array<std::uint32_t, 4> piece(std::uint32_t element, std::uint32_t piece) const {
        std::array<std::uint32_t, 4> corners{};
        detail::check(medax_pair_piece(get(), element, piece, corners.data()));
        return corners;
    }

    /// With the inner vertices at other places, which the boundary follows.
    Pair with_inner(const std::vector<Point> &places, const Job &job = Job::fresh()) const {
        return moved(medax_pair_with_inner, places, job);
    }
    /// With the boundary at other places, which the inner vertices follow.
    Pair with_boundary(const std::vector<Point> &places, const Job &job = Job::fresh()) const {
        return moved(medax_pair_with_boundary, places, job);
    }

    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_pair_validate, get(), job);
    }

private:
    static double *coordinates(std::vector<Point> &points) noexcept {
        return points.empty() ? nullptr : points.front().data();
    }
    template <class F>
    Complex made(F make, const Job &job) const {
        const medax_complex *complex = nullptr;
        job.check(make(get(), job.get(), &complex));
        return Complex(complex);
    }
    template <class F>
    Pair moved(F move, const std::vector<Point> &places, const Job &job) const {
        const medax_pair *pair = nullptr;
        job.check(move(get(), places.empty() ? nullptr : places.front().data(), places.size(),
                       job.get(), &pair));
        return Pair(pair);
    }
};

/// Every face of every element of a pair-mesh, seen from inside that element, with its edges.
class HalfFaces
    : public detail::Handle<medax_half_faces, medax_half_faces_clone, medax_half_faces_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit HalfFaces(const medax_half_faces *owned) noexcept : Handle(owned) {}

    static HalfFaces of(const Pair &pair, const Job &job = Job::fresh()) {
        const medax_half_faces *half_faces = nullptr;
        job.check(medax_half_faces_build(pair.get(), job.get(), &half_faces));
        return HalfFaces(half_faces);
    }

    /// Where the half-faces of each element begin.
    View<std::uint32_t> of_element() const noexcept {
        return detail::view(medax_half_faces_of_element(get()));
    }
    /// Where the half-edges of each half-face begin.
    View<std::uint32_t> offsets() const noexcept {
        return detail::view(medax_half_faces_offsets(get()));
    }
    /// The half-face on the other side of each; `none` on the boundary.
    View<std::uint32_t> duals() const noexcept {
        return detail::view(medax_half_faces_duals(get()));
    }
    /// The vertex at which each half-edge begins.
    View<std::uint32_t> origins() const noexcept {
        return detail::view(medax_half_faces_origins(get()));
    }
    /// The half-edge on the other side of each edge within the element.
    View<std::uint32_t> opposites() const noexcept {
        return detail::view(medax_half_faces_opposites(get()));
    }
    /// That of the same edge in the dual half-face.
    View<std::uint32_t> partners() const noexcept {
        return detail::view(medax_half_faces_partners(get()));
    }
};

}  // namespace medax
