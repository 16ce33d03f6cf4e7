#pragma once

#include "loop/diagnosis.hpp"
#include "project/output_json.hpp"
#include "report/html_report.hpp"

namespace myo {

/// The page about a diagnosis: the verdict in words first, then what it stands on; the numbers of diagnosis_json(), which is in it, too.
/// Asserts a complete diagnosis.
HtmlReport diagnosis_report(const Study& study, const Diagnosis& diagnosis, const RunFacts& facts);

}  // namespace myo
