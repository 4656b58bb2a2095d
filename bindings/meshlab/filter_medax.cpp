// SPDX-License-Identifier: MIT OR Apache-2.0
#include "filter_medax.h"

#include "layers.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <stdexcept>

namespace {

using namespace medax_meshlab;

constexpr double pi = 3.14159265358979323846;

/// Tells MeshLab how far a filter is. It may give no callback.
Steps::Report report(vcg::CallBackPos *callback) {
    return [callback](int percent, const char *doing) {
        return callback == nullptr || callback(percent, doing);
    };
}

/// The order of the parameter `inside`.
Inside inside(const RichParameterList &parameters) {
    return static_cast<Inside>(parameters.getEnum("inside"));
}

/// The order of the parameter `side`.
std::uint32_t side(const RichParameterList &parameters) {
    switch (parameters.getEnum("side")) {
        case 0: return MEDAX_SIDE_INNER;
        case 1: return MEDAX_SIDE_OUTER;
        default: return MEDAX_SIDE_BOTH;
    }
}

medax::MedialFilter medial_filter(const RichParameterList &parameters) {
    medax::MedialFilter filter;
    const double theta = parameters.getFloat("theta");
    if (!(theta >= 0 && theta < 90))
        throw std::invalid_argument("The angle theta must be 0 or more and below 90 degrees.");
    // A product of what is next below 90 may be rounded up.
    filter.theta = std::min(theta * (pi / 180), std::nextafter(pi / 2, 0.0));
    filter.rho = parameters.getFloat("rho");
    return filter;
}

medax::PowerCrustOptions crust_options(const RichParameterList &parameters) {
    medax::PowerCrustOptions options;
    // The orders of the two enumerations are those of the parameters.
    options.label_rule = static_cast<std::uint32_t>(parameters.getEnum("labels"));
    options.omit = static_cast<std::uint32_t>(parameters.getEnum("omit"));
    options.lambda = parameters.getFloat("lambda");
    return options;
}

/// What a filter takes from the current layer, which must have something.
Input current(MeshDocument &document) {
    if (document.mm() == nullptr) throw std::invalid_argument("There is no current layer.");
    Input points = input(*document.mm());
    if (points.points.empty()) throw std::invalid_argument("The layer has no vertices.");
    return points;
}

void add_crust_parameters(RichParameterList &parameters) {
    parameters.addParam(RichEnum(
        "labels", 0, {"automatic", "spread", "least conflict"}, "Inside and outside",
        "How the balls of the poles are told inner from outer: by labels that spread from outside "
        "and are never taken back; by changing these until they contradict each other least, for "
        "noise and large gaps; or automatically by the latter where the former leaves much "
        "conflict."));
    parameters.addParam(RichEnum(
        "omit", 0, {"none", "for noise", "for sharp edges"}, "Leave out poles",
        "<i>For noise</i> leaves out poles that are nearer than the spacing of the points allows. "
        "<i>For sharp edges</i> leaves out both poles of a point where one is too near."));
    parameters.addParam(RichFloat(
        "lambda", 0, "Spacing (lambda)",
        "For leaving out poles: the spacing of the points relative to the local feature size, from "
        "0 to 0.78. 0: it is estimated."));
}

void add_inside_parameter(RichParameterList &parameters) {
    parameters.addParam(RichEnum(
        "inside", 0, {"Tight Cocone", "power crust", "faces of the layer"}, "Inside and outside",
        "What tells inside from outside: the watertight surface of Tight Cocone through the "
        "points, their power crust, or the faces of the layer, which must point out of the "
        "solid."));
}

void add_side_parameter(RichParameterList &parameters) {
    parameters.addParam(RichEnum("side", 0, {"inner", "outer", "both"}, "Side",
                                 "The side of the surface."));
}

void add_medial_parameters(RichParameterList &parameters) {
    parameters.addParam(RichFloat(
        "theta", 22.5f, "Angle condition, theta (degrees)",
        "A Voronoi facet is kept where its two points' connection makes more than this angle with "
        "the surface at one of them. A larger angle prunes more. From 0 to below 90."));
    parameters.addParam(RichFloat(
        "rho", 8, "Ratio condition, rho",
        "A Voronoi facet is kept, too, where its two points are more than so many times as far "
        "apart as the surface's triangles there are wide. A larger ratio prunes more."));
}

}  // namespace

FilterMedaxPlugin::FilterMedaxPlugin() {
    typeList << FP_SURFACE << FP_AXIS << FP_CORE << FP_THICKNESS;
    for (const FilterIDType filter : types()) actionList << new QAction(filterName(filter), this);
}

FilterMedaxPlugin::~FilterMedaxPlugin() { qDeleteAll(actionList); }

QString FilterMedaxPlugin::pluginName() const { return "FilterMedax"; }

QString FilterMedaxPlugin::filterName(FilterIDType filter) const {
    switch (filter) {
        case FP_SURFACE: return "medax: Surface from Points (Power Crust)";
        case FP_AXIS: return "medax: Medial Axis";
        case FP_CORE: return "medax: Core";
        case FP_THICKNESS: return "medax: Thickness";
        default: return "medax: Unknown Filter";
    }
}

QString FilterMedaxPlugin::filterInfo(FilterIDType filter) const {
    switch (filter) {
        case FP_SURFACE:
            return "Makes a closed surface from points, without normals: the <b>power crust</b> of "
                   "the layer's vertices. Its faces divide the balls of the inner from those of "
                   "the outer poles; the points are among its vertices.<br><br>See:<br>"
                   "<i>Nina Amenta, Sunghee Choi, Ravi Krishna Kolluri</i><br>"
                   "<b>\"The Power Crust\"</b><br>Solid Modeling and Applications, 2001<br>";
        case FP_AXIS:
            return "Finds the <b>medial axis</b> of the solid whose surface the layer's vertices "
                   "sample: the Voronoi facets that fulfil the angle or the ratio condition. The "
                   "radius of the inscribed ball becomes the vertex quality of the new "
                   "layer.<br><br>See:<br><i>Tamal K. Dey, Wulue Zhao</i><br>"
                   "<b>\"Approximating the Medial Axis from the Voronoi Diagram with a Convergence "
                   "Guarantee\"</b><br>Algorithmica, volume 38, 2004<br>";
        case FP_CORE:
            return "Finds the <b>core</b> of the solid whose surface the layer's vertices sample: "
                   "an axis that is connected as the solid is, made of what flows from the "
                   "critical points of the distance to the points. The radius of the inscribed "
                   "ball becomes the vertex quality. Loose edges come in a layer of their "
                   "own.<br><br>See:<br><i>Joachim Giesen, Edgar A. Ramos, Bardia Sadri</i><br>"
                   "<b>\"Medial Axis Approximation and Unstable Flow Complex\"</b><br>Symposium on "
                   "Computational Geometry, 2006<br>";
        case FP_THICKNESS:
            return "Measures how <b>thick</b> the solid is at each vertex: the diameter of the "
                   "largest ball in the solid that touches the surface there, by the inner poles of "
                   "a sample. It becomes the vertex quality of the layer, in its units. With the "
                   "feature size instead, the distance to the medial axis of both sides.<br><br>"
                   "See:<br><i>Nina Amenta, Marshall Bern</i><br>"
                   "<b>\"Surface Reconstruction by Voronoi Filtering\"</b><br>Discrete and "
                   "Computational Geometry, volume 22, 1999<br>";
        default: return "Unknown filter";
    }
}

MeshFilterInterface::FilterClass FilterMedaxPlugin::getClass(QAction *filter) {
    switch (ID(filter)) {
        case FP_SURFACE: return FilterClass(Remeshing + PointSet);
        case FP_THICKNESS: return FilterClass(Quality + Measure);
        default: return FilterClass(Remeshing + Quality);
    }
}

int FilterMedaxPlugin::getRequirements(QAction *filter) {
    return ID(filter) == FP_THICKNESS ? MeshModel::MM_VERTQUALITY : MeshModel::MM_NONE;
}

int FilterMedaxPlugin::postCondition(QAction *filter) const {
    // The others change no layer that is there.
    return ID(filter) == FP_THICKNESS ? MeshModel::MM_VERTQUALITY + MeshModel::MM_VERTCOLOR
                                      : MeshModel::MM_NONE;
}

MeshFilterInterface::FILTER_ARITY FilterMedaxPlugin::filterArity(QAction *) const {
    return SINGLE_MESH;
}

void FilterMedaxPlugin::initParameterSet(QAction *filter, MeshDocument &document,
                                         RichParameterList &parameters) {
    switch (ID(filter)) {
        case FP_SURFACE:
            add_crust_parameters(parameters);
            parameters.addParam(RichBool(
                "open", false, "Leave holes open",
                "Leave out the faces that close holes: those between an inner and an outer ball "
                "that intersect deeply."));
            parameters.addParam(RichBool(
                "shape", false, "Power shape, too",
                "Add the power shape of the inner poles, an approximation of the medial axis, with "
                "the radius as vertex quality."));
            break;
        case FP_AXIS:
            add_medial_parameters(parameters);
            parameters.addParam(RichFloat(
                "object", 0, "Least object angle (degrees)",
                "The directions from some point of a facet to its two nearest points must make at "
                "least this angle. From 0 to 180."));
            add_side_parameter(parameters);
            add_inside_parameter(parameters);
            break;
        case FP_CORE:
            add_side_parameter(parameters);
            add_inside_parameter(parameters);
            parameters.addParam(RichBool(
                "repair", true, "Repair",
                "Add as much flow to the inner core as it takes for it to be connected as the solid "
                "is, however sparse the points are."));
            parameters.addParam(RichBool(
                "extend", false, "Extend by the medial axis",
                "Extend the core by the flow of the Voronoi facets that the conditions below "
                "let pass, as far as that does not change how it is connected."));
            add_medial_parameters(parameters);
            break;
        case FP_THICKNESS: {
            // meshlabserver asks without any layer, too.
            const MeshModel *layer = document.mm();
            const float diagonal = layer == nullptr ? 0 : layer->cm.bbox.Diag();
            parameters.addParam(RichEnum("size", 0, {"thickness", "local feature size"}, "Measure",
                                         "What becomes the vertex quality."));
            parameters.addParam(RichBool(
                "faces", layer != nullptr && layer->cm.fn > 0, "Sample the faces",
                "Take the sample on the faces of the layer, which must point out of the solid and "
                "close it; else the vertices are the sample."));
            parameters.addParam(RichAbsPerc(
                "spacing", diagonal / 100, 0, diagonal, "Spacing of the sample",
                "How far apart samples on the faces are, at the least: near edges and in thin walls "
                "the measure is only as exact as this. 0: a hundredth of the diagonal."));
            add_crust_parameters(parameters);
            parameters.addParam(
                RichBool("colour", true, "Colour the vertices", "Colour the vertices by it."));
            break;
        }
        default: break;
    }
}

bool FilterMedaxPlugin::applyFilter(QAction *filter, MeshDocument &document,
                                    const RichParameterList &parameters,
                                    vcg::CallBackPos *callback) {
    errorMessage.clear();
    try {
        switch (ID(filter)) {
            case FP_SURFACE: surface(document, parameters, callback); break;
            case FP_AXIS: axis(document, parameters, callback); break;
            case FP_CORE: core(document, parameters, callback); break;
            case FP_THICKNESS: thickness(document, parameters, callback); break;
            default: throw std::invalid_argument("There is no such filter.");
        }
        return true;
    } catch (const medax::Error &error) {
        // medax speaks of rows, and of an option that there is not here.
        errorMessage = error.status() == MEDAX_STATUS_NON_FINITE
                           ? QString("Vertex %1 has a coordinate that is NaN or infinite: delete it.")
                                 .arg(error.index())
                           : QString::fromUtf8(error.what());
    } catch (const std::bad_alloc &) {
        errorMessage = "There is not enough memory.";
    } catch (const std::exception &error) {
        errorMessage = QString::fromUtf8(error.what());
    }
    // meshlabserver prints the log, and not the message.
    Log(GLLogStream::WARNING, "%s", qUtf8Printable(errorMessage));
    return false;
}

void FilterMedaxPlugin::surface(MeshDocument &document, const RichParameterList &parameters,
                                vcg::CallBackPos *callback) {
    const Input input = current(document);
    SurfaceOptions options;
    options.crust = crust_options(parameters);
    options.open = parameters.getBool("open");
    options.shape = parameters.getBool("shape");
    Steps steps(report(callback));
    const Surface made = medax_meshlab::surface(input, options, steps);
    if (made.surface.faces().empty())
        throw std::runtime_error("The power crust has no faces: the points bound no solid.");
    const MeshModel &source = *document.mm();
    if (made.shape) add_layers(document, source, "Power Shape", *made.shape, "radius");
    add_layers(document, source, "Power Crust", made.surface, nullptr);
    Log("Power crust of %i points: %i faces", static_cast<int>(input.points.size()),
        static_cast<int>(made.surface.faces().rows()));
}

void FilterMedaxPlugin::axis(MeshDocument &document, const RichParameterList &parameters,
                             vcg::CallBackPos *callback) {
    const Input input = current(document);
    AxisOptions options;
    options.filter = medial_filter(parameters);
    options.filter.side = side(parameters);
    options.filter.object_angle = std::min(parameters.getFloat("object") * (pi / 180), pi);
    options.inside = inside(parameters);
    Steps steps(report(callback));
    const medax::Complex axis = medax_meshlab::axis(input, options, steps);
    if (axis.faces().empty())
        throw std::runtime_error("No Voronoi facet passes: take a smaller theta or rho.");
    add_layers(document, *document.mm(), "Medial Axis", axis, "radius");
    Log("Medial axis of %i points: %i facets", static_cast<int>(input.points.size()),
        static_cast<int>(axis.faces().rows()));
}

void FilterMedaxPlugin::core(MeshDocument &document, const RichParameterList &parameters,
                             vcg::CallBackPos *callback) {
    const Input input = current(document);
    CoreOptions options;
    options.core.side = side(parameters);
    options.core.repair = parameters.getBool("repair") ? 1 : 0;
    options.inside = inside(parameters);
    if (parameters.getBool("extend")) {
        options.extend = medial_filter(parameters);
        options.extend->side = options.core.side;
    }
    Steps steps(report(callback));
    const medax::Core core = medax_meshlab::core(input, options, steps);
    if (add_layers(document, *document.mm(), "Core", core.complex, "radius") == 0)
        throw std::runtime_error("The core is empty: there is no critical point on this side.");
    Log("Core of %i points: %i faces, %i loose edges", static_cast<int>(input.points.size()),
        static_cast<int>(core.complex.faces().rows()),
        static_cast<int>(core.complex.edges().rows()));
    if (core.report.unbounded > 0 && options.core.side == MEDAX_SIDE_INNER)
        Log(GLLogStream::WARNING,
            "The inner core leaves the solid: the points are too sparse somewhere.");
}

void FilterMedaxPlugin::thickness(MeshDocument &document, const RichParameterList &parameters,
                                  vcg::CallBackPos *callback) {
    const Input input = current(document);
    SizesOptions options;
    options.crust = crust_options(parameters);
    options.faces = parameters.getBool("faces");
    options.spacing = parameters.getAbsPerc("spacing");
    Steps steps(report(callback));
    const medax::Sizes sizes = medax_meshlab::sizes(input, options, steps);
    const bool is_thickness = parameters.getEnum("size") == 0;
    const auto &values = is_thickness ? sizes.thickness : sizes.feature_size;
    const auto extremes = std::minmax_element(values.begin(), values.end());
    if (extremes.second == values.end() || !(*extremes.second > 0))
        throw std::runtime_error(options.faces
                                     ? "Every value is 0: the faces must close the solid and point out of it."
                                     : "Every value is 0: the points are too sparse.");
    set_quality(*document.mm(), values, parameters.getBool("colour"));
    Log("%s of %i vertices: from %f to %f", is_thickness ? "Thickness" : "Local feature size",
        static_cast<int>(values.size()), *extremes.first, *extremes.second);
}

MESHLAB_PLUGIN_NAME_EXPORTER(FilterMedaxPlugin)
