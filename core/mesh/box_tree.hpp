#pragma once

#include <functional>
#include <vector>

#include "mesh/surface_mesh.hpp"

namespace myo::mesh {

/// A binary tree of bounding boxes over items (triangles, faces): finds near and overlapping ones in logarithmic time.
/// Deterministic: items are split at the median of the longest side, ties by number.
class BoxTree {
public:
    explicit BoxTree(const std::vector<Box>& items);

    /// Calls visit(item, other) for each pair item < other whose boxes, grown by `margin`, overlap; stops when it
    /// returns false.
    void overlapping_pairs(double margin, const std::function<bool(int, int)>& visit) const;

    /// Visits items in order of likely nearness. `measure(item)` gives an item's squared distance to the point;
    /// items whose box is farther than the best so far are skipped. Returns the best item (lowest number on ties), -1
    /// when empty.
    int nearest(const Eigen::Vector3d& point, const std::function<double(int)>& measure) const;

private:
    struct Node {
        Box box;
        int first = 0;   // leaf: first position in order_
        int count = 0;   // leaf: number of items; 0 for an inner node
        int right = -1;  // inner node: right child; the left one follows directly
    };
    int build(int first, int count);
    void pairs(int a, int b, double margin, const std::function<bool(int, int)>& visit, bool& go_on) const;
    void search(int node, const Eigen::Vector3d& point, const std::function<double(int)>& measure, int& best,
                double& best_distance) const;

    std::vector<Box> items_;
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

}  // namespace myo::mesh
