// Poles against exact circumcentres.
#pragma once

#include "subject.hpp"

#include <cstddef>
#include <string>

// The cells with their vertices ascending, in order.
std::vector<reference::Cell> sorted(std::vector<reference::Cell> cells);

// What is wrong with the poles, or nothing. `near_ties` receives the number of first poles that another
// Voronoi vertex beats by less than a double can tell.
std::string wrong_poles(const subject::Poles& medax, std::size_t& near_ties);

inline reference::Point centre_of(const std::array<double, 4>& ball) { return {ball[0], ball[1], ball[2]}; }
