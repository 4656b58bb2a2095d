// The power crust's labels and facets, written anew from the paper (Amenta, Choi, Kolluri 2001,
// section 5.2 and Figure 8) on any regular triangulation: medax is compared with it.
#pragma once

#include "reference.hpp"

#include <cstddef>
#include <vector>

namespace reference {

struct Balls {
    std::vector<Point> centres;
    std::vector<double> radii;
    std::vector<Point> samples;
    std::vector<std::array<std::uint32_t, 2>> pole_of_sample;  // rows of balls, or none
    std::vector<bool> seed;                                    // touches a corner of the far box
    // What the regular triangulation is of: the centres, or what they were rounded to, and the weights.
    std::vector<Point> sites;
    std::vector<double> weights;
    std::vector<std::uint32_t> rank;  // of sites of one power the least counts
};

struct Crust {
    std::vector<bool> inner;                                      // one a ball
    std::vector<std::array<std::uint32_t, 2>> facets;             // (inner, outer), sorted
    std::size_t forced = 0;                                       // unbounded cells that would have been inner
};

// `regular` is the regular triangulation of the balls, `deep` the least -cos of the angle at which two
// balls meet deeply.
Crust power_crust(const Balls& balls, const Triangulation& regular, double deep);

}  // namespace reference
