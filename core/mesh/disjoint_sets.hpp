#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace myo::mesh {

/// Union-find over 0 ... n - 1, with path compression.
///
/// The smallest member represents its set, so the result does not depend on the order of joins.
class DisjointSets {
public:
    /// @param n  number of members; each is a set of its own at first
    explicit DisjointSets(std::size_t n) { reset(n); }

    /// Starts again with n sets of one member each.
    void reset(std::size_t n) {
        parent_.resize(n);
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    /// Representative of a set; compresses the path.
    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    /// Merges the sets of a and b.
    void join(std::size_t a, std::size_t b) {
        a = find(a), b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace myo::mesh
