#pragma once

#include <functional>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// Binary tree of bounding boxes over items (triangles, faces), for nearest and overlap queries in logarithmic time.
/// Deterministic: items are split at the median of the longest side, ties by item number.
class BoxTree {
public:
    /// Builds the tree in O(n log n).
    /// @param items  bounding box of each item [m]; copied
    explicit BoxTree(const std::vector<Box>& items);

    /// Visits all pairs of items whose boxes overlap, in an order that depends on the tree.
    /// @param margin  boxes are grown by this length [m]
    /// @param visit   called once per pair item < other; returns false to stop
    void overlapping_pairs(double margin, const std::function<bool(int, int)>& visit) const;

    /// Item with the smallest distance to a point (branch and bound).
    /// @param measure  squared distance of an item to the point [m2], not below that of its box
    /// @return         lowest item number on ties; -1 if there are no items
    int nearest(const Eigen::Vector3d& point, const std::function<double(int)>& measure) const;

private:
    /// Node of the tree; the left child of an inner node follows it directly.
    struct Node {
        Box box;         // of all items below
        int first = 0;   // leaf: first position in order_
        int count = 0;   // leaf: number of items; 0 for an inner node
        int right = -1;  // inner node: right child
    };
    /// Builds the subtree of the items order_[first ... first + count - 1]; returns its node.
    int build(int first, int count);
    /// Visits overlapping pairs between the subtrees a and b.
    void pairs(int a, int b, double margin, const std::function<bool(int, int)>& visit, bool& go_on) const;
    /// Nearest item in a subtree, updating the best one so far.
    void search(int node, const Eigen::Vector3d& point, const std::function<double(int)>& measure, int& best,
                double& best_distance) const;

    std::vector<Box> items_;   // bounding boxes by item number
    std::vector<int> order_;   // item numbers in the order of the leaves
    std::vector<Node> nodes_;  // preorder
};

}  // namespace myo::mesh
