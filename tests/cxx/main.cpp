// The C++ layer: references, exceptions, views, the progress function.
#include "check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <thread>

medax::Triangulation triangulate_elsewhere(const medax::Points &points);
/// figures.cpp
void figures();
/// distances.cpp
void distances();
/// pairs.cpp
void pairs();

namespace {

std::vector<medax::Point> cloud(std::size_t count) {
    std::uint64_t state = 1;
    std::vector<medax::Point> points(count);
    for (medax::Point &point : points)
        for (double &x : point) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            x = static_cast<double>(state >> 11) / 9007199254740992.0;
        }
    return points;
}

const std::vector<medax::Point> corners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {1, 1, 1}};

void errors() {
    std::vector<medax::Point> bad = corners;
    bad[3][1] = std::nan("");
    const medax::Error error = THROWN(medax::Points::from(bad));
    CHECK(error.status() == MEDAX_STATUS_NON_FINITE && error.index() == 3);
    CHECK(error.kind() == MEDAX_ERROR_KIND_ROW && std::strstr(error.what(), "NaN") != nullptr);
    CHECK(THROWN(medax::Points::from({})).status() == MEDAX_STATUS_TOO_FEW_POINTS);
    CHECK(std::strcmp(medax::name(error.status()), "MEDAX_STATUS_NON_FINITE") == 0);

    medax::PointsOptions options;
    options.skip_non_finite = 1;
    const medax::Points points = medax::Points::from(bad, options);
    CHECK(points.count() == 4 && points.skipped_count() == 1);
    CHECK(points.vertex_of_row()[3][0] == medax::none);
}

void versions() {
    CHECK(medax::version() == MEDAX_VERSION);
    const std::string text = medax::version_string();
    CHECK(std::count(text.begin(), text.end(), '.') == 2);
    const medax::Error own(MEDAX_STATUS_MISMATCH, "sides differ", MEDAX_ERROR_KIND_FACE, 7);
    CHECK(own.status() == MEDAX_STATUS_MISMATCH && own.kind() == MEDAX_ERROR_KIND_FACE && own.index() == 7);
    CHECK(std::strcmp(own.what(), "sides differ") == 0);
}

void references() {
    medax::Points first = medax::Points::from(corners);
    medax::Points second = first;
    CHECK(first.get() == second.get());
    medax::Points third = std::move(first);
    CHECK(third.get() == second.get() && first.get() == nullptr);
    CHECK(first.coords().empty() && first.count() == 0);
    CHECK(THROWN(medax::Triangulation::delaunay(first)).status() == MEDAX_STATUS_NULL_ARGUMENT);
    first = second;
    second = medax::Points::from(cloud(10));
    second = std::move(third);
    CHECK(second.get() == first.get() && second.count() == 5);
    second = *&second;
    CHECK(second.count() == 5 && second.bounds().max[0] == 4);
}

void triangulations() {
    const medax::Triangulation t = triangulate_elsewhere(medax::Points::from(corners));
    CHECK(t.cells().rows() == 4 && t.cells().cols() == 4 && t.cells().size() == 16);
    CHECK(t.points().count() == 5 && t.coords().rows() == 5 && t.hidden().empty());
    CHECK(t.validate().is_valid());
    CHECK(t.locate({9, 9, 9}) == medax::none && t.locate({0.5, 0.5, 0.5}) < 4);
    CHECK(THROWN(t.locate({0, std::nan(""), 0})).status() == MEDAX_STATUS_NON_FINITE);
    const medax::Incidence incidence = medax::Incidence::of(t);
    std::size_t around = 0;
    for (std::size_t v = 0; v < 5; ++v)
        for (const std::uint32_t cell : incidence.cells_of_vertex()[v]) around += cell < 4;
    CHECK(around == 16 && incidence.edges().rows() == 10);
    const auto edge = incidence.edges()[0];
    const auto ring = t.ring(incidence.cell_of_edge()[0][0], edge[0], edge[1]);
    CHECK(ring.cells.size() == (ring.closed ? 3 : 2));

    const medax::Points points = t.points();
    const medax::Triangulation r = medax::Triangulation::regular(points, {0, 0, 0, 0, -100});
    CHECK(r.cells().rows() == 1 && r.hidden().rows() == 1);
    CHECK(THROWN(medax::Triangulation::regular(points, {0, 0})).status()
          == MEDAX_STATUS_MISMATCH);

    // More cells round an edge than the first buffer holds.
    std::vector<medax::Point> wheel = {{0, 0, 0.01}, {0, 0, -0.01}};
    for (int i = 0; i < 100; ++i) wheel.push_back({std::cos(0.0628 * i), std::sin(0.0628 * i), 0});
    const medax::Triangulation w = triangulate_elsewhere(medax::Points::from(wheel));
    const medax::Incidence spokes = medax::Incidence::of(w);
    std::size_t longest = 0;
    for (std::size_t e = 0; e < spokes.edges().rows(); ++e) {
        const auto ends = spokes.edges()[e];
        const auto cells = w.ring(spokes.cell_of_edge()[e][0], ends[0], ends[1]).cells;
        if (cells.size() > longest) longest = cells.size();
    }
    CHECK(longest > 32);
}

void jobs() {
    struct Stop {};
    const medax::Points points = medax::Points::from(cloud(20000));
    const auto run = [&](medax::JobOptions options) {
        const medax::Job job(std::move(options));
        medax::Triangulation::delaunay(points, {}, job);
        return job;
    };
    CHECK(run({}).times().size() == 1 && run({}).progress() == 1);
    CHECK(THROWN(run({0, 1000, nullptr})).status() == MEDAX_STATUS_OUT_OF_MEMORY);
    const medax::Job spent;
    spent.cancel();
    CHECK(spent.is_cancelled());
    CHECK(THROWN(medax::Points::from(corners, {}, spent)).status() == MEDAX_STATUS_CANCELLED);

    // The callback comes after 50 ms: larger and larger sets until it does.
    int calls = 0;
    medax::JobOptions cancel, escape;
    cancel.progress = [&](double progress, const char *stage) {
        ++calls;
        CHECK(progress >= 0 && progress <= 1 && std::strcmp(stage, "triangulate") == 0);
        return medax::Next::cancel;
    };
    escape.progress = [&](double, const char *) -> medax::Next {
        ++calls;
        throw Stop();
    };
    for (std::size_t count = 20000; count < 10000000; count *= 2) {
        const medax::Points many = medax::Points::from(cloud(count));
        const medax::Job job(cancel);
        try {
            medax::Triangulation::delaunay(many, {}, job);
        } catch (const medax::Error &error) {
            CHECK(error.status() == MEDAX_STATUS_CANCELLED && job.is_cancelled());
            // Eight times as many take longer than the callback waits, however the machine is busy.
            const medax::Points larger = medax::Points::from(cloud(8 * count));
            const medax::Job thrower(escape);
            const medax::Job copy = thrower;
            bool stopped = false;
            try {
                medax::Triangulation::delaunay(larger, {}, copy);
            } catch (const Stop &) {
                stopped = true;
            }
            CHECK(stopped && thrower.is_cancelled());
            CHECK(THROWN(medax::Triangulation::delaunay(larger, {}, thrower)).status()
                  == MEDAX_STATUS_CANCELLED);
            // The same by a lambda alone: one that throws and returns nothing, one that cancels.
            int seen = 0;
            const medax::Job watcher = medax::Job::watched([&](double, const char *) {
                ++seen;
                throw Stop();
            });
            stopped = false;
            try {
                medax::Triangulation::delaunay(larger, {}, watcher);
            } catch (const Stop &) {
                stopped = true;
            }
            CHECK(stopped && seen == 1 && watcher.is_cancelled() && watcher.progress() < 1);
            const medax::Job stopper = medax::Job::watched([](double, const char *) { return medax::Next::cancel; });
            CHECK(THROWN(medax::Triangulation::delaunay(larger, {}, stopper)).status() == MEDAX_STATUS_CANCELLED);
            // And from another thread.
            const medax::Job remote;
            std::thread canceller([remote] {
                while (remote.progress() == 0) std::this_thread::yield();
                remote.cancel();
            });
            CHECK(THROWN(medax::Triangulation::delaunay(larger, {}, remote)).status() == MEDAX_STATUS_CANCELLED);
            canceller.join();
            break;
        }
    }
    CHECK(calls == 2);
    const medax::Job quiet = medax::Job::watched([](double, const char *) {});
    medax::Triangulation::delaunay(points, {}, quiet);
    CHECK(quiet.progress() == 1 && quiet.memory_peak() > 0 && !quiet.is_cancelled());
    CHECK(std::strcmp(quiet.times().at(0).stage, "triangulate") == 0);
}

void complexes() {
    const std::uint32_t offsets[] = {0, 4}, ring[] = {0, 1, 2, 3};
    const double xyz[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    medax_attribute radius{};
    radius.name = "radius";
    radius.f64_values = {xyz, 4, 3};
    medax::ComplexParts parts;
    parts.vertices = xyz;
    parts.vertex_count = 4;
    parts.face_offsets = offsets;
    parts.face_indices = ring;
    parts.face_count = 1;
    parts.attributes = &radius;
    parts.attribute_count = 1;
    const medax::Complex complex = medax::Complex::from(parts);
    CHECK(complex.faces().rows() == 1 && complex.faces()[0].size() == 4);
    CHECK(complex.faces().offsets().size() == 2 && complex.faces().indices().size() == 4);
    CHECK(complex.triangles().rows() == 2 && complex.face_of_triangle()[1][0] == 0);
    CHECK(complex.vertices()[2][1] == 1 && complex.edges().empty() && complex.cells().empty());
    const medax::Attribute found = complex.attribute(MEDAX_ELEMENT_VERTEX, std::string("radius"));
    CHECK(found.f64_values.cols() == 3 && found.u32_values.empty());
    CHECK(complex.attribute_count() == 1 && std::strcmp(complex.attribute(0).name, "radius") == 0);
    CHECK(THROWN(complex.attribute(MEDAX_ELEMENT_FACE, "radius")).status()
          == MEDAX_STATUS_INVALID_ARGUMENT);
}

void intersections() {
    // Two triangles that cross; the third is on its own.
    const double xyz[] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -1, 1, 1, 1, 2, 1, 1, 9, 9, 9, 9, 8, 9, 8, 9, 9};
    const std::uint32_t offsets[] = {0, 3, 6, 9}, rings[] = {6, 7, 8, 0, 1, 2, 3, 4, 5};
    medax::ComplexParts parts;
    parts.vertices = xyz;
    parts.vertex_count = 9;
    parts.face_offsets = offsets;
    parts.face_indices = rings;
    parts.face_count = 3;
    const medax::Job job;
    const medax::Intersections found = medax::Complex::from(parts).self_intersections(job);
    const medax::View<std::uint32_t> pairs = found.pairs();
    CHECK(pairs.rows() == 1 && pairs.cols() == 2 && pairs[0][0] == 1 && pairs[0][1] == 2);
    // Found once.
    CHECK(job.times().size() == 1);
    const medax::Intersections same = found;
    CHECK(same.get() == found.get() && same.pairs().data() == pairs.data());
    parts.face_count = 1;
    CHECK(medax::Complex::from(parts).self_intersections().pairs().empty());
}

void crusts() {
    // The corners of a grid on the surface of a cube.
    std::vector<medax::Point> grid;
    for (int i = 0; i <= 6; ++i)
        for (int j = 0; j <= 6; ++j)
            for (const double end : {0.0, 6.0})
                for (int axis = 0; axis < 3; ++axis) {
                    medax::Point point;
                    point[axis] = end;
                    point[(axis + 1) % 3] = i;
                    point[(axis + 2) % 3] = j;
                    grid.push_back(point);
                }
    const medax::Points points = medax::Points::from(grid);
    CHECK(points.count() == 218 && points.duplicate_count() == 294 - 218);
    const medax::Poles poles = medax::Poles::with_far_box(points);
    CHECK(poles.has_far_box() && poles.validate().is_valid());
    CHECK(poles.pole_of_sample().rows() == 218 && poles.normals().rows() == 218);
    CHECK(poles.cell_of_pole().rows() == poles.balls().rows());
    CHECK(poles.triangulation().coords().rows() == 226);
    CHECK(poles.feature_size({{3, 3, 3}, {3, 3, 5}}).size() == 2);
    const medax::PowerCrust crust = medax::PowerCrust::of(poles);
    CHECK(crust.validate().is_valid() && crust.poles().get() != nullptr);
    CHECK(crust.labels().rows() == poles.radii_squared().rows());
    CHECK(crust.regular().points().row_count() == poles.touches_far_box().rows());
    CHECK(crust.forced_count() <= crust.labels().rows() && !crust.is_visible(medax::none));
    const medax::Complex surface = medax::PowerCrust::of(points).surface();
    CHECK(surface.faces().rows() == crust.surface().faces().rows() && !surface.faces().empty());
    CHECK(crust.shape(MEDAX_LABEL_INNER).attribute(MEDAX_ELEMENT_VERTEX, "radius").f64_values.rows()
          == crust.shape(MEDAX_LABEL_INNER).vertices().rows());

    const std::string path = "cxx_surface.off";
    CHECK(surface.write(path).count() == 4);
    std::vector<std::uint32_t> labels(crust.labels().rows());
    for (std::size_t pole = 0; pole < labels.size(); ++pole) labels[pole] = crust.labels()[pole][0];
    CHECK(crust.with_labels(labels).surface().faces().rows() == surface.faces().rows());
    labels.pop_back();
    CHECK(THROWN(crust.with_labels(labels)).status() == MEDAX_STATUS_MISMATCH);
    const medax::PowerCrust labelled = crust.labelled_by_mesh(surface);
    CHECK(labelled.validate().is_valid() && labelled.unreached_count() == 0);
    CHECK(labelled.surface().faces().rows() == surface.faces().rows());
    const std::vector<double> numbers = surface.winding_numbers({{3, 3, 3}, {30, 30, 30}});
    CHECK(numbers.size() == 2 && numbers[0] > 0.99 && numbers[1] < 0.01);
    const medax::PowerCrust larger = crust.offset(0.01);
    CHECK(larger.validate().is_valid() && !larger.surface().faces().empty());
    const medax::Simplified simplified = crust.simplify();
    CHECK(simplified.epsilon() > simplified.delta() && simplified.delta() > 0);
    CHECK(simplified.crust().validate().is_valid());
    CHECK(simplified.unstable().rows() + simplified.redundant().rows() < crust.labels().rows());
    const auto [left, left_out] = crust.open();
    CHECK(left.faces().rows() + left_out.faces().rows() == crust.surface().faces().rows());
    const medax::Sizes sizes = crust.sizes_at({{3, 3, 3}, {3, 3, 9}});
    CHECK(sizes.feature_size == poles.feature_size({{3, 3, 3}, {3, 3, 9}}));
    CHECK(sizes.thickness.size() == 2 && sizes.thickness[1] > 5 && crust.sizes_at({}).thickness.empty());
    CHECK(THROWN(crust.sizes_at({{0, 0, 0}, {0, NAN, 0}})).index() == 1);
    const medax::Complex sized = crust.with_sizes(crust.surface());
    CHECK(sized.attribute(MEDAX_ELEMENT_VERTEX, "thickness").f64_values.rows()
          == crust.surface().vertices().rows());
    CHECK(crust.samples_complex().attribute(MEDAX_ELEMENT_VERTEX, "row").u32_values.rows()
          == points.count());
    CHECK(poles.samples_on_balls().rows() == crust.labels().rows() && poles.lambda() == 0);
    const medax::Complex both = crust.both_shapes();
    CHECK(both.vertices().rows() == crust.shape(MEDAX_LABEL_INNER).vertices().rows()
                                        + crust.shape(MEDAX_LABEL_OUTER).vertices().rows());
    CHECK(both.attribute(MEDAX_ELEMENT_VERTEX, "label").u32_values[0][0] == MEDAX_LABEL_INNER);
    CHECK(poles.object_angles().rows() == poles.balls().rows());
    medax::FlattenOptions all;
    all.flatness = 1;
    const medax::Flattened flattened = both.flatten(all);
    CHECK(flattened.collapses().rows() + flattened.left_count() == both.cells().rows());
    CHECK(flattened.complex().cells().rows() == flattened.left_count());
    CHECK(flattened.complex().topology().betti[1] == both.topology().betti[1]);
    CHECK(crust.poles_complex().attribute(MEDAX_ELEMENT_VERTEX, "label").u32_values.rows()
          == crust.labels().rows());
    CHECK(poles.complex().vertices().rows() == poles.balls().rows());
    CHECK(poles.samples_complex().vertices().rows() == points.count());
    CHECK(poles.triangulation().complex().cells().rows() == poles.triangulation().cells().rows());
    const medax::File file = medax::File::read(path);
    CHECK(file.is_mesh() && file.faces().rows() == surface.faces().rows());
    CHECK(file.attribute_count() == 0);
    CHECK(THROWN(file.attribute(0)).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    CHECK(THROWN(file.attribute(MEDAX_ELEMENT_FACE, "label")).index() == UINT64_MAX);
    CHECK(file.warnings().empty() && file.points().row_count() == file.vertices().rows());
    CHECK(file.complex().faces().rows() == medax::Complex::read(path).faces().rows());
    CHECK(medax::Points::read(path).write(path + ".xyz").empty());
    CHECK(poles.complex().write("cxx_poles.ply").empty());
    const medax::File balls = medax::File::read("cxx_poles.ply");
    CHECK(balls.attribute_count() == 2 && std::strcmp(balls.attribute(0).name, "radius") == 0);
    CHECK(balls.attribute(MEDAX_ELEMENT_VERTEX, "radius").f64_values.rows() == poles.balls().rows());
    std::remove("cxx_poles.ply");
    std::remove(path.c_str());
    std::remove((path + ".xyz").c_str());
    CHECK(THROWN(medax::File::read(path)).status() == MEDAX_STATUS_IO);
}

void flow_complexes(const medax::Flow &flow, medax::FlowElement middle) {
    const medax::Job job;
    const medax::FlowComplex its = medax::FlowComplex::of(flow, job);
    CHECK(std::strcmp(job.times().at(0).stage, "flow") == 0 && its.validate().is_valid());
    CHECK(its.flow().triangles().data() == flow.triangles().data());
    CHECK(its.points().rows() == its.triangle_of_point().rows() && !its.points().empty());
    CHECK(its.vertex_count() == flow.labels().is_inner().rows() + its.points().rows());
    CHECK(its.edge_of_vertex().rows() == its.vertex_count());
    CHECK(its.face_of_edge().rows() == its.edges().rows() && its.edges().cols() == 2);
    CHECK(its.triangle_of_edge().rows() < its.edges().rows());
    CHECK(its.face_edges()[7].size() == its.faces()[7].size());
    const std::uint32_t *begins = its.faces_of_facet().data();
    std::uint32_t widest = 0;
    for (std::uint32_t f = 0; f + 1 < its.faces_of_facet().rows(); ++f)
        if (begins[f + 1] - begins[f] > begins[widest + 1] - begins[widest]) widest = f;
    // More faces than the first buffer holds.
    const std::vector<medax::FlowElement> faces = its.elements_of({1, widest});
    CHECK(faces.size() > 8 && faces.size() == begins[widest + 1] - begins[widest]);
    CHECK(faces.back().number + 1 == begins[widest + 1]);
    CHECK(its.elements_of({3, 4}).size() == 1 && its.elements_of({3, 4})[0].number == 4);
    CHECK(THROWN(its.elements_of({0, 0})).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    // A Voronoi vertex where the flow stands still.
    CHECK(its.closure({middle}).size() == 1 && its.closure({}).empty());
    const std::vector<medax::FlowElement> upstream = its.upstream({middle});
    CHECK(upstream.size() > 1 && upstream.front().kind == MEDAX_ELEMENT_VERTEX);
    CHECK(THROWN(its.upstream({middle, {3, 0}})).index() == 1);
    const auto sets = its.critical_sets({middle, faces.front(), faces.back()});
    CHECK(sets.size() == 3 && sets[0].size() > 16 && sets[1].size() >= 2);
    CHECK(sets[0].back() == flow.critical_row({3, middle.number}));
    CHECK(sets[1] == its.critical_sets({faces.front()})[0]);
    // More critical points than the first buffer holds.
    CHECK(sets[0] == its.critical_sets({middle})[0]);
    const medax::Complex complex = its.complex();
    CHECK(complex.faces().rows() < its.faces().rows() && !complex.faces().empty());
}

void flows(const medax::Dual &dual, const medax::Labels &labels,
           const std::vector<std::uint32_t> &axis) {
    const medax::Flow flow = medax::Flow::of(dual, labels);
    CHECK(flow.validate().is_valid());
    CHECK(flow.dual().centers().data() == dual.centers().data());
    CHECK(flow.labels().is_inner().data() == labels.is_inner().data());
    const std::size_t count = flow.critical_count(), samples = dual.triangulation().coords().rows();
    CHECK(flow.critical_simplices().rows() == count && flow.critical_points().cols() == 3);
    CHECK(flow.critical_distances().rows() == count && flow.critical_corners().cols() == 4);
    CHECK(flow.critical_slopes().rows() == count && flow.critical_shares().rows() == count);
    CHECK(flow.critical_complex().vertices().rows() == count - samples);
    const std::array<double, 2> gap = flow.gap();
    CHECK(gap[0] <= 0.5 && gap[1] > 0.5);
    std::size_t row = count;
    while (flow.critical_classes().data()[row - 1] != MEDAX_CRITICAL_CLASS_INNER) --row;
    const auto last = flow.critical_simplices()[--row];
    CHECK(last[0] == 3 && flow.critical_row({last[0], last[1]}) == row);
    CHECK(flow.critical_row({3, medax::none}) == medax::none);
    CHECK(flow.driver_of_cell(last[1]).dimension == 3);
    CHECK(flow.driver_of_triangle(0).dimension != 0);
    CHECK(flow.driver_of_triangle(static_cast<std::uint32_t>(flow.triangles().rows())).number
          == medax::none);
    const auto place = flow.critical_points()[row];
    const medax::Point middle = {place[0], place[1], place[2]};
    const std::vector<medax::Point> queries = {{1.02, 0, 0.01}, middle, {9, 9, 9}};
    const std::vector<medax::FlowPoint> at = flow.at(queries);
    CHECK(at.size() == 3 && at[0].distance > 0.3 && at[2].distance > 12 && flow.at({}).empty());
    CHECK(THROWN(flow.at({{0, 0, 0}, {0, NAN, 0}})).index() == 1);
    const medax::Orbits orbits = flow.orbits(queries);
    CHECK(orbits.ends.size() == 3 && orbits.ends[2] == medax::none);
    CHECK(flow.critical_classes().data()[orbits.ends[0]] == MEDAX_CRITICAL_CLASS_INNER);
    CHECK(orbits.complex.edges().rows() >= 2 && flow.orbits({}).complex.vertices().empty());

    const medax::Core core = flow.core();
    CHECK(core.complex.topology().betti[0] == 1 && core.complex.topology().betti[1] == 1);
    CHECK(core.complex.topology().betti[2] == 0 && core.report.taken == 0);
    medax::CoreOptions options;
    CHECK(options.side == MEDAX_SIDE_INNER && options.repair == 1);
    const medax::Core extended = flow.core(options, axis);
    CHECK(extended.report.taken > 0 && extended.complex.topology().betti[1] == 1);
    CHECK(extended.report.taken + extended.report.leaving == axis.size());
    options.side = 3;
    CHECK(THROWN(flow.core(options)).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    const medax::Complex closure = flow.closure({{last[0], last[1]}});
    CHECK(closure.vertices().rows() == 1 && flow.closure({}).vertices().empty());
    medax::FlowOptions wrong;
    wrong.least_slope = 1;
    CHECK(THROWN(medax::Flow::of(dual, labels, wrong)).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    flow_complexes(flow, {MEDAX_ELEMENT_VERTEX, last[1]});
}

void axes(const medax::Points &points, const medax::Dual &dual, const medax::Complex &surface) {
    const medax::Triangulation t = dual.triangulation();
    const medax::Labels labels = medax::Labels::of(dual, medax::PowerCrust::of(points));
    CHECK(labels.triangulation().cells().data() == t.cells().data());
    CHECK(labels.inner_count() > 0 && labels.inner_count() < labels.is_inner().rows());
    CHECK(labels.disagreement(medax::Labels::of(dual, surface)) < t.cells().rows() / 50);
    std::vector<std::uint8_t> flags(labels.is_inner().begin(), labels.is_inner().end());
    CHECK(medax::Labels::from(t, flags).disagreement(labels) == 0);
    flags.pop_back();
    CHECK(THROWN(medax::Labels::from(t, flags)).status() == MEDAX_STATUS_MISMATCH);

    const medax::Cocone cocone = medax::Cocone::of(dual);
    CHECK(cocone.validate().is_valid() && cocone.used_count() <= points.count());
    CHECK(cocone.surface().topology().boundary_loops == 0);
    CHECK(cocone.open_surface().faces().rows() > 0);
    CHECK(cocone.is_undersampled().rows() == points.count());
    CHECK(cocone.is_well_sampled().rows() == points.count());
    CHECK(cocone.marked_count() > 0 && cocone.marked_count() <= t.cells().rows());
    CHECK(medax::Labels::of(cocone).inner_count() > 0);
    CHECK(cocone.is_inner().rows() == labels.is_inner().rows());

    const medax::Job job;
    medax::MedialOptions with_scales;
    with_scales.scales = 1;
    const medax::Medial medial = medax::Medial::of(dual, labels, with_scales, job);
    CHECK(std::strcmp(job.times().at(0).stage, "medial") == 0 && medial.validate().is_valid());
    CHECK(medial.labels() && medial.labels()->is_inner().data() == labels.is_inner().data());
    CHECK(medial.dual().centers().data() == dual.centers().data());
    CHECK(medial.sines().rows() == dual.facets().rows() && medial.ratios().cols() == 2);
    CHECK(medial.reaches().rows() == dual.facets().rows());
    CHECK(medial.scales().rows() == t.cells().rows() && medial.least_cell()[0][0] == 0);
    CHECK(medial.umbrella_offsets().rows() == points.count() + 1);
    CHECK(medial.umbrella_rims().rows() == medial.umbrella_offsets()[points.count()][0]);
    CHECK(medial.umbrella_is_disk().rows() == points.count());
    CHECK(medial.torn_count() < points.count() / 10);
    medax::MedialFilter filter;
    CHECK(filter.rho == 8 && filter.side == MEDAX_SIDE_INNER);
    const std::vector<std::uint32_t> selected = medial.selected();
    CHECK(!selected.empty() && selected.back() < dual.facets().rows());
    const medax::Complex axis = medial.axis();
    CHECK(axis.faces().rows() <= selected.size() && axis.topology().components == 1);
    CHECK(axis.attribute(MEDAX_ELEMENT_FACE, "facet").u32_values.rows() == axis.faces().rows());
    filter.scale = 8;
    CHECK(medial.selected(filter).size() < selected.size());
    filter.theta = 2;
    CHECK(THROWN(medial.axis(filter)).status() == MEDAX_STATUS_INVALID_ARGUMENT);

    const medax::Medial bare = medax::Medial::of(dual);
    CHECK(!bare.labels() && bare.scales().empty());
    CHECK(THROWN(bare.axis()).status() == MEDAX_STATUS_INVALID_ARGUMENT);
    medax::MedialFilter both;
    both.side = MEDAX_SIDE_BOTH;
    CHECK(bare.selected(both).size() > selected.size());
    flows(dual, labels, selected);
    CHECK(surface.vertex_normals().size() == surface.vertices().rows());
}

void shapes() {
    CHECK(std::strcmp(medax::name(MEDAX_SHAPE_TORUS), "torus") == 0);
    CHECK(medax::describe(MEDAX_SHAPE_TORUS).genus == 1);
    medax::SampleOptions options;
    options.spacing = 0.15;
    const medax::Samples samples = medax::Samples::of(MEDAX_SHAPE_TORUS, options);
    CHECK(samples.spacing() == 0.15 && std::abs(samples.area() - 15.8) < 0.5);
    CHECK(samples.coords().rows() == samples.normals().rows());
    CHECK(samples.complex().attribute(MEDAX_ELEMENT_VERTEX, "normal").f64_values.cols() == 3);
    const medax::Points points = samples.points();
    const medax::Complex surface = medax::PowerCrust::of(points).surface();
    const medax::Topology topology = surface.topology();
    CHECK(topology.closed && topology.oriented && topology.has_genus && topology.genus == 1);
    CHECK(topology.betti[1] == 2 && topology.components == 1);
    CHECK(std::abs(surface.measure().volume - 3.158) < 0.3 && surface.validate().is_valid());
    CHECK(surface.oriented().measure().volume == surface.measure().volume);
    CHECK(surface.compare(samples.complex()).b_to_a_max < 0.1);
    medax::DecimateOptions fewer;
    fewer.triangles = surface.triangles().rows() / 4;
    const medax::Complex decimated = surface.decimate(fewer);
    CHECK(decimated.triangles().rows() <= surface.triangles().rows() / 4);
    CHECK(decimated.topology().genus == surface.topology().genus);
    CHECK(medax::Samples::of(surface, options).coords().rows() > 300);
    CHECK(THROWN(medax::Samples::of(samples.complex())).status() == MEDAX_STATUS_DEGENERATE);

    const medax::Triangulation t = medax::Triangulation::delaunay(points);
    medax::DualOptions with_facets;
    with_facets.facets = 1;
    const medax::Dual dual = medax::Dual::of(t, with_facets);
    CHECK(dual.validate().is_valid() && dual.triangulation().cells().data() == t.cells().data());
    CHECK(dual.centers().rows() == t.cells().rows() && !dual.ray_facets().empty());
    CHECK(dual.radii_squared().rows() == t.cells().rows());
    CHECK(dual.ray_directions().rows() == dual.ray_facets().rows());
    CHECK(dual.facets().rows() == dual.facet_edges().rows());
    CHECK(dual.facet_rays().rows() == dual.facet_edges().rows());
    const medax::Poles poles = medax::Poles::of(dual);
    CHECK(!poles.has_far_box() && poles.pole_of_sample().rows() == points.count());
    CHECK(THROWN(medax::PowerCrust::of(poles)).status() == MEDAX_STATUS_MISMATCH);
    axes(points, dual, surface);
}

void threads() {
    const medax::Triangulation t = medax::Triangulation::delaunay(medax::Points::from(cloud(500)));
    std::uint64_t sums[2] = {0, 0};
    const auto read = [](medax::Triangulation copy, std::uint64_t &sum) {
        for (const std::uint32_t v : copy.cells()) sum = sum * 31 + v;
    };
    std::thread other(read, t, std::ref(sums[0]));
    read(t, sums[1]);
    other.join();
    CHECK(sums[0] == sums[1]);
}

}  // namespace

int main() {
    errors();
    versions();
    references();
    triangulations();
    jobs();
    complexes();
    intersections();
    crusts();
    shapes();
    figures();
    distances();
    pairs();
    threads();
    std::printf("%u passed, %u failed\n", passed, failed);
    return failed == 0 ? 0 : 1;
}
