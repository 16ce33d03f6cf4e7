#pragma once

#include "diagnosis/diagnosis.hpp"
#include "report/html_report.hpp"
#include "results/output_json.hpp"

namespace myo::diagnosis {

/// HTML page of a diagnosis: the verdict in words, then the evidence. Embeds diagnosis_json(). Asserts a complete
/// diagnosis.
report::HtmlReport diagnosis_report(const setup::Setup& setup, const Diagnosis& diagnosis,
                                    const results::RunFacts& facts);

}  // namespace myo::diagnosis
