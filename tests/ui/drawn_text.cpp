#include "ui/drawn_text.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace myo::test {
namespace {

/// A letter's place in the font texture.
struct TexturePart {
    float u0, v0, u1, v1;
    unsigned letter;
};

constexpr float same_uv = 1e-6f;  // texture coordinates are copied, or moved by whole pixels

constexpr float invisible_px = 1.5f;  // by which some letters reach beyond their place

/// A rectangle of two triangles, as ImGui draws a letter.
struct Quad {
    ImVec2 lowest, highest;
    ImVec2 uv_lowest, uv_highest;
};

/// All letters of the texture, from left to right.
struct Letters {
    std::vector<TexturePart> parts;
    float widest = 0.0f;
};

Letters letters_of_fonts() {
    Letters letters;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (glyph.Visible) {
                letters.parts.push_back({glyph.U0, glyph.V0, glyph.U1, glyph.V1, glyph.Codepoint});
                letters.widest = std::max(letters.widest, glyph.U1 - glyph.U0);
            }
    std::sort(letters.parts.begin(), letters.parts.end(), [](const auto& a, const auto& b) { return a.u0 < b.u0; });
    return letters;
}

/// The letter of which a quad shows all or a part; null if it is none. Letters do not overlap in the texture.
const TexturePart* letter_of(const Letters& letters, const Quad& quad) {
    // A letter that begins farther to the left does not reach the quad.
    const float leftmost = quad.uv_lowest.x - letters.widest - same_uv;
    for (auto part = std::lower_bound(letters.parts.begin(), letters.parts.end(), leftmost,
                                      [](const TexturePart&a, float u) { return a.u0 < u; });
         part != letters.parts.end() && part->u0 <= quad.uv_lowest.x + same_uv; ++part) {
        if (part->u1 >= quad.uv_highest.x - same_uv && part->v0 <= quad.uv_lowest.y + same_uv &&
            part->v1 >= quad.uv_highest.y - same_uv)
            return &*part;
    }
    return nullptr;
}

/// The next two triangles of a list as a rectangle; false if they are something else.
bool read_quad(const ImDrawList& list, unsigned vertex_offset, const ImDrawIdx* index, Quad& quad) {
    if (index[1] != index[0] + 1 || index[2] != index[0] + 2 || index[3] != index[0] || index[4] != index[2] ||
        index[5] != index[0] + 3)
        return false;
    const ImDrawVert* corner = &list.VtxBuffer[static_cast<int>(vertex_offset + index[0])];
    const auto square = [](const ImVec2& a, const ImVec2& b, const ImVec2& c, const ImVec2& d) {
        return a.x == d.x && b.x == c.x && a.y == b.y && c.y == d.y && c.x > a.x && c.y > a.y;
    };
    if (!square(corner[0].pos, corner[1].pos, corner[2].pos, corner[3].pos) ||
        !square(corner[0].uv, corner[1].uv, corner[2].uv, corner[3].uv))
        return false;
    quad = {corner[0].pos, corner[2].pos, corner[0].uv, corner[2].uv};
    return true;
}

/// Collects the letters of one window into texts.
class TextReader {
public:
    TextReader(std::string window, const Letters& letters) : window_(std::move(window)), letters_(letters) {}

    void add(const Quad& quad, const ImVec4& clip) {
        const TexturePart* letter = letter_of(letters_, quad);
        if (letter == nullptr) return;
        const float top = std::max(quad.lowest.y, clip.y), foot = std::min(quad.highest.y, clip.w);
        if (foot <= top) return;
        // In the texture and in the window a letter has the same size.
        const float hidden_px = (letter->u1 - letter->u0 - (quad.uv_highest.x - quad.uv_lowest.x)) *
                                static_cast<float>(ImGui::GetIO().Fonts->TexWidth);
        const float outside_px = std::max(clip.x - quad.lowest.x, quad.highest.x - clip.z);
        const bool cut = std::max(hidden_px, outside_px) > invisible_px;
        if (!follows(quad)) texts.push_back({window_, {}, {quad.lowest, quad.lowest}, false});
        DrawnText& text = texts.back();
        if (!text.text.empty() && quad.lowest.x - last_.highest.x > 0.2f * ImGui::GetFontSize()) text.text += ' ';
        char utf8[5];
        text.text += ImTextCharToUtf8(utf8, letter->letter);
        text.cut = text.cut || cut;
        text.part.lowest = {std::max(clip.x, std::min(text.part.lowest.x, quad.lowest.x)),
                            std::min(std::max(text.part.lowest.y, clip.y), top)};
        text.part.highest = {std::min(clip.z, std::max(text.part.highest.x, quad.highest.x)),
                             std::max(text.part.highest.y, foot)};
        last_ = quad;
    }
    /// Something else was drawn.
    void pause() { paused_ = true; }

    std::vector<DrawnText> texts;

private:
    bool follows(const Quad& quad) {
        const bool next = !paused_ && !texts.empty() && quad.lowest.x > last_.lowest.x &&
                          quad.lowest.x - last_.highest.x < 20.0f &&
                          quad.lowest.y < texts.back().part.highest.y + 8.0f &&
                          quad.highest.y > texts.back().part.lowest.y - 8.0f;
        paused_ = false;
        return next;
    }

    std::string window_;
    const Letters& letters_;
    Quad last_{};
    bool paused_ = false;
};

bool overlap(const ui::platform::Rectangle& a, const ui::platform::Rectangle& b) {
    constexpr float touching = 2.0f;
    return std::min(a.highest.x, b.highest.x) - std::max(a.lowest.x, b.lowest.x) > touching &&
           std::min(a.highest.y, b.highest.y) - std::max(a.lowest.y, b.lowest.y) > touching;
}

}  // namespace

std::vector<DrawnText> drawn_text() {
    const Letters letters = letters_of_fonts();
    const ImDrawData& drawn = *ImGui::GetDrawData();
    std::vector<DrawnText> all;
    for (int l = 0; l < drawn.CmdListsCount; ++l) {
        const ImDrawList& list = *drawn.CmdLists[l];
        TextReader reader(list._OwnerName != nullptr ? list._OwnerName : "", letters);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback != nullptr || command.GetTexID() != ImGui::GetIO().Fonts->TexID) continue;
            reader.pause();
            const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
            for (unsigned i = 0; i + 6 <= command.ElemCount;) {
                Quad quad;
                if (read_quad(list, command.VtxOffset, index + i, quad)) {
                    reader.add(quad, command.ClipRect);
                    i += 6;
                } else {
                    reader.pause();
                    i += 3;
                }
            }
        }
        all.insert(all.end(), reader.texts.begin(), reader.texts.end());
    }
    return all;
}

std::vector<std::string> text_defects(const std::vector<DrawnText>& texts) {
    std::vector<std::string> defects;
    for (std::size_t a = 0; a < texts.size(); ++a) {
        const auto place = [](const DrawnText& text) {
            return " at " + std::to_string(std::lround(text.part.lowest.x)) + ", " +
                   std::to_string(std::lround(text.part.lowest.y));
        };
        if (texts[a].cut) defects.push_back("cut: \"" + texts[a].text + "\"" + place(texts[a]));
        for (std::size_t b = 0; b < a; ++b)
            if (texts[a].window == texts[b].window && overlap(texts[a].part, texts[b].part))
                defects.push_back("\"" + texts[b].text + "\" and \"" + texts[a].text + "\" overlap" + place(texts[a]));
    }
    return defects;
}

}  // namespace myo::test
