#include "workloads.hpp"

#include <medax.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace {

using Point = std::array<double, 3>;
using Points = std::vector<Point>;

// Only what the standard fixes to the bit: the engine's numbers, and arithmetic on them. (Sines, cosines
// and logarithms may differ in the last bit between machines; both peers get the same points all the same.)
class Random {
public:
    double unit() { return std::ldexp(static_cast<double>(engine() >> 11), -53); }
    double between(double low, double high) { return low + (high - low) * unit(); }
    std::size_t below(std::size_t n) { return engine() % n; }
    double gauss() {
        const double r = std::sqrt(-2 * std::log(1 - unit()));
        return r * std::cos(2 * 3.14159265358979323846 * unit());
    }

private:
    std::mt19937_64 engine{1};
};

Points uniform(std::size_t count, Random& random) {
    Points points;
    while (points.size() < count) points.push_back({random.unit(), random.unit(), random.unit()});
    return points;
}

// Uniform by area on the ellipsoid with half axes 1, 0.7, 0.4; each point moved along the normal by a
// Gaussian amount with standard deviation `noise`.
Points ellipsoid(std::size_t count, double noise, Random& random) {
    const double a = 1, b = 0.7, c = 0.4;
    Points points;
    while (points.size() < count) {
        Point u{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const double r = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
        if (r > 1 || r < 0.1) continue;
        for (double& x : u) x /= r;
        // The area that a piece of the unit sphere gets, relative to the most that any gets.
        const Point n{u[0] / a, u[1] / b, u[2] / c};
        const double stretch = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        if (random.unit() * (1 / c) > stretch) continue;
        const double move = noise > 0 ? noise * random.gauss() / stretch : 0;
        points.push_back({a * u[0] + move * n[0], b * u[1] + move * n[1], c * u[2] + move * n[2]});
    }
    return points;
}

void shuffle(Points& points, Random& random) {
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
}

Points lattice(std::size_t count, Random& random) {
    const auto side = static_cast<int>(std::lround(std::cbrt(static_cast<double>(count))));
    Points points;
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
            for (int z = 0; z < side; ++z) points.push_back({double(x), double(y), double(z)});
    shuffle(points, random);
    return points;
}

// The two poles of every sample, one weighted point for each Voronoi vertex that is chosen; as the power crust
// takes them, rounded to its grid or not.
Workload poles(const Points& samples, bool rounded, Random& random) {
    medax::PowerCrustOptions options;
    options.round_poles = rounded;
    const auto built = medax::PowerCrust::of(medax::Points::from(samples), options).regular();
    std::vector<std::size_t> order(built.coords().rows());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    Workload result;
    for (std::size_t pole : order) {
        const auto center = built.coords()[pole];
        result.points.push_back({center[0], center[1], center[2]});
        result.weights.push_back(built.weights()[pole][0]);
    }
    return result;
}

}  // namespace

const std::vector<std::string>& workload_names() {
    static const std::vector<std::string> names{"uniform", "ellipsoid",     "ellipsoid_noise", "lattice",            "weighted",
                                                "poles",   "poles_rounded", "poles_noise",     "poles_noise_rounded"};
    return names;
}

Workload workload(const std::string& name, std::size_t count) {
    Random random;
    Workload result;
    if (name == "uniform") {
        result.points = uniform(count, random);
    } else if (name == "ellipsoid") {
        result.points = ellipsoid(count, 0, random);
    } else if (name == "ellipsoid_noise") {
        result.points = ellipsoid(count, 0.005, random);
    } else if (name == "lattice") {
        result.points = lattice(count, random);
    } else if (name == "weighted") {
        result.points = uniform(count, random);
        // Up to the square of the mean spacing.
        const double most = std::pow(static_cast<double>(count), -2.0 / 3);
        for (std::size_t i = 0; i < count; ++i) result.weights.push_back(most * random.unit());
    } else if (name == "poles" || name == "poles_rounded") {
        result = poles(ellipsoid(count / 2, 0, random), name == "poles_rounded", random);
    } else if (name == "poles_noise" || name == "poles_noise_rounded") {
        result = poles(ellipsoid(count / 2, 0.005, random), name == "poles_noise_rounded", random);
    } else {
        throw std::invalid_argument("there is no workload '" + name + "'");
    }
    result.name = name;
    return result;
}

Workload model(const std::string& path) {
    medax::PointsOptions options;
    options.skip_non_finite = 1;
    const auto points = medax::Points::read(path, options);
    Workload result{path.substr(path.find_last_of('/') + 1), {}, {}};
    for (std::size_t i = 0; i < points.coords().rows(); ++i) {
        const auto p = points.coords()[i];
        result.points.push_back({p[0], p[1], p[2]});
    }
    Random random;
    shuffle(result.points, random);
    return result;
}
