#include <algorithm>

#include "commands/part_edits.hpp"
#include "commands/workbench.hpp"

// Parts of the body: where they are on the shown mesh, and their paint.

namespace myo::ui::commands {
namespace {

/// What a part holds of the shown body, as paint.
fibre::CellPaint held_by(const WorkbenchState& state, std::size_t part) {
    fibre::CellPaint paint = fibre::blank_paint(state.body->mesh);
    const auto column = static_cast<Eigen::Index>(part) + 1;
    if (state.part_shares.rows() != paint.count() || state.part_shares.cols() <= column) return paint;
    paint.weights = state.part_shares.col(column);
    // A mask has directions, which mean nothing for a part.
    paint.directions.row(0) = (paint.weights.array() > 0.0).cast<double>().transpose();
    return paint;
}

}  // namespace

void Workbench::on(const PaintPart& c) {
    if (!state_.scene || !state_.scene->is_experiment || !state_.body || c.part > state_.scene->parts.size()) return;
    const auto paint = c.paint ? c.paint : std::make_shared<const fibre::CellPaint>(held_by(state_, c.part));
    // The mesh has been replaced since the stroke began.
    if (paint->count() != state_.body->mesh.cell_count()) return;
    const auto mask = std::make_shared<const fibre::PaintedMask>(fibre::mask_of_cells(state_.body->mesh, *paint));
    if (mask->count() == 0) {
        refuse({"a painted part needs at least one element; remove the part instead", ""});
        return;
    }
    placed_.remember(state_.body, mask, paint);
    std::vector<DeclarationEdit> edits;
    if (c.part == state_.scene->parts.size()) edits.push_back(AppendDeclared{{"part"}, new_part(state_, "")});
    edits.push_back(PaintDeclared{c.part, mask});
    const std::string item = "part/" + std::to_string(c.part);
    on(EditDeclaration{std::move(edits), item + "/paint"});
    // A part that the stroke has declared is shown in the list.
    if (c.part < state_.scene->parts.size()) state_.view.edited = item;
}

void Workbench::place_parts() {
    state_.part_shares = state_.body && !state_.scene->parts.empty()
                             ? backend_->part_shares(*state_.scene, *state_.body)
                             : Eigen::MatrixXd();
}

void Workbench::follow_parts(const std::vector<ScenePart>& before) {
    if (state_.brush.part < 0) return;
    const auto index = static_cast<std::size_t>(state_.brush.part);
    const std::vector<ScenePart>& now = state_.scene->parts;
    // The first stroke declares the part behind the last one, and undo takes it back.
    bool same = index <= now.size();
    for (std::size_t k = 0; k < std::min({index + 1, before.size(), now.size()}); ++k)
        same = same && before[k].name == now[k].name;
    if (same && (index == now.size() || now[index].mask)) return;
    state_.brush.part = -1;
    state_.brush.tool = BrushTool::none;
}

}  // namespace myo::ui::commands
