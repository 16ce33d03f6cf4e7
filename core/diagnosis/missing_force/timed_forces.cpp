#include "diagnosis/missing_force/timed_forces.hpp"

#include <algorithm>

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

using SharedForces = std::shared_ptr<const std::vector<TimedForce>>;

/// Value of a course; at a jump the one before or after it, as the integrator asks.
double size_at(const fibre::Signal& course, const model::ForceState& at) {
    return at.before_jump ? course.value_before(at.time_s) : course.value(at.time_s);
}

/// Dead forces: energy -f . (x - X), with a gradient that does not depend on positions, hence no Hessian.
class TimedForces : public model::ForceElement {
public:
    TimedForces(SharedForces forces, VectorXd factors) : forces_(std::move(forces)), factors_(std::move(factors)) {}

    void add(const model::Body& body, const model::ForceState& at, model::HessianKind,
             model::InternalEnergy& out) const override {
        const Matrix3Xd force = sum(body, at, factors_);
        out.energy -= force.cwiseProduct(at.x - body.mesh.nodes).sum();
        out.gradient -= force;
    }

    std::vector<model::ForceParameter> parameters() const override {
        std::vector<model::ForceParameter> list;
        for (Index k = 0; k < factors_.size(); ++k) list.push_back({"force_" + std::to_string(k), factors_(k), 1.0});
        return list;
    }
    model::ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<TimedForces>(forces_, values);
    }
    void add_tangent(const model::Body& body, const model::ForceState& at, const VectorXd& change,
                     Matrix3Xd& gradient) const override {
        gradient -= sum(body, at, change);
    }

    bool steady(double from_s, double to_s) const override {
        return std::all_of(forces_->begin(), forces_->end(), [&](const TimedForce& force) {
            return force.course.value(from_s) == force.course.value(to_s);
        });
    }
    std::vector<double> jumps() const override {
        std::vector<double> times;
        for (const TimedForce& force : *forces_)
            for (const double t : force.course.jumps()) times.push_back(t);
        return times;
    }

private:
    Matrix3Xd sum(const model::Body& body, const model::ForceState& at, const VectorXd& factors) const {
        Matrix3Xd force = Matrix3Xd::Zero(3, body.node_count());
        for (std::size_t k = 0; k < forces_->size(); ++k) {
            const double size = factors(static_cast<Index>(k)) * size_at((*forces_)[k].course, at);
            if (size != 0.0) force += size * (*forces_)[k].pattern;
        }
        return force;
    }

    SharedForces forces_;
    VectorXd factors_;
};

}  // namespace

model::ForceElementPointer timed_forces(std::vector<TimedForce> forces, double factor) {
    const auto count = static_cast<Index>(forces.size());
    return std::make_shared<TimedForces>(std::make_shared<const std::vector<TimedForce>>(std::move(forces)),
                                         VectorXd::Constant(count, factor));
}

}  // namespace myo::diagnosis
