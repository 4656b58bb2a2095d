// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Distances to sites, and the medial axes read off them.

#include <medax/complex.hpp>
#include <medax/figure.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medax {

using DecideOptions = detail::Options<medax_decide_options, medax_decide_options_init>;
using FieldAxisOptions = detail::Options<medax_field_axis_options, medax_field_axis_options_init>;
using MedialGraphOptions =
    detail::Options<medax_medial_graph_options, medax_medial_graph_options_init>;

/// What is nearest to a point.
using Nearest = medax_nearest;
/// A circle or sphere that was looked at.
using Cover = medax_cover;
/// Two sites, either first.
using SitePair = std::array<std::uint32_t, 2>;

/// A piece of a boundary, and the number of its site.
struct Piece : medax_piece {
    static Piece point(const Point &p, std::uint32_t site = 0) {
        return Piece(MEDAX_PIECE_KIND_POINT, site, {p});
    }
    static Piece segment(const Point &a, const Point &b, std::uint32_t site = 0) {
        return Piece(MEDAX_PIECE_KIND_SEGMENT, site, {a, b});
    }
    static Piece ray(const Point &origin, const Point &along, std::uint32_t site = 0) {
        return Piece(MEDAX_PIECE_KIND_RAY, site, {origin, along});
    }
    static Piece line(const Point &on_it, const Point &along, std::uint32_t site = 0) {
        return Piece(MEDAX_PIECE_KIND_LINE, site, {on_it, along});
    }
    static Piece triangle(const Point &a, const Point &b, const Point &c, std::uint32_t site = 0) {
        return Piece(MEDAX_PIECE_KIND_TRIANGLE, site, {a, b, c});
    }
    /// A circle in the plane.
    static Piece sphere(const Point &center, double radius, std::uint32_t site = 0) {
        return Piece(MEDAX_PIECE_KIND_SPHERE, site, {center, Point{radius, 0, 0}});
    }

    Piece() noexcept : medax_piece{} {}

private:
    Piece(medax_piece_kind of, std::uint32_t to, const std::array<Point, 3> &points) noexcept
        : medax_piece{} {
        kind = of;
        site = to;
        for (std::size_t i = 0; i < 9; ++i) numbers[i] = points[i / 3][i % 3];
    }
};
static_assert(sizeof(Piece) == sizeof(medax_piece), "pieces lie in memory as in C");

/// What is known of a circle or a sphere.
struct Decision : medax_decision {
    /// Where the gradient was looked at, in the plane counterclockwise.
    std::vector<Point> theta;

    /// Whether it holds a medial point, which then is `center`.
    bool has_point() const noexcept { return test != MEDAX_DECIDE_TEST_NONE; }
};

/// All that is nearest to each of some points.
class AllNearest
    : public detail::Handle<medax_all_nearest, medax_all_nearest_clone, medax_all_nearest_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit AllNearest(const medax_all_nearest *owned) noexcept : Handle(owned) {}

    /// One row a query: the pieces, which ascend. The other arrays have a row for each of these.
    Rows pieces() const noexcept { return Rows(medax_all_nearest_pieces(get())); }
    View<std::uint32_t> sites() const noexcept {
        return detail::view(medax_all_nearest_sites(get()));
    }
    View<double> points() const noexcept { return detail::view(medax_all_nearest_points(get())); }
    View<double> distances() const noexcept {
        return detail::view(medax_all_nearest_distances(get()));
    }
    View<double> directions() const noexcept {
        return detail::view(medax_all_nearest_directions(get()));
    }
};

/// What distances are measured to.
class Sites : public detail::Handle<medax_sites, medax_sites_clone, medax_sites_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit Sites(const medax_sites *owned) noexcept : Handle(owned) {}

    /// Pieces in the plane (2) or in space (3); in the plane a flag for each tells those of closed
    /// curves, if any are given.
    static Sites from(std::uint32_t dimension, const std::vector<Piece> &pieces,
                      const std::vector<std::uint8_t> &is_closed = {},
                      const Job &job = Job::fresh()) {
        const medax_sites *sites = nullptr;
        job.check(medax_sites_create(dimension, pieces.data(), pieces.size(), is_closed.data(),
                                     is_closed.size(), job.get(), &sites));
        return Sites(sites);
    }
    /// The curves and points of a plane figure, a site for each part.
    static Sites of(const Figure &figure, const Job &job = Job::fresh()) {
        const medax_sites *sites = nullptr;
        job.check(medax_sites_of_figure(figure.get(), job.get(), &sites));
        return Sites(sites);
    }
    /// A mesh or polygon soup: one site.
    static Sites of(const Complex &complex, const std::vector<std::uint8_t> &is_closed = {},
                    const Job &job = Job::fresh()) {
        const medax_sites *sites = nullptr;
        job.check(medax_sites_of_complex(complex.get(), is_closed.data(), is_closed.size(),
                                         job.get(), &sites));
        return Sites(sites);
    }
    /// The same, a site for each connected component.
    static Sites of_components(const Complex &complex,
                               const std::vector<std::uint8_t> &is_closed = {},
                               const Job &job = Job::fresh()) {
        const medax_sites *sites = nullptr;
        job.check(medax_sites_of_components(complex.get(), is_closed.data(), is_closed.size(),
                                            job.get(), &sites));
        return Sites(sites);
    }

    /// 2 or 3.
    std::uint32_t dimension() const noexcept { return medax_sites_dimension(get()); }
    std::vector<Piece> pieces() const {
        std::vector<Piece> pieces(medax_sites_piece_count(get()));
        detail::check(medax_sites_pieces(get(), 0, pieces.size(), pieces.data()));
        return pieces;
    }
    std::size_t piece_count() const noexcept { return medax_sites_piece_count(get()); }
    View<std::uint32_t> site_of_piece() const noexcept {
        return detail::view(medax_sites_site_of_piece(get()));
    }
    std::size_t site_count() const noexcept { return medax_sites_site_count(get()); }
    /// The smallest box round the bounded pieces: its least corner and its greatest.
    std::array<Point, 2> bounds() const {
        std::array<Point, 2> bounds;
        detail::check(medax_sites_bounds(get(), bounds[0].data(), bounds[1].data()));
        return bounds;
    }
    double size() const noexcept { return medax_sites_size(get()); }

    /// What is nearest to each point.
    std::vector<Nearest> nearest(const std::vector<Point> &queries,
                                 const Job &job = Job::fresh()) const {
        std::vector<Nearest> nearest(queries.size());
        job.check(medax_sites_nearest(get(), xyz(queries), queries.size(), job.get(),
                                      nearest.data()));
        return nearest;
    }
    /// All that is no farther than the nearest and a tolerance.
    AllNearest all_nearest(const std::vector<Point> &queries, double tolerance,
                           const Job &job = Job::fresh()) const {
        const medax_all_nearest *all = nullptr;
        job.check(medax_sites_all_nearest(get(), xyz(queries), queries.size(), tolerance,
                                          job.get(), &all));
        return AllNearest(all);
    }
    /// 1 for each point inside, 0 for any other.
    std::vector<std::uint8_t> is_inside(const std::vector<Point> &queries,
                                        const Job &job = Job::fresh()) const {
        std::vector<std::uint8_t> is_inside(queries.size());
        job.check(medax_sites_is_inside(get(), xyz(queries), queries.size(), job.get(),
                                        is_inside.data()));
        return is_inside;
    }

    /// Directions spread evenly, for decisions.
    std::vector<Point> even_directions(std::size_t count) const {
        std::vector<Point> directions(count);
        double *out = directions.empty() ? nullptr : directions.front().data();
        detail::check(medax_sites_even_directions(get(), count, out));
        return directions;
    }
    /// Whether a circle or a sphere that the boundary does not enter holds a medial point.
    Decision decide(const Point &center, double radius, const std::vector<Point> &directions,
                    const DecideOptions &options = {}, const Job &job = Job::fresh()) const {
        Decision decision;
        decision.struct_size = sizeof(medax_decision);
        decision.theta.resize(2 * directions.size());
        double *theta = decision.theta.empty() ? nullptr : decision.theta.front().data();
        job.check(medax_sites_decide(get(), center.data(), radius, xyz(directions),
                                     directions.size(), &options, job.get(),
                                     decision.theta.size(), theta, &decision));
        decision.theta.resize(decision.theta_count);
        return decision;
    }

private:
    static const double *xyz(const std::vector<Point> &points) noexcept {
        return points.empty() ? nullptr : points.front().data();
    }
};

/// The largest object angle of a medial point that a circle can hold unnoticed; pi for no claim.
inline double largest_missed_angle(double gap, double radius, double distance) noexcept {
    return medax_largest_missed_angle(gap, radius, distance);
}

/// Points of the medial axis of sites, and where they were looked for.
class FieldAxis
    : public detail::Handle<medax_field_axis, medax_field_axis_clone, medax_field_axis_free> {
public:
    /// What may have been missed.
    struct Claim {
        /// The largest object angle where there is a claim, in radians.
        double angle;
        /// The number of covers that make none.
        std::size_t unclaimed;
    };

    /// Takes over a reference that a function of medax.h gave.
    explicit FieldAxis(const medax_field_axis *owned) noexcept : Handle(owned) {}

    static FieldAxis of(const Sites &sites, const FieldAxisOptions &options = {},
                        const Job &job = Job::fresh()) {
        const medax_field_axis *axis = nullptr;
        job.check(medax_field_axis_build(sites.get(), &options, job.get(), &axis));
        return FieldAxis(axis);
    }
    /// Only what has its nearest points on one of some pairs of sites.
    static FieldAxis between(const Sites &sites, const std::vector<SitePair> &pairs,
                             const FieldAxisOptions &options = {}, const Job &job = Job::fresh()) {
        const medax_field_axis *axis = nullptr;
        const std::uint32_t *first = pairs.empty() ? nullptr : pairs.front().data();
        job.check(medax_field_axis_between(sites.get(), first, pairs.size(), &options, job.get(),
                                           &axis));
        return FieldAxis(axis);
    }

    Sites sites() const {
        const medax_sites *sites = nullptr;
        detail::check(medax_field_axis_sites(get(), &sites));
        return Sites(sites);
    }
    /// What was asked for, with numbers in place of the defaults.
    FieldAxisOptions resolved() const {
        FieldAxisOptions options;
        detail::check(medax_field_axis_resolved(get(), &options));
        return options;
    }

    View<double> points() const noexcept { return detail::view(medax_field_axis_points(get())); }
    View<double> radii() const noexcept { return detail::view(medax_field_axis_radii(get())); }
    View<double> object_angles() const noexcept {
        return detail::view(medax_field_axis_object_angles(get()));
    }
    /// Rows of six: two nearest points.
    View<double> feet() const noexcept { return detail::view(medax_field_axis_feet(get())); }
    View<std::uint32_t> pieces() const noexcept {
        return detail::view(medax_field_axis_pieces(get()));
    }
    View<std::uint32_t> sites_of_points() const noexcept {
        return detail::view(medax_field_axis_sites_of_points(get()));
    }
    View<std::uint32_t> cover_of_point() const noexcept {
        return detail::view(medax_field_axis_cover_of_point(get()));
    }
    std::vector<Cover> covers() const {
        std::vector<Cover> covers(medax_field_axis_cover_count(get()));
        detail::check(medax_field_axis_covers(get(), 0, covers.size(), covers.data()));
        return covers;
    }
    Claim claim() const {
        Claim claim{};
        detail::check(medax_field_axis_claim(get(), &claim.angle, &claim.unclaimed));
        return claim;
    }
    std::size_t unconfirmed() const noexcept { return medax_field_axis_unconfirmed(get()); }
    /// The points as vertices, for writing.
    Complex complex(const Job &job = Job::fresh()) const {
        const medax_complex *complex = nullptr;
        job.check(medax_field_axis_complex(get(), job.get(), &complex));
        return Complex(complex);
    }
    /// In space the axis as polygons, and loose edges where it is a curve.
    Complex surface(const Job &job = Job::fresh()) const {
        const medax_complex *surface = nullptr;
        job.check(medax_field_axis_surface(get(), job.get(), &surface));
        return Complex(surface);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_field_axis_validate, get(), job);
    }
};

/// The medial axis of sites in the plane as a graph: nodes, where arcs meet or end, and arcs.
class MedialGraph
    : public detail::Handle<medax_medial_graph, medax_medial_graph_clone, medax_medial_graph_free> {
public:
    /// Takes over a reference that a function of medax.h gave.
    explicit MedialGraph(const medax_medial_graph *owned) noexcept : Handle(owned) {}

    static MedialGraph of(const Sites &sites, const MedialGraphOptions &options = {},
                          const Job &job = Job::fresh()) {
        const medax_medial_graph *graph = nullptr;
        job.check(medax_medial_graph_build(sites.get(), &options, job.get(), &graph));
        return MedialGraph(graph);
    }
    /// Only what has its nearest points on one of some pairs of sites.
    static MedialGraph between(const Sites &sites, const std::vector<SitePair> &pairs,
                               const MedialGraphOptions &options = {},
                               const Job &job = Job::fresh()) {
        const medax_medial_graph *graph = nullptr;
        const std::uint32_t *first = pairs.empty() ? nullptr : pairs.front().data();
        job.check(medax_medial_graph_between(sites.get(), first, pairs.size(), &options, job.get(),
                                             &graph));
        return MedialGraph(graph);
    }

    Sites sites() const {
        const medax_sites *sites = nullptr;
        detail::check(medax_medial_graph_sites(get(), &sites));
        return Sites(sites);
    }
    /// How many of the points are nodes: the first ones.
    std::size_t node_count() const noexcept { return medax_medial_graph_node_count(get()); }
    /// One row an arc: its points in order.
    Rows arcs() const noexcept { return Rows(medax_medial_graph_arcs(get())); }
    std::size_t torn() const noexcept { return medax_medial_graph_torn(get()); }
    View<double> points() const noexcept { return detail::view(medax_medial_graph_points(get())); }
    View<double> radii() const noexcept { return detail::view(medax_medial_graph_radii(get())); }
    View<double> object_angles() const noexcept {
        return detail::view(medax_medial_graph_object_angles(get()));
    }
    /// Rows of six: two nearest points.
    View<double> feet() const noexcept { return detail::view(medax_medial_graph_feet(get())); }
    View<std::uint32_t> pieces() const noexcept {
        return detail::view(medax_medial_graph_pieces(get()));
    }
    View<std::uint32_t> sites_of_points() const noexcept {
        return detail::view(medax_medial_graph_sites_of_points(get()));
    }
    /// The arcs as loose edges, for writing.
    Complex complex(const Job &job = Job::fresh()) const {
        const medax_complex *complex = nullptr;
        job.check(medax_medial_graph_complex(get(), job.get(), &complex));
        return Complex(complex);
    }
    Validation validate(const Job &job = Job::fresh()) const {
        return detail::validated(medax_medial_graph_validate, get(), job);
    }
};

}  // namespace medax
