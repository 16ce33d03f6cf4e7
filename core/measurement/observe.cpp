#include "measurement/observe.hpp"

#include <algorithm>
#include <cassert>

#include "measurement/hermite_weights.hpp"

namespace myo::measurement {
namespace {

using Eigen::Matrix3Xd;

/// Nodal field at one time from the series of positions and velocities.
template <class Positions, class Velocities>
Matrix3Xd combine(const HermiteWeights& w, const Positions& x, const Velocities& v) {
    Matrix3Xd result = w.x0 * x(w.step) + w.v0 * v(w.step);
    if (w.x1 != 0.0) result += w.x1 * x(w.step + 1);
    if (w.v1 != 0.0) result += w.v1 * v(w.step + 1);
    return result;
}

Matrix3Xd columns(const Matrix3Xd& X, const std::vector<int>& positions) { return X(Eigen::all, positions); }

/// Tangents of the nodes. Interpolation is linear, so tangents use the same weights.
std::vector<Matrix3Xd> node_tangents(const sensitivity::SensitiveTrace& run, const HermiteWeights& w) {
    std::vector<Matrix3Xd> d;
    for (const sensitivity::NodeTangent& tangent : run.tangents)
        d.push_back(combine(
            w, [&](std::size_t k) -> const Matrix3Xd& { return tangent.positions[k]; },
            [&](std::size_t k) -> const Matrix3Xd& { return tangent.velocities[k]; }));
    return d;
}

/// Markers with these bindings.
MarkerSet of_bindings(std::vector<MarkerBinding> bindings) {
    MarkerSet set;
    set.bindings = std::move(bindings);
    for (const MarkerBinding& binding : set.bindings)
        set.nodes.insert(set.nodes.end(), binding.nodes.begin(), binding.nodes.end());
    // Many markers share nodes: only their union has to be kept of a run.
    std::sort(set.nodes.begin(), set.nodes.end());
    set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
    for (const MarkerBinding& binding : set.bindings) {
        std::vector<int> places;
        for (const int node : binding.nodes)
            places.push_back(
                static_cast<int>(std::lower_bound(set.nodes.begin(), set.nodes.end(), node) - set.nodes.begin()));
        set.positions.push_back(std::move(places));
    }
    return set;
}

}  // namespace

MarkerSet marker_set(const mesh::VolumeMesh& mesh, const std::vector<Eigen::Vector3d>& rest_m) {
    const mesh::BoundaryLocator locator(mesh);
    std::vector<MarkerBinding> bindings;
    for (const Eigen::Vector3d& rest : rest_m) bindings.push_back(bind_marker(mesh, locator, rest));
    return of_bindings(std::move(bindings));
}

MarkerSet seen_markers(const MarkerSet& declared, const ObservationError& error) {
    if (error.places.empty()) return declared;
    std::vector<MarkerBinding> bindings = declared.bindings;
    for (const MarkerPlace& place : error.places) bindings[place.marker] = place.binding;
    return of_bindings(std::move(bindings));
}

SensitiveTracks observe(const sensitivity::SensitiveTrace& run, const MarkerSet& markers,
                        const Eigen::VectorXd& times_s) {
    assert(!run.trace.times_s.empty());
    const auto count = markers.bindings.size();
    const Eigen::Index samples = times_s.size();
    SensitiveTracks result;
    result.tracks.positions.assign(count, Matrix3Xd(3, samples));
    result.tracks.velocities.assign(count, Matrix3Xd(3, samples));
    result.tangents.assign(run.tangents.size(), std::vector<Matrix3Xd>(count, Matrix3Xd(3, samples)));
    const auto x = [&](std::size_t k) -> Matrix3Xd { return run.trace.positions[k](Eigen::all, markers.nodes); };
    const auto v = [&](std::size_t k) -> Matrix3Xd { return run.trace.velocities[k](Eigen::all, markers.nodes); };
    for (Eigen::Index t = 0; t < samples; ++t) {
        const HermiteWeights w = hermite_weights(run.trace.times_s, times_s(t));
        // The velocity of a marker is its tangent along the nodal velocities.
        const Matrix3Xd now = combine(w, x, v), rate = combine(w.rate(), x, v);
        const std::vector<Matrix3Xd> d = node_tangents(run, w);
        for (std::size_t m = 0; m < count; ++m) {
            const MarkerBinding& binding = markers.bindings[m];
            const Matrix3Xd local = columns(now, markers.positions[m]);
            result.tracks.positions[m].col(t) = marker_position(binding, local);
            result.tracks.velocities[m].col(t) = marker_tangent(binding, local, columns(rate, markers.positions[m]));
            for (std::size_t p = 0; p < d.size(); ++p)
                result.tangents[p][m].col(t) = marker_tangent(binding, local, columns(d[p], markers.positions[m]));
        }
    }
    return result;
}

MarkerTracks observe(const sensitivity::NodeMotion& motion, const MarkerSet& markers, const Eigen::VectorXd& times_s) {
    assert(!motion.times_s.empty());
    const std::size_t count = markers.bindings.size();
    MarkerTracks tracks{std::vector<Matrix3Xd>(count, Matrix3Xd(3, times_s.size())),
                        std::vector<Matrix3Xd>(count, Matrix3Xd(3, times_s.size()))};
    const auto x = [&](std::size_t k) -> const Matrix3Xd& { return motion.positions[k]; };
    const auto v = [&](std::size_t k) -> const Matrix3Xd& { return motion.velocities[k]; };
    for (Eigen::Index t = 0; t < times_s.size(); ++t) {
        const HermiteWeights w = hermite_weights(motion.times_s, times_s(t));
        const Matrix3Xd now = combine(w, x, v), rate = combine(w.rate(), x, v);
        for (std::size_t m = 0; m < count; ++m) {
            const Matrix3Xd local = columns(now, markers.positions[m]);
            tracks.positions[m].col(t) = marker_position(markers.bindings[m], local);
            tracks.velocities[m].col(t) = marker_tangent(markers.bindings[m], local,
                                                         columns(rate, markers.positions[m]));
        }
    }
    return tracks;
}

sensitivity::MotionLoss pull_on_nodes(const sensitivity::NodeMotion& motion, const MarkerSet& markers,
                                      const Eigen::VectorXd& times_s, const std::vector<Matrix3Xd>& pulls) {
    assert(!motion.times_s.empty() && pulls.size() == markers.bindings.size());
    const Matrix3Xd none = Matrix3Xd::Zero(3, static_cast<Eigen::Index>(markers.nodes.size()));
    sensitivity::MotionLoss loss;
    loss.d_positions.assign(motion.times_s.size(), none);
    loss.d_velocities.assign(motion.times_s.size(), none);
    const auto x = [&](std::size_t k) -> const Matrix3Xd& { return motion.positions[k]; };
    const auto v = [&](std::size_t k) -> const Matrix3Xd& { return motion.velocities[k]; };
    for (Eigen::Index t = 0; t < times_s.size(); ++t) {
        const HermiteWeights w = hermite_weights(motion.times_s, times_s(t));
        // Reverse of observe(): markers to nodes, then nodes at time t to the two ends of the step interval.
        const Matrix3Xd now = combine(w, x, v);
        Matrix3Xd on_nodes = none;
        for (std::size_t m = 0; m < pulls.size(); ++m) {
            if (pulls[m].col(t).isZero(0.0)) continue;
            on_nodes(Eigen::all, markers.positions[m]) += marker_pull(
                markers.bindings[m], columns(now, markers.positions[m]), pulls[m].col(t));
        }
        // Transposed Hermite interpolation.
        loss.d_positions[w.step] += w.x0 * on_nodes;
        loss.d_velocities[w.step] += w.v0 * on_nodes;
        if (w.x1 != 0.0) loss.d_positions[w.step + 1] += w.x1 * on_nodes;
        if (w.v1 != 0.0) loss.d_velocities[w.step + 1] += w.v1 * on_nodes;
    }
    return loss;
}

MarkerTracks observe(const dynamics::Trace& trace, const MarkerSet& markers, const Eigen::VectorXd& times_s) {
    return observe(sensitivity::SensitiveTrace{trace, {}}, markers, times_s).tracks;
}

}  // namespace myo::measurement
