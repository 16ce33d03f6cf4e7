#include "commands/scene_at_time.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "commands/actuator_drawing.hpp"
#include "commands/body_cut.hpp"
#include "commands/force_arrows.hpp"
#include "commands/import_drawing.hpp"
#include "commands/muscle_drawing.hpp"
#include "commands/rest_outline.hpp"
#include "commands/setup_drawing.hpp"
#include "commands/support_drawing.hpp"
#include "viewport/color_map.hpp"
#include "viewport/scene_lines.hpp"

namespace myo::ui::commands {
namespace {

constexpr double trail_s = 0.5;  // length of the trails

// Bounding box of points that are added one after the other. Points that are not finite are ignored.
struct Bounds {
    Box box;
    bool empty = true;

    void include(const Eigen::Matrix3Xd& points) {
        for (Eigen::Index i = 0; i < points.cols(); ++i) {
            if (!points.col(i).allFinite()) continue;
            box.lowest = empty ? Eigen::Vector3d(points.col(i)) : box.lowest.cwiseMin(points.col(i)).eval();
            box.highest = empty ? Eigen::Vector3d(points.col(i)) : box.highest.cwiseMax(points.col(i)).eval();
            empty = false;
        }
    }
};

/// Bounds of body and markers at rest.
Bounds rest_bounds(const WorkbenchState& state) {
    Bounds bounds;
    if (state.body) bounds.include(state.body->mesh.nodes);
    if (state.scene) {
        if (!state.body) bounds.include(state.scene->surface.vertices);
        for (const SceneMarker& marker : state.scene->markers) bounds.include(marker.rest_m);
    }
    return bounds;
}

// Samples of a track in [t - trail_s, t].
Eigen::Matrix3Xd trail(const Eigen::Matrix3Xd& track, const Eigen::VectorXd& time_s, double t) {
    const double* begin = time_s.data();
    const auto first = std::lower_bound(begin, begin + time_s.size(), t - trail_s) - begin;
    const auto last = std::upper_bound(begin, begin + time_s.size(), t) - begin;
    return track.middleCols(first, std::max<std::ptrdiff_t>(0, last - first));
}

/// Adds a polyline. A single point is no line.
void add_line(viewport::DrawnScene& scene, Eigen::Matrix3Xd points, const viewport::Color& color, double width) {
    if (points.cols() > 1) scene.lines.push_back({std::move(points), color, width});
}

/// Marker m of the simulation, with its trail and the line from the measured one.
void add_simulated_marker(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme,
                          std::size_t m, const TimePlace& place) {
    const SceneTrial* trial = state.scene_trial();
    const SimulatedTrial* simulated = state.simulated_trial();
    const ViewOptions& view = state.view;
    const Eigen::Vector3d measured = at_time(trial->measured[m], place);
    if (!simulated || !view.simulated || m >= simulated->markers.size() ||
        simulated->markers[m].cols() != trial->time_s.size())
        return;
    const Eigen::Vector3d predicted = at_time(simulated->markers[m], place);
    // The label belongs to the measured marker while that is visible.
    drawn.markers.push_back({predicted, viewport::color_of(theme.simulated), true,
                             measured.allFinite() && view.measured ? "" : state.scene->markers[m].name,
                             static_cast<int>(m)});
    if (view.trails) {
        add_line(drawn, trail(simulated->markers[m], trial->time_s, state.time_s),
                 viewport::color_of(theme.simulated, 0.75f), 1.5);
    }
    if (view.errors && view.measured) {
        Eigen::Matrix3Xd whisker(3, 2);
        whisker << measured, predicted;
        add_line(drawn, whisker, viewport::color_of(theme.failure), 2.0);
    }
}

/// Whether a marker is neither seen nor simulated in the shown trial, such as a probe before the first run.
bool is_unknown(const WorkbenchState& state, std::size_t m) {
    const SimulatedTrial* const simulated = state.simulated_trial();
    return !(simulated && m < simulated->markers.size()) && !is_seen(*state.scene_trial(), m);
}

/// Adds measured and simulated markers, trails and error lines of the shown trial.
void add_markers(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    const SceneTrial* trial = state.scene_trial();
    const ViewOptions& view = state.view;
    const TimePlace place = trial ? place_in_time(trial->time_s, state.time_s) : TimePlace{};
    for (std::size_t m = 0; m < state.scene->markers.size(); ++m) {
        const std::string label = state.scene->markers[m].name;
        const int number = static_cast<int>(m);
        // No trial, or a trial without samples: the markers at rest are all there is to show.
        if (place.index < 0) {
            drawn.markers.push_back(
                {state.scene->markers[m].rest_m, viewport::color_of(theme.measured), false, label, number});
            continue;
        }
        if (is_unknown(state, m)) {
            drawn.markers.push_back(
                {state.scene->markers[m].rest_m, viewport::color_of(theme.simulated), true, label, number});
            continue;
        }
        const Eigen::Vector3d measured = at_time(trial->measured[m], place);
        if (view.measured) {
            drawn.markers.push_back({measured, viewport::color_of(theme.measured), false, label, number});
            if (view.trails)
                add_line(drawn, trail(trial->measured[m], trial->time_s, state.time_s),
                         viewport::color_of(theme.measured, 0.75f), 1.5);
        }
        add_simulated_marker(drawn, state, theme, m, place);
    }
}

/// Adds the markers where they are on the model that plays live. Nothing was measured then.
void add_live_markers(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    const std::vector<Eigen::Vector3d>& places = state.live->frame->markers_m;
    for (std::size_t m = 0; m < std::min(places.size(), state.scene->markers.size()); ++m)
        drawn.markers.push_back(
            {places[m], viewport::color_of(theme.simulated), true, state.scene->markers[m].name, static_cast<int>(m)});
}

/// Adds the markers of compared runs at the shown time as rings. They cannot be picked (number -1).
void add_compared(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    const SceneTrial* trial = state.scene_trial();
    if (!trial || !state.view.simulated) return;
    const TimePlace place = place_in_time(trial->time_s, state.time_s);
    if (place.index < 0) return;
    for (const std::size_t k : compared_records(state)) {
        const SimulatedTrial* const other = state.trial_of(state.history[k].run.get());
        if (!other) continue;
        const viewport::Color color = viewport::color_of(theme.muscle(static_cast<int>(k)));
        for (const Eigen::Matrix3Xd& way : other->markers)
            if (way.cols() == trial->time_s.size()) drawn.markers.push_back({at_time(way, place), color, true, "", -1});
    }
}

/// The body at the shown time, still without anything on it.
viewport::DrawnScene drawn_body(const WorkbenchState& state, const MotionSummary& motion) {
    viewport::DrawnScene drawn;
    drawn.surface = motion.surface;
    drawn.body = motion.body;
    drawn.positions = positions_at_time(state);
    drawn.edges = state.view.edges;
    drawn.grid = state.view.grid;
    drawn.body_opacity = state.view.opacity;
    drawn.extent = motion.rest;
    drawn.reach = motion.reach;
    // 1.2 % of the diagonal: visible, without covering the body.
    drawn.marker_radius = 0.012 * motion.rest.size().norm();
    return drawn;
}

}  // namespace

std::optional<viewport::DrawnField> drawn_field(const ViewOptions& view, const FieldKind& kind, const FieldFrame& frame,
                                                Eigen::Index nodes) {
    if (frame.values.size() != nodes) return std::nullopt;
    viewport::DrawnField field;
    field.name = kind.label;
    field.unit = kind.unit;
    field.diverging = kind.signed_values;
    field.color_map = viewport::number_of_color_map(view.color_map);
    field.values = frame.values / kind.per_unit;
    std::array<double, 2> range = frame.trial_range.value_or(
        std::array<double, 2>{frame.values.minCoeff(), frame.values.maxCoeff()});
    if (const auto fixed = view.field_ranges.find(kind.id); fixed != view.field_ranges.end()) range = fixed->second;
    // A signed field has its zero in the middle of the colours.
    else if (kind.signed_values)
        range = {-std::max(std::abs(range[0]), std::abs(range[1])), std::max(std::abs(range[0]), std::abs(range[1]))};
    field.lowest = range[0] / kind.per_unit;
    field.highest = range[1] / kind.per_unit;
    // A field without differences, such as the stress at rest, is drawn in one colour; rounding errors must not look
    // like a pattern.
    const double least = 1e-9 * std::max(std::abs(field.lowest), std::abs(field.highest)) + 1e-12;
    if (!(field.highest - field.lowest > least)) field.highest = field.lowest + std::max(1e-3, std::abs(field.lowest));
    return field;
}

TimePlace place_in_time(const Eigen::VectorXd& time_s, double t) {
    TimePlace place;
    if (time_s.size() == 0) return place;
    const double* begin = time_s.data();
    const double* end = begin + time_s.size();
    const auto above = std::upper_bound(begin, end, t) - begin;
    place.index = std::max<std::ptrdiff_t>(0, above - 1);
    place.next = std::min<std::ptrdiff_t>(place.index + 1, time_s.size() - 1);
    const double span = time_s[place.next] - time_s[place.index];
    place.weight = span > 0.0 ? std::clamp((t - time_s[place.index]) / span, 0.0, 1.0) : 0.0;
    return place;
}

Eigen::Vector3d at_time(const Eigen::Matrix3Xd& track, const TimePlace& place) {
    assert(place.index >= 0 && place.next < track.cols());
    // A sample that is hit exactly counts even if its neighbour is a gap.
    if (place.weight <= 0.0) return track.col(place.index);
    if (place.weight >= 1.0) return track.col(place.next);
    return (1.0 - place.weight) * track.col(place.index) + place.weight * track.col(place.next);
}

Eigen::Matrix3Xd positions_at_time(const WorkbenchState& state) {
    if (!state.body) return state.scene ? state.scene->surface.vertices : Eigen::Matrix3Xd(3, 0);
    const SimulatedTrial* trial = state.drawn_trial();
    if (!trial || trial->frames.empty()) return state.body->mesh.nodes;
    const TimePlace place = place_in_time(trial->frame_time_s, state.time_s);
    const Eigen::Matrix3Xd& a = trial->frames[static_cast<std::size_t>(place.index)];
    const Eigen::Matrix3Xd& b = trial->frames[static_cast<std::size_t>(place.next)];
    return (1.0 - place.weight) * a + place.weight * b;
}

MotionSummary summarize_motion(const WorkbenchState& state) {
    MotionSummary motion;
    if (state.body) {
        // Meshed bodies are drawn by their cells' faces, others by the surface that was read.
        motion.outline = std::make_shared<const Eigen::Matrix3Xd>(rest_outline(*state.body));
        motion.body = std::make_shared<viewport::DrawnBody>(viewport::DrawnBody{state.body->boundary, {}});
        motion.surface = std::make_shared<viewport::DrawnSurface>(viewport::drawn_surface(state.body->boundary));
    } else if (state.scene && state.scene->surface.triangles.cols() > 0) {
        motion.surface = std::make_shared<viewport::DrawnSurface>(viewport::drawn_surface(state.scene->surface));
    }
    Bounds bounds = rest_bounds(state);
    motion.rest = bounds.box;
    if (const SceneTrial* trial = state.scene_trial()) {
        // The view must hold the measured and the simulated motion at every time.
        for (const Eigen::Matrix3Xd& track : trial->measured) bounds.include(track);
    }
    if (const SimulatedTrial* trial = state.simulated_trial()) {
        // Including every frame of a long run would take seconds. Extremes change little between frames, so about 40
        // frames suffice.
        const std::size_t stride = std::max<std::size_t>(1, trial->frames.size() / 40);
        for (std::size_t f = 0; f < trial->frames.size(); f += stride) {
            bounds.include(trial->frames[f]);
        }
    }
    motion.reach = bounds.box;
    motion.loaded = loaded_points(state);
    motion.part_of_cell = part_of_cell(state);
    return motion;
}

WorkbenchState at_rest(WorkbenchState state) {
    state.trial = -1;
    state.run.reset();
    state.search.reset();
    state.preview.run.reset();
    state.live.reset();
    state.diagnosis.reset();
    return state;
}

viewport::DrawnScene scene_at_time(const WorkbenchState& state, const platform::Theme& theme,
                                   const MotionSummary& motion, const fibre::CellPaint* live, const FieldKind* kind,
                                   const FieldFrame* field) {
    if (!state.scene) return {};
    viewport::DrawnScene drawn = drawn_body(state, motion);
    if (kind && field) drawn.field = drawn_field(state.view, *kind, *field, drawn.positions.cols());
    if (state.view.clamp && state.scene->clamp_m) {
        for (viewport::DrawnLine& line :
             viewport::box_lines(*state.scene->clamp_m, viewport::color_of(theme.muted, 0.9f), 1.5))
            drawn.lines.push_back(std::move(line));
    }
    if (state.view.clamp) add_supports(drawn, state, theme);
    if (state.view.undeformed && motion.outline)
        add_line(drawn, *motion.outline, viewport::color_of(theme.muted, 0.7f), 1.0);
    if (state.view.clip.on && state.body)
        add_line(drawn, outline_of(state.view.clip, motion.rest), viewport::color_of(theme.accent, 0.9f), 1.5);
    // The order decides about the colour of a face: muscles, over them chambers, and parts where neither is.
    const bool paints_part = state.brush.part >= 0;
    add_muscles(drawn, state, theme, paints_part ? nullptr : live);
    add_actuators(drawn, state, theme);
    add_setup(drawn, state, theme, motion, paints_part ? live : nullptr);
    // A colour must have one meaning at a time.
    if (drawn.field && !live) drawn.tints.resize(4, 0), drawn.legend.clear();
    add_force_arrows(drawn, state, theme);
    if (state.import)
        add_import(drawn, state, theme);
    else if (state.live && state.live->frame)
        add_live_markers(drawn, state, theme);
    else
        add_markers(drawn, state, theme), add_compared(drawn, state, theme);
    return drawn;
}

std::vector<std::size_t> compared_records(const WorkbenchState& state) {
    std::vector<std::size_t> compared;
    for (std::size_t k = 0; k < state.history.size(); ++k)
        if (state.history[k].compared && state.history[k].run && state.history[k].run != state.run)
            compared.push_back(k);
    return compared;
}

}  // namespace myo::ui::commands
