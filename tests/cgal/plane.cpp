// The medial graphs of letters and countries against CGAL's Voronoi diagram of segments, both ways; and how long either takes in one run.
#include "reference.hpp"
#include "report.hpp"

#include <medax.hpp>

#include <chrono>
#include <filesystem>

namespace fs = std::filesystem;

namespace {

reference::PlanePoint place(const double* xyz) { return {xyz[0], xyz[1]}; }

reference::Polylines lines_of(const medax::MedialGraph& graph) {
    const auto points = graph.points();
    const auto arcs = graph.arcs();
    reference::Polylines lines;
    for (std::size_t arc = 0; arc < arcs.rows(); ++arc) {
        lines.emplace_back();
        for (const std::uint32_t point : arcs[arc]) lines.back().push_back({points[point][0], points[point][1]});
    }
    return lines;
}

void compare(const std::string& name, const medax::Figure& figure, Report& report) {
    const medax::Sites sites = medax::Sites::of(figure);
    std::vector<reference::PlaneSegment> segments;
    for (const medax::Piece& piece : sites.pieces()) segments.push_back({place(piece.numbers), place(piece.numbers + 3)});
    medax::MedialGraphOptions options;
    options.spacing = 1e-3 * sites.size();
    const auto begun = std::chrono::steady_clock::now();
    const medax::MedialGraph graph = medax::MedialGraph::of(sites, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const reference::Polylines ours = lines_of(graph);
    const reference::PlaneAxis axis = reference::plane_axis(segments, options.spacing / 8);
    const reference::Distance to = reference::distance(ours, axis.lines), from = reference::distance(axis.lines, ours);
    // Parts of arcs bulge by a fiftieth of their longest length.
    const double most = options.spacing / 25;
    char text[200];
    std::snprintf(text, sizeof text, "%zu arcs; in units of the size max %.1e and %.1e, mean %.1e and %.1e; CGAL %.3f s, medax %.3f s", ours.size(),
                  to.max / sites.size(), from.max / sites.size(), to.mean / sites.size(), from.mean / sites.size(), axis.seconds, seconds);
    report.line(graph.torn() == 0 && to.max <= most && from.max <= most, name, text);
}

// An L with a hole, for where the real figures are not there.
medax::Figure corner() {
    medax::FigureParts parts;
    parts.polygons = {{{{0, 0}, {4, 0}, {4, 1.5}, {1.5, 1.7}, {1.2, 3}, {0, 3.1}}, {{0.4, 0.4}, {0.9, 0.5}, {0.6, 1.1}}}};
    return medax::Figure::from(parts);
}

}  // namespace

int main() {
    Report report;
    compare("a corner with a hole", corner(), report);
    const fs::path directory = MEDAX_DATA_DIR;
    const std::vector<std::pair<const char*, std::vector<const char*>>> files = {
        {"letters.geojson", {"B", "g", "i", "S", "O", "&", "8", "Y"}},
        {"countries.geojson", {"Norway", "South Africa", "Italy", "Croatia"}},
    };
    for (const auto& [file, features] : files) {
        const fs::path path = directory / file;
        if (!fs::exists(path)) {
            std::printf("skipped: there is no %s\n", path.c_str());
            continue;
        }
        for (const char* feature : features) {
            const auto options = medax::FigureReadOptions::named(feature);
            compare(feature, medax::Figure::read(path.string(), options), report);
        }
    }
    return report.finish("medial graphs against CGAL");
}
