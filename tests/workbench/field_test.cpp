#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

/// The bundled beam, let go under gravity, at the lowest point of its first swing.
TEST(CoreFields, ABeamThatHangsIsPulledAboveAndPressedBelow) {
    Driver driver(backend::make_core_backend(), 1200, 800);
    driver.workbench->execute(
        ui::commands::Open{std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam", std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    const ui::commands::WorkbenchState& state = driver.state();
    const ui::commands::Backend& backend = driver.workbench->backend();
    const auto values = [&](const std::string& id, std::size_t frame) {
        return backend.field(id, *state.body, *state.run, 0, frame);
    };
    const ui::commands::SimulatedTrial& trial = state.run->trials[0];
    std::size_t lowest = 0;
    for (std::size_t f = 0; f < trial.frames.size(); ++f)
        if (trial.frames[f].row(2).minCoeff() < trial.frames[lowest].row(2).minCoeff()) lowest = f;
    const Eigen::Matrix3Xd& rest = state.body->mesh.nodes;
    // Half way along, away from clamp and tip.
    double above = 0.0, below = 0.0;
    const Eigen::VectorXd pressure = values("pressure", lowest);
    for (Eigen::Index i = 0; i < rest.cols(); ++i) {
        if (rest(0, i) < 0.03 || rest(0, i) > 0.06) continue;
        if (rest(2, i) > 0.0199) above += pressure(i);
        if (rest(2, i) < 0.0001) below += pressure(i);
    }
    EXPECT_LT(above, 0.0);
    EXPECT_GT(below, 0.0);
    // Most stress at the clamp, where the moment is largest; none to speak of at the free end.
    const Eigen::VectorXd stress = values("von_mises", lowest);
    Eigen::Index most = 0;
    stress.maxCoeff(&most);
    EXPECT_LT(rest(0, most), 0.02);
    EXPECT_GT(values("stretch", lowest).maxCoeff(), 1.02);
    // Straight, it begins without stress and speed.
    EXPECT_LT(values("von_mises", 0).maxCoeff(), 1e-6 * state.settings.youngs_modulus_Pa);
    EXPECT_EQ(values("displacement", 0).maxCoeff(), 0.0);
    EXPECT_GT(values("velocity", lowest / 2).maxCoeff(), 0.05);
    EXPECT_EQ(values("activation", lowest).cwiseAbs().maxCoeff(), 0.0) << "it has no muscle";
    for (const ui::commands::FieldKind& kind : backend.fields())
        EXPECT_EQ(values(kind.id, lowest).size(), rest.cols()) << kind.id;
}

}  // namespace
}  // namespace myo
