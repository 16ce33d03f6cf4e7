#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {
namespace {

/// Location of a part: exactly one of box_m, file, region and mask.
decltype(PartDeclaration::place) read_place(const toml::TomlReader& table, const std::filesystem::path& folder) {
    std::vector<std::string> given;
    for (const char* key : {"box_m", "file", "region", "mask"})
        if (table.has(key)) given.emplace_back(key);
    if (given.empty()) table.fail("box_m", "where the part is, is missing: give one of box_m, file, region, mask");
    if (given.size() > 1)
        table.fail(given.back(), "cannot be combined with " + given.front() +
                                     "; a part has exactly one of box_m, file, region, mask");
    if (given.front() == "box_m") return table.box("box_m");
    if (given.front() == "file") return table.file("file", folder);
    // The window declares a mask before it writes the file; part_shares() says if it is missing.
    if (given.front() == "mask") return PartDeclaration::Painted{(folder / table.text("mask")).lexically_normal()};
    // Numbers of cells in mesh files are 32-bit.
    const double number = table.number("region", toml::between(-2147483648.0, 2147483647.0));
    if (number != std::floor(number)) table.fail("region", "must be a whole number, not " + format_number(number));
    return PartDeclaration::Region{static_cast<int>(number)};
}

/// Parameters of a part to fit, each at most once; laws and their own parameters belong to the whole body.
std::vector<std::string> read_part_calibrate(const toml::TomlReader& table) {
    const std::vector<std::string> known{"youngs_modulus", "damping"};
    std::vector<std::string> names = table.texts("calibrate");
    for (auto name = names.begin(); name != names.end(); ++name) {
        if (std::find(known.begin(), known.end(), *name) == known.end())
            table.fail("calibrate", "unknown parameter \"" + *name + "\"; " + toml::suggest(*name, known));
        if (std::find(names.begin(), name, *name) != name) table.fail("calibrate", "names \"" + *name + "\" twice");
    }
    return names;
}

}  // namespace

std::vector<PartDeclaration> read_parts(const toml::TomlReader& document, const std::filesystem::path& folder,
                                        const MaterialDeclaration& material) {
    std::vector<PartDeclaration> parts;
    for (const toml::TomlReader& table : document.tables(
             "part", {"name", "box_m", "file", "region", "mask", "youngs_modulus_Pa", "youngs_modulus_tolerance",
                      "poissons_ratio", "density_kg_m3", "damping_s", "calibrate"})) {
        PartDeclaration part;
        part.name = table.name("name");
        part.place = read_place(table, folder);
        part.youngs_modulus_Pa = table.number_or("youngs_modulus_Pa", material.youngs_modulus_Pa, toml::positive());
        part.youngs_modulus_tolerance = table.number_or("youngs_modulus_tolerance", material.youngs_modulus_tolerance,
                                                        toml::not_negative());
        if (part.youngs_modulus_tolerance >= 1.0)
            table.fail("youngs_modulus_tolerance",
                       "is a relative half-width and must be below 1, or the modulus could be zero");
        part.poissons_ratio = table.number_or("poissons_ratio", material.poissons_ratio,
                                              toml::strictly_between(0.0, 0.5));
        part.density_kg_m3 = table.number_or("density_kg_m3", material.density_kg_m3, toml::positive());
        // Damping is not copied from the material: an absent value follows that of the material in a fit as well.
        part.damping_s = table.optional_number("damping_s", toml::not_negative());
        if (table.has("calibrate")) part.calibrate = read_part_calibrate(table);
        parts.push_back(std::move(part));
    }
    return parts;
}

}  // namespace myo::experiment
