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
    /// Markers lost together whose names are compared in every order: 24 orders of four.
    std::size_t max_lost = 4;
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

/// Two markers since they were last visible at once.
struct MarkerPair {
    Index together = -1;                   // the last sample in which both were visible; -1: none
    Vector3d relative = Vector3d::Zero();  // of the second to the first, then
    bool was_lost = false;                 // both were hidden at once since
};

/// A change of labels among markers that were lost together.
struct Regained {
    Index since = 0, at = 0;  // the first of them is visible again; all are, and the change was noticed
    std::vector<std::size_t> markers;
    Names labels;  // of all markers from `since` on
};

/// Follows the markers through the recording and keeps track of the label that each of them carries.
class Follower {
public:
    explicit Follower(const std::vector<Eigen::Matrix3Xd>& tracks)
        : tracks_(tracks),
          names_(tracks.size()),
          past_(tracks.size()),
          returned_(tracks.size(), 0),
          pairs_(tracks.size(), std::vector<MarkerPair>(tracks.size())) {
        std::iota(names_.begin(), names_.end(), std::size_t{0});
    }

    /// Labels of the markers in sample `at`. Samples must be visited in order.
    const Names& follow(Index at) {
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (sees(i, at) && past_[i].sample < at - 1) returned_[i] = at;
        rename(at);
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (sees(i, at)) past_[i].see(tracks_[names_[i]].col(at), at);
        for (std::size_t i = 0; i < names_.size(); ++i)
            for (std::size_t j = i + 1; j < names_.size(); ++j) {
                if (sees(i, at) && sees(j, at))
                    pairs_[i][j] = {at, past_[j].last - past_[i].last, false};
                else if (!sees(i, at) && !sees(j, at))
                    pairs_[i][j].was_lost = true;
            }
        return names_;
    }

    /// Changes of labels among markers lost together, in order of time.
    const std::vector<Regained>& regained() const { return regained_; }

private:
    bool sees(std::size_t marker, Index at) const { return is_seen(tracks_[names_[marker]], at); }

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

    /// Whether two markers are visible again that were lost together.
    bool is_regained(std::size_t i, std::size_t j, Index at) const {
        const MarkerPair& pair = pairs_[std::min(i, j)][std::max(i, j)];
        return pair.was_lost && pair.together >= 0 && sees(i, at) && sees(j, at);
    }

    /// Groups of markers that are visible again after they were lost together.
    std::vector<std::vector<std::size_t>> regained_groups(Index at) const {
        std::vector<std::vector<std::size_t>> groups;
        std::vector<bool> taken(names_.size(), false);
        for (std::size_t i = 0; i < names_.size(); ++i) {
            if (taken[i]) continue;
            std::vector<std::size_t> group{i};
            for (std::size_t j = i + 1; j < names_.size(); ++j)
                if (!taken[j] && is_regained(i, j, at)) group.push_back(j), taken[j] = true;
            if (group.size() > 1) groups.push_back(group);
        }
        return groups;
    }

    /// Squared change of the relative positions in a group if marker group[k] carries the label of group[order[k]].
    double squared_change(const std::vector<std::size_t>& group, const std::vector<std::size_t>& order,
                          Index at) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < group.size(); ++k)
            for (std::size_t l = k + 1; l < group.size(); ++l) {
                const MarkerPair& pair = pairs_[group[k]][group[l]];
                if (pair.together < 0) continue;
                const Vector3d now = tracks_[names_[group[order[l]]]].col(at) -
                                     tracks_[names_[group[order[k]]]].col(at);
                sum += (now - pair.relative).squaredNorm();
            }
        return sum;
    }

    /// Whether other markers show that the body itself turned round since the markers of a group were lost.
    bool body_turned(const std::vector<std::size_t>& group, Index at) const {
        Index lost = at;
        for (const std::size_t i : group)
            for (const std::size_t j : group)
                if (i < j && pairs_[i][j].together >= 0) lost = std::min(lost, pairs_[i][j].together);
        std::vector<std::size_t> others;
        for (std::size_t k = 0; k < names_.size(); ++k)
            if (std::find(group.begin(), group.end(), k) == group.end() && sees(k, at) && sees(k, lost))
                others.push_back(k);
        for (const std::size_t k : others)
            for (const std::size_t l : others) {
                const Eigen::Matrix3Xd &from = tracks_[names_[k]], &to = tracks_[names_[l]];
                if (k < l && (to.col(at) - from.col(at)).dot(to.col(lost) - from.col(lost)) < 0.0) return true;
            }
        return false;
    }

    /// Labels among markers lost together: the order that keeps their relative positions, if it does so much better
    /// than the present one.
    void compare_orders(const std::vector<std::size_t>& group, Index at,
                        std::vector<std::optional<std::size_t>>& moved) {
        if (group.size() > exchanges_policy.max_lost || body_turned(group, at)) return;
        std::vector<std::size_t> order(group.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const double own = squared_change(group, order, at);
        std::vector<std::size_t> best = order;
        double least = own;
        while (std::next_permutation(order.begin(), order.end()))
            if (const double change = squared_change(group, order, at); change < least) best = order, least = change;
        const double much_nearer = exchanges_policy.much_nearer * exchanges_policy.much_nearer;
        if (!(least < much_nearer * own)) return;
        Regained change{at, at, {}, {}};
        for (std::size_t k = 0; k < group.size(); ++k) {
            if (best[k] == k) continue;
            moved[group[k]] = names_[group[best[k]]];
            change.markers.push_back(group[k]);
            change.since = std::min(change.since, returned_[group[k]]);
        }
        regained_.push_back(change);
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
        const std::size_t known = regained_.size();
        for (const std::vector<std::size_t>& group : regained_groups(at)) compare_orders(group, at, moved);
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
        for (std::size_t r = known; r < regained_.size(); ++r) {
            regained_[r].labels = names_;
            // Samples since the first of them returned belong to other markers.
            for (const std::size_t i : regained_[r].markers) past_[i] = {};
        }
    }

    const std::vector<Eigen::Matrix3Xd>& tracks_;
    Names names_;
    std::vector<Past> past_;
    std::vector<Index> returned_;                 // first sample after the last gap
    std::vector<std::vector<MarkerPair>> pairs_;  // [i][j] with i < j
    std::vector<Regained> regained_;
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

/// Whether an interval of these members began with a change of labels among markers lost together.
bool began_in_gap(const std::vector<Regained>& regained, const std::vector<std::size_t>& members, Index first) {
    return std::any_of(regained.begin(), regained.end(), [&](const Regained& change) {
        return change.since == first &&
               std::find(members.begin(), members.end(), change.markers.front()) != members.end();
    });
}

/// Exchanges among the members of a group.
void add_exchanges(std::vector<Exchange>& exchanges, const std::vector<Names>& names,
                   const std::vector<std::size_t>& members, const std::vector<Regained>& regained) {
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
        // An exchange in full view that lasts to the end is kept, see the header.
        if (end < count || began_in_gap(regained, members, first)) exchanges.push_back({markers, first, end});
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
    for (const Regained& change : follower.regained())
        for (Index t = change.since; t < change.at; ++t)
            for (const std::size_t i : change.markers) names[static_cast<std::size_t>(t)][i] = change.labels[i];
    const std::vector<std::size_t> group = groups_of(names);
    std::vector<Exchange> exchanges;
    for (std::size_t g = 0; g < tracks.size(); ++g) {
        add_exchanges(exchanges, names, members_of(group, g), follower.regained());
    }
    for (const Exchange& exchange : exchanges) put_back(tracks, exchange, names);
    std::sort(exchanges.begin(), exchanges.end(),
              [](const Exchange& a, const Exchange& b) { return a.first < b.first; });
    return exchanges;
}

}  // namespace myo::measurement
