#pragma once

#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "panels/panel.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// The recording that is being imported: the coordinates of a label over the file's time, and what the cameras saw of
/// each.
class RecordingPanel : public Panel {
public:
    std::string name() const override { return "recording"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    bool offered(const commands::WorkbenchState& state) const override { return state.import != nullptr; }
    void draw(PanelContext& context) override;

private:
    void draw_gaps(PanelContext& context, const plot::PlotArea& area, float height);

    std::shared_ptr<const measurement::Recording> recording_;   // of the curves and gaps below
    std::vector<std::vector<std::pair<double, double>>> seen_;  // per label, when it was seen [s]
    plot::LinkedAxis time_;
    std::array<plot::PlotState, 3> plots_;
    plot::HiddenSeries hidden_;
};

}  // namespace myo::ui::panels
