#pragma once

#include "panels/number_field.hpp"
#include "panels/panel.hpp"
#include "viewport/camera.hpp"

namespace myo::ui::panels {

/// Dialog for saving the 3D view: kind of output, size and times. The file browser then asks for the name.
///
/// Images have a size of their own: the view is rendered again in that size, not scaled. Videos need ffmpeg.
class PictureDialog {
public:
    /// Opens the dialog. `view` is the present size of the view, the default for the size of images.
    void open(const commands::WorkbenchState& state, const viewport::ViewSize& view);
    /// Draws the dialog while it is open.
    void draw(PanelContext& context);

private:
    enum class Kind { picture, frames, film };  // one image, numbered images, or a video

    /// Rows for the size of the image [pixels] and the annotations.
    void draw_size(PanelContext& context);
    /// Row for what is behind the body.
    void draw_background(PanelContext& context);
    /// Fields of width and height.
    void draw_sides(PanelContext& context);
    /// Tabs of what is written: a picture, pictures of the motion, or a film.
    void draw_kinds(PanelContext& context);
    /// Requests the dialog for the file or folder.
    void ask_for_file(PanelContext& context) const;
    /// Row for the time of a single image.
    void draw_time(PanelContext& context);
    /// Rows for the motion: range of times, rate and speed.
    void draw_motion(PanelContext& context);

    bool open_ = false;          // the dialog is shown
    Kind kind_ = Kind::picture;  // selected kind of output
    std::string size_ = "view";  // id of the selected size
    viewport::ViewSize view_;    // size of the view when the dialog was opened
    PictureRequest request_;     // as edited
    NumberEdits edit_;           // edits in progress
};

}  // namespace myo::ui::panels
