// Poles against exact circumcentres.
#pragma once

#include "subject.hpp"

#include <string>

// The cells with their vertices ascending, in order.
std::vector<reference::Cell> sorted(std::vector<reference::Cell> cells);

// What is wrong with the poles, or nothing.
std::string wrong_poles(const subject::Poles& medax);

inline reference::Point centre_of(const std::array<double, 4>& ball) { return {ball[0], ball[1], ball[2]}; }
