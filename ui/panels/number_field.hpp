#pragma once

#include <array>
#include <map>
#include <string>

#include "commands/typed_quantity.hpp"
#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Description of a number field, which is dragged, or typed after a double click, Ctrl and a click, or Tab. Values are
/// stored in SI units, shown in a convenient one and typed in any unit of the dimension.
struct NumberField {
    std::string label;  // in the left column
    std::string name;   // item name for tests: "model/youngs_modulus"
    commands::Dimension dimension = commands::Dimension::number;
    std::string unit;                   // shown unit, of the dimension; empty for numbers and ratios without one
    std::string tip;                    // tooltip
    commands::Limits limits{0.0, 1.0};  // of the value, SI
    double smallest_step = 1e-3;        // of the shown value per pixel of dragging
    std::string quantity = {};          // in sentences: "Poisson's ratio"; empty: the label
    bool whole_number = false;          // counts
};

/// Texts that are being typed into number fields, and those that were refused and stay in their fields until they are
/// corrected. One object per group of fields, kept by the panel.
class NumberEdits {
public:
    /// A text in one field.
    struct Typed {
        std::array<char, 128> text{};  // as typed, with a terminating zero
        std::string opened;            // the text that the field began with
        bool active = false;           // has the keyboard
        bool again = false;            // gets the keyboard in the next frame
        bool refused = false;          // was tried, and is no value
        double value = 0.0;            // of the field when it was opened
        std::string subject;           // what the value belongs to
    };

    /// The text of a field, null if its value is shown. Drops a refused text if the field has got another value or
    /// subject since, such as by undo.
    Typed* find(const std::string& name, double value, const std::string& subject);
    /// Puts a text into a field in place of its value; the field gets the keyboard in the next frame.
    Typed& open(const std::string& name, const std::string& text, double value, const std::string& subject);
    /// Shows the value of a field again.
    void drop(const std::string& name) { typed_.erase(name); }

    OpenEdit drag;          // drag in progress
    std::string explained;  // name of the field whose refusal is explained next to it

private:
    std::map<std::string, Typed> typed_;  // by the names of the fields
};

/// Draws the field alone, in an item whose width is set. Returns true if the value changed.
///
/// Typed text is tried at Enter, Tab or when the field is left. What is refused stays there, red, with a sentence next
/// to the field, and leaves the value as it is; Escape restores the old text. An accepted text is one edit.
///
/// @param value  SI; changed within the field's limits
/// @param goes_on  set to whether the change continues a drag
/// @param subject  what the value belongs to, if that can change; a text refused for another one is dropped
bool number_field(PanelContext& context, const NumberField& field, NumberEdits& edits, double& value, bool& goes_on,
                  const std::string& subject = {});

/// As number_field(), in a row of the side panel with its label.
bool number_row(PanelContext& context, const NumberField& field, NumberEdits& edits, double& value, bool& goes_on,
                const std::string& subject = {});

}  // namespace myo::ui::panels
