#pragma once

#include "mesh/volume_mesh.hpp"
#include "model/body.hpp"
#include "model/tendon.hpp"

namespace myo::model {

struct TendonChannelPolicy {
    /// Distance of the points at which a thread in a channel is bound, over the mean edge of the cells: a quadratic
    /// cell that bends is followed to a quarter of what one straight leg would leave.
    double spacing = 0.5;
    /// A place this close to the mesh counts as one in the material, over the mean edge: the mesh of a remeshed surface
    /// is off by as much.
    double close = 0.1;
};
inline constexpr TendonChannelPolicy tendon_channel_policy;

/// Number of legs, >= 1, into which a straight leg of this length at rest [m] is divided for a thread in a channel.
///
/// @param mean_edge_m  of the cells
int channel_legs(double mean_edge_m, double length_m);

/// Route of a thread that lies between its straight path and a channel of the body.
///
/// Legs between guides that the body carries are divided by points on the way. Each lies, once the body has moved,
/// sqrt(share) of the way from its place on the straight leg to its place in the material. A leg in an arc is longer
/// than its chord by the square of its height, so that the share is that of the lengthening in the channel.
///
/// A fixed guide in the material, such as one in a clamp, counts as carried; legs with an end off the body stay as they
/// are, and so does a leg within a cavity.
/// @param share  0: straight, 1: follows the material; negative values count as 0
TendonRoute in_channel(const TendonRoute& route, const mesh::VolumeMesh& mesh, double share);

/// Copy of the body which couples the nodes of the route, too.
///
/// @param route  its first coupling is set to the first of the new ones
BodyPointer coupled_body(const Body& body, TendonRoute& route, bool by_shortening);

}  // namespace myo::model
