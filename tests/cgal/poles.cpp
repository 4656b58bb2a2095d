// The poles of a sample alone, at infinity on its hull.
#include "poles.hpp"

#include "clouds.hpp"
#include "models.hpp"
#include "report.hpp"

namespace {

void compare(const std::string& name, const std::vector<reference::Point>& rows, Report& report) {
    const subject::Poles medax = subject::poles(rows);
    std::size_t at_infinity = 0;
    const std::string wrong = wrong_poles(medax);
    for (const auto& [first, second] : medax.pole_of_sample) at_infinity += first == reference::none;
    std::string text = std::to_string(medax.pole_of_sample.size()) + " samples, " + std::to_string(medax.balls.size()) +
                       " poles, " + std::to_string(at_infinity) + " at infinity";
    report.line(wrong.empty(), name, wrong.empty() ? text : text + ": " + wrong);
}

}  // namespace

int main() {
    Report report;
    for (const Cloud& cloud : plain_clouds()) compare(cloud.name, cloud.rows, report);
    for (const Model& shape : shapes()) compare(shape.name, shape.points, report);
    for (const Model& model : models(50000)) compare(model.name, model.points, report);
    return report.finish("poles of exact Voronoi vertices");
}
