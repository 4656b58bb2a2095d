// medax against its peers on the same points: `peers [--count N] [--rounds R] [--threads T] [NAME or FILE]...`
//
// Each build is a process of its own; the libraries take turns, A B A B, so that what else the machine does hits
// both. The table gives the median CPU time, the median of the ratios within a round, cells a second, and
// the growth of the process at its peak. Where answers differ there is no ratio, and the program fails.
#include "builds.hpp"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <stdexcept>

namespace {

struct Peer {
    std::string name;
    std::function<Measured(const Workload&)> build;
};

// Runs the build in a process of its own; nothing if that failed.
std::optional<Measured> run(const Peer& peer, const Workload& workload) {
    int ends[2];
    if (pipe(ends) != 0) return std::nullopt;
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        int code = 1;
#ifdef __GLIBC__
        // What making the workload has left in the heap is no part of the build's peak.
        malloc_trim(0);
#endif
        try {
            const Measured measured = peer.build(workload);
            if (write(ends[1], &measured, sizeof measured) == static_cast<ssize_t>(sizeof measured)) code = 0;
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s, %s: %s\n", peer.name.c_str(), workload.name.c_str(), error.what());
        }
        std::fflush(stderr);
        _exit(code);
    }
    close(ends[1]);
    Measured measured;
    const bool whole = child > 0 && read(ends[0], &measured, sizeof measured) == static_cast<ssize_t>(sizeof measured);
    close(ends[0]);
    int status = 0;
    if (child > 0) waitpid(child, &status, 0);
    if (!whole || status != 0) return std::nullopt;
    return measured;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

// Measures a workload in so many rounds and prints a line for each peer; whether all answers agree.
bool compare(const Workload& workload, const std::vector<Peer>& peers, int rounds) {
    std::vector<std::vector<Measured>> found(peers.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t p = 0; p < peers.size(); ++p) {
            const auto measured = run(peers[p], workload);
            if (!measured) {
                std::printf("%s: %s failed\n", workload.name.c_str(), peers[p].name.c_str());
                return false;
            }
            found[p].push_back(*measured);
        }
    const Measured& first = found[0][0];
    bool agree = true;
    for (std::size_t p = 0; p < peers.size(); ++p) {
        const auto all = [&](auto value) {
            std::vector<double> values;
            for (const Measured& m : found[p]) values.push_back(value(m));
            return median(values);
        };
        const bool same = std::all_of(found[p].begin(), found[p].end(), [&](const Measured& m) {
            return m.cells == first.cells && m.hidden == first.hidden && m.fingerprint == first.fingerprint;
        });
        agree &= same;
        const double cpu = all([](const Measured& m) { return m.cpu_seconds; });
        std::vector<double> cpu_ratios, wall_ratios;
        for (int round = 0; round < rounds; ++round) {
            cpu_ratios.push_back(found[p][round].cpu_seconds / found[0][round].cpu_seconds);
            wall_ratios.push_back(found[p][round].wall_seconds / found[0][round].wall_seconds);
        }
        char ratios[64] = "the answers differ";
        if (same) std::snprintf(ratios, sizeof ratios, "%.3f | %.3f", median(cpu_ratios), median(wall_ratios));
        std::printf("| %s | %zu | %s | %.3f | %.3f | %s | %.2f | %.0f | %llu | %llu |\n", workload.name.c_str(),
                    workload.points.size(), peers[p].name.c_str(), cpu, all([](const Measured& m) { return m.wall_seconds; }),
                    ratios, static_cast<double>(found[p][0].cells) / cpu / 1e6,
                    all([](const Measured& m) { return static_cast<double>(m.peak_bytes); }) /
                        static_cast<double>(workload.points.size()),
                    static_cast<unsigned long long>(found[p][0].cells), static_cast<unsigned long long>(found[p][0].hidden));
        std::fflush(stdout);
    }
    return agree;
}

[[noreturn]] void refuse(const char* problem) {
    std::fprintf(stderr, "peers: %s\nusage: peers [--count N] [--rounds R] [--threads T] [NAME or FILE]...\nnames:", problem);
    for (const std::string& name : workload_names()) std::fprintf(stderr, " %s", name.c_str());
    std::fprintf(stderr, "\n");
    std::exit(2);
}

}  // namespace

int main(int argc, char** argv) {
#ifdef __GLIBC__
    // Large blocks go back to the system when they are freed, also after others were: so a peak is what a build needs, not
    // what the heap keeps of it, or had to spare from making the workload.
    mallopt(M_MMAP_THRESHOLD, 128 << 10);
#endif
    std::size_t count = 1000000;
    int rounds = 3;
    unsigned threads = 1;
    std::vector<std::string> names;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto number = [&]() -> unsigned long {
            const unsigned long value = i + 1 < argc ? std::strtoul(argv[++i], nullptr, 10) : 0;
            if (value == 0) refuse(("a positive number must follow " + argument).c_str());
            return value;
        };
        if (argument == "--count") count = number();
        else if (argument == "--rounds") rounds = static_cast<int>(number());
        else if (argument == "--threads") threads = static_cast<unsigned>(number());
        else if (argument.rfind("--", 0) == 0) refuse(("there is no option " + argument).c_str());
        else names.push_back(argument);
    }
    if (names.empty()) names = workload_names();

    std::vector<Peer> peers{{"CGAL", build_with_cgal},
                            {"medax", [](const Workload& w) { return build_with_medax(w, 1); }}};
    if (threads > 1) {
        const std::string many = ", " + std::to_string(threads) + " threads";
        peers.push_back({"medax" + many, [=](const Workload& w) { return build_with_medax(w, threads); }});
        if (has_parallel_cgal())
            peers.push_back({"CGAL" + many, [=](const Workload& w) { return build_with_parallel_cgal(w, threads); }});
    }
    std::printf("| workload | points | library | CPU s | wall s | x CGAL, CPU | x CGAL, wall | Mcells/s | peak B/point | cells | hidden |\n"
                "|---|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    bool agree = true;
    for (const std::string& name : names) {
        const auto& known = workload_names();
        const bool is_made = std::find(known.begin(), known.end(), name) != known.end();
        try {
            agree &= compare(is_made ? workload(name, count) : model(name), peers, rounds);
        } catch (const std::exception& error) {
            refuse((name + ": " + error.what()).c_str());
        }
    }
    return agree ? 0 : 1;
}
