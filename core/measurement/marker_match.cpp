#include "measurement/marker_match.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "measurement/registration.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Triple = std::array<Index, 3>;

struct MarkerMatchPolicy {
    std::size_t base_triples = 24;  // searched triples; at least one is visible unless most markers are hidden
};
constexpr MarkerMatchPolicy marker_match_policy;

/// Columns of the visible points.
std::vector<Index> usable(const Matrix3Xd& places) {
    std::vector<Index> columns;
    for (Index i = 0; i < places.cols(); ++i)
        if (places.col(i).allFinite()) columns.push_back(i);
    return columns;
}

double area(const Matrix3Xd& places, const Triple& t) {
    return 0.5 * (places.col(t[1]) - places.col(t[0])).cross(places.col(t[2]) - places.col(t[0])).norm();
}

/// Triangles of markers, largest area first. Large triangles determine the motion best; degenerate ones are excluded.
std::vector<Triple> wide_triples(const Matrix3Xd& rest_m, double tolerance_m) {
    std::vector<Triple> triples;
    for (Index i = 0; i < rest_m.cols(); ++i)
        for (Index j = i + 1; j < rest_m.cols(); ++j)
            for (Index k = j + 1; k < rest_m.cols(); ++k)
                if (area(rest_m, {i, j, k}) > tolerance_m * tolerance_m) triples.push_back({i, j, k});
    const auto count = std::min(triples.size(), marker_match_policy.base_triples);
    std::partial_sort(triples.begin(), triples.begin() + static_cast<std::ptrdiff_t>(count), triples.end(),
                      [&](const Triple& a, const Triple& b) { return area(rest_m, a) > area(rest_m, b); });
    triples.resize(count);
    return triples;
}

/// Greedy assignment, closest pairs first; each marker and each point is used once.
Eigen::VectorXi nearest_pairs(const Matrix3Xd& rest_m, const Matrix3Xd& seen_m, const RigidMotion& motion,
                              double tolerance_m) {
    struct Pair {
        double distance;
        Index marker, place;
    };
    std::vector<Pair> pairs;
    const Matrix3Xd moved = motion.apply_all(seen_m);
    for (Index m = 0; m < rest_m.cols(); ++m)
        for (Index s = 0; s < moved.cols(); ++s)
            if (const double distance = (moved.col(s) - rest_m.col(m)).norm(); distance <= tolerance_m)
                pairs.push_back({distance, m, s});
    std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
    Eigen::VectorXi seen = Eigen::VectorXi::Constant(rest_m.cols(), -1);
    std::vector<char> taken(static_cast<std::size_t>(seen_m.cols()), 0);
    for (const Pair& pair : pairs) {
        if (seen[pair.marker] >= 0 || taken[static_cast<std::size_t>(pair.place)]) continue;
        seen[pair.marker] = static_cast<int>(pair.place);
        taken[static_cast<std::size_t>(pair.place)] = 1;
    }
    return seen;
}

/// Motion of the matched pairs: rigid if they determine it, otherwise a translation with the given rotation.
RigidMotion motion_of(const Matrix3Xd& rest_m, const Matrix3Xd& seen_m, const Eigen::VectorXi& seen,
                      const Eigen::Matrix3d& rotation) {
    const auto count = (seen.array() >= 0).count();
    Matrix3Xd from(3, count), to(3, count);
    Index k = 0;
    for (Index m = 0; m < seen.size(); ++m)
        if (seen[m] >= 0) from.col(k) = seen_m.col(seen[m]), to.col(k++) = rest_m.col(m);
    if (const Result<Registration> fit = rigid_registration(from, to)) return fit->motion;
    return {rotation, (to - rotation * from).rowwise().mean()};
}

/// Alternates assignment and motion, as in iterative closest point, until the assignment no longer changes.
MarkerMatch refined(const Matrix3Xd& rest_m, const Matrix3Xd& seen_m, RigidMotion motion, double tolerance_m) {
    MarkerMatch match;
    match.seen = nearest_pairs(rest_m, seen_m, motion, tolerance_m);
    for (int turn = 0; turn < 5 && match.count() > 0; ++turn) {
        motion = motion_of(rest_m, seen_m, match.seen, motion.rotation);
        const Eigen::VectorXi before = match.seen;
        match.seen = nearest_pairs(rest_m, seen_m, motion, tolerance_m);
        if (match.seen == before) break;
    }
    match.motion = motion;
    double squares = 0.0;
    for (Index m = 0; m < rest_m.cols(); ++m)
        if (match.seen[m] >= 0) squares += (motion.apply(seen_m.col(match.seen[m])) - rest_m.col(m)).squaredNorm();
    match.rms_m = std::sqrt(squares / std::max(1, match.count()));
    return match;
}

/// Collects the assignments with the largest number of matched markers.
class Search {
public:
    Search(const Matrix3Xd& rest_m, const Matrix3Xd& seen_m, double tolerance_m)
        : rest_m_(rest_m), seen_m_(seen_m), tolerance_m_(tolerance_m) {}

    /// Tries every translation that maps one point to one marker, at fixed rotation.
    void try_shifts(const Eigen::Matrix3d& rotation) {
        for (Index m = 0; m < rest_m_.cols(); ++m)
            for (Index s = 0; s < seen_m_.cols(); ++s)
                keep(refined(rest_m_, seen_m_, {rotation, rest_m_.col(m) - rotation * seen_m_.col(s)}, tolerance_m_));
    }

    /// Tries all triples of points whose side lengths agree with those of the marker triple.
    void try_triple(const Triple& t) {
        const auto side = [](const Matrix3Xd& p, Index a, Index b) { return (p.col(a) - p.col(b)).norm(); };
        // Distances are invariant under rigid motions. Each of two points may be off by the tolerance: slack of twice
        // it.
        const double ab = side(rest_m_, t[0], t[1]), ac = side(rest_m_, t[0], t[2]), bc = side(rest_m_, t[1], t[2]),
                     slack = 2.0 * tolerance_m_;
        for (Index a = 0; a < seen_m_.cols(); ++a)
            for (Index b = 0; b < seen_m_.cols(); ++b) {
                if (b == a || std::abs(side(seen_m_, a, b) - ab) > slack) continue;
                for (Index c = 0; c < seen_m_.cols(); ++c) {
                    if (c == a || c == b || std::abs(side(seen_m_, a, c) - ac) > slack ||
                        std::abs(side(seen_m_, b, c) - bc) > slack)
                        continue;
                    Matrix3Xd from(3, 3), to(3, 3);
                    from << seen_m_.col(a), seen_m_.col(b), seen_m_.col(c);
                    to << rest_m_.col(t[0]), rest_m_.col(t[1]), rest_m_.col(t[2]);
                    if (const Result<Registration> fit = rigid_registration(from, to))
                        keep(refined(rest_m_, seen_m_, fit->motion, tolerance_m_));
                }
            }
    }

    /// The assignment with the smallest residual; among equally good ones the one closest to the expected rotation.
    MarkerMatch best(const Eigen::Matrix3d& expected) const {
        double least = found_.front().rms_m;
        for (const MarkerMatch& match : found_) least = std::min(least, match.rms_m);
        // Residuals within this range cannot be distinguished from the best one.
        const double equal = std::max(1.5 * least, 0.25 * tolerance_m_);
        const MarkerMatch* chosen = nullptr;
        int equals = 0;
        for (const MarkerMatch& match : found_) {
            if (match.rms_m > equal) continue;
            ++equals;
            const auto turn = [&](const MarkerMatch& m) {
                return rotation_angle(m.motion.rotation * expected.transpose());
            };
            if (!chosen || turn(match) < turn(*chosen)) chosen = &match;
        }
        MarkerMatch best = *chosen;
        best.unique = equals == 1;
        return best;
    }

    bool empty() const { return found_.empty(); }

private:
    /// Keeps assignments with the largest number of markers, each once.
    void keep(MarkerMatch match) {
        if (match.count() == 0) return;
        if (!found_.empty() && match.count() < found_.front().count()) return;
        if (!found_.empty() && match.count() > found_.front().count()) found_.clear();
        // The same assignment may be reached from several triples.
        for (const MarkerMatch& known : found_)
            if (known.seen == match.seen) return;
        found_.push_back(std::move(match));
    }

    const Matrix3Xd& rest_m_;
    const Matrix3Xd& seen_m_;
    double tolerance_m_;
    std::vector<MarkerMatch> found_;
};

}  // namespace

Result<MarkerMatch> match_markers(const Matrix3Xd& rest_m, const Matrix3Xd& seen_m, double tolerance_m,
                                  const Eigen::Matrix3d& expected) {
    const std::vector<Index> columns = usable(seen_m);
    if (rest_m.cols() == 0) return Error{"there is no marker to match", ""};
    if (columns.empty()) return Error{"the recording shows no marker before the motion", ""};
    const Matrix3Xd places = seen_m(Eigen::all, columns);
    Search search(rest_m, places, tolerance_m);
    for (const Triple& triple : wide_triples(rest_m, tolerance_m)) search.try_triple(triple);
    if (search.empty()) search.try_shifts(expected);
    MarkerMatch match = search.best(expected);  // not empty: a translation always matches one marker
    // Indices of visible points back to columns of seen_m.
    for (int& seen : match.seen)
        if (seen >= 0) seen = static_cast<int>(columns[static_cast<std::size_t>(seen)]);
    return match;
}

}  // namespace myo::measurement
