// medax_cgal.hpp: points and meshes of several kernels in and out, and what does not fit a mesh.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/helpers.h>

#include <medax.hpp>
#include <medax_cgal.hpp>

#include "converters.hpp"

#include <cmath>
#include <list>

namespace {

using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Inexact::Point_3>;
using Vertex = Mesh::Vertex_index;
namespace PMP = CGAL::Polygon_mesh_processing;

template <class T>
T value(const Mesh &mesh, const char *name, Vertex v) {
    const auto [property, found] = mesh.property_map<Vertex, T>(name);
    CHECK(found);
    return property[v];
}

template <class Kernel>
void points_of() {
    using P = typename Kernel::Point_3;
    const std::vector<P> range = {P(0, 0, 0), P(3, 0, 0), P(0, 3, 0), P(0, 0, 3), P(3, 0, 0)};
    const medax::Points points = medax::cgal::points(range);
    CHECK(points.row_count() == 5 && points.count() == 4 && points.bounds().max[2] == 3);
    CHECK(medax::cgal::points(std::list<P>(range.begin(), range.end())).count() == 4);
    std::vector<std::pair<P, typename Kernel::Vector_3>> oriented;
    for (std::size_t i = 0; i < range.size(); ++i)
        oriented.emplace_back(range[i], typename Kernel::Vector_3(static_cast<double>(i), 0, 1));
    CHECK(medax::cgal::points(oriented).count() == 4);
    const auto normals = medax::by_vertex(points, medax::cgal::normals(oriented));
    CHECK(normals.size() == 4);
    for (std::size_t v = 0; v < 4; ++v) CHECK(normals[v][0] == points.row_of_vertex()[v][0]);
    bool refused = false;
    try {
        medax::by_vertex(points, std::vector<int>(4));
    } catch (const std::invalid_argument &) {
        refused = true;
    }
    CHECK(refused);
}

template <class Kernel>
void there_and_back() {
    using Any = CGAL::Surface_mesh<typename Kernel::Point_3>;
    const medax::Complex from = cube();
    auto mesh = medax::cgal::mesh<Any>(from);
    CHECK(mesh.number_of_faces() == 6 && mesh.number_of_vertices() == 8 && CGAL::is_closed(mesh));
    const medax::Complex back = medax::cgal::complex(mesh, {"radius"});
    CHECK(same(from, back) && back.attribute_count() == 1);
    CHECK(back.attribute(MEDAX_ELEMENT_VERTEX, "radius").f64_values[7][0] == 7.5);
    CHECK(medax::cgal::points(mesh).count() == 8 && medax::cgal::normals(mesh).empty());
    bool refused = false;
    try {
        medax::cgal::complex(mesh, {"radios"});
    } catch (const std::invalid_argument &error) {
        refused = std::string(error.what()).find("'v:radios'") != std::string::npos;
    }
    CHECK(refused);
    // Removed elements are passed over.
    CGAL::Euler::remove_center_vertex(mesh.halfedge(typename Any::Vertex_index(2)), mesh);
    CHECK(mesh.has_garbage());
    const medax::Complex less = medax::cgal::complex(mesh, {"radius"});
    CHECK(less.vertices().rows() == 7 && less.faces().rows() == 4);
    CHECK(less.attribute(MEDAX_ELEMENT_VERTEX, "radius").f64_values[2][0] == 3.5);
    CHECK(medax::cgal::complex(Any()).vertices().empty());
}

void results() {
    const medax::PowerCrust crust = medax::PowerCrust::of(torus());
    const medax::Complex surface = crust.surface();
    auto mesh = medax::cgal::mesh<Mesh>(surface);
    CHECK(mesh.number_of_faces() == surface.faces().rows() && CGAL::is_closed(mesh));
    CHECK(same(medax::cgal::complex(mesh), surface));
    auto normals = mesh.add_property_map<Vertex, Inexact::Vector_3>("v:normal").first;
    PMP::compute_vertex_normals(mesh, normals);
    const medax::Complex with_normals = medax::cgal::complex(mesh);
    const auto at = with_normals.attribute(MEDAX_ELEMENT_VERTEX, "normal").f64_values;
    CHECK(at.rows() == surface.vertices().rows() && at[5][1] == normals[Vertex(5)].y());
    CHECK(value<Inexact::Vector_3>(medax::cgal::mesh<Mesh>(with_normals), "v:normal", Vertex(5)) == normals[Vertex(5)]);
    PMP::triangulate_faces(mesh);
    CHECK(std::abs(PMP::volume(mesh) - surface.measure().volume) < 0.01 * PMP::volume(mesh));

    // An axis is not manifold: what fits of it, and all of it as a soup.
    const medax::Complex shape = crust.shape(MEDAX_LABEL_INNER);
    std::vector<std::uint32_t> left_out;
    const auto part = medax::cgal::mesh<Mesh>(shape, &left_out);
    CHECK(part.is_valid() && part.number_of_faces() > 0 && !left_out.empty());
    CHECK(part.number_of_faces() + left_out.size() == shape.faces().rows());
    CHECK(THROWN(medax::cgal::mesh<Mesh>(shape)).index() == left_out.front());
    const auto radius = shape.attribute(MEDAX_ELEMENT_VERTEX, "radius").f64_values;
    const auto pole = shape.attribute(MEDAX_ELEMENT_VERTEX, "pole").u32_values;
    CHECK(value<double>(part, "v:radius", Vertex(7)) == radius[7][0]);
    CHECK(value<std::uint32_t>(part, "v:pole", Vertex(7)) == pole[7][0]);
    auto soup = medax::soup<Inexact::Point_3>(shape);
    CHECK(soup.points.size() == shape.vertices().rows() && soup.polygons.size() == shape.faces().rows());
    CHECK(!PMP::is_polygon_soup_a_polygon_mesh(soup.polygons));
    PMP::orient_polygon_soup(soup.points, soup.polygons);
    CHECK(PMP::is_polygon_soup_a_polygon_mesh(soup.polygons) && soup.points.size() > shape.vertices().rows());

    // CGAL's regular triangulation of the polar balls has the vertices of medax's.
    const medax::Poles poles = crust.poles();
    const auto balls = medax::cgal::weighted_points<Inexact>(poles.balls(), poles.radii_squared());
    const CGAL::Regular_triangulation_3<Inexact> regular(balls.begin(), balls.end());
    const std::size_t seen = crust.regular().coords().rows() - crust.regular().hidden().rows();
    CHECK(regular.number_of_vertices() + 20 > seen && seen + 20 > regular.number_of_vertices());
}

void what_does_not_fit() {
    for (const Misfit &from : misfits()) {
        const medax::Complex complex = misfit(from);
        std::vector<std::uint32_t> left_out;
        const Mesh mesh = medax::cgal::mesh<Mesh>(complex, &left_out);
        CHECK(mesh.number_of_faces() == from.rings.size() - from.left_out.size() && mesh.is_valid());
        CHECK(left_out == from.left_out);
        const medax::Error error = THROWN(medax::cgal::mesh<Mesh>(complex));
        CHECK(error.kind() == MEDAX_ERROR_KIND_FACE && error.index() == from.left_out.front());
    }
}

}  // namespace

int main() {
    points_of<CGAL::Simple_cartesian<float>>();
    points_of<Inexact>();
    points_of<Exact>();
    there_and_back<Inexact>();
    there_and_back<Exact>();
    results();
    what_does_not_fit();
    std::printf("%u passed, %u failed\n", passed, failed);
    return failed == 0 ? 0 : 1;
}
