#pragma once

#include "panels/widgets.hpp"

namespace myo {

/// Material, damping and time stepping.
class ModelPanel : public Panel {
public:
    std::string name() const override { return "model"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::rail; }
    void draw(PanelContext& context) override;

private:
    OpenEdit edit_;
};

}  // namespace myo
