#include "inverse/fibre_amount.hpp"

#include <cassert>
#include <cmath>
#include <utility>

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Cells that a group has points in, ascending by first appearance, and the number of each point's cell among them.
struct GroupCells {
    std::vector<int> cells;
    std::vector<Index> of_point;
};
GroupCells cells_of(const fibre::FibreGroup& fibres) {
    GroupCells found;
    for (const fibre::FibrePoint& point : fibres.points) {
        // Points of a cell are consecutive.
        if (found.cells.empty() || found.cells.back() != point.cell) found.cells.push_back(point.cell);
        found.of_point.push_back(static_cast<Index>(found.cells.size()) - 1);
    }
    return found;
}

class FibreAmount : public DesignVariable {
public:
    FibreAmount(const mesh::VolumeMesh& mesh, std::size_t group, const fibre::FibreGroup& fibres,
                const fibre::CellPaint& paint)
        : name_(fibres.name), group_(group), cells_(cells_of(fibres)), declared_(paint.weights(cells_.cells)) {
        for (const fibre::FibrePoint& point : fibres.points) volumes_.push_back(point.volume);
        std::vector<Index> number(static_cast<std::size_t>(mesh.cell_count()), -1);
        for (std::size_t k = 0; k < cells_.cells.size(); ++k)
            number[static_cast<std::size_t>(cells_.cells[k])] = static_cast<Index>(k);
        const Eigen::Matrix2Xi neighbours = mesh::neighbouring_cells(mesh);
        for (const auto pair : neighbours.colwise()) {
            const Index a = number[static_cast<std::size_t>(pair(0))], b = number[static_cast<std::size_t>(pair(1))];
            if (a >= 0 && b >= 0) pairs_.emplace_back(a, b);
        }
    }

    std::string name() const override { return "painted weights of " + name_; }
    VectorXd declared() const override { return declared_; }
    DesignRange range() const override {
        return {VectorXd::Zero(declared_.size()), VectorXd::Ones(declared_.size()), 1.0};
    }
    void apply(const VectorXd& values, model::Model& model) const override {
        auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>(*model.fibres);
        fibre::FibreGroup& group = (*fibres)[group_];
        assert(group.points.size() == volumes_.size());
        for (std::size_t k = 0; k < volumes_.size(); ++k)
            group.points[k].volume = values(cells_.of_point[k]) * volumes_[k];
        model.fibres = std::move(fibres);
    }
    VectorXd gradient(const VectorXd& values, const model::Model&,
                      const sensitivity::ModelGradient& gradient) const override {
        VectorXd by_weight = VectorXd::Zero(values.size());
        for (std::size_t k = 0; k < volumes_.size(); ++k)
            by_weight(cells_.of_point[k]) += volumes_[k] * gradient.fibre_volume_m3[group_][k];
        return by_weight;
    }
    bool changes_fibres() const override { return true; }
    double roughness(const VectorXd& values, double weight, VectorXd& gradient) const override {
        if (pairs_.empty()) return 0.0;
        const double across = std::cbrt(static_cast<double>(values.size()));
        const double factor = across * across / static_cast<double>(pairs_.size());
        const VectorXd change = values - declared_;
        double sum = 0.0;
        for (const auto& [a, b] : pairs_) {
            const double jump = change(a) - change(b);
            sum += factor * jump * jump;
            gradient(a) += 2.0 * weight * factor * jump;
            gradient(b) -= 2.0 * weight * factor * jump;
        }
        return sum;
    }

private:
    std::string name_;
    std::size_t group_;
    GroupCells cells_;
    VectorXd declared_;                           // weight of each of the cells
    std::vector<double> volumes_;                 // of the points at weight 1 [m3]
    std::vector<std::pair<Index, Index>> pairs_;  // neighbours among the cells
};

}  // namespace

DesignVariablePointer fibre_amount(const mesh::VolumeMesh& mesh, std::size_t group, const fibre::FibreGroup& fibres,
                                   const fibre::CellPaint& paint) {
    return std::make_shared<FibreAmount>(mesh, group, fibres, paint);
}

fibre::CellPaint with_amounts(const fibre::FibreGroup& fibres, const VectorXd& values, fibre::CellPaint paint) {
    const GroupCells cells = cells_of(fibres);
    for (std::size_t k = 0; k < cells.cells.size(); ++k) paint.weights(cells.cells[k]) = values(static_cast<Index>(k));
    return paint;
}

}  // namespace myo::inverse
