#include "panels/body_panel.hpp"
#include "panels/chamber_panel.hpp"
#include "panels/checks_panel.hpp"
#include "panels/diagnose_panel.hpp"
#include "panels/effect_panel.hpp"
#include "panels/fibre_panel.hpp"
#include "panels/fit_panel.hpp"
#include "panels/goal_panel.hpp"
#include "panels/import_panel.hpp"
#include "panels/jobs_panel.hpp"
#include "panels/live_panel.hpp"
#include "panels/log_panel.hpp"
#include "panels/marker_panel.hpp"
#include "panels/material_panel.hpp"
#include "panels/measure_panel.hpp"
#include "panels/mesh_panel.hpp"
#include "panels/obstacle_panel.hpp"
#include "panels/panel.hpp"
#include "panels/part_panel.hpp"
#include "panels/probe_panel.hpp"
#include "panels/recording_panel.hpp"
#include "panels/report_panel.hpp"
#include "panels/run_panel.hpp"
#include "panels/search_panel.hpp"
#include "panels/signal_panel.hpp"
#include "panels/summary_panel.hpp"
#include "panels/support_panel.hpp"
#include "panels/tendon_panel.hpp"
#include "panels/time_panel.hpp"
#include "panels/trial_panel.hpp"
#include "panels/unknown_panel.hpp"
#include "panels/verdict_panel.hpp"

namespace myo::ui::panels {

// The order determines the order of panels within a task, and of the tabs below the view.
std::vector<std::unique_ptr<Panel>> all_panels() {
    std::vector<std::unique_ptr<Panel>> panels;
    const auto add = [&panels]<class T>(std::type_identity<T>) { panels.push_back(std::make_unique<T>()); };
    // Panels at the side, in the order of the tasks.
    add(std::type_identity<BodyPanel>());
    add(std::type_identity<SupportPanel>());
    add(std::type_identity<ObstaclePanel>());
    add(std::type_identity<MeshPanel>());
    add(std::type_identity<MaterialPanel>());
    add(std::type_identity<PartPanel>());
    add(std::type_identity<FibrePanel>());
    add(std::type_identity<TendonPanel>());
    add(std::type_identity<ChamberPanel>());
    add(std::type_identity<TrialPanel>());
    add(std::type_identity<TimePanel>());
    add(std::type_identity<LivePanel>());
    add(std::type_identity<RunPanel>());
    add(std::type_identity<ProbePanel>());
    add(std::type_identity<MeasurePanel>());
    add(std::type_identity<ImportPanel>());
    add(std::type_identity<UnknownPanel>());
    add(std::type_identity<EffectPanel>());
    add(std::type_identity<GoalPanel>());
    add(std::type_identity<FitPanel>());
    add(std::type_identity<VerdictPanel>());
    add(std::type_identity<ReportPanel>());
    // Panels below the view; the first one is in front at the start.
    add(std::type_identity<MarkerPanel>());
    add(std::type_identity<RecordingPanel>());
    add(std::type_identity<SignalPanel>());
    add(std::type_identity<SearchPanel>());
    add(std::type_identity<DiagnosePanel>());
    add(std::type_identity<ChecksPanel>());
    add(std::type_identity<JobsPanel>());
    add(std::type_identity<SummaryPanel>());
    add(std::type_identity<LogPanel>());
    return panels;
}

}  // namespace myo::ui::panels
