#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

// Texts that the summary in the menu bar and the panel share.
inline constexpr const char* checks_panel_name = "checks";  // panel name
inline constexpr const char* no_checks_text =
    "Checks appear once an experiment is open: whether its units, support, mesh, time step, start and recordings can "
    "be trusted, and after a run, a calibration or a diagnosis what that brought.";
inline constexpr const char*
    stale_checks_text = "The settings changed since: these are the checks of earlier settings.";

/// Results of the checks of the experiment and the newest job, most severe first, each with what the user can do.
///
/// Emits nothing. Links in other panels bring it to the front. Item names begin with "checks/".
class ChecksPanel : public Panel {
public:
    std::string name() const override { return checks_panel_name; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    void draw(PanelContext& context) override;

private:
    /// Counts of the states, the job they belong to, and a note if they are outdated.
    void draw_head(PanelContext& context);
    /// Table of the checks: five columns if there is room, otherwise two.
    void draw_rows(PanelContext& context);
};

}  // namespace myo::ui::panels
