// The sets on which the peers are measured: made here, the same on every machine.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

struct Workload {
    std::string name;
    std::vector<std::array<double, 3>> points;
    std::vector<double> weights;  // one a point, or none
};

// The names of all workloads that are made here.
const std::vector<std::string>& workload_names();

// A workload of about `count` points; of poles about `count` poles of half as many samples. Throws
// std::invalid_argument for a name that is none of the above.
Workload workload(const std::string& name, std::size_t count);

// The vertices of a model or scan, as medax reads it.
Workload model(const std::string& path);
