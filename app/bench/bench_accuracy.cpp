#include <memory>
#include <numbers>
#include <optional>

#include "base/text.hpp"
#include "bench/bar_meshes.hpp"
#include "bench/beam_run.hpp"
#include "bench/beam_statics.hpp"
#include "bench/bench_cases.hpp"
#include "bench/held_bar.hpp"
#include "dynamics/material_damping.hpp"
#include "material/strain_stiffening.hpp"
#include "model/internal_forces.hpp"
#include "model/rest_points.hpp"

namespace myo::bench {
namespace {

/// Target errors, relative. Volumetric stiffness resists bending most in nearly incompressible material.
constexpr double stiffness_target = 0.02, nearly_incompressible_target = 0.03, torsion_target = 0.06,
                 field_target = 0.05;

/// One mesh of the bar (length over height 40) at one Poisson's ratio.
struct AccuracyRow {
    std::string name;
    fem::ElementKind element = fem::ElementKind::hex8;
    Eigen::Vector3i bricks{40, 1, 1};
    Skew skew = Skew::none;
    double poissons_ratio = 0.49;
};

/// The default bar with the Poisson's ratio of the row.
BarShape bar_of(const AccuracyRow& row) {
    BarShape bar;
    bar.poissons_ratio = row.poissons_ratio;
    return bar;
}

/// Static deflection, first frequency and modal damping against beam theory.
void add_bending(const BarShape& bar, SmallMotions& motions, const Eigen::VectorXd& tip, BenchFigures& figures) {
    constexpr double gravity_m_s2 = 0.01;  // small: the formulas are linear
    const double target = bar.poissons_ratio > 0.49 ? nearly_incompressible_target : stiffness_target;
    const double sag = -gravity_m_s2 * (motions.under(motions.weight_N()) * tip).z();
    const BendingMode mode = motions.first_bending();
    const double expected_Hz = first_bending_rad_s(bar) / (2.0 * std::numbers::pi);
    figures.quantities.push_back(
        {"sag under 0.01 m/s2", 1e3 * sag, "mm", 1e3 * sag_under_gravity(bar, gravity_m_s2), target});
    figures.quantities.push_back(
        {"first frequency", mode.omega_rad_s / (2.0 * std::numbers::pi), "Hz", expected_Hz, target});
    figures.quantities.push_back({"damping ratio over omega damping_s / 2", mode.damping_factor, "",
                                  dynamics::slender_damping_factor(bar.poissons_ratio), field_target});
}

/// Torsional stiffness from the work of a unit torque.
void add_torsion(const BarShape& bar, const model::Model& model, SmallMotions& motions, BenchFigures& figures) {
    const Eigen::Matrix3Xd torque = unit_torque(*model.body);
    // Work of a unit torque is the mean rotation.
    const double stiffness = 1.0 / torque.cwiseProduct(motions.under(torque)).sum();
    figures.quantities.push_back(
        {"torsion stiffness", 1e3 * stiffness, "N mm", 1e3 * torsion_stiffness_N_m(bar), torsion_target});
}

/// A modulus that varies linearly over the thickness couples tension and bending.
void add_gradient(const BarShape& bar, model::Model model, const Eigen::VectorXd& tip, BenchFigures& figures) {
    // From half to one and a half times the modulus over the height.
    constexpr double relative_change = 1.0, pull_N = 2e-6;  // a strain of 3e-7: linear
    const auto z = model::rest_points(*model.body).row(2).transpose().array().eval();
    model.point_factors = (1.0 + relative_change * (z / bar.height_m - 0.5)).matrix();
    SmallMotions motions(model);
    const Eigen::Matrix3Xd pull = Eigen::Vector3d(pull_N, 0.0, 0.0) * tip.transpose();
    figures.quantities.push_back({"linear modulus: bend of the pulled bar", 1e3 * (motions.under(pull) * tip).z(), "mm",
                                  1e3 * deflection_of_graded_bar(bar, relative_change, pull_N), field_target});
}

/// Bending by a muscle in the upper half, linearised in its contraction.
void add_muscle(const BarShape& bar, model::Model model, const Eigen::VectorXd& tip, BenchFigures& figures) {
    constexpr double stiffness_Pa = 1e5, contraction = 1e-4;
    // The muscle fills the upper half, so its line of action is a quarter of the height off the axis.
    const Box upper{{-1.0, -1.0, 0.5 * bar.height_m}, {1.0, 1.0, 1.0}};
    model.fibres = std::make_shared<const std::vector<fibre::FibreGroup>>(std::vector<fibre::FibreGroup>{
        fibre::fibres_in_box(model.body->mesh, upper, Eigen::Vector3d::UnitX(), stiffness_Pa, "upper")});
    model.activation = {fibre::Signal::constant(1.0)};
    SmallMotions motions(model);
    const Eigen::Matrix3Xd pull = -model::activation_gradient(model, model.body->mesh.nodes, {-contraction});
    figures.quantities.push_back({"muscle of half the thickness: bend", 1e3 * (motions.under(pull) * tip).z(), "mm",
                                  1e3 * deflection_by_half_muscle(bar, stiffness_Pa, contraction), field_target});
}

/// Relative change of the deflection by a law [%] under an end force. The outer strain at the clamp is 6e-4 and the
/// deflection 1.7 % of the length, so that geometric nonlinearity is negligible.
class EndLoad {
public:
    EndLoad(const BarShape& bar, model::Model model, const Eigen::VectorXd& tip) : bar_(bar), model_(std::move(model)) {
        model::DeadForce down;
        down.share = tip;
        down.force_N = {0.0, 0.0, -force_N()};
        model_.forces.push_back(std::move(down));
    }

    double outer_strain() const {
        return force_N() * bar_.length_m / bar_.bending_stiffness_N_m2() * 0.5 * bar_.height_m;
    }

    /// Relative change of the deflection by a law, against beam theory with the same law.
    Result<BenchQuantity> change(const std::string& name, const StretchLaw& law) {
        if (!plain_m_)
            if (const Result<void> found = find_plain(); !found) return found.error();
        model::Model changed = model_;
        if (law.yeoh_c2 > 0.0) changed.material = material::strain_stiffening(changed.material, law.yeoh_c2);
        if (law.damage_max > 0.0) changed.softening = material::StressSoftening{law.damage_max, law.energy_scale_J_m3};
        const Result<double> other = deflection(changed);
        if (!other) return other.error();
        const double expected = end_load_deflection(bar_, law, force_N()) / end_load_deflection(bar_, {}, force_N()) -
                                1.0;
        return BenchQuantity{name + ": change of the deflection", 100.0 * (*other / *plain_m_ - 1.0), "%",
                             100.0 * expected, field_target};
    }

private:
    /// Force at the end whose linear deflection F L^3 / (3 EI) is 1.7 % of the length.
    double force_N() const { return 0.05 * bar_.bending_stiffness_N_m2() / (bar_.length_m * bar_.length_m); }

    /// Mean deflection of the free end [m], downwards, in nonlinear equilibrium.
    Result<double> deflection(const model::Model& model) const {
        const Result<Eigen::Matrix3Xd> x = beam_equilibrium(model);
        if (!x) return x.error();
        return -((*x - model.body->mesh.nodes) * model.forces.front().share).z();
    }

    /// Deflection with the plain law, to which all changes refer.
    Result<void> find_plain() {
        const Result<double> found = deflection(model_);
        if (!found) return found.error();
        plain_m_ = *found;
        return {};
    }

    BarShape bar_;
    model::Model model_;
    std::optional<double> plain_m_;  // deflection with the linear law, computed once
};

/// Change of the deflection by strain stiffening and by stress softening.
Result<void> add_laws(const BarShape& bar, const model::Model& model, const Eigen::VectorXd& tip,
                      BenchFigures& figures) {
    EndLoad load(bar, model, tip);
    // The coefficients are chosen so that the effect is large: the stress of the outer fibre at the clamp doubles (nu
    // close to 1/2), and its energy is half of the softening scale.
    const double strain = load.outer_strain();
    const StretchLaw stiffening{1.0 / (6.0 * strain * strain), 0.0, 1.0};
    const StretchLaw softening{0.0, 0.3, bar.youngs_modulus_Pa * strain * strain};
    for (const auto& [name, law] : {std::pair{"strain stiffening", stiffening}, {"stress softening", softening}}) {
        const Result<BenchQuantity> quantity = load.change(name, law);
        if (!quantity) return quantity.error();
        figures.quantities.push_back(*quantity);
    }
    return {};
}

/// All quantities of one mesh.
Result<BenchFigures> measure_accuracy(const AccuracyRow& row) {
    const double start = thread_time_s();
    const BarShape bar = bar_of(row);
    const mesh::VolumeMesh mesh = bar_mesh(bar, row.element, row.bricks, row.skew);
    const model::Model model = held_bar(bar, row.element, mesh);
    // Effects that vary within cells use their own element, as in every experiment.
    const model::Model fine = held_bar(bar, fem::fine_element(row.element), mesh);
    const Eigen::VectorXd tip = free_end_share(*model.body);
    BenchFigures figures;
    figures.dofs = model.body->dofs();
    figures.cells = model.body->cell_count();
    figures.name = row.name + ", " + std::to_string(figures.dofs) + " DOF";
    SmallMotions motions(model);
    add_bending(bar, motions, tip, figures);
    add_torsion(bar, model, motions, figures);
    if (const Result<void> done = add_laws(bar, fine, tip, figures); !done) return done.error();
    add_gradient(bar, fine, tip, figures);
    add_muscle(bar, model, tip, figures);
    figures.run_s = thread_time_s() - start;
    return figures;
}

/// Mid-nodes count: with bricks twice as long, tetrahedra have as many nodes along the bar as hexahedra.
double usual_aspect(fem::ElementKind element) { return fem::cell_type(element) == mesh::CellType::tet10 ? 2.0 : 1.0; }

/// "hex8, 2 layers".
std::string with_layers(fem::ElementKind element, int layers) {
    return to_string(element) + ", " + std::to_string(layers) + (layers == 1 ? " layer" : " layers");
}

}  // namespace

BenchCase bench_accuracy() {
    BenchCase result{
        "accuracy",
        "a bar of 200 x 5 x 5 mm against beam theory: layers, Poisson's ratio (0.49 where not stated), long "
        "and skewed cells",
        {}};
    const auto add = [&](const AccuracyRow& row) {
        result.runs.push_back({row.name, [row] { return measure_accuracy(row); }});
    };
    // Three series per element: layers and Poisson's ratio, aspect ratio, distortion.
    for (const fem::ElementKind element : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        for (const int layers : {1, 2, 4})
            for (const double nu : {0.0, 0.3, 0.49, 0.4995})
                add({with_layers(element, layers) + ", nu " + format_number(nu), element,
                     bar_bricks({}, layers, usual_aspect(element)), Skew::none, nu});
        for (const double aspect : {1.0, 3.0, 10.0})
            add({with_layers(element, 1) + ", cells " + format_number(aspect) + " times as long as thick", element,
                 bar_bricks({}, 1, aspect)});
        for (const Skew skew : {Skew::plan, Skew::side, Skew::nodes})
            for (const int layers : {1, 2})
                add({with_layers(element, layers) + ", " + name_of(skew), element,
                     bar_bricks({}, layers, usual_aspect(element)), skew});
    }
    return result;
}

}  // namespace myo::bench
