#include "sweep/readable_number.hpp"

#include <cmath>
#include <map>

#include "base/text.hpp"
#include "effect/readable_quantity.hpp"

namespace myo::sweep {

ShownQuantity shown_quantity(const std::string& name, const std::string& unit) {
    // Units as they end names; others are shown as they are.
    static const std::map<std::string, std::string> suffixes{
        {"m", "_m"}, {"Pa", "_Pa"}, {"s", "_s"}, {"N", "_N"}, {"kg", "_kg"}};
    const auto suffix = suffixes.find(unit);
    // Name and unit as the ending of the name says: "youngs_modulus_Pa" in kPa.
    const effect::ReadableQuantity own = effect::readable_quantity(name);
    if (unit.empty()) return {own.name, own.unit, own.factor};
    ShownQuantity shown{name, unit, 1.0};
    if (suffix != suffixes.end()) {
        const effect::ReadableQuantity readable = effect::readable_quantity(suffix->second);
        shown.unit = readable.unit;
        shown.factor = readable.factor;
    }
    // A name that ends in its unit does not say it twice.
    if (own.unit == shown.unit) shown.name = own.name;
    return shown;
}

ShownQuantity shown_quantity(const Varied& varied) {
    if (varied.name == "--resolution") return {varied.name, "mm", 1e3};
    if (varied.name == "--dt") return {varied.name, "ms", 1e3};
    if (varied.is_option()) return {varied.name, "", 1.0};
    // The tables before the last key stay as the file names them.
    const std::size_t last = varied.name.rfind('.') + 1;
    const effect::ReadableQuantity shown = effect::readable_quantity(varied.name.substr(last));
    return {varied.name.substr(0, last) + shown.name, shown.unit, shown.factor};
}

std::string words_of(const CaseNumber& number) {
    const ShownQuantity shown = shown_quantity(number.name, number.unit);
    std::string words = format_number(shown.factor * number.value, 4);
    if (std::isfinite(number.deviation)) words += " ± " + format_number(shown.factor * number.deviation, 2);
    return shown.unit.empty() ? words : words + " " + shown.unit;
}

}  // namespace myo::sweep
