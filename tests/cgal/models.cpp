#include "models.hpp"

#include "subject.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

namespace fs = std::filesystem;

std::vector<Model> shapes() {
    std::vector<Model> result;
    for (auto& [name, points] : subject::shapes()) result.push_back({name, std::move(points)});
    return result;
}

std::vector<Model> models(std::size_t limit) {
    const fs::path directory = MEDAX_DATA_DIR;
    std::vector<Model> result;
    if (!fs::is_directory(directory)) {
        std::printf("skipped: the real models, since there is no %s\n", directory.c_str());
        return result;
    }
    const std::set<std::string> endings{".obj", ".off", ".ply", ".pts", ".xyz"};
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(directory))
        if (endings.count(entry.path().extension().string()) != 0) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) {
        Model model{path.filename().string(), subject::read(path.string())};
        if (model.points.size() <= limit)
            result.push_back(std::move(model));
        else
            std::printf("left out: %s, %zu points\n", model.name.c_str(), model.points.size());
    }
    return result;
}
