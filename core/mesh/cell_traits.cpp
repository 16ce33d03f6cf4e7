#include "mesh/cell_traits.hpp"

#include "mesh/cells.hpp"

namespace myo::mesh {

const std::vector<CellTraits>& all_cell_traits() {
    // One list names all cells; everything that is stated per type is derived from it.
    static const std::vector<CellTraits> table = std::apply(
        [](auto... cells) { return std::vector<CellTraits>{decltype(cells)::traits()...}; }, Cells{});
    return table;
}

const CellTraits& cell_traits(CellType type) { return all_cell_traits()[static_cast<std::size_t>(type)]; }

std::optional<CellType> find_cell_type(const std::string& name) {
    for (const CellTraits& traits : all_cell_traits())
        if (traits.name == name) return traits.type;
    return std::nullopt;
}

std::vector<std::string> cell_type_names() {
    std::vector<std::string> names;
    for (const CellTraits& traits : all_cell_traits()) names.push_back(traits.name);
    return names;
}

std::vector<std::pair<std::string, CellType>> named_cell_types() {
    std::vector<std::pair<std::string, CellType>> named;
    for (const CellTraits& traits : all_cell_traits()) named.emplace_back(traits.name, traits.type);
    return named;
}

int nodes_per_cell(CellType type) { return cell_traits(type).nodes; }

std::string to_string(CellType type) { return cell_traits(type).name; }

}  // namespace myo::mesh
