// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// What the filters calculate, without MeshLab.

#include "steps.hpp"

#include <medax.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace medax_meshlab {

/// What a filter takes from a layer.
struct Input {
    std::vector<medax::Point> points;
    /// Three points a triangle.
    std::vector<std::uint32_t> corners;
};

/// What tells inside from outside.
enum class Inside { cocone, crust, mesh };

struct SurfaceOptions {
    medax::PowerCrustOptions crust;
    /// Leave out what closes holes.
    bool open = false;
    /// Make the power shape too.
    bool shape = false;
};

struct Surface {
    medax::Complex surface;
    std::optional<medax::Complex> shape;
};

struct AxisOptions {
    medax::MedialFilter filter;
    Inside inside = Inside::cocone;
    /// Clip both the outer axis and that of both sides to the box of the points, grown by this share of its diagonal.
    double margin = 0.1;
};

struct CoreOptions {
    medax::CoreOptions core;
    Inside inside = Inside::cocone;
    /// Extend it by the facets that pass this filter.
    std::optional<medax::MedialFilter> extend;
};

struct SizesOptions {
    medax::PowerCrustOptions crust;
    /// Sample the faces; else the vertices are the sample.
    bool faces = false;
    double spacing = 0;
};

Surface surface(const Input &input, const SurfaceOptions &options, Steps &steps);
/// The axis; \p input needs faces if they tell inside from outside.
medax::Complex axis(const Input &input, AxisOptions options, Steps &steps);
medax::Core core(const Input &input, const CoreOptions &options, Steps &steps);
/// Feature size and thickness at the points of \p input.
medax::Sizes sizes(const Input &input, const SizesOptions &options, Steps &steps);

}  // namespace medax_meshlab
