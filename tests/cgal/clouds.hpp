// The sets on which medax is compared: made here, the same on every machine.
#pragma once

#include "reference.hpp"

#include <string>
#include <vector>

struct Cloud {
    std::string name;
    std::vector<reference::Point> rows;  // may repeat a position
    std::vector<double> weights;         // one a row, or none
};

// Random, clustered, on surfaces, on lattices, cospherical, coplanar within a box, repeated, 1 ulp
// apart, at scales 1e-9 and 1e9, far from the origin; many small sets full of ties.
std::vector<Cloud> plain_clouds();

// The same kinds of set with weights: random, tied, equal, negative, such that most points hide, and
// different ones at one position.
std::vector<Cloud> weighted_clouds();
