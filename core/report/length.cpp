#include "report/length.hpp"

#include "base/markup.hpp"

namespace myo::report {

std::string in_mm(double metres) { return readable_number(1e3 * metres, 3); }

std::string length_words(double metres) { return in_mm(metres) + " mm"; }

std::vector<double> curve_in_mm(const Eigen::VectorXd& metres) {
    const Eigen::VectorXd scaled = 1e3 * metres;
    return {scaled.begin(), scaled.end()};
}

}  // namespace myo::report
