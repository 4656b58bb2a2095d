// SPDX-License-Identifier: MIT OR Apache-2.0
#pragma once

/// \file medax.hpp
/// medax for C++17: the C ABI of medax.h with destructors and exceptions. Header only; this one
/// includes those of all structures.
///
/// - Every class holds one counted reference to an immutable handle. Copies share it, and any
///   thread may use any of them. An object that was moved from holds none: it has no rows.
/// - What fails throws medax::Error, or what the progress function threw.
/// - Views borrow: they are valid while an object that shares the handle lives.
/// - medax_openmesh.hpp and medax_cgal.hpp, beside this one, bring meshes of OpenMesh and CGAL in and out.
/// - Units, lengths, costs and errors of each function are in medax.h, under the same name.

#include <medax/error.hpp>
#include <medax/view.hpp>
#include <medax/job.hpp>
#include <medax/points.hpp>
#include <medax/complex.hpp>
#include <medax/file.hpp>
#include <medax/figure.hpp>
#include <medax/triangulation.hpp>
#include <medax/dual.hpp>
#include <medax/poles.hpp>
#include <medax/crust.hpp>
#include <medax/cocone.hpp>
#include <medax/labels.hpp>
#include <medax/medial.hpp>
#include <medax/flow.hpp>
#include <medax/flow_complex.hpp>
#include <medax/pair.hpp>
#include <medax/distance.hpp>
#include <medax/balls.hpp>
#include <medax/sample.hpp>
#include <medax/convert.hpp>
