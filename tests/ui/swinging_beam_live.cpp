#include <chrono>
#include <thread>

#include "ui/swinging_beam.hpp"

namespace myo::test {
namespace {

class LiveBeam : public ui::commands::LiveModel {
public:
    LiveBeam(SwingingBeam& beam, const ui::commands::Scene& scene, const ui::commands::MeshedBody& body, double modulus,
             std::size_t trial)
        : beam_(beam), scene_(scene), rest_(body.mesh.nodes), modulus_(modulus), trial_(trial) {}

    std::vector<ui::commands::LiveActuator> actuators() const override {
        return {{"lift", "Height", "mm", 1e-3, 0.0, 0.05, 0.0}};
    }
    double spring_N_m() const override { return 40.0; }
    Result<ui::commands::LiveFrame> step(const ui::commands::LiveControls& controls, const Progress&) override {
        std::this_thread::sleep_for(std::chrono::duration<double>(beam_.step_delay_s.load()));
        beam_.live_velocity_force = controls.velocity_force_1_s;
        if (controls.levels.front() > 0.04) return Error{"the beam is too high", ""};
        time_s_ += controls.time_step_s;
        ui::commands::LiveFrame frame;
        frame.time_s = time_s_;
        frame.step_s = controls.time_step_s;
        const Eigen::Vector3d lift(0.0, 0.0, controls.levels.front());
        Eigen::Matrix3Xd x(3, rest_.cols());
        for (Eigen::Index i = 0; i < x.cols(); ++i) x.col(i) = beam_point(rest_.col(i), modulus_, time_s_) + lift;
        for (const ui::commands::SceneMarker& marker : scene_.markers)
            frame.markers_m.push_back(beam_point(marker.rest_m, modulus_, time_s_) + lift);
        if (controls.grip) {
            frame.pulled_m = (x(Eigen::all, controls.grip->nodes) - controls.grip->offsets_m) * controls.grip->shares;
            frame.force_N = controls.spring_N_m * (controls.grip->place_m - frame.pulled_m).norm();
        }
        auto run = std::make_shared<ui::commands::RunResult>();
        run->trials.resize(scene_.trials.size());
        run->trials[trial_].frame_time_s = Eigen::VectorXd::Constant(1, time_s_);
        run->trials[trial_].frames.push_back(std::move(x));
        frame.run = std::move(run);
        return frame;
    }

private:
    SwingingBeam& beam_;
    ui::commands::Scene scene_;
    Eigen::Matrix3Xd rest_;
    double modulus_;
    std::size_t trial_;
    double time_s_ = 0.0;
};

}  // namespace

Result<std::unique_ptr<ui::commands::LiveModel>> SwingingBeam::live(const ui::commands::Scene& scene,
                                                                    const ui::commands::MeshedBody& body,
                                                                    const ui::commands::Settings& settings,
                                                                    std::size_t trial, const ui::commands::LiveModel*,
                                                                    const Progress&) {
    if (refuses_live) return Error{"this body cannot move", ""};
    ++live_models;
    return std::unique_ptr<ui::commands::LiveModel>(
        std::make_unique<LiveBeam>(*this, scene, body, settings.youngs_modulus_Pa, trial));
}

}  // namespace myo::test
