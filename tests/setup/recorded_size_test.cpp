#include "setup/recorded_size.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/check_body.hpp"
#include "experiment/read_experiment.hpp"
#include "support/swung_beam.hpp"

namespace myo::setup {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// The beam of 10 cm, with what is said of its markers' motion in a camera frame.
class RecordedSize : public testing::Test {
protected:
    RecordedSize() : folder_("recorded_size") {
        test::swung_beam(folder_, 0.1);
        experiment_ = *experiment::read_experiment(folder_.path());
        surface_ = *experiment::read_body_surface(experiment_);
    }

    /// Markers at rest, displaced by up to 50 mm, in so many units per metre.
    measurement::Recording recording(double units_per_metre, double metres_per_unit) const {
        measurement::Recording made;
        made.metres_per_unit = metres_per_unit;
        made.time_s = Eigen::VectorXd::LinSpaced(90, 0.0, 0.89);
        for (const experiment::MarkerDeclaration& marker : experiment_.markers.on_body) {
            Eigen::Matrix3Xd track(3, 90);
            for (Eigen::Index t = 0; t < 90; ++t)
                track.col(t) = marker.rest_m + Eigen::Vector3d(2.0, 3.0, 5.0) -
                               0.5 * marker.rest_m(0) * std::sin(0.2 * static_cast<double>(t)) *
                                   Eigen::Vector3d::UnitZ();
            made.labels.push_back(marker.name);
            made.tracks.emplace_back(units_per_metre * metres_per_unit * track);
        }
        made.tracks[0].leftCols(30).setConstant(std::nan(""));
        return made;
    }
    std::string error_of(const measurement::Recording& recording) const {
        const Result<void> checked = check_recorded_size(experiment_, experiment_.trials[0], surface_, recording);
        return checked ? "" : checked.error().what;
    }

    test::Folder folder_;
    experiment::Experiment experiment_;
    mesh::SurfaceMesh surface_;
};

TEST_F(RecordedSize, OfTheRightUnitIsAccepted) {
    EXPECT_EQ(error_of(recording(1.0, 1.0)), "");
    EXPECT_EQ(error_of(recording(1e3, 1e-3)), "");
    EXPECT_EQ(error_of(recording(2.0, 1.0)), "") << "soft bodies stretch";
}

TEST_F(RecordedSize, OfAnotherUnitIsRefusedAndNamesIt) {
    struct Slip {
        double units_per_metre, metres_per_unit;
        const char* told;
    };
    for (const Slip& slip : {Slip{1e3, 1.0, "look like mm instead of m"},
                             {1e2, 1.0, "look like cm instead of m"},
                             {10.0, 1.0, "look like dm instead of m"},
                             {1.0, 1e-3, "look like m instead of mm"},
                             {1e6, 1e-3, "look like um instead of mm"}}) {
        const std::string said = error_of(recording(slip.units_per_metre, slip.metres_per_unit));
        EXPECT_THAT(said, StartsWith("trial[0].trace: swing.csv has its markers "));
        EXPECT_THAT(said, HasSubstr(slip.told));
    }
}

TEST_F(RecordedSize, OfASingleMarkerIsThatOfItsMotion) {
    experiment_.markers.on_body.resize(1);
    const auto single = [&](double units_per_metre) {
        measurement::Recording made = recording(units_per_metre, 1.0);
        made.tracks.resize(1);
        return error_of(made);
    };
    EXPECT_EQ(single(1.0), "");
    EXPECT_THAT(single(1e3), HasSubstr("motion of"));
}

}  // namespace
}  // namespace myo::setup
