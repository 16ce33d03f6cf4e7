#pragma once

#include <optional>

#include "fibre/signal.hpp"
#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// A change of a curve by its rows.
struct CurveEdit {
    fibre::Signal curve;   // all rows, the changed one included
    bool goes_on = false;  // continues a drag
};

/// Rows of a curve over time: a time and a value each, with buttons that remove a row or add one behind the last.
///
/// @param value    unit and limits of a value; its name heads the item names: "/0/time", "/0/value", "/0/remove",
/// "/add"
/// @param subject  what the curve belongs to
/// @return         the changed curve, at least two rows, its times ascending; empty: no change
std::optional<CurveEdit> curve_rows(PanelContext& context, const NumberField& value, NumberEdits& edits,
                                    const fibre::Signal& curve, const std::string& subject);

/// A curve that rises linearly from 0 at t = 0 to a value, within the time of CurveRowPolicy. Unit: that of the value.
fibre::Signal new_curve(double value);

}  // namespace myo::ui::panels
