#pragma once

#include <array>
#include <string>
#include <vector>

#include "panels/panel.hpp"

namespace myo::ui::panels {

inline constexpr std::array axis_names{"x", "y", "z"};

/// Words about the last item while the mouse is over it; `width` in units of the scale.
void tooltip(const platform::Theme& theme, const std::string& text, float width = 380.0f);

/// A button that is one of several to choose from.
bool tab(const platform::Theme& theme, const char* label, bool chosen);

void right_aligned(const std::string& text);
void heading(const platform::Theme& theme, const std::string& text);

/// "42 s", "3 min 5 s", "1 h 2 min"
std::string duration_label(double seconds);

// Rows of the side: a label on the left, the value on the right, all aligned.

/// Label in the left column; leaves the cursor at the right one with the remaining width set for the next item.
void row_label(const platform::Theme& theme, const std::string& label, const std::string& tip = {});

/// A label and a text that wraps; both together are the last item then.
void text_row(const platform::Theme& theme, const std::string& label, const std::string& value,
              const ImVec4* color = nullptr);

/// Wrapped text in the secondary colour.
void muted_text(const platform::Theme& theme, const std::string& text);

/// A sentence that a person should notice, with an icon.
void notice(const platform::Theme& theme, commands::LogLevel level, const std::string& text);

/// A button in the accent colour, for the one thing to do next.
bool primary_button(const platform::Theme& theme, const std::string& label, const ImVec2& size);

/// A number that is dragged, or typed after a double click.
struct NumberField {
    std::string label;
    std::string name;  // of the item, as "model/youngs_modulus"
    std::string unit;
    std::string tip;
    double per_unit = 1.0;              // shown value = value / per_unit
    commands::Limits limits{0.0, 1.0};  // of the value itself
    double smallest_step = 1e-3;        // of the shown value, while dragging
};

/// Which field's edit is going on: changes of one drag are one step for undo.
class OpenEdit {
public:
    /// After the field's item was submitted: whether a change in this frame continues an earlier one.
    bool goes_on(const std::string& name, bool changed);

private:
    std::string name_;
};

/// True when changed; `goes_on` tells whether by the same drag as before.
bool number_row(PanelContext& context, const NumberField& field, OpenEdit& edit, double& value, bool& goes_on);

/// A slider below its number, without words of its own; `shown` is rounded to what a person would type. True when
/// changed.
bool slider_row(PanelContext& context, const std::string& name, commands::Limits shown_limits, bool logarithmic,
                OpenEdit& edit, double& shown, bool& goes_on);

/// A list; true when another entry was chosen.
bool choice_row(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip,
                const std::vector<commands::Choice>& choices, std::string& id);

/// A question in the middle of the window that wants an answer before anything else, `width` in units of the scale.
/// False when it is not drawn; else to be ended with ImGui::EndPopup().
bool begin_dialog(const platform::Theme& theme, const char* title, float width);

/// A popup that stands on the last item, as parts at the foot of the window need; Esc closes it. False when it is not
/// open; else to be ended with ImGui::EndPopup().
bool begin_popup_above(const platform::Theme& theme, const char* name, float width);

/// "12,345"
std::string with_separators(double count);

}  // namespace myo::ui::panels
