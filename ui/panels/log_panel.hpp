#pragma once

#include <map>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Messages, newest last.
class LogPanel : public Panel {
public:
    std::string name() const override { return "messages"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    void draw(PanelContext& context) override;

private:
    std::size_t seen_ = 0;  // lines since the start
    std::map<std::size_t, float>
        heights_;  // of lines that were drawn, by their number since the start, at this width and scale
    float width_ = 0.0f, scale_ = 0.0f;
};

}  // namespace myo::ui::panels
