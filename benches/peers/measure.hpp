// Clocks, memory and fingerprints.
#pragma once

#include "builds.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>

// Runs from its making to `stop`.
class Meter {
public:
    Meter() : cpu(cpu_now()), wall(std::chrono::steady_clock::now()) {
        // Linux forgets the peak when told so: what follows is the build's own.
        if (std::FILE* file = std::fopen("/proc/self/clear_refs", "w")) {
            std::fputs("5", file);
            std::fclose(file);
        }
        before = status("VmRSS:");
        cpu = cpu_now();
        wall = std::chrono::steady_clock::now();
    }

    void stop(Measured& measured) const {
        measured.cpu_seconds = cpu_now() - cpu;
        measured.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
        const std::uint64_t peak = status("VmHWM:");
        measured.peak_bytes = peak > before ? peak - before : 0;
    }

private:
    static double cpu_now() {
        rusage usage;
        getrusage(RUSAGE_SELF, &usage);
        const auto seconds = [](timeval t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
        return seconds(usage.ru_utime) + seconds(usage.ru_stime);
    }

    static std::uint64_t status(const char* key) {
        std::uint64_t kib = 0;
        char line[256];
        if (std::FILE* file = std::fopen("/proc/self/status", "r")) {
            while (std::fgets(line, sizeof line, file))
                if (std::strncmp(line, key, std::strlen(key)) == 0) kib = std::strtoull(line + std::strlen(key), nullptr, 10);
            std::fclose(file);
        }
        return kib * 1024;
    }

    double cpu;
    std::chrono::steady_clock::time_point wall;
    std::uint64_t before = 0;
};

// The last step of SplitMix64.
inline std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

inline std::uint64_t fingerprint(double x, double y, double z) {
    std::uint64_t hash = 0;
    for (double value : {x, y, z}) {
        value += 0.0;  // -0 becomes 0
        std::uint64_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        hash = mix(hash + 0x9e3779b97f4a7c15u + bits);
    }
    return hash;
}

// Of a cell, whatever the order of its vertices; cells are added up, whatever their order.
inline std::uint64_t fingerprint(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
    return mix(a + b + c + d) ^ mix(mix(a) + mix(b) + mix(c) + mix(d));
}
