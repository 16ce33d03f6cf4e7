#include "results/marker_places.hpp"

#include <algorithm>
#include <cstdio>

#include "report/length.hpp"

namespace myo::results {

std::string place_lines(const std::vector<prediction::FoundPlace>& places) {
    if (places.empty()) return {};
    std::size_t width = 18;
    for (const prediction::FoundPlace& place : places) width = std::max(width, place.marker.size());
    // Wide enough for the longest name, but within the line buffer.
    const int column = static_cast<int>(std::min<std::size_t>(width, 120));
    char line[512];
    std::snprintf(line, sizeof line, "\n%-*s  %16s  %16s  %16s", column, "marker off by [mm]", "x", "y", "z");
    std::string text = line;
    for (const prediction::FoundPlace& place : places) {
        std::snprintf(line, sizeof line, "\n%-*s", column, place.marker.c_str());
        text += line;
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            std::snprintf(line, sizeof line, "  %7.3f ± %6.3f", 1e3 * place.shift_m(axis),
                          1e3 * place.deviation_m(axis));
            text += line;
        }
    }
    return text + "\n";
}

report::Json places_json(const std::vector<prediction::FoundPlace>& places) {
    report::Json json = report::Json::object();
    for (const prediction::FoundPlace& place : places)
        json[place.marker] = {{"shift_m", report::json_array(place.shift_m)},
                              {"std_m", report::json_array(place.deviation_m)},
                              {"distance_m", report::json_number(place.shift_m.norm())}};
    return json;
}

report::Section places_section(const std::vector<prediction::FoundPlace>& places, double placement_m) {
    report::Table table{
        "How far each marker sits from its declared place on the undeformed body, found from the trials "
        "to fit with a deviation of " +
            report::length_words(placement_m) +
            " per coordinate to start from. Errors of all trials are those at these places.",
        {{"Marker"}, {"x", "mm", 3}, {"±", "mm", 2}, {"y", "mm", 3}, {"±", "mm", 2}, {"z", "mm", 3}, {"±", "mm", 2}},
        {}};
    for (const prediction::FoundPlace& place : places) {
        table.rows.push_back({place.marker});
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            table.rows.back().emplace_back(1e3 * place.shift_m(axis));
            table.rows.back().emplace_back(1e3 * place.deviation_m(axis));
        }
    }
    return {"Places of the markers", {table}};
}

}  // namespace myo::results
