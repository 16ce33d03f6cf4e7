#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace myo::mesh {

/// Union-find over 0 ... n - 1; the smallest member names its set, so the outcome does not depend on the order of
/// joins.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t n) { reset(n); }

    /// n sets of one member each, as at the start.
    void reset(std::size_t n) {
        parent_.resize(n);
        std::iota(parent_.begin(), parent_.end(), std::size_t{0});
    }

    std::size_t find(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = find(a), b = find(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

}  // namespace myo::mesh
