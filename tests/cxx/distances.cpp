// Distances to sites in C++, and the medial axes read off them.
#include "check.hpp"

#include <cmath>
#include <utility>

namespace {

constexpr double pi = 3.14159265358979323846;

medax::Sites rectangle() {
    medax::FigureParts parts;
    parts.polygons = {{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}}};
    return medax::Sites::of(medax::Figure::from(parts));
}

void pieces() {
    using medax::Piece;
    const std::vector<Piece> given = {
        Piece::point({1, 2, 3}, 4),         Piece::segment({0, 0, 0}, {1, 0, 0}),
        Piece::ray({0, 0, 0}, {0, 1, 0}),   Piece::line({0, 0, 5}, {1, 1, 0}),
        Piece::sphere({9, 9, 9}, 2.5, 2),   Piece::triangle({0, 0, 8}, {1, 0, 8}, {0, 1, 8}, 1)};
    const medax::Sites sites = medax::Sites::from(3, given);
    const std::vector<Piece> found = sites.pieces();
    CHECK(sites.dimension() == 3 && sites.site_count() == 5 && sites.piece_count() == 6);
    CHECK(found[0].kind == MEDAX_PIECE_KIND_POINT && found[0].numbers[2] == 3 && found[0].site == 4);
    CHECK(found[1].kind == MEDAX_PIECE_KIND_SEGMENT && found[1].numbers[3] == 1);
    CHECK(found[2].kind == MEDAX_PIECE_KIND_RAY && found[2].numbers[4] == 1);
    CHECK(found[3].kind == MEDAX_PIECE_KIND_LINE && found[3].numbers[2] == 5);
    CHECK(found[4].kind == MEDAX_PIECE_KIND_SPHERE && found[4].numbers[3] == 2.5);
    CHECK(found[5].kind == MEDAX_PIECE_KIND_TRIANGLE && found[5].numbers[8] == 8);
    CHECK(sites.site_of_piece()[4][0] == 2 && sites.bounds()[1][0] == 11.5);
    const medax::Error flat = THROWN(medax::Sites::from(2, given));
    CHECK(flat.kind() == MEDAX_ERROR_KIND_ROW && flat.index() == 0);
    CHECK(THROWN(medax::Sites::from(3, {})).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    const std::vector<Piece> circle = {Piece::sphere({0, 0, 0}, 1)};
    CHECK(THROWN(medax::Sites::from(2, circle, {1, 1})).status() == MEDAX_STATUS_MISMATCH);
    CHECK(medax::Sites::from(2, circle, {1}).is_inside({{0.5, 0, 0}, {2, 0, 0}})
          == (std::vector<std::uint8_t>{1, 0}));
    CHECK(medax::Sites::from(2, circle).is_inside({{0.5, 0, 0}})[0] == 0);
}

void queries() {
    const medax::Sites sites = rectangle();
    const std::vector<medax::Nearest> nearest = sites.nearest({{2, 0.5, 0}, {3.5, 1, 0}});
    CHECK(nearest[0].distance == 0.5 && nearest[0].piece == 0 && nearest[0].direction[1] == -1);
    CHECK(nearest[1].distance == 0.5 && nearest[1].piece == 1 && nearest[1].point[0] == 4);
    const medax::AllNearest all = sites.all_nearest({{1, 1, 0}, {2, 1, 0}}, 1e-9);
    CHECK(all.pieces().rows() == 2 && all.pieces()[0].size() == 3 && all.pieces()[1].size() == 2);
    CHECK(all.distances().rows() == 5 && all.sites()[4][0] == 0 && all.points()[1].size() == 3);
    CHECK(all.directions()[3][1] == -1);
    CHECK(sites.nearest({}).empty() && sites.size() == std::sqrt(20.0));
    const medax::Error row = THROWN(sites.nearest({{0, 0, 0}, {std::nan(""), 0, 0}}));
    CHECK(row.status() == MEDAX_STATUS_NON_FINITE && row.index() == 1);

    const medax::Decision found = sites.decide({2, 1, 0}, 0.5, sites.even_directions(16));
    CHECK(found.has_point() && std::fabs(found.center[1] - 1) < 1e-5);
    const medax::Decision none = sites.decide({2, 0.4, 0}, 0.2, sites.even_directions(16));
    CHECK(!none.has_point() && none.theta.size() == 16 && std::fabs(none.gap - 0.2 * pi / 8) < 1e-12);
    CHECK(std::fabs(medax::largest_missed_angle(none.gap, 0.2, 0.4) - std::asin(none.gap / 0.4) * 2)
          < 1e-15);
    CHECK(THROWN(sites.decide({2, 1, 0}, 3, {})).status() == MEDAX_STATUS_INVALID_ARGUMENT);

    medax::FieldAxisOptions coarse;
    coarse.density = 0.5;
    const medax::Complex points = medax::FieldAxis::of(sites, coarse).complex();
    CHECK(medax::Sites::of(points).piece_count() == points.vertices().rows());
}

void axes() {
    medax::Sites sites = rectangle();
    medax::FieldAxisOptions coarse;
    coarse.density = 0.2;
    coarse.object_angle = 2;
    const medax::FieldAxis axis = medax::FieldAxis::of(sites, coarse);
    CHECK(axis.resolved().min_distance == 0.05 && axis.resolved().object_angle == 2);
    for (std::size_t i = 0; i < axis.points().rows(); ++i)
        CHECK(std::fabs(axis.points()[i][1] - 1) < 1e-5 && std::fabs(axis.radii()[i][0] - 1) < 1e-5);
    CHECK(axis.points().rows() > 5 && axis.feet().cols() == 6 && axis.pieces().cols() == 2);
    CHECK(axis.object_angles().rows() == axis.points().rows() && axis.sites_of_points()[0][1] == 0);
    std::size_t found = 0;
    for (const medax::Cover &cover : axis.covers()) found += cover.found;
    CHECK(found == axis.points().rows() && axis.cover_of_point().rows() == found);
    CHECK(axis.claim().angle <= pi / 9 && axis.claim().unclaimed < axis.covers().size());
    CHECK(axis.unconfirmed() < found && axis.sites().piece_count() == 4);
    CHECK(axis.complex().vertices().rows() == found);

    const medax::MedialGraph graph = medax::MedialGraph::of(sites);
    CHECK(graph.node_count() == 6 && graph.arcs().rows() == 5 && graph.torn() == 0);
    CHECK(graph.arcs()[0].size() >= 2 && graph.points().cols() == 3 && graph.feet().cols() == 6);
    CHECK(graph.radii().rows() == graph.points().rows() && graph.pieces().cols() == 2);
    CHECK(graph.object_angles().rows() == graph.points().rows());
    CHECK(graph.sites_of_points()[0][0] == 0 && graph.complex().topology().betti[0] == 1);
    medax::MedialGraphOptions wrong;
    wrong.spacing = -1;
    CHECK(THROWN(medax::MedialGraph::of(sites, wrong)).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    const medax::Sites moved = std::move(sites);
    CHECK(sites.piece_count() == 0 && graph.sites().site_of_piece().data() == moved.site_of_piece().data());
}

/// The square between two points, as a surface; and the ray and lines that three points have in the plane.
void diagrams() {
    using medax::Piece;
    medax::FieldAxisOptions options;
    options.side = MEDAX_SIDE_OUTER;
    options.density = 0.3;
    options.has_clip = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        options.clip_min[k] = -1;
        options.clip_max[k] = 1;
    }
    const std::vector<Piece> two = {Piece::point({-1, 0, 0}), Piece::point({1, 0, 0}, 1)};
    const medax::Sites points = medax::Sites::from(3, two);
    const medax::FieldAxis axis = medax::FieldAxis::between(points, {{0, 1}}, options);
    const medax::Validation found = axis.validate();
    CHECK(found.is_valid() && found.checked > axis.points().rows() && axis.points().rows() > 20);
    const medax::Complex square = axis.surface();
    for (std::size_t i = 0; i < square.vertices().rows(); ++i)
        CHECK(std::fabs(square.vertices()[i][0]) < 1e-5);
    CHECK(square.topology().betti[0] == 1 && square.topology().boundary_loops == 1);
    CHECK(square.faces().rows() > 20 && square.measure().area <= 4);
    CHECK(medax::FieldAxis::between(points, {}, options).points().empty());
    const medax::Error third = THROWN(medax::FieldAxis::between(points, {{0, 1}, {0, 2}}, options));
    CHECK(third.status() == MEDAX_STATUS_INVALID_ARGUMENT && third.index() == 1);

    const std::vector<Piece> three = {Piece::point({-1, 0, 0}), Piece::point({1, 0, 0}, 1),
                                      Piece::point({0, 2, 0}, 2)};
    const medax::Sites plane = medax::Sites::from(2, three);
    medax::MedialGraphOptions outer;
    outer.side = MEDAX_SIDE_OUTER;
    CHECK(medax::MedialGraph::of(plane, outer).arcs().rows() == 3);
    const medax::MedialGraph one = medax::MedialGraph::between(plane, {{1, 0}}, outer);
    CHECK(one.arcs().rows() == 1 && one.validate().is_valid() && one.points().rows() > 2);
    for (std::size_t i = 0; i < one.points().rows(); ++i)
        CHECK(std::fabs(one.points()[i][0]) < 1e-9 && one.points()[i][1] < 0.75 + 1e-9);
    CHECK(medax::MedialGraph::between(plane, {}, outer).arcs().rows() == 0);
    const medax::Error none = THROWN(medax::MedialGraph::between(plane, {{3, 0}}, outer));
    CHECK(none.kind() == MEDAX_ERROR_KIND_ROW && none.index() == 0);
    CHECK(THROWN(medax::FieldAxis::of(rectangle()).surface()).status() == MEDAX_STATUS_INVALID_ARGUMENT);
}

void balls() {
    const medax::Balls apart = medax::Balls::from({{0, 0, 0}, {4, 0, 0}}, {1, 0.5});
    CHECK(apart.count() == 2 && apart.centers()[1][0] == 4 && apart.radii()[1][0] == 0.5);
    CHECK(apart.bounds()[0][0] == -1 && apart.bounds()[1][0] == 4.5);
    CHECK(apart.distances({{0, 0, 0}, {2, 0, 0}, {4, 0.5, 0}}) == (std::vector<double>{-1, 1, 0}));
    CHECK(apart.distances({}).empty());
    medax::BoundaryOptions options;
    options.spacing = 0.1;
    const medax::Complex mesh = apart.boundary(options);
    CHECK(mesh.topology().betti[0] == 2 && mesh.topology().betti[2] == 2);
    CHECK(std::fabs(mesh.measure().volume / (4 * pi / 3 * 1.125) - 1) < 0.01);
    CHECK(mesh.attribute(MEDAX_ELEMENT_VERTEX, "ball").u32_values.rows() == mesh.vertices().rows());

    medax::FieldAxisOptions coarse;
    coarse.density = 0.5;
    coarse.side = MEDAX_SIDE_BOTH;
    const medax::Sites sphere = medax::Sites::from(3, {medax::Piece::sphere({1, 2, 3}, 2)});
    const medax::Balls again = medax::Balls::of(medax::FieldAxis::of(sphere, coarse).complex());
    CHECK(std::fabs(again.distances({{1, 2, 6}})[0] - 1) < 1e-4);
    options.spacing = -1;
    CHECK(THROWN(again.boundary(options)).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    CHECK(THROWN(medax::Balls::of(mesh)).status() == MEDAX_STATUS_MISMATCH);
    CHECK(THROWN(medax::Balls::from({{0, 0, 0}}, {})).status() == MEDAX_STATUS_MISMATCH);
    CHECK(THROWN(medax::Balls::from({}, {})).status() == MEDAX_STATUS_TOO_FEW_POINTS);
    CHECK(THROWN(medax::Balls::from({{0, 0, 0}, {1, 0, 0}}, {1, 0})).index() == 1);
}

}  // namespace

void distances() {
    pieces();
    queries();
    axes();
    diagrams();
    balls();
}
