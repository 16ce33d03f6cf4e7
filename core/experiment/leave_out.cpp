#include "experiment/leave_out.hpp"

#include <set>

#include "base/random_stream.hpp"

namespace myo::experiment {

Result<std::vector<std::string>> leave_out(Experiment& experiment, int count, std::uint64_t seed) {
    std::vector<std::size_t> open;
    for (std::size_t t = 0; t < experiment.trials.size(); ++t)
        if (experiment.trials[t].role == TrialRole::fit) open.push_back(t);
    if (open.empty()) return Error{"no trial has role = \"fit\", so that none can be left out", "--leave-out"};
    if (static_cast<std::size_t>(count) >= open.size())
        return Error{"of " + std::to_string(open.size()) + " trials to fit, at most " +
                         std::to_string(open.size() - 1) + " can be left out",
                     "--leave-out"};
    // A trial that is drawn twice is drawn again. The set is sorted, hence the names are in the order of the
    // experiment.
    RandomStream random({seed});
    std::set<std::size_t> drawn;
    while (static_cast<int>(drawn.size()) < count)
        drawn.insert(open[static_cast<std::size_t>(random.below(static_cast<int>(open.size())))]);
    std::vector<std::string> names;
    for (const std::size_t t : drawn) {
        experiment.trials[t].role = TrialRole::validate;
        names.push_back(experiment.trials[t].name);
    }
    return names;
}

}  // namespace myo::experiment
