// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file
/// Layers of MeshLab in, layers out.

#include "operations.hpp"

#include <common/meshmodel.h>

#include <QString>

#include <cstddef>
#include <vector>

namespace medax_meshlab {

/// The vertices and faces of a layer that are not deleted, in their order.
Input input(const MeshModel &layer);

/// New layers of a complex, where the source is: one of its faces; one of its loose edges, since MeshLab shows those only of a
/// layer without faces; and one of its vertices that have neither. Vertices get the attribute as quality, and colours by it;
/// NULL for none. Returns the number of layers; the first has the label itself, and is the current one.
int add_layers(MeshDocument &document, const MeshModel &source, const QString &label,
               const medax::Complex &complex, const char *quality);

/// Sets the quality of a layer's vertices, one value for each that is not deleted.
void set_quality(MeshModel &layer, const std::vector<double> &values, bool colour);

}  // namespace medax_meshlab
