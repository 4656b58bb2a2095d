#include "clouds.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using reference::Point;
using Rows = std::vector<Point>;

// Only what the standard fixes to the bit: the engine's numbers, and arithmetic on them.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine(seed) {}
    double unit() { return std::ldexp(static_cast<double>(engine() >> 11), -53); }
    double between(double low, double high) { return low + (high - low) * unit(); }
    std::uint64_t below(std::uint64_t n) { return engine() % n; }
    Point in_cube() { return {unit(), unit(), unit()}; }
    Point on_sphere() {
        for (;;) {
            Point p{between(-1, 1), between(-1, 1), between(-1, 1)};
            double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            if (r > 0.1 && r <= 1) return {p[0] / r, p[1] / r, p[2] / r};
        }
    }

private:
    std::mt19937_64 engine;
};

void shuffle(Rows& rows, Random& random) {
    for (std::size_t i = rows.size(); i > 1; --i) std::swap(rows[i - 1], rows[random.below(i)]);
}

Rows map(Rows rows, double scale, Point shift) {
    for (Point& p : rows)
        for (int i = 0; i < 3; ++i) p[i] = p[i] * scale + shift[i];
    return rows;
}

Rows uniform(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    Rows rows;
    while (rows.size() < n) rows.push_back(random.in_cube());
    return rows;
}

Rows clustered(std::size_t clusters, std::size_t each, double size, std::uint64_t seed) {
    Random random(seed);
    Rows rows;
    for (std::size_t c = 0; c < clusters; ++c) {
        Point centre = random.in_cube();
        for (const Point& p : map(uniform(each, seed + c + 1), size, centre)) rows.push_back(p);
    }
    return rows;
}

// Not quite on the surface, since a double seldom is.
Rows sphere(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    Rows rows;
    while (rows.size() < n) rows.push_back(random.on_sphere());
    return rows;
}

Rows torus(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    Rows rows;
    while (rows.size() < n) {
        Point p = random.on_sphere(), q = random.on_sphere();
        double around = std::sqrt(p[0] * p[0] + p[1] * p[1]), across = std::sqrt(q[0] * q[0] + q[1] * q[1]);
        if (around < 0.1 || across < 0.1) continue;
        double ring = 1 + 0.4 * q[0] / across;
        rows.push_back({ring * p[0] / around, ring * p[1] / around, 0.4 * q[1] / across});
    }
    return rows;
}

Rows lattice(int side) {
    Rows rows;
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
            for (int z = 0; z < side; ++z) rows.push_back({double(x), double(y), double(z)});
    return rows;
}

// Every integer point at this squared distance from the origin: exactly cospherical.
Rows cospherical(int squared_radius) {
    Rows rows;
    int side = static_cast<int>(std::sqrt(squared_radius)) + 1;
    for (int x = -side; x <= side; ++x)
        for (int y = -side; y <= side; ++y)
            for (int z = -side; z <= side; ++z)
                if (x * x + y * y + z * z == squared_radius) rows.push_back({double(x), double(y), double(z)});
    return rows;
}

void add_box(Rows& rows, double half) {
    for (double x : {-half, half})
        for (double y : {-half, half})
            for (double z : {-half, half}) rows.push_back({x, y, z});
}

Rows coplanar_plus_box(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    Rows rows;
    while (rows.size() < n) rows.push_back({random.unit(), random.unit(), 0});
    add_box(rows, 10);
    return rows;
}

// A square grid in an oblique plane, whose every coordinate is exact.
Rows oblique_grid_plus_box(int side) {
    Rows rows;
    for (int u = 0; u < side; ++u)
        for (int v = 0; v < side; ++v) rows.push_back({double(u + v), double(u - v), double(2 * u + v)});
    add_box(rows, 4.0 * side);
    return rows;
}

Rows collinear_plus_box(int n) {
    Rows rows;
    for (int i = 0; i < n; ++i) rows.push_back({0.25 * i, 0.5 * i, 0.125 * i});
    add_box(rows, double(n));
    return rows;
}

Rows repeated(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    Rows rows;
    for (Point p : uniform(n, seed + 1)) {
        if (random.below(10) == 0) p[random.below(3)] = 0;
        for (std::uint64_t copies = 1 + random.below(3); copies > 0; --copies) {
            rows.push_back(p);
            for (double& x : p)
                if (x == 0) x = -x;
        }
    }
    shuffle(rows, random);
    return rows;
}

Rows one_ulp_apart(Rows base, std::uint64_t seed) {
    Random random(seed);
    Rows rows;
    for (const Point& p : base) {
        rows.push_back(p);
        for (int copies = 0; copies < 4; ++copies) {
            Point q = p;
            for (double& x : q)
                if (std::uint64_t way = random.below(3)) x = std::nextafter(x, way == 1 ? -INFINITY : INFINITY);
            rows.push_back(q);
        }
    }
    shuffle(rows, random);
    return rows;
}

// Nearly flat cells: lattice points moved by a few units in the last place.
Rows shaken_lattice(int side, std::uint64_t seed) {
    Random random(seed);
    Rows rows = map(lattice(side), 1, {1, 1, 1});
    for (Point& p : rows)
        for (double& x : p) x += (static_cast<double>(random.below(5)) - 2) * std::ldexp(1, -50);
    return rows;
}

// Points of a tiny lattice, most of them several times: nothing but ties.
Rows tiny(std::uint64_t seed) {
    Random random(seed);
    int side = 2 + static_cast<int>(random.below(3));
    Rows rows{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::uint64_t n = random.below(40); n > 0; --n)
        rows.push_back({double(random.below(side)), double(random.below(side)), double(random.below(side))});
    shuffle(rows, random);
    return rows;
}

std::vector<double> weights_of(const Rows& rows, std::uint64_t seed, double low, double high) {
    Random random(seed);
    std::vector<double> weights;
    for (std::size_t i = 0; i < rows.size(); ++i) weights.push_back(random.between(low, high));
    return weights;
}

// Weights that take `levels` values, `step` apart: ties of power everywhere.
std::vector<double> tied_weights_of(const Rows& rows, std::uint64_t seed, std::uint64_t levels, double step) {
    Random random(seed);
    std::vector<double> weights;
    for (std::size_t i = 0; i < rows.size(); ++i) weights.push_back(step * static_cast<double>(random.below(levels)));
    return weights;
}

// Each row the ball about a point that touches one of the sites: every site has power zero to
// several of them, as samples have to polar balls.
Cloud touching_balls(std::size_t n, const Rows& sites, std::uint64_t seed) {
    Cloud cloud{"balls through common points", uniform(n, seed), {}};
    for (const Point& p : cloud.rows) {
        double nearest = INFINITY;
        for (const Point& s : sites) {
            double x = p[0] - s[0], y = p[1] - s[1], z = p[2] - s[2];
            nearest = std::min(nearest, x * x + y * y + z * z);
        }
        cloud.weights.push_back(nearest);
    }
    return cloud;
}

}  // namespace

std::vector<Cloud> plain_clouds() {
    const Rows random = uniform(10000, 1);
    std::vector<Cloud> clouds{
        {"random", random, {}},
        {"clustered", clustered(50, 200, 1e-4, 2), {}},
        {"clusters in clusters", clustered(20, 200, 1e-9, 3), {}},
        {"sphere", sphere(10000, 4), {}},
        {"torus", torus(3000, 5), {}},
        {"lattice", lattice(20), {}},
        {"lattice in tenths", map(lattice(16), 0.1, {0, 0, 0}), {}},
        {"lattice shaken by ulps", shaken_lattice(12, 6), {}},
        {"cospherical", cospherical(11025), {}},
        {"coplanar plus box", coplanar_plus_box(5000, 7), {}},
        {"oblique grid plus box", oblique_grid_plus_box(60), {}},
        {"collinear plus box", collinear_plus_box(200), {}},
        {"repeated", repeated(3000, 8), {}},
        {"1 ulp apart", one_ulp_apart(uniform(1000, 9), 10), {}},
        {"lattice, 1 ulp apart", one_ulp_apart(map(lattice(8), 1, {1, 1, 1}), 11), {}},
        {"random far away", map(random, 1, {1e6, -2e6, 3e6}), {}},
        {"random very far away", map(random, 1, {1e14, 2e14, -3e14}), {}},
        {"cospherical far away", map(cospherical(11025), 1, {1e8, 1e8, 1e8}), {}},
    };
    for (double scale : {1e-9, 1e9}) {
        std::string at = scale < 1 ? " x 1e-9" : " x 1e9";
        clouds.push_back({"random" + at, map(random, scale, {0, 0, 0}), {}});
        clouds.push_back({"torus" + at, map(torus(1500, 12), scale, {0, 0, 0}), {}});
        clouds.push_back({"lattice" + at, map(lattice(12), scale, {0, 0, 0}), {}});
        clouds.push_back({"cospherical" + at, map(cospherical(2025), scale, {0, 0, 0}), {}});
    }
    for (std::uint64_t seed = 100; seed < 400; ++seed)
        clouds.push_back({"tiny " + std::to_string(seed), tiny(seed), {}});
    return clouds;
}

std::vector<Cloud> weighted_clouds() {
    const Rows random = uniform(5000, 21), grid = lattice(14), sphere_points = cospherical(11025);
    std::vector<Cloud> clouds{
        {"random, random weights", random, weights_of(random, 22, 0, 0.002)},
        {"random, negative weights", random, weights_of(random, 23, -0.01, 0)},
        {"random, most hidden", random, weights_of(random, 24, 0, 0.2)},
        {"random, tied weights", random, tied_weights_of(random, 25, 3, 0.001)},
        {"random, equal weights", random, std::vector<double>(random.size(), 0.5)},
        {"lattice, equal weights", grid, std::vector<double>(grid.size(), 2)},
        {"lattice, tied weights", grid, tied_weights_of(grid, 26, 3, 0.5)},
        {"lattice, many hidden", grid, tied_weights_of(grid, 27, 4, 2)},
        {"cospherical, tied weights", sphere_points, tied_weights_of(sphere_points, 28, 2, 1)},
        {"cospherical, random weights", sphere_points, weights_of(sphere_points, 29, -40, 40)},
        touching_balls(4000, uniform(60, 30), 31),
        touching_balls(4000, map(lattice(4), 0.25, {0, 0, 0}), 32),
    };
    clouds.back().name += " of a lattice";
    const Rows plane = coplanar_plus_box(2000, 33);
    clouds.push_back({"coplanar plus box, tied weights", plane, tied_weights_of(plane, 34, 3, 1e-4)});
    const Rows again = repeated(2000, 35);
    clouds.push_back({"repeated, random weights", again, weights_of(again, 36, 0, 0.003)});
    clouds.push_back({"repeated, tied weights", again, tied_weights_of(again, 37, 2, 0.002)});
    const Rows ulps = one_ulp_apart(uniform(500, 38), 39);
    clouds.push_back({"1 ulp apart, tied weights", ulps, tied_weights_of(ulps, 40, 2, 1e-17)});
    for (double scale : {1e-9, 1e9}) {
        std::string at = scale < 1 ? " x 1e-9" : " x 1e9";
        double square = scale * scale;
        Rows near = map(random, scale, {0, 0, 0}), even = map(grid, scale, {0, 0, 0});
        clouds.push_back({"random, random weights" + at, near, weights_of(near, 41, 0, 0.002 * square)});
        clouds.push_back({"lattice, tied weights" + at, even, tied_weights_of(even, 42, 3, 0.5 * square)});
    }
    const Rows clusters = clustered(20, 200, 1e-4, 44), ring = torus(3000, 45), ball = sphere(3000, 46);
    clouds.push_back({"clustered, random weights", clusters, weights_of(clusters, 47, 0, 1e-9)});
    clouds.push_back({"clustered, tied weights", clusters, tied_weights_of(clusters, 48, 3, 1e-10)});
    clouds.push_back({"torus, random weights", ring, weights_of(ring, 49, 0, 0.002)});
    clouds.push_back({"torus, tied weights", ring, tied_weights_of(ring, 50, 3, 0.001)});
    clouds.push_back({"sphere, random weights", ball, weights_of(ball, 51, -0.01, 0.01)});
    const Rows far = map(random, 1, {1e6, -2e6, 3e6}), very_far = map(random, 1, {1e14, 2e14, -3e14});
    clouds.push_back({"random very far away, random weights", very_far, weights_of(very_far, 52, 0, 0.002)});
    const Rows far_sphere = map(sphere_points, 1, {1e8, 1e8, 1e8});
    clouds.push_back({"cospherical far away, tied weights", far_sphere, tied_weights_of(far_sphere, 53, 3, 1)});
    clouds.push_back({"random far away, random weights", far, weights_of(far, 43, 0, 0.002)});
    for (std::uint64_t seed = 500; seed < 800; ++seed) {
        Rows rows = tiny(seed);
        std::vector<double> weights = tied_weights_of(rows, seed, 1 + seed % 4, 0.5);
        clouds.push_back({"tiny " + std::to_string(seed), std::move(rows), std::move(weights)});
    }
    return clouds;
}
