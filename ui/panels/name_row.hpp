#pragma once

#include <string>

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Text that is being typed into one of the name fields of a panel. One object per panel.
class NameEdit {
public:
    /// Draws a row with a name. Returns true once it has been changed, at Enter or when the field is left.
    ///
    /// @param name   item name for tests
    /// @param value  the present name; receives the new one
    bool row(PanelContext& context, const std::string& label, const std::string& name, const std::string& tip,
             std::string& value);

private:
    std::string field_;  // that is being typed into; empty: none
    std::string typed_;
};

}  // namespace myo::ui::panels
