#include "model/tendon_channel.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "mesh/closest_point.hpp"
#include "mesh/quality.hpp"

namespace myo::model {
namespace {

using Eigen::Index;
using fem::MaterialPoint;

/// Adds a point times a factor to a weighted sum of points.
void add(const MaterialPoint& point, double factor, MaterialPoint& sum) {
    for (std::size_t a = 0; a < point.nodes.size(); ++a) {
        auto at = std::find(sum.nodes.begin(), sum.nodes.end(), point.nodes[a]);
        if (at == sum.nodes.end()) {
            sum.nodes.push_back(point.nodes[a]);
            const auto count = static_cast<Index>(sum.nodes.size());
            sum.weights.conservativeResize(count);
            sum.gradient.conservativeResize(count, 3);
            sum.weights(count - 1) = 0.0;
            sum.gradient.row(count - 1).setZero();
            at = sum.nodes.end() - 1;
        }
        const Index row = at - sum.nodes.begin(), from = static_cast<Index>(a);
        sum.weights(row) += factor * point.weights(from);
        sum.gradient.row(row) += factor * point.gradient.row(from);
    }
}

}  // namespace

int channel_legs(double mean_edge_m, double length_m) {
    return std::max(1, static_cast<int>(std::ceil(length_m / (tendon_channel_policy.spacing * mean_edge_m))));
}

TendonRoute in_channel(const TendonRoute& route, const mesh::VolumeMesh& mesh, double share) {
    const mesh::BoundaryLocator boundary(mesh);
    const double edge_m = mesh::mean_edge_length(mesh), way = std::sqrt(std::max(0.0, share));
    const auto in_material = [&](const Eigen::Vector3d& rest_m) {
        return fem::material_point_within(mesh, boundary, rest_m, tendon_channel_policy.close * edge_m);
    };
    TendonRoute result = route;
    result.guides.clear();
    std::optional<MaterialPoint> from;  // the guide before, as a point of the material
    for (const TendonGuide& guide : route.guides) {
        const std::optional<MaterialPoint> to = guide.on_body ? guide.on_body : in_material(guide.rest_m);
        if (from && to) {
            const Eigen::Vector3d start_m = result.guides.back().rest_m;
            const int legs = channel_legs(edge_m, (guide.rest_m - start_m).norm());
            for (int i = 1; i < legs; ++i) {
                const double s = static_cast<double>(i) / legs;
                TendonGuide point{MaterialPoint{}, (1.0 - s) * start_m + s * guide.rest_m};
                const std::optional<MaterialPoint> here = in_material(point.rest_m);
                if (!here) continue;  // free, in a cavity
                point.on_body->cell = here->cell;
                add(*here, way, *point.on_body);
                add(*from, (1.0 - way) * (1.0 - s), *point.on_body);
                add(*to, (1.0 - way) * s, *point.on_body);
                result.guides.push_back(std::move(point));
            }
        }
        result.guides.push_back(guide);
        from = to;
    }
    return result;
}

BodyPointer coupled_body(const Body& body, TendonRoute& route, bool by_shortening) {
    auto coupled = std::make_shared<Body>(body);
    route.first_coupling = coupled->couplings.size();
    for (std::vector<int>& group : tendon_couplings(route.guides, by_shortening))
        coupled->couplings.push_back(std::move(group));
    coupled->pattern = block_pattern(coupled->mesh, coupled->clamped, coupled->couplings, coupled->guided);
    return coupled;
}

}  // namespace myo::model
