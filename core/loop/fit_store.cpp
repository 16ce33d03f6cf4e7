#include "loop/fit_store.hpp"

#include <utility>
#include <vector>

#include "report/json.hpp"

namespace myo {
namespace {

constexpr const char* schema = "fits/1";

}  // namespace

FitStore::FitStore(std::filesystem::path file, std::string study) : file_(std::move(file)), study_(std::move(study)) {
    const Result<Json> json = read_json(*file_);
    if (!json || !json->is_object() || json->value("schema", "") != schema || json->value("study", "") != study_) return;
    for (const auto& [fit, values] : (*json)["fits"].items()) {
        if (!values.is_array()) continue;
        std::vector<double> numbers;
        for (const Json& value : values)
            if (value.is_number()) numbers.push_back(value.get<double>());
        if (numbers.size() == values.size()) fits_[fit] = Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
    }
}

std::optional<Eigen::VectorXd> FitStore::find(const std::string& fit) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = fits_.find(fit);
    if (found == fits_.end()) return {};
    return found->second;
}

Result<void> FitStore::keep(const std::string& fit, const Eigen::VectorXd& values) {
    if (!file_) return {};
    const std::lock_guard<std::mutex> lock(mutex_);
    fits_[fit] = values;
    Json json{{"schema", schema}, {"study", study_}, {"fits", Json::object()}};
    for (const auto& [name, numbers] : fits_) json["fits"][name] = json_array(numbers);
    return write_json(*file_, json);
}

}  // namespace myo
