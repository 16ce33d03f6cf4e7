#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {

std::vector<measurement::TraceRepair> read_repairs(const toml::TomlReader& trial) {
    using measurement::RepairKind;
    std::vector<measurement::TraceRepair> repairs;
    for (const toml::TomlReader& table :
         trial.tables("repair", {"kind", "marker", "with", "from_s", "to_s", "window_s"})) {
        measurement::TraceRepair repair;
        repair.kind = table.choice<RepairKind>("kind", {{to_string(RepairKind::cut), RepairKind::cut},
                                                        {to_string(RepairKind::swap), RepairKind::swap},
                                                        {to_string(RepairKind::fill), RepairKind::fill},
                                                        {to_string(RepairKind::smooth), RepairKind::smooth}});
        repair.marker = table.text("marker");
        // Keys of another kind are refused: they would have no effect.
        if (repair.kind == RepairKind::swap)
            repair.with = table.text("with");
        else
            table.reject("with", "belongs to kind = \"swap\"");
        if (repair.kind == RepairKind::smooth)
            repair.window_s = table.number("window_s", toml::positive());
        else
            table.reject("window_s", "belongs to kind = \"smooth\"");
        repair.from_s = table.number("from_s");
        repair.to_s = table.number("to_s");
        // One sample is a span of length zero.
        if (repair.to_s < repair.from_s)
            table.fail("to_s", "lies before from_s (" + format_number(repair.to_s) + " < " +
                                   format_number(repair.from_s) + ")");
        repairs.push_back(std::move(repair));
    }
    return repairs;
}

}  // namespace myo::experiment
