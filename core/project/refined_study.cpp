#include "project/refined_study.hpp"

namespace myo {

Result<Study> refined_study(const Study& study, double ratio, const Progress& progress) {
    StudySettings settings = study.settings;
    settings.mesh.element = study.mesh.element;
    settings.mesh.refinement *= ratio;
    return prepare_study(study.experiment, settings, progress);
}

}  // namespace myo
