#include "setup/tetrahedra_surface.hpp"

#include "setup/default_mesh.hpp"

namespace myo::setup {
namespace {

struct TetrahedraSurfacePolicy {
    double wall_deviation = 0.15;  // of the local thickness, by which a coarser surface may lie off the declared one
};
constexpr TetrahedraSurfacePolicy tetrahedra_surface_policy;

}  // namespace

mesh::SizedSurface surface_for_tetrahedra(const mesh::SurfaceMesh& surface, double edge, const Progress& progress) {
    return mesh::sized_surface(surface, edge, tetrahedra_surface_policy.wall_deviation * local_thickness(surface),
                               progress);
}

}  // namespace myo::setup
