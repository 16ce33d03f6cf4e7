#include "inverse/design.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "fibre/cell_parts.hpp"
#include "inverse/actuated_beam.hpp"
#include "inverse/fibre_amount.hpp"
#include "inverse/fibre_turn.hpp"
#include "inverse/part_moduli.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"

// Fibre directions, painted weights and moduli as unknowns of a search: exact gradients, and truths found again.

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::actuated_beam;
using test::wave;

/// The lower muscle of the beam with points of weight 1 in its cells and those above, and its paint.
fibre::CellPaint give_room_to_grow(ActuationProblem& problem) {
    const mesh::VolumeMesh& mesh = problem.model.body->mesh;
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>(*problem.model.fibres);
    fibre::FibreGroup& lower = fibres->front();
    const fibre::CellPaint paint = fibre::paint_of_group(mesh, lower),
                           reach = fibre::grown(paint, mesh::neighbouring_cells(mesh));
    fibre::FibreGroup room{lower.name, lower.stiffness_Pa, {}, {}};
    for (Index c = 0; c < reach.count(); ++c)
        if (reach.weights(c) > 0.0)
            fibre::add_whole_cell(
                mesh, static_cast<int>(c), 1.0, [](const Vector3d&) { return Vector3d::UnitX(); }, room);
    lower = room;
    problem.model.fibres = fibres;
    return paint;
}

/// Shares of two parts, the half at the clamp and the rest, with a layer of mixed cells between them.
std::vector<std::vector<material::Moduli>> two_parts(const model::Model& model) {
    std::vector<std::vector<material::Moduli>> shares(2, model.moduli);
    const mesh::VolumeMesh& mesh = model.body->mesh;
    for (std::size_t c = 0; c < model.moduli.size(); ++c) {
        double x = 0.0;
        for (const int node : mesh.cells.col(static_cast<Index>(c))) x += mesh.nodes(0, node) / 8.0;
        const double part = x < 0.04 ? 1.0 : x < 0.06 ? 0.3 : 0.0;
        for (std::size_t k = 0; k < 2; ++k) {
            const double share = k == 0 ? part : 1.0 - part;
            shares[k][c].mu *= share, shares[k][c].kappa *= share;
        }
    }
    return shares;
}

/// Everything at once: a smooth field of turns, a uniform turn, weights, and the moduli of two parts.
ActuationProblem with_everything() {
    ActuationProblem problem = actuated_beam(false, true, false);
    const fibre::CellPaint paint = give_room_to_grow(problem);
    const mesh::VolumeMesh& mesh = problem.model.body->mesh;
    const std::vector<fibre::FibreGroup>& fibres = *problem.model.fibres;
    std::vector<std::vector<material::Moduli>> shares = two_parts(problem.model);
    problem.design = {fibre_turn(mesh, 0, fibres[0], TurnField::smooth),
                      fibre_turn(mesh, 1, fibres[1], TurnField::uniform), fibre_amount(mesh, 0, fibres[0], paint),
                      part_moduli({{"root", shares[0]}, {"tip", shares[1]}},
                                  std::vector<material::Moduli>(shares[0].size(), material::Moduli{0.0, 0.0}))};
    return problem;
}

/// Values away from the declared ones, within the bounds.
VectorXd moved(const Design& design) {
    const DesignBounds bounds = design_bounds(design);
    VectorXd values = declared_design(design);
    for (Index i = 0; i < values.size(); ++i) values(i) += 0.1 * std::sin(1.0 + 1.7 * static_cast<double>(i));
    return values.cwiseMax(bounds.lower).cwiseMin(bounds.upper).cwiseMax(VectorXd::Constant(values.size(), -0.3));
}

TEST(Design, LossHasTheGradientOfItsDifferences) {
    ActuationProblem p = with_everything();
    test::aim_at(p, wave(p.sought));
    p.design_smoothness_m = 1e-4;
    p.smoothness_m_s = 1e-4;
    p.options.solver.tolerance = p.options.solver.tangent_tolerance = 1e-11;
    const MatrixXd signals = wave(p.sought);
    const VectorXd at = moved(p.design);
    const ActuationEvaluation here = evaluate_actuation(p, signals, at);
    ASSERT_TRUE(here.ok()) << here.message;
    // One value of each kind, two of the field and of the weights.
    Index first = 0;
    std::vector<Index> checked;
    for (const DesignVariablePointer& variable : p.design) {
        const Index count = variable->declared().size();
        for (const Index i : {Index{1}, count / 2, count - 1})
            if (checked.empty() || first + i > checked.back()) checked.push_back(first + i);
        first += count;
    }
    std::vector<double> errors;
    for (const Index i : checked) {
        double difference = 0.0;
        for (const double side : {-2.0, -1.0, 1.0, 2.0}) {
            VectorXd x = at;
            constexpr double h = 2e-3;
            x(i) += side * h;
            const double weight = (side > 0.0 ? 1.0 : -1.0) * (std::abs(side) > 1.5 ? -1.0 : 8.0) / (12.0 * h);
            difference += weight * evaluate_actuation(p, signals, x).loss_m2;
        }
        const double scale = std::max(std::abs(here.design_gradient(i)),
                                      1e-4 * here.design_gradient.cwiseAbs().maxCoeff());
        errors.push_back(std::abs(here.design_gradient(i) - difference) / scale);
        EXPECT_LT(errors.back(), 1e-4) << "value " << i << ": " << here.design_gradient(i) << " for " << difference;
    }
    test::record("relative_error", errors);
}

/// The model with the declared values is the model itself.
TEST(Design, DeclaredValuesChangeNothing) {
    const ActuationProblem p = with_everything();
    const model::Model same = designed_model(p.design, declared_design(p.design), p.model);
    for (std::size_t c = 0; c < p.model.moduli.size(); ++c)
        EXPECT_NEAR(same.moduli[c].mu, p.model.moduli[c].mu, 1e-12 * p.model.moduli[c].mu);
    for (std::size_t k = 0; k < same.fibres->back().points.size(); ++k)
        EXPECT_LT((same.fibres->back().points[k].shape - p.model.fibres->back().points[k].shape).norm(), 1e-9);
    VectorXd gradient = VectorXd::Zero(declared_design(p.design).size());
    EXPECT_EQ(design_roughness(p.design, declared_design(p.design), 1.0, gradient), 0.0);
}

/// A search that has only `design` to change, towards the motion that the model makes with `truth`.
ActuationFit found_again(ActuationProblem& p, const VectorXd& truth) {
    p.sought.groups.clear();
    const std::vector<fibre::Signal> signals = commands_of(actuated_beam(false, true, false).sought,
                                                           wave(actuated_beam(false, true, false).sought));
    for (const fibre::Signal& signal : signals) p.sought.groups.push_back({.own = signal});
    p.sought.signals.clear();
    p.design_smoothness_m = 0.0;
    const MatrixXd none(0, 1);
    p.target.positions_m.assign(p.target.markers.bindings.size(), Eigen::Matrix3Xd::Zero(3, p.target.times_s.size()));
    p.target.positions_m = target_residuals(p.target, evaluate_actuation(p, none, truth).motion);
    ActuationFitOptions options;
    options.max_evaluations = 200;
    options.relative_decrease = 1e-9;
    return fit_actuation(p, none, options);
}

TEST(Design, FindsHowTheFibresOfAMuscleWereTurned) {
    ActuationProblem p = actuated_beam(false, true, false);
    p.target.markers = measurement::marker_set(
        p.model.body->mesh, {{0.1, 0.0, 0.03}, {0.1, 0.03, 0.03}, {0.1, 0.015, 0.0}, {0.06, 0.015, 0.03}});
    p.design = {fibre_turn(p.model.body->mesh, 1, (*p.model.fibres)[1], TurnField::uniform)};
    // About z: fibres along x have no other turn within their layer; the turn about x is none.
    const ActuationFit fit = found_again(p, Vector3d(0.0, 0.0, 20.0 * std::numbers::pi / 180.0));
    ASSERT_TRUE(fit.usable()) << fit.message;
    test::record("found_rad", std::vector<double>(fit.design.begin(), fit.design.end()));
    test::record("rms_m", std::vector<double>{fit.first.rms_m, fit.best.rms_m});
    EXPECT_LT(fit.best.rms_m, 1e-3 * fit.first.rms_m);
    EXPECT_NEAR(fit.design(2), 20.0 * std::numbers::pi / 180.0, 2e-3);
}

TEST(Design, FindsTheModuliOfTwoParts) {
    ActuationProblem p = actuated_beam(false, true, false);
    std::vector<std::vector<material::Moduli>> shares = two_parts(p.model);
    p.design = {part_moduli({{"root", shares[0]}, {"tip", shares[1]}},
                            std::vector<material::Moduli>(shares[0].size(), material::Moduli{0.0, 0.0}))};
    const ActuationFit fit = found_again(p, Eigen::Vector2d(std::log(1.4), std::log(0.7)));
    ASSERT_TRUE(fit.usable()) << fit.message;
    test::record("factors", std::vector<double>{std::exp(fit.design(0)), std::exp(fit.design(1))});
    EXPECT_NEAR(std::exp(fit.design(0)), 1.4, 1e-3 * 1.4);
    EXPECT_NEAR(std::exp(fit.design(1)), 0.7, 1e-2 * 0.7);
}

/// Many weights make the same motion; the loss says whether one of them was found, the bounds that they are shares.
TEST(Design, WeightsReachAMotionOfOtherWeights) {
    ActuationProblem p = actuated_beam(false, true, false);
    const fibre::CellPaint paint = give_room_to_grow(p);
    p.design = {fibre_amount(p.model.body->mesh, 0, (*p.model.fibres)[0], paint)};
    VectorXd truth = declared_design(p.design);
    for (Index i = 0; i < truth.size(); ++i) truth(i) = truth(i) > 0.0 ? 0.5 * truth(i) : 0.4;
    const ActuationFit fit = found_again(p, truth);
    ASSERT_TRUE(fit.usable()) << fit.message;
    test::record("rms_m", std::vector<double>{fit.first.rms_m, fit.best.rms_m});
    EXPECT_LT(fit.best.rms_m, 0.01 * fit.first.rms_m);
    EXPECT_GE(fit.design.minCoeff(), 0.0);
    EXPECT_LE(fit.design.maxCoeff(), 1.0);
    EXPECT_GT((fit.design - declared_design(p.design)).cwiseAbs().maxCoeff(), 0.05);
}

}  // namespace
}  // namespace myo::inverse
