#include "support/corpus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/diagnosis_work.hpp"
#include "experiment/read_experiment.hpp"
#include "support/folder.hpp"

namespace myo::diagnosis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Fits of other steps cannot be continued, which is said.
TEST(Corpus, FitsOfTheFormerProgramAreNotUsedWithANote) {
    const test::Folder folder("former_fits");
    std::filesystem::copy(test::corpus("diagnose/diagnose_fits.json"), folder.path());
    const Result<experiment::Experiment> experiment = experiment::read_experiment(
        test::corpus("diagnose/experiment_augmented.toml"));
    ASSERT_TRUE(experiment) << experiment.error().text();
    setup::SetupSettings coarse;
    coarse.mesh.resolution_m = 0.03;
    const Result<setup::Setup> setup = setup::prepare_setup(*experiment, coarse);
    ASSERT_TRUE(setup) << setup.error().text();
    DiagnoseSettings settings;
    settings.fits = folder.path() / "diagnose_fits.json";
    const DiagnosisWork work(*setup, settings, {}, {});
    EXPECT_THAT(work.result.notes, ElementsAre(HasSubstr("the fits kept in diagnose_fits.json")));
    // A file that this program keeps is used.
    settings.fits = folder.path() / "new.json";
    ASSERT_TRUE(DiagnosisWork(*setup, settings, {}, {}).store->keep("a fit", Eigen::VectorXd::Ones(1)));
    const DiagnosisWork again(*setup, settings, {}, {});
    EXPECT_TRUE(again.result.notes.empty());
    EXPECT_TRUE(again.store->find("a fit"));
}

}  // namespace
}  // namespace myo::diagnosis
