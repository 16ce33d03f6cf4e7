#pragma once

#include "panels/panel.hpp"
#include "panels/widgets.hpp"
#include "viewport/camera.hpp"

namespace myo::ui::panels {

/// What is to be drawn into files, and how large; the file browser then asks where.
class PictureDialog {
public:
    void open(const commands::WorkbenchState& state, const viewport::ViewSize& view);
    void draw(PanelContext& context);

private:
    enum class Kind { picture, frames, film };

    void draw_size(PanelContext& context);
    void draw_time(PanelContext& context);
    void draw_motion(PanelContext& context);

    bool open_ = false;
    Kind kind_ = Kind::picture;
    std::string size_ = "view";
    viewport::ViewSize view_;
    PictureRequest request_;
    OpenEdit edit_;
};

}  // namespace myo::ui::panels
