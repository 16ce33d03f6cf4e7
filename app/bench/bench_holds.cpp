#include <cmath>
#include <memory>
#include <vector>

#include "bench/bar_meshes.hpp"
#include "bench/beam_run.hpp"
#include "bench/bench_cases.hpp"
#include "bench/held_bar.hpp"
#include "model/tendon.hpp"
#include "sensitivity/tangent_run.hpp"

namespace myo::bench {
namespace {

using Eigen::Vector3d;

/// Numbers of the fit that is timed.
struct HoldsPolicy {
    double true_modulus_Pa = 3e5, start_modulus_Pa = 2.4e5;
    double least_tension_N = 0.5, most_tension_N = 4.0;
    double settled = 1e-6;  // change of the modulus that ends the fit
    int max_evaluations = 12;
};
constexpr HoldsPolicy holds_policy;

/// A bar of 0.2 m x 20 mm x 20 mm, hanging, with a tendon 6 mm off its axis through eleven guides.
model::Model hanging_bar(const Eigen::Vector3i& bricks) {
    BarShape bar;
    bar.length_m = 0.2;
    bar.height_m = bar.width_m = 0.02;
    bar.youngs_modulus_Pa = holds_policy.true_modulus_Pa;
    bar.poissons_ratio = 0.49;
    model::Model model = held_bar(bar, fem::ElementKind::hex8, bar_mesh(bar, fem::ElementKind::hex8, bricks));
    model.gravity_m_s2 = {9.81, 0.0, 0.0};
    const mesh::VolumeMesh& mesh = model.body->mesh;
    const mesh::BoundaryLocator boundary(mesh);
    const Vector3d low = mesh.nodes.rowwise().minCoeff(), high = mesh.nodes.rowwise().maxCoeff();
    model::TendonRoute route;
    for (int i = 0; i <= 10; ++i) {
        const Vector3d at(low.x() + 0.02 * i, 0.5 * (low.y() + high.y()), 0.5 * (low.z() + high.z()) - 0.006);
        // The first guide stands still: the motor's end.
        route.guides.push_back({i > 0 ? std::optional(fem::material_point(mesh, boundary, at)) : std::nullopt, at});
    }
    std::vector<int> clamped;
    for (int i = 0; i < model.body->node_count(); ++i)
        if (model.body->clamped[static_cast<std::size_t>(i)]) clamped.push_back(i);
    // Made a second time with the couplings of the tendon, which need the guides on the mesh.
    model.body = model::make_body(mesh, model.body->kind, clamped, model::tendon_couplings(route.guides, false));
    model.force_elements.push_back(model::tendon_of_tension(route, fibre::Signal::constant(0.0)));
    return model;
}

/// Least squares of the modulus over the tips of `count` holds, each from the pose of the evaluation before.
class HoldsFit {
public:
    HoldsFit(int count, const Eigen::Vector3i& bricks) : bar_(hanging_bar(bricks)) {
        tip_ = free_end_share(*bar_.body);
        for (int i = 0; i < bar_.body->node_count(); ++i)
            if (tip_(i) != 0.0) tip_nodes_.push_back(i);
        options_.start = dynamics::StartKind::equilibrium;
        options_.end_s = 0.0;
        // Solutions of a hold start its next evaluation.
        options_.keep_path = true;
        for (int k = 0; k < count; ++k)
            tensions_N_.push_back(holds_policy.least_tension_N +
                                  (holds_policy.most_tension_N - holds_policy.least_tension_N) * k / count);
        paths_.resize(tensions_N_.size());
    }

    /// Makes the tips with the true modulus, then fits the modulus and measures the time of that alone.
    Result<BenchFigures> run() {
        BenchFigures figures;
        for (std::size_t k = 0; k < tensions_N_.size(); ++k) {
            const Outcome truth = hold(k, holds_policy.true_modulus_Pa, figures);
            if (!truth.ok()) return Error{truth.message, "holds"};
            measured_.push_back(truth.tip);
            // The fit must not start from the solution.
            paths_[k].reset();
        }
        figures = {};
        const double start_s = thread_time_s();
        double modulus = holds_policy.start_modulus_Pa;
        for (int evaluation = 0; evaluation < holds_policy.max_evaluations; ++evaluation) {
            // Gauss-Newton with one parameter: step = J'r / J'J.
            double normal = 0.0, right = 0.0;
            for (std::size_t k = 0; k < tensions_N_.size(); ++k) {
                const Outcome here = hold(k, modulus, figures);
                if (!here.ok()) return Error{here.message, "holds"};
                normal += here.by_modulus.squaredNorm();
                right += here.by_modulus.dot(measured_[k] - here.tip);
            }
            modulus += right / normal;
            if (std::abs(right / normal) < holds_policy.settled * modulus) break;
        }
        figures.run_s = thread_time_s() - start_s;
        figures.iterations_per_step /= figures.steps;
        figures.factorisations_per_step /= figures.steps;
        figures.dofs = static_cast<int>(bar_.body->dofs());
        figures.cells = static_cast<int>(bar_.body->cell_count());
        figures.name = "calibration of " + std::to_string(tensions_N_.size()) + " holds, " +
                       std::to_string(figures.dofs) + " DOF; a step is one pose with its tangent";
        figures.quantities = {{"modulus", 1e-3 * modulus, "kPa", 1e-3 * holds_policy.true_modulus_Pa, 1e-4}};
        return figures;
    }

private:
    /// Pose of a hold: tip [m] and its derivative by the modulus [m/Pa].
    struct Outcome {
        std::string message;  // empty: found
        Vector3d tip, by_modulus;
        bool ok() const { return message.empty(); }
    };

    /// Equilibrium of hold k with this modulus; adds steps, iterations and times to `figures`.
    Outcome hold(std::size_t k, double modulus_Pa, BenchFigures& figures) {
        model::Model model = bar_;
        model.force_elements[0] = model.force_elements[0]->with_command(fibre::Signal::constant(tensions_N_[k]));
        // Both moduli are proportional to Young's modulus at constant Poisson's ratio.
        for (material::Moduli& moduli : model.moduli) {
            moduli.mu *= modulus_Pa / holds_policy.true_modulus_Pa;
            moduli.kappa *= modulus_Pa / holds_policy.true_modulus_Pa;
        }
        options_.warm_start = paths_[k];
        const sensitivity::SensitiveTrace run = sensitivity::simulate_with_tangents(
            model, options_, {sensitivity::youngs_modulus_tangent(model, modulus_Pa)}, tip_nodes_);
        if (!run.trace.complete()) return {run.trace.message, {}, {}};
        paths_[k] = run.trace.path;
        ++figures.steps;
        figures.iterations_per_step += run.trace.newton_iterations;
        figures.factorisations_per_step += run.trace.factorisations;
        figures.times += run.trace.times;
        Outcome found{{}, run.trace.positions[0] * tip_, Vector3d::Zero()};
        for (std::size_t i = 0; i < tip_nodes_.size(); ++i)
            found.by_modulus += tip_(tip_nodes_[i]) * run.tangents[0].positions[0].col(static_cast<Eigen::Index>(i));
        return found;
    }

    model::Model bar_;
    Eigen::VectorXd tip_;
    std::vector<int> tip_nodes_;
    dynamics::SimulationOptions options_;
    std::vector<double> tensions_N_;
    std::vector<Vector3d> measured_;
    std::vector<std::shared_ptr<const dynamics::StagePath>> paths_;
};

}  // namespace

BenchCase bench_holds() {
    const auto fit = [](int count, const Eigen::Vector3i& bricks) {
        return [count, bricks] { return HoldsFit(count, bricks).run(); };
    };
    return {"holds",
            "calibration of static poses of a body pulled by a tendon",
            {{"10 small", fit(10, {20, 2, 2})}, {"300", fit(300, {34, 6, 6})}}};
}

}  // namespace myo::bench
