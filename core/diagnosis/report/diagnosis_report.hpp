#pragma once

#include "diagnosis/diagnosis.hpp"
#include "report/html_report.hpp"
#include "results/output_json.hpp"

namespace myo::diagnosis {

/// The page about a diagnosis: the verdict in words first, then what it stands on; the numbers of diagnosis_json(),
/// which is in it, too. Asserts a complete diagnosis.
report::HtmlReport diagnosis_report(const setup::Setup& setup, const Diagnosis& diagnosis,
                                    const results::RunFacts& facts);

}  // namespace myo::diagnosis
