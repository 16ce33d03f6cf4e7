#include "diagnosis/screening/residual_lines.hpp"

#include <algorithm>
#include <cmath>

#include "statistics/periodogram.hpp"

namespace myo::diagnosis {
namespace {

/// Peak of a spectrum; power over that of white noise.
struct Line {
    double frequency_Hz = 0.0;
    double power = 0.0;
};

/// Local maxima from the second frequency on: slower motion is a trend.
std::vector<Line> peaks(const statistics::Spectrum& spectrum) {
    std::vector<Line> lines;
    const Eigen::VectorXd& p = spectrum.power;
    for (Eigen::Index k = 2; k + 1 < p.size(); ++k) {
        if (!(p(k) > p(k - 1) && p(k) >= p(k + 1)) || !(p(k - 1) > 0.0) || !(p(k + 1) > 0.0)) continue;
        // Vertex of the parabola through three logarithms, in units of the frequency spacing.
        const double left = std::log(p(k - 1) / p(k)), right = std::log(p(k + 1) / p(k));
        const double shift = 0.5 * (left - right) / (left + right);
        lines.push_back({spectrum.frequency_Hz(k) + shift * spectrum.frequency_Hz(1), p(k)});
    }
    return lines;
}

}  // namespace

std::vector<double> residual_lines(const Eigen::VectorXd& r, const statistics::ResidualLayout& layout,
                                   std::size_t count) {
    std::vector<Line> lines;
    double resolved_Hz = 0.0;
    for (const int trial : statistics::trials_of(layout)) {
        const statistics::Spectrum spectrum = statistics::mean_spectrum(r, layout, trial);
        if (spectrum.frequency_Hz.size() < 3) continue;
        // The first frequency is the spacing 1 / duration: the coarsest trial decides what counts as one line.
        resolved_Hz = std::max(resolved_Hz, spectrum.frequency_Hz(1));
        const std::vector<Line> of_trial = peaks(spectrum);
        lines.insert(lines.end(), of_trial.begin(), of_trial.end());
    }
    std::stable_sort(lines.begin(), lines.end(), [](const Line& a, const Line& b) { return a.power > b.power; });
    std::vector<double> chosen;
    for (const Line& line : lines) {
        if (chosen.size() == count) break;
        const bool known = std::any_of(chosen.begin(), chosen.end(),
                                       [&](double f) { return std::abs(f - line.frequency_Hz) < resolved_Hz; });
        if (!known) chosen.push_back(line.frequency_Hz);
    }
    return chosen;
}

}  // namespace myo::diagnosis
