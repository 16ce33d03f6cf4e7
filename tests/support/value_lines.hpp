#pragma once

#include <Eigen/Core>

#include <cstdio>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace myo::test {

/// Values of a file as lines of a key and its values, to be compared with a record of another version.
class ValueLines {
public:
    /// Text in quotes.
    void add(const std::string& key, const std::string& text) { lines_[key] = "\"" + text + "\""; }
    void add(const std::string& key, const char* text) { add(key, std::string(text)); }
    void add(const std::string& key, bool truth) { lines_[key] = truth ? "true" : "false"; }
    /// Numbers with all digits.
    void add(const std::string& key, double number) { lines_[key] = digits(number); }
    void add(const std::string& key, int number) { add(key, static_cast<double>(number)); }
    /// Components of a vector or matrix, by columns.
    template <class Derived>
    void add(const std::string& key, const Eigen::MatrixBase<Derived>& values) {
        const Eigen::MatrixXd all = values;
        add(key, std::vector<double>(all.data(), all.data() + all.size()));
    }
    void add(const std::string& key, const std::vector<double>& values) {
        std::string& line = lines_[key];
        for (const double value : values) line += (line.empty() ? "" : " ") + digits(value);
    }
    void add(const std::string& key, const std::vector<std::string>& texts) {
        std::string& line = lines_[key];
        for (const std::string& text : texts) line += (line.empty() ? "\"" : " \"") + text + "\"";
    }
    /// The alternative that a variant holds.
    template <class... Alternatives>
    void add(const std::string& key, const std::variant<Alternatives...>& value) {
        std::visit([&](const auto& held) { add(key, held); }, value);
    }

    const std::map<std::string, std::string>& lines() const { return lines_; }
    /// "key = values" by key, one per line.
    std::string text() const {
        std::string all;
        for (const auto& [key, line] : lines_) all += key + " = " + line + "\n";
        return all;
    }

private:
    static std::string digits(double number) {
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", number);
        return text;
    }

    std::map<std::string, std::string> lines_;
};

}  // namespace myo::test
