#pragma once

#include "panels/panel.hpp"

namespace myo {

/// Messages, newest last.
class LogPanel : public Panel {
public:
    std::string name() const override { return "messages"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    void draw(PanelContext& context) override;

private:
    std::size_t seen_ = 0;
};

}  // namespace myo
