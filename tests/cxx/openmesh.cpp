// medax_openmesh.hpp: meshes in and out, and what does not fit one.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <medax.hpp>
#include <medax_openmesh.hpp>

#include "converters.hpp"

#include <numeric>
#include <random>

namespace {

struct Doubles : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<Doubles>;
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<Doubles>;
using FloatMesh = OpenMesh::TriMesh_ArrayKernelT<>;

template <class T, class Mesh>
T value(const Mesh &mesh, const char *name, typename Mesh::VertexHandle v) {
    OpenMesh::VPropHandleT<T> property;
    CHECK(mesh.get_property_handle(property, name));
    return mesh.property(property, v);
}

void there_and_back() {
    const medax::Complex from = cube();
    auto mesh = medax::openmesh::mesh<PolyMesh>(from);
    CHECK(mesh.n_vertices() == 8 && mesh.n_faces() == 6 && mesh.n_edges() == 12);
    CHECK(value<double>(mesh, "radius", PolyMesh::VertexHandle(3)) == 3.5);
    const medax::Complex back = medax::openmesh::complex(mesh, {"radius"});
    CHECK(same(from, back) && back.attribute_count() == 1);
    CHECK(back.attribute(MEDAX_ELEMENT_VERTEX, "radius").f64_values[7][0] == 7.5);
    bool refused = false;
    try {
        medax::openmesh::complex(mesh, {"radios"});
    } catch (const std::invalid_argument &error) {
        refused = std::string(error.what()).find("'radios'") != std::string::npos;
    }
    CHECK(refused && medax::openmesh::normals(mesh).empty());

    const auto triangles = medax::openmesh::mesh<FloatMesh>(from);
    CHECK(triangles.n_faces() == 12 && triangles.n_vertices() == 8);
    CHECK(medax::openmesh::complex(triangles).faces().rows() == 12);
    CHECK(medax::openmesh::points(triangles).bounds().max[2] == 1);

    // Normals both ways, and in the order of points.
    mesh.request_face_normals();
    mesh.request_vertex_normals();
    mesh.update_normals();
    const medax::Complex with_normals = medax::openmesh::complex(mesh);
    CHECK(with_normals.attribute(MEDAX_ELEMENT_VERTEX, "normal").f64_values[6][0] > 0.5);
    const auto again = medax::openmesh::mesh<PolyMesh>(with_normals);
    CHECK(again.has_vertex_normals() && again.normal(PolyMesh::VertexHandle(0)) == mesh.normal(PolyMesh::VertexHandle(0)));
    const medax::Points points = medax::openmesh::points(mesh);
    const auto normals = medax::by_vertex(points, medax::openmesh::normals(mesh));
    CHECK(normals.size() == 8);
    for (std::size_t v = 0; v < 8; ++v)
        CHECK((points.coords()[v][0] > 0.5) == (normals[v][0] > 0) && (points.coords()[v][2] > 0.5) == (normals[v][2] > 0));

    // Deleted elements are passed over.
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_face_status();
    mesh.delete_vertex(PolyMesh::VertexHandle(2));
    const medax::Complex less = medax::openmesh::complex(mesh, {"radius"});
    CHECK(less.vertices().rows() == 7 && less.faces().rows() == 3);
    CHECK(less.attribute(MEDAX_ELEMENT_VERTEX, "radius").f64_values[2][0] == 3.5);
    CHECK(less.attribute(MEDAX_ELEMENT_VERTEX, "normal").f64_values.rows() == 7);
    CHECK(medax::openmesh::points(mesh).row_count() == 7);
    CHECK(medax::openmesh::complex(PolyMesh()).vertices().empty());
}

void results() {
    const medax::Points points = torus();
    const medax::PowerCrust crust = medax::PowerCrust::of(points);
    const medax::Complex surface = crust.surface();
    const auto mesh = medax::openmesh::mesh<PolyMesh>(surface);
    CHECK(mesh.n_faces() == surface.faces().rows() && same(medax::openmesh::complex(mesh), surface));
    for (const PolyMesh::HalfedgeHandle side : mesh.halfedges()) CHECK(!mesh.is_boundary(side));
    CHECK(medax::openmesh::mesh<TriMesh>(surface).n_faces() == surface.triangles().rows());

    // An axis is not manifold: what fits of it, and all of it as a soup.
    const medax::Complex shape = crust.shape(MEDAX_LABEL_INNER);
    std::vector<std::uint32_t> left_out;
    const auto part = medax::openmesh::mesh<TriMesh>(shape, &left_out);
    CHECK(part.n_faces() > 0 && !left_out.empty() && part.n_faces() + left_out.size() == shape.triangles().rows());
    CHECK(THROWN(medax::openmesh::mesh<TriMesh>(shape)).index() == left_out.front());
    const auto radius = shape.attribute(MEDAX_ELEMENT_VERTEX, "radius").f64_values;
    const auto pole = shape.attribute(MEDAX_ELEMENT_VERTEX, "pole").u32_values;
    const TriMesh::VertexHandle last(static_cast<int>(radius.rows()) - 1);
    CHECK(value<double>(part, "radius", last) == radius[radius.rows() - 1][0]);
    CHECK(value<std::uint32_t>(part, "pole", last) == pole[radius.rows() - 1][0]);
    const medax::Soup<> soup = medax::soup(shape);
    CHECK(soup.points.size() == shape.vertices().rows() && soup.polygons.size() == shape.faces().rows());

    medax::DualOptions with_facets;
    with_facets.facets = 1;
    const medax::Dual dual = medax::Dual::of(medax::Triangulation::delaunay(points), with_facets);
    const medax::Complex axis = medax::Medial::of(dual, medax::Labels::of(dual, crust)).axis();
    left_out.clear();
    const auto sheets = medax::openmesh::mesh<PolyMesh>(axis, &left_out);
    OpenMesh::FPropHandleT<std::uint32_t> facet;
    OpenMesh::FPropHandleT<std::vector<std::uint32_t>> samples;
    CHECK(sheets.get_property_handle(facet, "facet") && sheets.get_property_handle(samples, "samples"));
    std::uint32_t first = 0;
    for (const std::uint32_t face : left_out) first += face == first;
    CHECK(sheets.property(facet, PolyMesh::FaceHandle(0))
          == axis.attribute(MEDAX_ELEMENT_FACE, "facet").u32_values[first][0]);
    CHECK(sheets.property(samples, PolyMesh::FaceHandle(0)).size() == 2);
}

void what_does_not_fit() {
    for (const Misfit &from : misfits()) {
        const medax::Complex complex = misfit(from);
        std::vector<std::uint32_t> left_out;
        CHECK(medax::openmesh::mesh<PolyMesh>(complex, &left_out).n_faces() == from.rings.size() - from.left_out.size());
        CHECK(left_out == from.left_out);
        left_out.clear();
        CHECK(medax::openmesh::mesh<TriMesh>(complex, &left_out).n_vertices() == 7 && left_out == from.left_out);
        const medax::Error error = THROWN(medax::openmesh::mesh<PolyMesh>(complex));
        CHECK(error.kind() == MEDAX_ERROR_KIND_FACE && error.index() == from.left_out.front());
        CHECK(error.status() == MEDAX_STATUS_INVALID_ARGUMENT);
    }
}

/// Faces at random on few vertices: those are left out that OpenMesh itself would refuse, and none of the others.
void refused_by_openmesh() {
    omerr().disable();
    std::mt19937 random(1);
    std::size_t all = 0, refused = 0;
    for (int round = 0; round < 2000; ++round) {
        const std::uint32_t count = 4 + random() % 6;
        std::vector<medax::Point> places(count);
        for (std::uint32_t v = 0; v < count; ++v) places[v] = {0.0 + v, 0.0 + v * v, 0.0 + v * v * v};
        std::vector<std::vector<std::uint32_t>> rings(3 + random() % 15);
        for (auto &ring : rings) {
            ring.resize(count);
            std::iota(ring.begin(), ring.end(), 0u);
            for (std::uint32_t v = count - 1; v > 0; --v) std::swap(ring[v], ring[random() % (v + 1)]);
            ring.resize(3 + random() % 2);
        }
        std::vector<std::uint32_t> left_out, expected;
        medax::openmesh::mesh<PolyMesh>(polygons(places, rings), &left_out);
        PolyMesh plain;
        std::vector<PolyMesh::VertexHandle> vertices, ring;
        for (const medax::Point &place : places) vertices.push_back(plain.add_vertex({place[0], place[1], place[2]}));
        for (std::uint32_t f = 0; f < rings.size(); ++f) {
            ring.clear();
            for (const std::uint32_t v : rings[f]) ring.push_back(vertices[v]);
            if (!plain.add_face(ring).is_valid()) expected.push_back(f);
        }
        CHECK(left_out == expected);
        all += rings.size();
        refused += expected.size();
    }
    CHECK(refused > all / 4 && refused < all);
    omerr().enable();
}

}  // namespace

int main() {
    there_and_back();
    results();
    what_does_not_fit();
    refused_by_openmesh();
    std::printf("%u passed, %u failed\n", passed, failed);
    return failed == 0 ? 0 : 1;
}
