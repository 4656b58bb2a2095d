// A second translation unit with the header: what is not inline would be defined twice.
#include <medax.hpp>

medax::Triangulation triangulate_elsewhere(const medax::Points &points) {
    return medax::Triangulation::delaunay(points);
}
