#include <array>
#include <cmath>

#include "base/text.hpp"
#include "check/checks.hpp"

namespace myo {
namespace {

/// A range beyond which a number is likelier in another unit than meant.
struct PlausibleRange {
    const char* key;
    const char* unit;
    double low, high;
    const char* slip;   // what was likely written
};

// Soft robots: gels of 1 kPa to plastics of 5 GPa, foams of 30 kg/m3 to metals, bodies of a millimetre to metres.
constexpr PlausibleRange modulus{"material.youngs_modulus_Pa", "Pa", 500.0, 5e9, "MPa or kPa in place of Pa"};
constexpr PlausibleRange density{"material.density_kg_m3", "kg/m3", 20.0, 25e3, "g/cm3 in place of kg/m3"};
constexpr PlausibleRange damping{"material.damping_s", "s", 0.0, 0.5, "ms in place of s"};
constexpr PlausibleRange gravity{"gravity_m_s2", "m/s2", 0.0, 30.0, "mm/s2 in place of m/s2"};
constexpr PlausibleRange noise{"markers.noise_m", "m", 0.0, 0.02, "mm in place of m"};
constexpr PlausibleRange extent{"body", "m", 0.002, 5.0, "mm in place of m, or the reverse"};

Finding judged(const PlausibleRange& range, double value) {
    Finding finding = fine_finding(range.key, std::string(range.key) + " = " + format_number(value) + " " + range.unit);
    finding.figure = value;
    finding.unit = range.unit;
    const bool low = value < range.low, high = value > range.high;
    finding.threshold = low ? range.low : range.high;
    if (!low && !high) return finding;
    finding.level = CheckLevel::doubtful;
    finding.sentence = std::string(range.key) + " is " + format_number(value) + " " + range.unit +
                       (low ? ", less than the " : ", more than the ") + format_number(finding.threshold) + " " +
                       range.unit + " of anything soft robots are made of";
    finding.way_out = std::string("was it written in ") + range.slip + "?";
    return finding;
}

}  // namespace

std::vector<Finding> check_units(const CheckedJob& job) {
    const Experiment& experiment = job.study.experiment;
    std::vector<Finding> findings{
        judged(extent, bounding_box(job.study.surface.vertices).size().maxCoeff()),
        judged(modulus, experiment.material.youngs_modulus_Pa),
        judged(density, experiment.material.density_kg_m3),
        judged(gravity, experiment.gravity_m_s2.norm()),
    };
    if (experiment.material.damping_s) findings.push_back(judged(damping, *experiment.material.damping_s));
    if (experiment.markers.noise_m) findings.push_back(judged(noise, *experiment.markers.noise_m));
    return findings;
}

}  // namespace myo
