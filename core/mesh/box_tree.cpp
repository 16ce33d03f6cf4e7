#include "mesh/box_tree.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace myo::mesh {
namespace {

struct BoxTreePolicy {
    int leaf_size = 4;  // items per leaf
};
constexpr BoxTreePolicy box_tree_policy;

/// True if the boxes overlap or touch after growing by `margin`.
bool overlap(const Box& a, const Box& b, double margin) {
    return (a.lowest.array() <= b.highest.array() + margin).all() &&
           (b.lowest.array() <= a.highest.array() + margin).all();
}

/// Squared distance from a point to a box; 0 inside.
double squared_distance(const Box& box, const Eigen::Vector3d& p) {
    return (box.lowest - p).cwiseMax(p - box.highest).cwiseMax(0.0).squaredNorm();
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& items) : items_(items), order_(items.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    if (!items.empty()) build(0, static_cast<int>(items.size()));
}

int BoxTree::build(int first, int count) {
    const int self = static_cast<int>(nodes_.size());
    nodes_.emplace_back();
    const auto begin = order_.begin() + first, end = begin + count;
    Box box = items_[static_cast<std::size_t>(*begin)];
    for (auto i = begin; i != end; ++i) {
        box.lowest = box.lowest.cwiseMin(items_[static_cast<std::size_t>(*i)].lowest);
        box.highest = box.highest.cwiseMax(items_[static_cast<std::size_t>(*i)].highest);
    }
    nodes_[static_cast<std::size_t>(self)].box = box;
    if (count <= box_tree_policy.leaf_size) {
        std::sort(begin, end);
        nodes_[static_cast<std::size_t>(self)].first = first;
        nodes_[static_cast<std::size_t>(self)].count = count;
        return self;
    }
    // Median split along the longest side. Ties are broken by item number, so that the tree is deterministic.
    Eigen::Index axis = 0;
    box.size().maxCoeff(&axis);
    // Halves differ by at most one item, so the depth is logarithmic whatever the shape of the body.
    const int half = count / 2;
    std::nth_element(begin, begin + half, end, [&](int a, int b) {
        const Box& A = items_[static_cast<std::size_t>(a)];
        const Box& B = items_[static_cast<std::size_t>(b)];
        const double middle_a = A.lowest[axis] + A.highest[axis], middle_b = B.lowest[axis] + B.highest[axis];
        return middle_a != middle_b ? middle_a < middle_b : a < b;
    });
    build(first, half);
    // nodes_ may have been reallocated by the recursion, hence the access by index.
    const int right = build(first + half, count - half);
    nodes_[static_cast<std::size_t>(self)].right = right;
    return self;
}

void BoxTree::overlapping_pairs(double margin, const std::function<bool(int, int)>& visit) const {
    bool go_on = true;
    if (!nodes_.empty()) pairs(0, 0, margin, visit, go_on);
}

void BoxTree::pairs(int a, int b, double margin, const std::function<bool(int, int)>& visit, bool& go_on) const {
    const Node& A = nodes_[static_cast<std::size_t>(a)];
    const Node& B = nodes_[static_cast<std::size_t>(b)];
    // Two different subtrees without overlap contain no pairs. A subtree is compared with itself to find inner pairs.
    if (!go_on || (a != b && !overlap(A.box, B.box, margin))) return;
    if (A.count > 0 && B.count > 0) {
        for (int i = 0; i < A.count; ++i) {
            for (int j = a == b ? i + 1 : 0; j < B.count && go_on; ++j) {
                const int p = order_[static_cast<std::size_t>(A.first + i)],
                          q = order_[static_cast<std::size_t>(B.first + j)];
                if (overlap(items_[static_cast<std::size_t>(p)], items_[static_cast<std::size_t>(q)], margin)) {
                    go_on = visit(std::min(p, q), std::max(p, q));
                }
            }
        }
        return;
    }
    // Otherwise the larger node is divided, which keeps the boxes of a pair at similar size.
    if (a == b) {
        pairs(a + 1, a + 1, margin, visit, go_on);
        pairs(A.right, A.right, margin, visit, go_on);
        pairs(a + 1, A.right, margin, visit, go_on);
    } else if (B.count > 0 || (A.count == 0 && A.box.size().sum() >= B.box.size().sum())) {
        pairs(a + 1, b, margin, visit, go_on);
        pairs(A.right, b, margin, visit, go_on);
    } else {
        pairs(a, b + 1, margin, visit, go_on);
        pairs(a, B.right, margin, visit, go_on);
    }
}

int BoxTree::nearest(const Eigen::Vector3d& point, const std::function<double(int)>& measure) const {
    int best = -1;
    double best_distance = std::numeric_limits<double>::infinity();
    if (!nodes_.empty()) search(0, point, measure, best, best_distance);
    return best;
}

void BoxTree::search(int node, const Eigen::Vector3d& point, const std::function<double(int)>& measure, int& best,
                     double& best_distance) const {
    const Node& N = nodes_[static_cast<std::size_t>(node)];
    if (N.count > 0) {
        for (int i = 0; i < N.count; ++i) {
            const int item = order_[static_cast<std::size_t>(N.first + i)];
            if (squared_distance(items_[static_cast<std::size_t>(item)], point) > best_distance) continue;
            // The exact measure is evaluated only if the box could contain a better point.
            const double distance = measure(item);
            if (distance < best_distance || (distance == best_distance && item < best)) {
                best_distance = distance;
                best = item;
            }
        }
        return;
    }
    // The nearer child is searched first, so that the farther one can often be skipped.
    int near = node + 1, far = N.right;
    double near_distance = squared_distance(nodes_[static_cast<std::size_t>(near)].box, point);
    double far_distance = squared_distance(nodes_[static_cast<std::size_t>(far)].box, point);
    if (far_distance < near_distance) {
        std::swap(near, far);
        std::swap(near_distance, far_distance);
    }
    if (near_distance <= best_distance) search(near, point, measure, best, best_distance);
    if (far_distance <= best_distance) search(far, point, measure, best, best_distance);
}

}  // namespace myo::mesh
