#include "calibration/body_design.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/text.hpp"
#include "fibre/cell_parts.hpp"
#include "inverse/fibre_amount.hpp"
#include "inverse/fibre_turn.hpp"
#include "inverse/part_moduli.hpp"

namespace myo::calibration {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Whether a quantity of the muscle or part with this name is sought.
bool seeks(const std::vector<SoughtItem>& items, SoughtKind kind, const std::string& of) {
    return std::find(items.begin(), items.end(), SoughtItem{kind, of}) != items.end();
}

/// Index of the muscle or part that an item names.
template <class Declarations>
std::size_t index_of(const Declarations& declared, const std::string& name) {
    const auto found = std::find_if(declared.begin(), declared.end(),
                                    [&](const auto& each) { return each.name == name; });
    return static_cast<std::size_t>(found - declared.begin());
}

/// Fibres of a paint: whole cells, of weight 1 if `full`.
fibre::FibreGroup group_of_paint(const mesh::VolumeMesh& mesh, const fibre::CellPaint& paint,
                                 const fibre::FibreGroup& like, bool full) {
    fibre::FibreGroup group{like.name, like.stiffness_Pa, {}, {}};
    for (Index c = 0; c < paint.count(); ++c) {
        if (!(paint.weights(c) > 0.0)) continue;
        const Vector3d direction = paint.directions.col(c);
        fibre::add_whole_cell(
            mesh, static_cast<int>(c), full ? 1.0 : paint.weights(c), [&](const Vector3d&) { return direction; },
            group);
    }
    return group;
}

/// Gives the models of all trials these fibres of a muscle; the fibres of prepared models are shared and constant.
void replace_group(setup::Setup& setup, std::size_t muscle, const fibre::FibreGroup& group) {
    for (setup::PreparedTrial& trial : setup.trials) {
        auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>(*trial.model.fibres);
        (*fibres)[muscle] = group;
        trial.model.fibres = std::move(fibres);
    }
}

/// Adds direction and weights of a muscle, as sought.
void add_muscle(setup::Setup& setup, const std::vector<SoughtItem>& seek, std::size_t muscle, BodyDesign& design) {
    const mesh::VolumeMesh& mesh = setup.mesh.mesh;
    const experiment::MuscleDeclaration& declared = setup.experiment.muscles[muscle];
    fibre::FibreGroup group = (*setup.trials.front().model.fibres)[muscle];
    const bool turns = seeks(seek, SoughtKind::direction, declared.name),
               amounts = seeks(seek, SoughtKind::weights, declared.name);
    const auto* const mask = std::get_if<experiment::MuscleMask>(&declared.part);
    // Painted directions may differ from cell to cell and then turn as a smooth field; one direction turns as a whole.
    const bool field = mask && !mask->fibre;
    fibre::CellPaint paint;
    // Weights of whole cells, as a mask painted on this mesh has them, so that the result can be written as such a
    // mask.
    if (amounts || (turns && field)) {
        paint = fibre::paint_of_group(mesh, group);
        fibre::CellPaint reach = paint;
        if (amounts) {
            // Cells next to the paint take part with weight 0, so that the muscle may grow into them.
            reach = fibre::grown(paint, mesh::neighbouring_cells(mesh));
            paint.directions = reach.directions;
        }
        group = group_of_paint(mesh, reach, group, amounts);
        replace_group(setup, muscle, group);
    }
    if (turns) {
        design.items.push_back({{SoughtKind::direction, declared.name}, design.variables.size(), 0, muscle, paint});
        design.variables.push_back(
            inverse::fibre_turn(mesh, muscle, group, field ? inverse::TurnField::smooth : inverse::TurnField::uniform));
    }
    if (amounts) {
        design.items.push_back({{SoughtKind::weights, declared.name}, design.variables.size(), 0, muscle, paint});
        design.variables.push_back(inverse::fibre_amount(mesh, muscle, group, paint));
        // The models keep the declared weights until values are applied.
        for (setup::PreparedTrial& trial : setup.trials)
            design.variables.back()->apply(design.variables.back()->declared(), trial.model);
    }
}

/// Adds the sought moduli as one variable.
void add_moduli(const setup::Setup& setup, const std::vector<SoughtItem>& seek, BodyDesign& design) {
    const experiment::Experiment& experiment = setup.experiment;
    const model::Model& model = setup.trials.front().model;
    const auto cells = static_cast<std::size_t>(setup.body->cell_count());
    const setup::MaterialValues all = setup::declared_materials(experiment, model.damping_s);
    std::vector<inverse::SoughtModulus> sought;
    // Moduli of what is not sought, per cell; sought shares are added to them times their factor.
    std::vector<material::Moduli> rest(cells, material::Moduli{0.0, 0.0});
    for (std::size_t k = 0; k <= experiment.parts.size(); ++k) {
        const std::string name = k == 0 ? "" : experiment.parts[k - 1].name;
        const double modulus = k == 0 ? all.youngs_modulus_Pa : all.part_modulus_Pa[k - 1],
                     ratio = k == 0 ? experiment.material.poissons_ratio : experiment.parts[k - 1].poissons_ratio;
        const material::Moduli own = material::moduli_from_young(modulus, ratio);
        std::vector<material::Moduli> share(cells);
        for (std::size_t c = 0; c < cells; ++c) {
            // Without parts the body's material fills every cell.
            const double part = setup.part_shares.size() == 0
                                    ? 1.0
                                    : setup.part_shares(static_cast<Index>(c), static_cast<Index>(k));
            share[c] = {part * own.mu, part * own.kappa};
        }
        if (!seeks(seek, SoughtKind::modulus, name)) {
            for (std::size_t c = 0; c < cells; ++c) rest[c].mu += share[c].mu, rest[c].kappa += share[c].kappa;
            continue;
        }
        design.items.push_back({{SoughtKind::modulus, name},
                                design.variables.size(),
                                static_cast<Index>(sought.size()),
                                k == 0 ? 0 : k - 1});
        sought.push_back({k == 0 ? "the body" : name, std::move(share)});
    }
    if (!sought.empty()) design.variables.push_back(inverse::part_moduli(std::move(sought), std::move(rest)));
}

/// Largest angle between two fields of fibres where there is paint; opposite directions are the same [degrees].
double largest_turn_deg(const fibre::CellPaint& before, const fibre::CellPaint& after) {
    double largest = 0.0;
    for (Index c = 0; c < after.count(); ++c)
        if (before.weights(c) > 0.0 && after.weights(c) > 0.0)
            largest = std::max(largest, std::atan2(before.directions.col(c).cross(after.directions.col(c)).norm(),
                                                   std::abs(before.directions.col(c).dot(after.directions.col(c)))));
    return largest * 180.0 / std::numbers::pi;
}

/// States the change of a quantity in numbers and words.
void state_change(double before, double after, const std::string& unit, FoundItem& found) {
    found.before = before;
    found.after = after;
    found.unit = unit;
    found.change = "from " + format_number(before, 4) + " to " + format_number(after, 4) + " " + unit;
}

/// States a turn [degrees]; `everywhere`: all fibres turn by it, otherwise it is the largest of them.
void state_turn(double degrees, bool everywhere, FoundItem& found) {
    found.after = degrees;
    found.unit = "°";
    found.change = std::string(everywhere ? "turned by " : "turned by up to ") + format_number(degrees, 3) + "°";
}

/// Volume of a muscle, cells weighted by their paint [cm3].
double volume_cm3(const mesh::VolumeMesh& mesh, const fibre::CellPaint& paint) {
    return 1e6 * fibre::amount_of(paint, mesh::cell_volumes(mesh)).volume_m3;
}

/// Direction or weights of a muscle.
FoundItem found_muscle(const setup::Setup& setup, const DesignedItem& designed, const model::Model& model) {
    const mesh::VolumeMesh& mesh = setup.mesh.mesh;
    const fibre::FibreGroup& group = (*model.fibres)[designed.index];
    FoundItem found{.item = designed.item, .index = designed.index};
    const fibre::CellPaint now = fibre::paint_of_group(mesh, group);
    const auto& part = setup.experiment.muscles[designed.index].part;
    const auto* const box = std::get_if<experiment::MuscleBox>(&part);
    const auto* const mask = std::get_if<experiment::MuscleMask>(&part);
    const std::optional<Vector3d> one = box ? std::optional(box->fibre) : mask->fibre;
    if (designed.paint.count() > 0) found.mask = std::make_shared<fibre::PaintedMask>(fibre::mask_of_cells(mesh, now));
    if (designed.item.kind == SoughtKind::weights) {
        state_change(volume_cm3(mesh, designed.paint), volume_cm3(mesh, now), "cm³", found);
    } else if (one) {
        // All fibres turn by one rotation: the direction of any cell with muscle, on the side of the declared one.
        Index cell = 0;
        now.weights.maxCoeff(&cell);
        const Vector3d direction = now.directions.col(cell);
        found.fibre = direction.dot(*one) < 0.0 ? Vector3d(-direction) : direction;
        state_turn(std::atan2(one->cross(*found.fibre).norm(), one->dot(*found.fibre)) * 180.0 / std::numbers::pi, true,
                   found);
    } else {
        state_turn(largest_turn_deg(designed.paint, now), false, found);
    }
    return found;
}

/// Modulus of a part or the body. `value`: ln of the found modulus over the declared one.
FoundItem found_modulus(const setup::Setup& setup, const DesignedItem& designed, double value) {
    const double declared = designed.item.of.empty() ? setup.experiment.material.youngs_modulus_Pa
                                                     : setup.experiment.parts[designed.index].youngs_modulus_Pa;
    FoundItem found{.item = designed.item, .index = designed.index};
    found.youngs_modulus_Pa = std::exp(value) * declared;
    state_change(1e-3 * declared, 1e-3 * found.youngs_modulus_Pa, "kPa", found);
    if (std::abs(value) >= std::log(inverse::part_moduli_policy.most)) found.change += ", the bound of the search";
    return found;
}

}  // namespace

Result<BodyDesign> body_design(setup::Setup& setup, const std::vector<SoughtItem>& seek) {
    BodyDesign design;
    for (std::size_t m = 0; m < setup.experiment.muscles.size(); ++m) {
        const std::string& name = setup.experiment.muscles[m].name;
        if (!seeks(seek, SoughtKind::direction, name) && !seeks(seek, SoughtKind::weights, name)) continue;
        if (setup.mesh.shrunk_from)
            return Error{"fibres cannot be sought on truncated voxels, whose mesh is smaller than the body",
                         "--voxels"};
        if ((*setup.trials.front().model.fibres)[m].points.empty())
            return Error{"muscle \"" + name + "\" has no material on this mesh, so that nothing can be sought of it",
                         ""};
        add_muscle(setup, seek, m, design);
    }
    add_moduli(setup, seek, design);
    return design;
}

setup::Setup with_design(setup::Setup setup, const inverse::Design& design, const VectorXd& values) {
    if (design.empty()) return setup;
    for (setup::PreparedTrial& trial : setup.trials)
        trial.model = inverse::designed_model(design, values, std::move(trial.model));
    return setup;
}

std::vector<FoundItem> found_items(const setup::Setup& setup, const BodyDesign& design, const VectorXd& values) {
    const model::Model model = inverse::designed_model(design.variables, values, setup.trials.front().model);
    std::vector<FoundItem> items;
    for (const DesignedItem& designed : design.items)
        items.push_back(
            designed.item.kind == SoughtKind::modulus
                ? found_modulus(setup, designed,
                                inverse::values_of(design.variables, designed.variable, values)(designed.value))
                : found_muscle(setup, designed, model));
    return items;
}

}  // namespace myo::calibration
