#pragma once

#include <string>
#include <string_view>

#include "report/html_report.hpp"

namespace myo::report {

/// The page's style sheet.
std::string_view html_style();

/// A table as HTML.
std::string html_table(const Table& table);

}  // namespace myo::report
