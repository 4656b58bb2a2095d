// One build by each library, measured, with a fingerprint of its answer.
#pragma once

#include "workloads.hpp"

#include <cstdint>

// What one build took and gave. Plain, so that it passes through a pipe.
struct Measured {
    double cpu_seconds = 0, wall_seconds = 0;
    std::uint64_t peak_bytes = 0;  // growth of the process, input excluded
    std::uint64_t cells = 0, hidden = 0;
    std::uint64_t fingerprint = 0;  // of the finite cells as sets of points; equal for equal sets
};

Measured build_with_cgal(const Workload& workload);
// With threads: CGAL's concurrent insertion, for machines that have TBB.
bool has_parallel_cgal();
Measured build_with_parallel_cgal(const Workload& workload, unsigned threads);
Measured build_with_medax(const Workload& workload, unsigned threads);
