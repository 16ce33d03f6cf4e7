#include "base/text.hpp"
#include "experiment/read_experiment_tables.hpp"

namespace myo::experiment {

fibre::Signal read_curve(const toml::TomlReader& table, const std::string& key) {
    fibre::Signal curve{{}, {}};
    const Eigen::Matrix2Xd rows = table.pairs(key);
    if (rows.cols() < 2) table.fail(key, "needs at least two rows [t_s, value]; what is constant needs no curve");
    for (const auto& row : rows.colwise()) {
        const std::size_t count = curve.times_s.size();
        // Equal times are allowed: the value jumps there.
        if (count > 0 && row(0) < curve.times_s.back())
            table.fail(key, "its times must ascend, but " + format_number(row(0)) + " s follows " +
                                format_number(curve.times_s.back()) + " s");
        // The middle one of three values at one time would never act.
        if (count > 1 && row(0) == curve.times_s[count - 2])
            table.fail(key, "has the time " + format_number(row(0)) + " s three times; a jump has two rows");
        curve.times_s.push_back(row(0));
        curve.values.push_back(row(1));
    }
    return curve;
}

}  // namespace myo::experiment
