#pragma once

#include "panels/widgets.hpp"

namespace myo {

/// How the motion is stepped in time, with the damping that this brings.
class TimePanel : public Panel {
public:
    std::string name() const override { return "time"; }
    std::string title() const override { return "Time step"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<Step> step() const override { return Step::run; }
    void draw(PanelContext& context) override;

private:
    void draw_numerical_damping(PanelContext& context);

    OpenEdit edit_;
};

}  // namespace myo
