#include "mesh/isotropic_remesh.hpp"

#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <exception>

namespace myo::mesh {
namespace {

// Plain doubles: remeshing constructs points and needs no exact predicate.
using Kernel = CGAL::Simple_cartesian<double>;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using VertexIndex = CgalMesh::Vertex_index;

/// CGAL's index of a vertex: vertices are added in their order.
VertexIndex vertex_index(int v) { return VertexIndex(static_cast<CgalMesh::size_type>(v)); }

/// False if CGAL rejects a triangle, e.g. at an edge of three triangles.
bool fill(const SurfaceMesh& surface, CgalMesh& mesh) {
    for (const auto& x : surface.vertices.colwise()) mesh.add_vertex({x[0], x[1], x[2]});
    for (const auto& t : surface.triangles.colwise())
        if (mesh.add_face(vertex_index(t[0]), vertex_index(t[1]), vertex_index(t[2])) == CgalMesh::null_face())
            return false;
    return true;
}

/// Surface and feature lines of a CGAL mesh, whose removed elements leave gaps in its numbers.
template <class EdgeMap, class VertexMap>
RemeshedSurface result_of(CgalMesh& mesh, const EdgeMap& is_feature, const VertexMap& is_corner) {
    std::vector<int> number(mesh.num_vertices() + mesh.number_of_removed_vertices(), -1);
    RemeshedSurface result;
    result.surface.vertices.resize(3, static_cast<Eigen::Index>(mesh.number_of_vertices()));
    int next = 0;
    const auto number_of = [&](VertexIndex v) { return number[static_cast<std::size_t>(v)]; };
    for (const VertexIndex v : mesh.vertices()) {
        const Kernel::Point_3& p = mesh.point(v);
        result.surface.vertices.col(next) << p.x(), p.y(), p.z();
        if (get(is_corner, v)) result.features.corners.push_back(next);
        number[static_cast<std::size_t>(v)] = next++;
    }
    result.surface.triangles.resize(3, static_cast<Eigen::Index>(mesh.number_of_faces()));
    Eigen::Index t = 0;
    for (const auto face : mesh.faces()) {
        int i = 0;
        for (const VertexIndex v : mesh.vertices_around_face(mesh.halfedge(face)))
            result.surface.triangles(i++, t) = number_of(v);
        ++t;
    }
    for (const auto edge : mesh.edges())
        if (get(is_feature, edge))
            result.features.edges.push_back(
                std::minmax(number_of(mesh.vertex(edge, 0)), number_of(mesh.vertex(edge, 1))));
    return result;
}

}  // namespace

std::optional<RemeshedSurface> isotropic_remesh(const SurfaceMesh& surface, const FeatureLines& features, double edge,
                                                int iterations) {
    // CGAL throws where a precondition fails.
    try {
        CgalMesh mesh;
        if (!fill(surface, mesh)) return std::nullopt;
        auto is_feature = mesh.add_property_map<CgalMesh::Edge_index, bool>("e:feature", false).first;
        auto is_corner = mesh.add_property_map<VertexIndex, bool>("v:corner", false).first;
        for (const auto& [a, b] : features.edges) {
            const auto half = mesh.halfedge(vertex_index(a), vertex_index(b));
            if (half != CgalMesh::null_halfedge()) is_feature[mesh.edge(half)] = true;
        }
        for (const int v : features.corners) is_corner[vertex_index(v)] = true;
        CGAL::Polygon_mesh_processing::isotropic_remeshing(
            mesh.faces(), edge, mesh,
            CGAL::parameters::number_of_iterations(static_cast<unsigned>(iterations))
                .edge_is_constrained_map(is_feature)
                .vertex_is_constrained_map(is_corner));
        return result_of(mesh, is_feature, is_corner);
    } catch (const std::exception&) {
        return std::nullopt;
    }
}

}  // namespace myo::mesh
