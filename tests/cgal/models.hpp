// Samples of shapes, and the real models beside the project where they are there.
#pragma once

#include "reference.hpp"

#include <string>
#include <vector>

struct Model {
    std::string name;
    std::vector<reference::Point> points;  // distinct
};

// Samples of medax's built-in shapes.
std::vector<Model> shapes();

// What medax reads of the files in ../shared/data: those of at most `limit` points, by name. None, and
// a line that says so, where the directory is absent.
std::vector<Model> models(std::size_t limit);
