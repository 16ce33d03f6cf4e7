#include "inverse/part_moduli.hpp"

#include <cassert>
#include <cmath>
#include <utility>

#include "base/text.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class PartModuli : public DesignVariable {
public:
    PartModuli(std::vector<SoughtModulus> parts, std::vector<material::Moduli> rest)
        : parts_(std::move(parts)), rest_(std::move(rest)) {}

    std::string name() const override {
        std::vector<std::string> names;
        for (const SoughtModulus& part : parts_) names.push_back(part.name);
        return "Young's modulus of " + join(names);
    }
    VectorXd declared() const override { return VectorXd::Zero(static_cast<Index>(parts_.size())); }
    DesignRange range() const override {
        const VectorXd most = VectorXd::Constant(declared().size(), std::log(part_moduli_policy.most));
        return {-most, most, 1.0};
    }
    void apply(const VectorXd& values, model::Model& model) const override {
        assert(model.moduli.size() == rest_.size());
        // As factors, since effects may have changed the moduli of the cells.
        const std::vector<material::Moduli> now = mixed(values), before = mixed(declared());
        for (std::size_t c = 0; c < rest_.size(); ++c) {
            model.moduli[c].mu *= now[c].mu / before[c].mu;
            model.moduli[c].kappa *= now[c].kappa / before[c].kappa;
        }
    }
    VectorXd gradient(const VectorXd& values, const model::Model& model,
                      const sensitivity::ModelGradient& gradient) const override {
        const std::vector<material::Moduli> now = mixed(values);
        VectorXd by_value(values.size());
        for (std::size_t p = 0; p < parts_.size(); ++p) {
            double sum = 0.0;
            for (std::size_t c = 0; c < rest_.size(); ++c)
                sum += model.moduli[c].mu / now[c].mu * parts_[p].share[c].mu * gradient.moduli[c].mu +
                       model.moduli[c].kappa / now[c].kappa * parts_[p].share[c].kappa * gradient.moduli[c].kappa;
            by_value(static_cast<Index>(p)) = std::exp(values(static_cast<Index>(p))) * sum;
        }
        return by_value;
    }

private:
    /// Moduli of the cells without effects [Pa].
    std::vector<material::Moduli> mixed(const VectorXd& values) const {
        std::vector<material::Moduli> moduli = rest_;
        for (std::size_t p = 0; p < parts_.size(); ++p) {
            const double factor = std::exp(values(static_cast<Index>(p)));
            for (std::size_t c = 0; c < moduli.size(); ++c) {
                moduli[c].mu += factor * parts_[p].share[c].mu;
                moduli[c].kappa += factor * parts_[p].share[c].kappa;
            }
        }
        return moduli;
    }

    std::vector<SoughtModulus> parts_;
    std::vector<material::Moduli> rest_;
};

}  // namespace

DesignVariablePointer part_moduli(std::vector<SoughtModulus> parts, std::vector<material::Moduli> rest) {
    return std::make_shared<PartModuli>(std::move(parts), std::move(rest));
}

}  // namespace myo::inverse
