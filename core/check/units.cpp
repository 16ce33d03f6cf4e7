#include <array>
#include <cmath>

#include "base/text.hpp"
#include "check/checks.hpp"

namespace myo::check {
namespace {

/// Range outside of which a value is more likely in a wrong unit.
struct PlausibleRange {
    const char* key;
    const char* unit;
    double low, high;
    const char* slip;  // the likely mistake
};

/// Plausible ranges; messages are derived from them.
struct UnitPolicy {
    // Jellyfish gels to stiff plastics (Young's moduli of polymers end at 5 GPa); light foams to heavy metals.
    PlausibleRange modulus{"material.youngs_modulus_Pa", "Pa", 500.0, 5e9, "MPa or kPa in place of Pa"};
    PlausibleRange density{"material.density_kg_m3", "kg/m3", 20.0, 25e3, "g/cm3 in place of kg/m3"};
    // Critical damping of a body of 0.6 Hz; gravity of Jupiter; the largest markers; the smallest to the longest arms.
    PlausibleRange damping{"material.damping_s", "s", 0.0, 0.5, "ms in place of s"};
    PlausibleRange gravity{"gravity_m_s2", "m/s2", 0.0, 30.0, "mm/s2 in place of m/s2"};
    PlausibleRange noise{"markers.noise_m", "m", 0.0, 0.02, "mm in place of m"};
    PlausibleRange extent{"body", "m", 0.002, 5.0, "mm in place of m, or the reverse"};
};
constexpr UnitPolicy unit_policy;

/// "500 to 5e+09 Pa"; "0 to 0.5 s".
std::string range_words(const PlausibleRange& range) {
    return format_number(range.low) + " to " + format_number(range.high) + " " + range.unit;
}

/// Finding for one quantity: passed inside the range, doubtful outside.
Finding judged(const PlausibleRange& range, double value) {
    Finding finding = passed_finding(range.key,
                                     std::string(range.key) + " = " + format_number(value) + " " + range.unit);
    finding.figure = value;
    finding.unit = range.unit;
    // Bounds belong to the range; the threshold of a passed finding is the upper one.
    const bool low = value<range.low, high = value> range.high;
    finding.threshold = low ? range.low : range.high;
    if (!low && !high) return finding;
    finding.level = CheckLevel::doubtful;
    finding.sentence += std::string(", ") + (low ? "below" : "above") + " what soft robots have, " + range_words(range);
    finding.way_out = std::string("was it written in ") + range.slip + "?";
    return finding;
}

}  // namespace

std::vector<Finding> check_units(const CheckedJob& job) {
    const experiment::Experiment& experiment = job.setup.experiment;
    std::vector<Finding> findings{
        judged(unit_policy.extent, mesh::bounding_box(job.setup.surface.vertices).size().maxCoeff()),
        judged(unit_policy.modulus, experiment.material.youngs_modulus_Pa),
        judged(unit_policy.density, experiment.material.density_kg_m3),
        judged(unit_policy.gravity, experiment.gravity_m_s2.norm()),
    };
    if (experiment.material.damping_s) findings.push_back(judged(unit_policy.damping, *experiment.material.damping_s));
    if (experiment.markers.noise_m) findings.push_back(judged(unit_policy.noise, *experiment.markers.noise_m));
    return findings;
}

}  // namespace myo::check
