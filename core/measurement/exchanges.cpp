#include "measurement/exchanges.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "measurement/gaps.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Names = std::vector<std::size_t>;  // the label that each marker carries

struct ExchangesPolicy {
    /// Largest ratio of the distance to the new label and to the own label for a move.
    double much_nearer = 0.25;
};
constexpr ExchangesPolicy exchanges_policy;

/// The last two visible samples of a marker.
struct Past {
    Index sample = -1, sample_before = -1;
    Vector3d last = Vector3d::Zero(), before = Vector3d::Zero();

    bool known() const { return sample >= 0; }
    /// Predicted position: linear extrapolation from two directly preceding samples, otherwise the last position.
    Vector3d foretold(Index at) const {
        return sample == at - 1 && sample_before == at - 2 ? Vector3d(2.0 * last - before) : last;
    }
    void see(const Vector3d& place, Index at) {
        before = last;
        sample_before = sample;
        last = place;
        sample = at;
    }
};

/// Follows the markers through the recording and keeps track of the label that each of them carries.
class Follower {
public:
    explicit Follower(const std::vector<Eigen::Matrix3Xd>& tracks)
        : tracks_(tracks), names_(tracks.size()), past_(tracks.size()) {
        std::iota(names_.begin(), names_.end(), std::size_t{0});
    }

    /// Labels of the markers in sample `at`. Samples must be visited in order.
    const Names& follow(Index at) {
        rename(at);
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (is_seen(tracks_[names_[i]], at)) past_[i].see(tracks_[names_[i]].col(at), at);
        return names_;
    }

private:
    /// Distance between the prediction of a marker and the sample of a label; infinite if either is unknown.
    double distance(std::size_t marker, std::size_t label, Index at) const {
        if (!past_[marker].known() || !is_seen(tracks_[label], at)) return std::numeric_limits<double>::infinity();
        return (tracks_[label].col(at) - past_[marker].foretold(at)).norm();
    }

    /// The label to which a marker has moved, if any.
    std::optional<std::size_t> moved_to(std::size_t marker, Index at) const {
        const double own = distance(marker, names_[marker], at);
        if (!(own < std::numeric_limits<double>::infinity())) return std::nullopt;
        std::size_t label = 0;
        for (std::size_t l = 1; l < names_.size(); ++l)
            if (distance(marker, l, at) < distance(marker, label, at)) label = l;
        const double there = distance(marker, label, at);
        if (label == names_[marker] || !(there < exchanges_policy.much_nearer * own)) return std::nullopt;
        // Mutual: no other marker may be closer to that label.
        for (std::size_t other = 0; other < names_.size(); ++other)
            if (other != marker && distance(other, label, at) <= there) return std::nullopt;
        return label;
    }

    /// Whether two markers lost together reappear with reversed relative position, wherever they are.
    bool turned_round(std::size_t i, std::size_t j, Index at) const {
        if (!past_[i].known() || past_[i].sample != past_[j].sample || past_[i].sample == at - 1) return false;
        if (!is_seen(tracks_[names_[i]], at) || !is_seen(tracks_[names_[j]], at)) return false;
        const Vector3d before = past_[j].last - past_[i].last,
                       now = tracks_[names_[j]].col(at) - tracks_[names_[i]].col(at);
        return (now + before).norm() < exchanges_policy.much_nearer * (now - before).norm();
    }

    /// Discards moves that form no cycle: the new label was not given up, or the old label was not taken.
    void discard_open_moves(std::vector<std::optional<std::size_t>>& moved) const {
        for (bool changed = true; changed;) {
            changed = false;
            const auto left = [&](std::size_t label) {
                for (std::size_t j = 0; j < names_.size(); ++j)
                    if (moved[j] && names_[j] == label) return true;
                return false;
            };
            const auto taken = [&](std::size_t label) {
                return std::find(moved.begin(), moved.end(), std::optional(label)) != moved.end();
            };
            for (std::size_t i = 0; i < names_.size(); ++i)
                if (moved[i] && !(left(*moved[i]) && taken(names_[i]))) {
                    moved[i].reset();
                    changed = true;
                }
        }
    }

    /// Determines the moves at a sample and applies those that form closed cycles.
    void rename(Index at) {
        std::vector<std::optional<std::size_t>> moved;
        for (std::size_t i = 0; i < names_.size(); ++i) moved.push_back(moved_to(i, at));
        for (std::size_t i = 0; i < names_.size(); ++i)
            for (std::size_t j = i + 1; j < names_.size(); ++j)
                if (turned_round(i, j, at)) {
                    moved[i] = names_[j];
                    moved[j] = names_[i];
                }
        // If marker i has certainly taken the label of marker j, which was lost before, then j can only have the label
        // of i, wherever j has moved in the meantime.
        for (std::size_t i = 0; i < names_.size(); ++i)
            for (std::size_t j = 0; j < names_.size(); ++j)
                if (moved[i] && *moved[i] == names_[j] && !moved[j] && past_[j].known() && past_[j].sample < at - 1 &&
                    is_seen(tracks_[names_[i]], at))
                    moved[j] = names_[i];
        discard_open_moves(moved);
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (moved[i]) names_[i] = *moved[i];
    }

    const std::vector<Eigen::Matrix3Xd>& tracks_;
    Names names_;
    std::vector<Past> past_;
};

/// Connected components of markers that were ever exchanged: for each marker the index of its group.
std::vector<std::size_t> groups_of(const std::vector<Names>& names) {
    std::vector<std::size_t> group(names.empty() ? 0 : names.front().size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    for (const Names& now : names)
        for (std::size_t i = 0; i < now.size(); ++i)
            if (group[i] != group[now[i]]) {
                const std::size_t from = group[now[i]], to = group[i];
                std::replace(group.begin(), group.end(), from, to);
            }
    return group;
}

std::vector<std::size_t> members_of(const std::vector<std::size_t>& group, std::size_t g) {
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < group.size(); ++i)
        if (group[i] == g) members.push_back(i);
    return members;
}

/// Exchanges among the members of a group.
void add_exchanges(std::vector<Exchange>& exchanges, const std::vector<Names>& names,
                   const std::vector<std::size_t>& members) {
    const auto count = static_cast<Index>(names.size());
    if (members.size() < 2) return;
    // A group is in its exchanged state while any member carries a foreign label.
    const auto exchanged = [&](Index t) {
        return std::any_of(members.begin(), members.end(),
                           [&](std::size_t i) { return names[static_cast<std::size_t>(t)][i] != i; });
    };
    for (Index first = 0; first < count; ++first) {
        if (!exchanged(first)) continue;
        Index end = first;
        while (end < count && exchanged(end)) ++end;
        std::vector<std::size_t> markers;
        for (const std::size_t i : members)
            if (std::any_of(names.begin() + first, names.begin() + end, [&](const Names& now) { return now[i] != i; }))
                markers.push_back(i);
        // An exchange that lasts to the end is kept, see the header.
        if (end < count) exchanges.push_back({markers, first, end});
        first = end;
    }
}

void put_back(std::vector<Eigen::Matrix3Xd>& tracks, const Exchange& exchange, const std::vector<Names>& names) {
    for (Index t = exchange.first; t < exchange.end; ++t) {
        // Copy first: the assignments are a permutation.
        std::vector<Vector3d> there;
        for (const std::size_t i : exchange.markers)
            there.push_back(tracks[names[static_cast<std::size_t>(t)][i]].col(t));
        for (std::size_t k = 0; k < there.size(); ++k) tracks[exchange.markers[k]].col(t) = there[k];
    }
}

}  // namespace

std::vector<Exchange> put_back_exchanges(std::vector<Eigen::Matrix3Xd>& tracks) {
    const Index count = tracks.empty() ? 0 : tracks.front().cols();
    std::vector<Names> names;
    Follower follower(tracks);
    for (Index t = 0; t < count; ++t) names.push_back(follower.follow(t));
    const std::vector<std::size_t> group = groups_of(names);
    std::vector<Exchange> exchanges;
    for (std::size_t g = 0; g < tracks.size(); ++g) {
        add_exchanges(exchanges, names, members_of(group, g));
    }
    for (const Exchange& exchange : exchanges) put_back(tracks, exchange, names);
    std::sort(exchanges.begin(), exchanges.end(),
              [](const Exchange& a, const Exchange& b) { return a.first < b.first; });
    return exchanges;
}

}  // namespace myo::measurement
