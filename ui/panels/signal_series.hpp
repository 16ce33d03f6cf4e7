#pragma once

#include <string>

#include "chart/layout.hpp"
#include "fibre/signal.hpp"
#include "platform/theme.hpp"

namespace myo::ui::panels {

/// A signal over a time range as a curve. Beyond its knots it is constant, so points are added at the ends of the
/// range.
///
/// @param per_unit  value of the shown unit in that of the signal
chart::Series signal_series(const std::string& name, const fibre::Signal& signal, const chart::Range& span,
                            const ImVec4& color, double per_unit = 1.0);

}  // namespace myo::ui::panels
