#pragma once

#include <string>

#include "panels/file_browser.hpp"
#include "panels/widgets.hpp"

namespace myo {

/// Opens a body and sets how it is meshed.
class BodyPanel : public Panel {
public:
    std::string name() const override { return "body"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::rail; }
    void draw(PanelContext& context) override;

private:
    void draw_open(PanelContext& context);
    void draw_mesh_settings(PanelContext& context);
    void draw_report(PanelContext& context);
    void ask_unit(PanelContext& context);

    std::string path_;
    FileBrowser browser_;
    OpenEdit edit_;
    std::shared_ptr<const Scene> scene_;
};

}  // namespace myo
