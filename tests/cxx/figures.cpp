// Plane figures in C++.
#include "check.hpp"

#include <cmath>
#include <cstring>
#include <fstream>

void figures() {
    medax::FigureParts parts;
    parts.polygons = {{{{0, 0}, {0, 9}, {9, 9}, {9, 0}, {0, 0}}, {{3, 3}, {5, 3}, {5, 5}}},
                      {{{20, 0}, {21, 0}, {20, 1}}}};
    parts.polylines = {{{30, 0}, {31, 0}, {31, 1}}};
    parts.points = {{4, 4}};
    parts.circles = {{50, 50, 2}};
    const medax::Figure figure = medax::Figure::from(parts);
    CHECK(figure.validate().is_valid() && figure.part_count() == 5);
    CHECK(figure.vertices().rows() == 14 && figure.vertices().cols() == 2);
    CHECK(figure.vertices()[1][0] == 9 && figure.vertices()[1][1] == 0);
    CHECK(figure.chains().rows() == 5 && figure.chains()[1].size() == 3);
    CHECK(figure.kinds()[1][0] == MEDAX_CHAIN_KIND_HOLE);
    CHECK(figure.kinds()[3][0] == MEDAX_CHAIN_KIND_POLYLINE);
    CHECK(figure.parts_of_chains()[2][0] == 1 && figure.parts_of_chains()[4][0] == 3);
    CHECK(figure.circles().rows() == 1 && figure.circles()[0][2] == 2);
    CHECK(figure.bounds()[0][0] == 0 && std::fabs(figure.bounds()[1][1] - 52) < 1e-9);
    CHECK(figure.normalised().turned_rings == 2 && figure.normalised().closing_vertices == 1);

    parts.points = {{std::nan(""), 0}};
    const medax::Error row = THROWN(medax::Figure::from(parts));
    CHECK(row.status() == MEDAX_STATUS_NON_FINITE && row.kind() == MEDAX_ERROR_KIND_ROW);
    parts = {};
    CHECK(THROWN(medax::Figure::from(parts)).status() == MEDAX_STATUS_TOO_FEW_POINTS);
    parts.polygons = {{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}};
    const medax::Error bow = THROWN(medax::Figure::from(parts));
    CHECK(bow.kind() == MEDAX_ERROR_KIND_RING && std::strstr(bow.what(), "(2, 2)") != nullptr);
    CHECK(medax::Figure::from(parts, MEDAX_CROSSINGS_ACCEPT).normalised().crossings == 1);

    const char *path = "cxx_figure.geojson";
    std::ofstream(path) << R"({"type":"FeatureCollection","features":[
        {"type":"Feature","properties":{"name":"a"},"geometry":{"type":"Point","coordinates":[1,2]}},
        {"type":"Feature","properties":{"name":"b"},"geometry":{"type":"Point","coordinates":[3,4]}}]})";
    CHECK(medax::Figure::read(path).part_count() == 2);
    const medax::Figure b = medax::Figure::read(path, medax::FigureReadOptions::named("b"));
    CHECK(b.vertices().rows() == 1 && b.vertices()[0][0] == 3);
    CHECK(THROWN(medax::Figure::read("no.geojson")).status() == MEDAX_STATUS_IO);
    std::remove(path);
}
