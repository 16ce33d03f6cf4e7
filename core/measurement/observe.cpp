#include "measurement/observe.hpp"

#include <algorithm>
#include <cassert>

namespace myo {
namespace {

using Eigen::Matrix3Xd;

/// Values and time derivative on the Hermite curve of one step interval.
struct HermiteWeights {
    std::size_t step = 0;   // interval [step, step + 1]
    double x0 = 1.0, v0 = 0.0, x1 = 0.0, v1 = 0.0;          // position
    double dx0 = 0.0, dv0 = 0.0, dx1 = 0.0, dv1 = 0.0;      // velocity
};

HermiteWeights hermite_weights(const std::vector<double>& times, double t) {
    HermiteWeights w;
    if (t <= times.front() || times.size() == 1) return w;   // at rest before the start
    if (t >= times.back()) {
        w.step = times.size() - 2;
        w.x0 = 0.0;
        w.x1 = w.dv1 = 1.0;
        return w;
    }
    w.step = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin()) - 1;
    const double h = times[w.step + 1] - times[w.step];
    const double s = (t - times[w.step]) / h;
    w.x0 = (1 + 2 * s) * (1 - s) * (1 - s);
    w.v0 = h * s * (1 - s) * (1 - s);
    w.x1 = s * s * (3 - 2 * s);
    w.v1 = h * s * s * (s - 1);
    w.dx0 = 6 * s * (s - 1) / h;
    w.dv0 = (1 - s) * (1 - 3 * s);
    w.dx1 = -w.dx0;
    w.dv1 = s * (3 * s - 2);
    return w;
}

/// x(t) of the nodes from their series of positions and velocities.
template <class Positions, class Velocities>
Matrix3Xd combine(const HermiteWeights& w, const Positions& x, const Velocities& v) {
    Matrix3Xd result = w.x0 * x(w.step) + w.v0 * v(w.step);
    if (w.x1 != 0.0) result += w.x1 * x(w.step + 1);
    if (w.v1 != 0.0) result += w.v1 * v(w.step + 1);
    return result;
}

Matrix3Xd columns(const Matrix3Xd& X, const std::vector<int>& positions) { return X(Eigen::all, positions); }

}  // namespace

MarkerSet marker_set(const VolumeMesh& mesh, const std::vector<Eigen::Vector3d>& rest_m) {
    const BoundaryLocator locator(mesh);
    MarkerSet set;
    for (const Eigen::Vector3d& rest : rest_m) {
        set.bindings.push_back(bind_marker(mesh, locator, rest));
        set.nodes.insert(set.nodes.end(), set.bindings.back().nodes.begin(), set.bindings.back().nodes.end());
    }
    std::sort(set.nodes.begin(), set.nodes.end());
    set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
    for (const MarkerBinding& binding : set.bindings) {
        std::vector<int> places;
        for (const int node : binding.nodes)
            places.push_back(static_cast<int>(std::lower_bound(set.nodes.begin(), set.nodes.end(), node) - set.nodes.begin()));
        set.positions.push_back(std::move(places));
    }
    return set;
}

SensitiveTracks observe(const SensitiveTrace& run, const MarkerSet& markers, const Eigen::VectorXd& times_s) {
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
        HermiteWeights dw = w;
        dw.x0 = w.dx0, dw.v0 = w.dv0, dw.x1 = w.dx1, dw.v1 = w.dv1;
        const Matrix3Xd now = combine(w, x, v);
        const Matrix3Xd rate = combine(dw, x, v);
        std::vector<Matrix3Xd> d;
        for (const NodeTangent& tangent : run.tangents)
            d.push_back(combine(w, [&](std::size_t k) -> const Matrix3Xd& { return tangent.positions[k]; },
                                [&](std::size_t k) -> const Matrix3Xd& { return tangent.velocities[k]; }));
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

MarkerTracks observe(const Trace& trace, const MarkerSet& markers, const Eigen::VectorXd& times_s) {
    return observe(SensitiveTrace{trace, {}}, markers, times_s).tracks;
}

}  // namespace myo
