// Nearest points of meshes against CGAL's AABB tree, on the same queries: `nearest [--count N] [--rounds R] FILE...`
//
// One thread each, in turns, A B A B. Queries are of two kinds: in the mesh's box, grown by half on each side; and beside its vertices, no
// farther than a hundredth of its diagonal. Trees are built once and timed apart. Where distances differ by more than rounding the program fails.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <medax.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>>>;

template <class Run>
double seconds(Run run) {
    const auto begun = std::chrono::steady_clock::now();
    run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// The faces as fans, as medax has them.
Triangles triangles_of(const medax::Complex& mesh) {
    const auto at = [&](std::uint32_t v) {
        const auto p = mesh.vertices()[v];
        return Kernel::Point_3(p[0], p[1], p[2]);
    };
    const auto faces = mesh.faces();
    Triangles triangles;
    for (std::size_t face = 0; face < faces.rows(); ++face)
        for (std::size_t i = 2; i < faces[face].size(); ++i) {
            const Kernel::Triangle_3 triangle(at(faces[face][0]), at(faces[face][i - 1]), at(faces[face][i]));
            if (!triangle.is_degenerate()) triangles.push_back(triangle);
        }
    return triangles;
}

std::vector<medax::Point> in_box(const medax::Sites& sites, std::size_t count) {
    const auto [min, max] = sites.bounds();
    std::mt19937_64 random(1);
    std::vector<medax::Point> queries(count);
    for (auto& query : queries)
        for (int k = 0; k < 3; ++k) {
            const double half = 0.5 * (max[k] - min[k]);
            query[k] = std::uniform_real_distribution<>(min[k] - half, max[k] + half)(random);
        }
    return queries;
}

std::vector<medax::Point> beside(const medax::Sites& sites, const medax::Complex& mesh, std::size_t count) {
    std::mt19937_64 random(2);
    const double most = 0.01 * sites.size() / std::sqrt(3.0);
    std::uniform_real_distribution<> off(-most, most);
    std::uniform_int_distribution<std::size_t> vertex(0, mesh.vertices().rows() - 1);
    std::vector<medax::Point> queries(count);
    for (auto& query : queries) {
        const auto p = mesh.vertices()[vertex(random)];
        query = {p[0] + off(random), p[1] + off(random), p[2] + off(random)};
    }
    return queries;
}

// Prints a line; whether the distances agree.
bool compare(const std::string& name, const char* kind, const medax::Sites& sites, const Tree& tree, double build_ratio,
             const std::vector<medax::Point>& queries, int rounds) {
    medax::JobOptions alone;
    alone.threads = 1;
    std::vector<double> ours, theirs, ratios, distances(queries.size());
    std::vector<medax::Nearest> nearest;
    double worst = 0;
    for (int round = 0; round < rounds; ++round) {
        theirs.push_back(seconds([&] {
            for (std::size_t i = 0; i < queries.size(); ++i) {
                const Kernel::Point_3 query(queries[i][0], queries[i][1], queries[i][2]);
                const auto found = tree.closest_point_and_primitive(query);
                distances[i] = std::sqrt(CGAL::squared_distance(query, found.first));
            }
        }));
        ours.push_back(seconds([&] { nearest = sites.nearest(queries, medax::Job(alone)); }));
        ratios.push_back(theirs.back() / ours.back());
    }
    for (std::size_t i = 0; i < queries.size(); ++i)
        worst = std::max(worst, std::abs(nearest[i].distance - distances[i]) / sites.size());
    const double count = static_cast<double>(queries.size());
    std::printf("| %s | %zu | %s | %.1f | %.1f | %.2f | %.2f | %.0e |\n", name.c_str(), sites.piece_count(), kind, count / median(theirs) / 1e3,
                count / median(ours) / 1e3, median(ratios), build_ratio, worst);
    std::fflush(stdout);
    return worst <= 1e-12;
}

}  // namespace

int main(int argc, char** argv) {
    std::size_t count = 200000;
    int rounds = 5;
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if ((argument == "--count" || argument == "--rounds") && i + 1 < argc && std::atol(argv[i + 1]) > 0) {
            (argument == "--count" ? count = std::strtoul(argv[i + 1], nullptr, 10) : rounds = std::atoi(argv[i + 1]));
            ++i;
        } else if (argument.rfind("--", 0) != 0) {
            files.push_back(argument);
        } else {
            files.clear();
            break;
        }
    }
    if (files.empty()) {
        std::fprintf(stderr, "usage: nearest [--count N] [--rounds R] FILE...\n");
        return 2;
    }
    std::printf("| mesh | triangles | queries | CGAL, thousands a second | medax, thousands a second | times as fast | tree built, times as fast | largest difference |\n"
                "|---|--:|---|--:|--:|--:|--:|--:|\n");
    bool agree = true;
    for (const std::string& file : files) try {
            const medax::Complex mesh = medax::Complex::read(file);
            Triangles triangles = triangles_of(mesh);
            medax::JobOptions alone;
            alone.threads = 1;
            medax::Sites sites = medax::Sites::of(mesh, {}, medax::Job(alone));
            const double our_build = seconds([&] { sites = medax::Sites::of(mesh, {}, medax::Job(alone)); });
            Tree tree;
            const double their_build = seconds([&] {
                tree.insert(triangles.begin(), triangles.end());
                tree.build();
                tree.accelerate_distance_queries();
            });
            const std::string name = file.substr(file.find_last_of('/') + 1);
            for (const auto& [kind, queries] : {std::pair("in the box", in_box(sites, count)), std::pair("beside it", beside(sites, mesh, count))})
                agree &= compare(name, kind, sites, tree, their_build / our_build, queries, rounds);
        } catch (const std::exception& error) {
            std::fprintf(stderr, "nearest: %s: %s\n", file.c_str(), error.what());
            return 2;
        }
    return agree ? 0 : 1;
}
