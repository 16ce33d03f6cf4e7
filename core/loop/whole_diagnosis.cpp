#include "loop/whole_diagnosis.hpp"

#include "base/stopwatch.hpp"

namespace myo {

Diagnosis whole_diagnosis(const Study& study, const DiagnoseSettings& settings, const Progress& progress, const std::function<void(const Diagnosis&)>& live) {
    Diagnosis d = diagnose(study, settings, progress, live);
    if (!d.complete() || d.verdict.kind != VerdictKind::unknown) return d;
    const Stopwatch watch;
    d.missing_force = infer_missing_force(study, d, progress);
    d.cost.push_back({"missing force", watch.seconds(), d.missing_force->runs});
    d.seconds += watch.seconds();
    d.stopped = progress.cancelled();
    return d;
}

}  // namespace myo
