#include "backend/marker_edit.hpp"

#include <vector>

#include "toml/toml_edit.hpp"
#include "toml/toml_text.hpp"

namespace myo::backend {
namespace {

using toml::TomlPath;
using toml::TomlValue;

/// Places of texts equal to `name` at a path: the value itself, or elements of a list.
std::vector<TomlPath> places_of(const TomlValue& document, const TomlPath& path, const std::string& name) {
    std::vector<TomlPath> places;
    const TomlValue* const value = toml::find_at(document, path);
    if (!value) return places;
    if (value->kind == TomlValue::Kind::text && value->text == name) places.push_back(path);
    if (value->kind != TomlValue::Kind::array) return places;
    for (std::size_t i = 0; i < value->items.size(); ++i)
        if (value->items[i].kind == TomlValue::Kind::text && value->items[i].text == name) {
            places.push_back(path);
            places.back().emplace_back(i);
        }
    return places;
}

/// Number of elements of an array of tables; 0 if there is none.
std::size_t count_of(const TomlValue& document, const TomlPath& array) {
    const TomlValue* const found = toml::find_at(document, array);
    return found ? found->items.size() : 0;
}

/// Where effects, columns of recordings, goals and repairs name a marker.
std::vector<TomlPath> references_to(const TomlValue& document, const std::string& name) {
    std::vector<TomlPath> all;
    const auto add = [&](const TomlPath& path) {
        for (TomlPath& place : places_of(document, path, name)) all.push_back(std::move(place));
    };
    for (std::size_t i = 0; i < count_of(document, {"effect"}); ++i)
        for (const char* key : {"marker", "markers"}) add({"effect", i, key});
    for (std::size_t i = 0; i < count_of(document, {"trial"}); ++i) {
        add({"trial", i, "columns", "markers"});
        for (std::size_t k = 0; k < count_of(document, {"trial", i, "goal"}); ++k)
            add({"trial", i, "goal", k, "marker"});
        for (std::size_t k = 0; k < count_of(document, {"trial", i, "repair"}); ++k)
            for (const char* key : {"marker", "with"}) add({"trial", i, "repair", k, key});
    }
    return all;
}

/// Whether a trial of the declaration has a recording.
bool is_recorded(const TomlValue& document) {
    for (std::size_t i = 0; i < count_of(document, {"trial"}); ++i)
        if (toml::find_at(document, {"trial", i, "trace"})) return true;
    return false;
}

}  // namespace

Result<std::string> with_renamed_marker(const std::string& text, const std::string& name, const std::string& wanted) {
    const Result<TomlValue> document = toml::parse_toml(text, "");
    if (!document) return document.error();
    // Markers on the body, probes and markers on the mount share one set of names.
    for (const char* other : {"rest_m", "probe_m", "fixed_m"})
        if (toml::find_at(*document, {"markers", other, wanted}))
            return Error{"there is a marker \"" + wanted + "\" already", ""};
    const bool marker = toml::find_at(*document, {"markers", "rest_m", name}) != nullptr;
    Result<std::string> result = toml::with_renamed_key(text, {"markers", marker ? "rest_m" : "probe_m", name}, wanted);
    // Recordings name the marker by its label, which is its former name if none was declared. The label keeps that
    // name, so that files need not change.
    if (result && toml::find_at(*document, {"markers", "labels", name}))
        result = toml::with_renamed_key(*result, {"markers", "labels", name}, wanted);
    else if (result && marker && is_recorded(*document))
        result = toml::with_value(*result, {"markers", "labels", wanted}, toml::toml_text(name));
    // Paths found before the renaming stay valid: they lie in other tables and contain no marker's name.
    for (const TomlPath& place : references_to(*document, name))
        if (result) result = toml::with_value(*result, place, toml::toml_text(wanted));
    return result;
}

}  // namespace myo::backend
