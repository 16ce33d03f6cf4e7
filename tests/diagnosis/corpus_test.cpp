#include "support/corpus.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "diagnosis/diagnosis_context.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/fit/store_words.hpp"
#include "experiment/read_experiment.hpp"
#include "support/folder.hpp"

namespace myo::diagnosis {
namespace {

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
    const std::string words = store_words(prepared_setup(*setup, {}));
    EXPECT_THAT(FitStore(folder.path() / "diagnose_fits.json", words).unused_note(),
                HasSubstr("the fits kept in diagnose_fits.json"));
    // A file that this program keeps is used.
    ASSERT_TRUE(FitStore(folder.path() / "new.json", words).keep("a fit", Eigen::VectorXd::Ones(1)));
    const FitStore again(folder.path() / "new.json", words);
    EXPECT_EQ(again.unused_note(), "");
    EXPECT_TRUE(again.find("a fit"));
}

}  // namespace
}  // namespace myo::diagnosis
