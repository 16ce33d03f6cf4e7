#include "platform/fonts.hpp"

#include <imgui.h>
#include <imgui_freetype.h>

#include <cmath>
#include <filesystem>

#include "platform/wide_fonts.hpp"

namespace myo::ui::platform {
namespace {

/// Returns the first of these files that exists, or an empty string.
std::string first_existing(const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(file, ignored)) return file;
    }
    return {};
}

// Latin, Greek, superscripts and subscripts, dashes and quotes, arrows, and the mathematical symbols that labels use.
// Each range costs space in the font texture, so only these are rasterised.
const ImWchar text_ranges[] = {0x0020, 0x024f, 0x02b0, 0x036f, 0x0370, 0x03ff, 0x1d2c, 0x1d6a, 0x2010, 0x2027,
                               0x2030, 0x2033, 0x2070, 0x209c, 0x2150, 0x215e, 0x2190, 0x2195, 0x2202, 0x2202,
                               0x2207, 0x2207, 0x2212, 0x2212, 0x221a, 0x221e, 0x223c, 0x223c, 0x2248, 0x2248,
                               0x2260, 0x2265, 0x22c5, 0x22c5, 0xfffd, 0xfffd, 0};
// Fonts of exported images are rasterised at a large size, so they hold only what names, units and numbers need.
const ImWchar label_ranges[] = {0x0020, 0x017f, 0x0370, 0x03ff, 0x2010, 0x2027, 0x2070, 0x209c,
                                0x2190, 0x2195, 0x2212, 0x2212, 0xfffd, 0xfffd, 0};
const ImWchar latin_ranges[] = {0x0020, 0x007e, 0};
const ImWchar icon_ranges[] = {0xf000, 0xf2e0, 0};

const std::string inter = "/usr/share/fonts/opentype/inter/Inter-";
const std::string dejavu = "/usr/share/fonts/truetype/dejavu/DejaVuSans";

/// Merges letters into the font that was added last, each from the first file that has it.
void merge_letters(ImFontAtlas& atlas, const std::vector<ImWchar>& letters, float pixels) {
    if (letters.empty()) return;
    ImFontConfig merge;
    merge.MergeMode = true;
    std::vector<std::string> files = wide_fonts(font_folders());
    files.insert(files.begin(), first_existing({dejavu + ".ttf"}));
    for (const std::string& file : files)
        if (!file.empty()) atlas.AddFontFromFileTTF(file.c_str(), pixels, &merge, letters.data());
}

/// Returns the font atlas of the current ImGui context, emptied and set to rasterise through FreeType.
ImFontAtlas& empty_atlas() {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    return atlas;
}

/// Adds one font at `pixels` height: `file`, with the glyphs that it lacks taken from `fallback` and icons merged in.
/// An empty file name skips that part; with neither text file ImGui's built-in bitmap font is used.
ImFont* add_font(ImFontAtlas& atlas, const std::string& file, const std::string& fallback, const std::string& icons,
                 float pixels, const ImWchar* ranges = text_ranges) {
    if (file.empty() && fallback.empty()) {
        ImFontConfig built_in;
        built_in.SizePixels = pixels;
        return atlas.AddFontDefault(&built_in);
    }
    const std::string& main = file.empty() ? fallback : file;
    ImFont* font = atlas.AddFontFromFileTTF(main.c_str(), pixels, nullptr, ranges);
    ImFontConfig merge;
    merge.MergeMode = true;
    if (!file.empty() && !fallback.empty()) atlas.AddFontFromFileTTF(fallback.c_str(), pixels, &merge, ranges);
    if (!icons.empty()) {
        merge.GlyphMinAdvanceX = std::round(pixels * 1.1f);
        atlas.AddFontFromFileTTF(icons.c_str(), std::round(pixels * 0.95f), &merge, icon_ranges);
    }
    return font;
}

}  // namespace

FontReport load_fonts(Theme& theme, const std::vector<ImWchar>& letters) {
    ImFontAtlas& atlas = empty_atlas();
    const std::string regular = first_existing({inter + "Regular.otf"});
    const std::string strong = first_existing({inter + "SemiBold.otf", inter + "Bold.otf"});
    const std::string fallback = first_existing({dejavu + ".ttf"});
    const std::string strong_fallback = first_existing({dejavu + "-Bold.ttf", dejavu + ".ttf"});
    const std::string icons = first_existing({"/usr/share/fonts/opentype/font-awesome/FontAwesome.otf",
                                              "/usr/share/fonts/truetype/font-awesome/fontawesome-webfont.ttf"});
    const float text = std::round(15.0f * theme.scale), small = std::round(13.0f * theme.scale);
    theme.regular = add_font(atlas, regular, fallback, icons, text);
    merge_letters(atlas, letters, text);
    theme.strong = add_font(atlas, strong, strong_fallback, icons, text);
    merge_letters(atlas, letters, text);
    theme.small = add_font(atlas, regular, fallback, icons, small);
    merge_letters(atlas, letters, small);
    theme.large = add_font(atlas, strong, strong_fallback, icons, std::round(26.0f * theme.scale), latin_ranges);
    ImGui::GetIO().FontDefault = theme.regular;
    return {regular.empty() ? fallback : regular, icons};
}

void load_label_font(Theme& theme, const std::vector<ImWchar>& letters) {
    ImFontAtlas& atlas = empty_atlas();
    theme.regular = theme.strong = theme.large = nullptr;
    theme.small = add_font(atlas, first_existing({inter + "Regular.otf"}), first_existing({dejavu + ".ttf"}), "",
                           std::round(13.0f * theme.scale), label_ranges);
    merge_letters(atlas, letters, std::round(13.0f * theme.scale));
    ImGui::GetIO().FontDefault = theme.small;
}

}  // namespace myo::ui::platform
