#include "diagnosis/fit/fit_store.hpp"

#include <utility>
#include <vector>

#include "report/json.hpp"

namespace myo::diagnosis {
namespace {

// Stated in the file. A change of what the keys mean needs another number.
constexpr const char* schema = "fits/1";

}  // namespace

FitStore::FitStore(std::filesystem::path file, std::string setup) : file_(std::move(file)), setup_(std::move(setup)) {
    const Result<report::Json> json = report::read_json(*file_);
    if (!json) return;
    // "study" is the former name of a setup, kept so that earlier files are read.
    holds_other_fits_ = !json->is_object() || json->value("schema", "") != schema || json->value("study", "") != setup_;
    if (holds_other_fits_) return;
    for (const auto& [fit, values] : (*json)["fits"].items()) {
        if (!values.is_array()) continue;
        std::vector<double> numbers;
        for (const report::Json& value : values)
            if (value.is_number()) numbers.push_back(value.get<double>());
        // An entry with anything but numbers is dropped, and so fitted again.
        if (numbers.size() == values.size())
            fits_[fit] = Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
    }
}

std::string FitStore::unused_note() const {
    if (!holds_other_fits_) return {};
    return "the fits kept in " + file_->filename().string() +
           " are of other data, settings or another version of the program; they are not used";
}

std::optional<Eigen::VectorXd> FitStore::find(const std::string& fit) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = fits_.find(fit);
    if (found == fits_.end()) return {};
    return found->second;
}

Result<void> FitStore::keep(const std::string& fit, const Eigen::VectorXd& values) {
    // The whole file is written each time, because a diagnosis may end at any moment.
    if (!file_) return {};
    const std::lock_guard<std::mutex> lock(mutex_);
    fits_[fit] = values;
    report::Json json{{"schema", schema}, {"study", setup_}, {"fits", report::Json::object()}};
    for (const auto& [name, numbers] : fits_) json["fits"][name] = report::json_array(numbers);
    return report::write_json(*file_, json);
}

}  // namespace myo::diagnosis
