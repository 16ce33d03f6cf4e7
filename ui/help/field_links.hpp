#pragma once

#include <string>
#include <vector>

namespace myo::ui::help {

/// Where the manual defines the quantity of a field.
struct FieldLink {
    const char* field;   // item name of the field, or its beginning up to a "/"
    const char* page;    // ManualPage::name
    const char* phrase;  // text of the paragraph, heading or table
};

/// All links, the longest names first.
const std::vector<FieldLink>& field_links();
/// The link of a field: the one with its name, or else the longest beginning up to a "/"; null if there is none.
const FieldLink* link_of(const std::string& field);

}  // namespace myo::ui::help
