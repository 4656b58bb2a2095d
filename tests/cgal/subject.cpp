#include "subject.hpp"

#include <cstring>

namespace subject {
namespace {

// The rows of a view as arrays of their length.
template <std::size_t N, class T>
std::vector<std::array<T, N>> rows(const medax::View<T>& view) {
    std::vector<std::array<T, N>> result(view.rows());
    for (std::size_t i = 0; i < view.rows(); ++i)
        for (std::size_t j = 0; j < N; ++j) result[i][j] = view[i][j];
    return result;
}

template <class T>
std::vector<T> values(const medax::View<T>& view) {
    return {view.begin(), view.end()};
}

Triangulation copy(const medax::Points& points, const medax::Triangulation& built) {
    return {rows<3>(built.coords()),  rows<4>(built.cells()),         rows<4>(built.neighbors()),
            values(built.weights()),  values(built.hidden()),         values(points.vertex_of_row()),
            values(points.duplicate_of())};
}

Poles copy(const medax::Poles& poles) {
    const auto triangulation = poles.triangulation();
    Poles result;
    result.vertices = rows<3>(triangulation.coords());
    result.cells = rows<4>(triangulation.cells());
    result.balls = rows<4>(poles.balls());
    result.radii_squared = values(poles.radii_squared());
    result.cell_of_pole = values(poles.cell_of_pole());
    for (std::uint8_t touches : poles.touches_far_box()) result.touches_far_box.push_back(touches != 0);
    result.pole_of_sample = rows<2>(poles.pole_of_sample());
    result.normals = rows<3>(poles.normals());
    return result;
}

void finish(Crust& crust, const medax::PowerCrust& built) {
    const auto regular = built.regular();
    const auto surface = built.surface();
    crust.regular_cells = rows<4>(regular.cells());
    crust.pole_of_vertex = values(regular.row_of_vertex());
    for (std::uint32_t label : built.labels()) crust.inner.push_back(label == MEDAX_LABEL_INNER);
    crust.forced = built.forced_count();
    const auto inner = surface.attribute(MEDAX_ELEMENT_FACE, "inner_pole").u32_values;
    const auto outer = surface.attribute(MEDAX_ELEMENT_FACE, "outer_pole").u32_values;
    for (std::size_t face = 0; face < surface.faces().rows(); ++face)
        crust.facets.push_back({inner[face][0], outer[face][0]});
    crust.with_shards = {rows<3>(surface.vertices()), rows<3>(surface.triangles())};
}

}  // namespace

std::vector<Point> read(const std::string& path) {
    medax::PointsOptions options;
    options.skip_non_finite = 1;
    return rows<3>(medax::Points::read(path, options).coords());
}

std::vector<std::pair<std::string, std::vector<Point>>> shapes() {
    std::vector<std::pair<std::string, std::vector<Point>>> result;
    for (int shape = 0; shape <= MEDAX_SHAPE_SPHERE; ++shape) {
        const auto samples = medax::Samples::of(static_cast<medax_shape>(shape));
        result.emplace_back(medax::name(static_cast<medax_shape>(shape)), rows<3>(samples.coords()));
    }
    return result;
}

Triangulation delaunay(const std::vector<Point>& rows) {
    const auto points = medax::Points::from(rows);
    return copy(points, medax::Triangulation::delaunay(points));
}

Triangulation regular(const std::vector<Point>& rows, const std::vector<double>& weights) {
    const auto points = medax::Points::from(rows);
    return copy(points, medax::Triangulation::regular(points, weights));
}

Poles poles(const std::vector<Point>& samples) {
    const auto points = medax::Points::from(samples);
    return copy(medax::Poles::of(medax::Dual::of(medax::Triangulation::delaunay(points))));
}

Crust power_crust(const std::vector<Point>& samples, bool round_poles) {
    const auto poles = medax::Poles::with_far_box(medax::Points::from(samples));
    Crust crust;
    crust.poles = copy(poles);
    medax::PowerCrustOptions options;
    options.round_poles = round_poles;
    // Only the paper's rule is written a second time.
    options.label_rule = MEDAX_LABEL_RULE_SPREAD;
    try {
        const medax::Complex merged = medax::PowerCrust::of(poles, options).surface();
        crust.merged = {rows<3>(merged.vertices()), rows<3>(merged.triangles())};
        options.keep_shards = 1;
        finish(crust, medax::PowerCrust::of(poles, options));
    } catch (const medax::Error& error) {
        if (error.status() != MEDAX_STATUS_DEGENERATE && error.status() != MEDAX_STATUS_TOO_FEW_POINTS) throw;
        crust.solid = false;
    }
    return crust;
}

Axis medial(const std::vector<Point>& samples, double theta, double rho) {
    medax::JobOptions one_thread;
    one_thread.threads = 1;
    const auto seconds = [](const medax::Job& job, const char* stage) {
        double sum = 0;
        for (const auto& time : job.times())
            if (std::strcmp(time.stage, stage) == 0) sum += time.wall_seconds;
        return sum;
    };
    const auto points = medax::Points::from(samples);
    const medax::Job delaunay(one_thread), filtering(one_thread);
    const auto triangulation = medax::Triangulation::delaunay(points, {}, delaunay);
    medax::DualOptions with_facets;
    with_facets.facets = 1;
    const auto dual = medax::Dual::of(triangulation, with_facets);
    const auto medial = medax::Medial::of(dual, {}, filtering);
    medax::MedialFilter filter;
    filter.theta = theta;
    filter.rho = rho;
    filter.side = MEDAX_SIDE_BOTH;
    Axis axis;
    axis.vertices = rows<3>(triangulation.coords());
    axis.directions = rows<3>(medax::Poles::of(dual).normals());
    const auto edges = rows<2>(dual.facet_edges());
    for (std::uint32_t facet : medial.selected(filter)) axis.edges.push_back(edges[facet]);
    axis.delaunay_seconds = seconds(delaunay, "triangulate");
    axis.filter_seconds = seconds(filtering, "medial");
    return axis;
}

}  // namespace subject
