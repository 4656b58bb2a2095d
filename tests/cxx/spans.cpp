// With C++20 every view is a std::span, without a word; the whole header compiles as C++20.
#include "check.hpp"

#include <numeric>
#include <ranges>
#include <span>
#include <utility>

namespace {

double sum(std::span<const double> values) { return std::accumulate(values.begin(), values.end(), 0.0); }
std::size_t count(std::span<const std::uint32_t> values) { return values.size(); }

}  // namespace

int main() {
    const std::vector<medax::Point> corners = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};
    const medax::Points points = medax::Points::from(corners);
    CHECK(sum(points.coords()) == 12 && sum(points.coords()[0]) <= 4);
    const std::span<const double> all = points.coords();
    CHECK(all.data() == points.coords().data() && all.size() == 12);
    const medax::Triangulation t = medax::Triangulation::delaunay(points);
    CHECK(count(t.cells()) == 4 && count(t.cells()[0]) == 4);
    const medax::Incidence incidence = medax::Incidence::of(t);
    CHECK(count(incidence.cells_of_vertex()[0]) == 1 && count(incidence.cells_of_vertex().offsets()) == 5);
    static_assert(std::ranges::contiguous_range<medax::View<double>>);
    static_assert(std::ranges::contiguous_range<medax::Span<std::uint32_t>>);
    // An object that was moved from has empty ones.
    medax::Triangulation from = t;
    const medax::Triangulation to = std::move(from);
    CHECK(count(from.cells()) == 0 && count(to.cells()) == 4);
    std::printf("%u passed, %u failed\n", passed, failed);
    return failed == 0 ? 0 : 1;
}
