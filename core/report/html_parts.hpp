#pragma once

#include <string>
#include <string_view>

#include "report/html_report.hpp"

namespace myo::report {

/// Style sheet of the page, for screen (light and dark) and print.
std::string_view html_style();

/// A table as HTML, with the number format of each column chosen from its numbers. Text is escaped.
std::string html_table(const Table& table);

}  // namespace myo::report
