// The edges that MEDIAL selects, against the same algorithm written on CGAL; and how long either takes in one run.
#include "clouds.hpp"
#include "models.hpp"
#include "report.hpp"
#include "subject.hpp"

#include <algorithm>
#include <iterator>

namespace {

constexpr double theta = 0.39269908169872414, rho = 8;  // the paper's: pi / 8 and 8

void compare(const std::string& name, const std::vector<reference::Point>& rows, Report& report) {
    const subject::Axis medax = subject::medial(rows, theta, rho);
    const reference::Axis cgal = reference::medial(medax.vertices, medax.directions, theta, rho);
    std::vector<reference::Edge> differing, wrong;
    std::set_symmetric_difference(medax.edges.begin(), medax.edges.end(), cgal.edges.begin(), cgal.edges.end(),
                                  std::back_inserter(differing));
    std::set_difference(differing.begin(), differing.end(), cgal.near.begin(), cgal.near.end(), std::back_inserter(wrong));
    char text[200];
    std::snprintf(text, sizeof text, "%zu edges, %zu within 1e-9 of a threshold, %zu differ; CGAL %.3f + %.3f s, medax %.3f + %.3f s",
                  medax.edges.size(), cgal.near.size(), wrong.size(), cgal.delaunay_seconds, cgal.filter_seconds,
                  medax.delaunay_seconds, medax.filter_seconds);
    report.line(wrong.empty(), name, text);
}

}  // namespace

int main() {
    Report report;
    for (const Model& shape : shapes()) compare(shape.name, shape.points, report);
    for (const Model& model : models(50000)) compare(model.name, model.points, report);
    return report.finish("medial axes against CGAL");
}
