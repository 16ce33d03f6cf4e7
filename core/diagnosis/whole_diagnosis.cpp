#include "diagnosis/whole_diagnosis.hpp"

#include "base/stopwatch.hpp"

namespace myo::diagnosis {

Diagnosis whole_diagnosis(const setup::Setup& setup, const DiagnoseSettings& settings, const Progress& progress,
                          const std::function<void(const Diagnosis&)>& live) {
    Diagnosis d = diagnose(setup, settings, progress, live);
    if (!d.complete() || d.verdict.kind != VerdictKind::unknown) return d;
    const Stopwatch watch;
    d.missing_force = infer_missing_force(setup, d, progress);
    d.cost.push_back({"missing force", watch.seconds(), d.missing_force->runs});
    d.seconds += watch.seconds();
    d.stopped = progress.cancelled();
    return d;
}

}  // namespace myo::diagnosis
