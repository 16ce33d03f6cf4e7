#include "panels/picture_dialog.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "panels/escape.hpp"
#include "panels/file_dialogs.hpp"
#include "platform/film.hpp"

namespace myo::ui::panels {
namespace {

constexpr int min_side = 64, max_side = 8192;  // of an image [pixels]
constexpr int max_pictures = 20000;            // limit for a sequence

}  // namespace

void PictureDialog::open(const commands::WorkbenchState& state, const viewport::ViewSize& view) {
    open_ = true;
    view_ = view;
    // The dialog starts with the present trial; other choices are kept from the last time.
    const std::array<double, 2> span = commands::time_span(state);
    request_.from_s = std::max(0.0, span[0]);
    request_.to_s = span[1];
    request_.speed = state.speed;
    request_.time_s = state.time_s;
    if (size_ == "view") request_.width = view.width, request_.height = view.height;
}

void PictureDialog::draw_sides(PanelContext& context) {
    // The fields always show the size; only "Other" allows to edit it.
    ImGui::BeginDisabled(size_ != "other");
    for (const auto& [label, word, side] :
         {std::tuple{"Width", "width", &request_.width}, std::tuple{"Height", "height", &request_.height}}) {
        const NumberField field{label,
                                std::string("picture/") + word,
                                commands::Dimension::number,
                                "",
                                "In pixels.",
                                {min_side, max_side},
                                1.0,
                                word,
                                true};
        double pixels = *side;
        bool goes_on = false;
        if (number_row(context, field, edit_, pixels, goes_on)) *side = static_cast<int>(std::lround(pixels));
    }
    ImGui::EndDisabled();
}

/// The fixed sizes are common for slides and videos. Other sizes are typed.
void PictureDialog::draw_size(PanelContext& context) {
    const std::vector<commands::Choice> sizes{{"view", "Like the view", ""},
                                              {"1600x900", "1600 \xc3\x97 900", ""},
                                              {"1920x1080", "1920 \xc3\x97 1080", ""},
                                              {"3840x2160", "3840 \xc3\x97 2160", ""},
                                              {"other", "Other", ""}};
    if (choice_row(context, "Size", "picture/size", "In pixels. The view is rendered at this size, not stretched.",
                   sizes, size_)) {
        if (size_ == "view")
            request_.width = view_.width, request_.height = view_.height;
        else if (size_ != "other")
            // The ids of the fixed sizes contain them.
            std::sscanf(size_.c_str(), "%dx%d", &request_.width, &request_.height);
    }
    draw_sides(context);
    row_label(context.theme, "Annotations");
    ImGui::Checkbox("Legend, scale and names", &request_.overlay);
    context.items.mark("picture/overlay");
    tooltip(context.theme,
            "Draws the overlay of the view into the pictures, too: the legend of the colours, the scale bar, axes, "
            "names of markers, distances, and the time. "
            "Text and lines keep their size relative to the view.");
}

/// A film has no opacity, so it is white instead.
void PictureDialog::draw_background(PanelContext& context) {
    std::vector<commands::Choice> choices{{"view", "Like the view", ""}, {"white", "White", ""}};
    if (kind_ != Kind::film) choices.push_back({"transparent", "Transparent", ""});
    constexpr std::array<PictureBackground, 3> meanings{PictureBackground::view, PictureBackground::white,
                                                        PictureBackground::transparent};
    const auto found = std::find(meanings.begin(), meanings.end(), request_.background);
    std::size_t chosen = std::min(static_cast<std::size_t>(found - meanings.begin()), choices.size() - 1);
    std::string id = choices[chosen].id;
    choice_row(context, "Background", "picture/background",
               "White and transparent pictures have the colours of the light theme, for papers and slides.", choices,
               id);
    for (std::size_t k = 0; k < choices.size(); ++k)
        if (choices[k].id == id) request_.background = meanings[k];
}

void PictureDialog::draw_time(PanelContext& context) {
    const std::array<double, 2> span = commands::time_span(context.state);
    bool goes_on = false;
    if (span[1] > span[0])
        number_row(context,
                   {"Time",
                    "picture/time",
                    commands::Dimension::time,
                    "s",
                    "Time of the picture: the time shown when the dialog was opened",
                    {span[0], span[1]},
                    1e-2},
                   edit_, *request_.time_s, goes_on);
}

/// The number of images is shown, so that the user can judge how long the writing takes.
void PictureDialog::draw_motion(PanelContext& context) {
    const std::array<double, 2> span = commands::time_span(context.state);
    bool goes_on = false;
    number_row(context,
               {"From",
                "picture/from",
                commands::Dimension::time,
                "s",
                "Time of the first picture",
                // Each end limits the other, so that the range is never reversed.
                {span[0], std::clamp(request_.to_s, span[0], span[1])},
                1e-2,
                "first time"},
               edit_, request_.from_s, goes_on);
    number_row(context,
               {"To",
                "picture/to",
                commands::Dimension::time,
                "s",
                "Time of the last picture",
                {request_.from_s, std::max(request_.from_s, span[1])},
                1e-2,
                "last time"},
               edit_, request_.to_s, goes_on);
    number_row(context,
               {"Rate",
                "picture/rate",
                commands::Dimension::frequency,
                "1/s",
                "Pictures per second of the film",
                {1.0, 240.0},
                1.0,
                "rate"},
               edit_, request_.rate_Hz, goes_on);
    number_row(context,
               {"Speed",
                "picture/speed",
                commands::Dimension::ratio,
                "\xc3\x97",
                "Speed of the film relative to real time",
                {0.01, 10.0},
                0.01,
                "speed"},
               edit_, request_.speed, goes_on);
    // A copy: the number of images depends on what is selected now.
    // Successive images are speed / rate apart in the trial [s].
    PictureRequest moving = request_;
    moving.moves = true;
    const int count = picture_count(moving);
    text_row(context.theme, "Pictures", with_separators(count) + (count > max_pictures ? ": too many" : ""),
             count > max_pictures ? &context.theme.failure : nullptr);
}

void PictureDialog::draw_kinds(PanelContext& context) {
    struct Tab {
        Kind kind;
        const char* label;
        const char* item;
    };
    // Checked in each frame, so that a newly installed ffmpeg is found.
    const bool films = platform::can_write_films();
    for (const Tab& t :
         {Tab{Kind::picture, "Picture", "picture/one"}, Tab{Kind::frames, "Numbered pictures", "picture/frames"},
          Tab{Kind::film, "Film (MP4)", "picture/film"}}) {
        if (t.kind != Kind::picture) ImGui::SameLine();
        ImGui::BeginDisabled(t.kind == Kind::film && !films);
        if (tab(context.theme, t.label, kind_ == t.kind)) kind_ = t.kind;
        ImGui::EndDisabled();
        context.items.mark(t.item);
        if (t.kind == Kind::film && !films) tooltip(context.theme, "Films need the program ffmpeg: apt install ffmpeg");
    }
}

void PictureDialog::ask_for_file(PanelContext& context) const {
    PictureRequest asked = request_;
    // H.264 requires even sides.
    if (kind_ == Kind::film) asked.width -= asked.width % 2, asked.height -= asked.height % 2;
    context.window.file = picture_dialog(asked, kind_ == Kind::picture  ? "picture.png"
                                                : kind_ == Kind::frames ? "frames"
                                                                        : "motion.mp4");
}

/// Closes itself before the file browser opens, as only one modal dialog can be in front.
void PictureDialog::draw(PanelContext& context) {
    if (!open_ || !context.state.scene) return;
    if (!begin_dialog(context.theme, "Save the 3D view", 420.0f)) return;
    draw_kinds(context);
    ImGui::Spacing();
    draw_size(context);
    draw_background(context);
    if (kind_ == Kind::picture)
        draw_time(context);
    else
        draw_motion(context);
    request_.moves = kind_ != Kind::picture;
    ImGui::Spacing();
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    // The row of the number of images explains why.
    ImGui::BeginDisabled(picture_count(request_) > max_pictures);
    if (primary_button(context.theme, "Save as\xe2\x80\xa6", {width, 0.0f})) {
        ask_for_file(context);
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndDisabled();
    context.items.mark("picture/where");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {width, 0.0f}) || escape_closes()) {
        open_ = false;
        ImGui::CloseCurrentPopup();
    }
    context.items.mark("picture/cancel");
    ImGui::EndPopup();
}

}  // namespace myo::ui::panels
