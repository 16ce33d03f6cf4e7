#pragma once

#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "fibre/painted_mask.hpp"
#include "toml/toml_path.hpp"

namespace myo::ui::commands {

/// Text of experiment.toml with the edits of the window. Compared by content.
struct Declaration {
    std::shared_ptr<const std::string> text;  // null: as it was opened
    std::string mesh_words;                   // body, support and parts where they differ from those opened; else empty
    /// Masks of parts that were painted in the window, by the names that the text has for their files. A name is made
    /// from the content, so that texts alone decide about equality.
    std::map<std::string, std::shared_ptr<const fibre::PaintedMask>> painted = {};

    bool operator==(const Declaration& other) const {
        const bool same_text = text == other.text || (text && other.text && *text == *other.text);
        return same_text && mesh_words == other.mesh_words;
    }
};

/// Sets a value of the declaration, in TOML syntax.
struct SetDeclared {
    toml::TomlPath path;
    std::string value;
};
/// Removes a key, a table or an element.
struct RemoveDeclared {
    toml::TomlPath path;
};
/// Appends an element to an array of tables.
struct AppendDeclared {
    toml::TomlPath array;
    std::string body;  // lines "key = value"
};
/// Copies an element of an array of tables behind itself, under another name.
struct DuplicateDeclared {
    toml::TomlPath element;
    std::string name;
};
/// Renames a marker or probe wherever the declaration names it; recordings keep the label they have for it.
struct RenameMarker {
    std::string name, wanted;
};
/// Says by paint where a part is, instead of by its box, file or region. The mask becomes a file when the declaration
/// is written.
struct PaintDeclared {
    std::size_t part = 0;  // index in the declaration
    std::shared_ptr<const fibre::PaintedMask> mask;
};
/// One edit of a declaration.
using DeclarationEdit = std::variant<SetDeclared, RemoveDeclared, AppendDeclared, DuplicateDeclared, RenameMarker,
                                     PaintDeclared>;

}  // namespace myo::ui::commands
