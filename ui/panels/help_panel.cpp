#include "panels/help_panel.hpp"

#include <imgui.h>

#include "help/manual_pages.hpp"
#include "panels/actions.hpp"
#include "panels/escape.hpp"
#include "panels/markdown_view.hpp"
#include "panels/tables.hpp"
#include "panels/widgets.hpp"
#include "panels/wrapped_text.hpp"
#include "platform/fonts.hpp"

namespace myo::ui::panels {
namespace {

using Part = HelpRequest::Part;

/// A part of the help and its button.
struct PartTab {
    Part part;
    const char* label;
    const char* item;
};
constexpr PartTab part_tabs[] = {{Part::tutorial, "Tutorial", "help/tutorial"},
                                 {Part::manual, "Manual", "help/manual"},
                                 {Part::shortcuts, "Keys", "help/shortcuts"}};

// Frames until the heights of all blocks above a target are known.
constexpr int settling_frames = 3;

}  // namespace

void HelpPanel::show_page(const std::string& name) {
    if (page_ == name) return;
    page_ = name;
    blocks_ = help::read_markdown(help::manual_text(name));
}

void HelpPanel::open(const HelpRequest& request) {
    open_ = true;
    part_ = request.part;
    if (part_ != Part::manual) return;
    show_page(request.page.empty() ? (page_.empty() ? help::manual_pages.front().name : page_) : request.page);
    if (request.phrase.empty()) return;
    if (const std::size_t found = help::find_block(blocks_, request.phrase); found < blocks_.size())
        target_ = found, draws_ = settling_frames;
}

void HelpPanel::draw(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    for (const PartTab& each : part_tabs) {
        if (&each != part_tabs) ImGui::SameLine();
        if (tab(theme, each.label, part_ == each.part)) open({each.part, "", ""});
        context.items.mark(each.item);
    }
    const float cross = ImGui::CalcTextSize(platform::icon::remove).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    const float corner = ImGui::GetWindowContentRegionMax().x - cross,
                tabs_end = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    // In a narrow panel the button that closes gets a line of its own.
    if (tabs_end + ImGui::GetStyle().ItemSpacing.x < corner) ImGui::SameLine(corner);
    // Escape belongs to the panel only while the mouse or the keyboard is in it: elsewhere it ends tools.
    const bool escape = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) && escape_closes();
    if (ImGui::Button(platform::icon::remove) || escape) close();
    context.items.mark("help/close");
    tooltip(theme, "Close the help (F1)");
    ImGui::BeginChild("help content", {0.0f, 0.0f});
    if (part_ == Part::tutorial) draw_tutorial(context);
    if (part_ == Part::manual) draw_manual(context);
    if (part_ == Part::shortcuts) draw_shortcuts(context);
    ImGui::EndChild();
}

void HelpPanel::draw_tutorial(PanelContext& context) {
    muted_text(context.theme, "From a body to a diagnosis. Each step is ticked when it is done.");
    for (std::size_t s = 0; s < tutorial_length; ++s) draw_step(context, s);
    ImGui::Spacing();
    if (progress_.next() == tutorial_length)
        notice(context.theme, commands::LogLevel::done, "All steps are done. Report writes pages and pictures.");
    if (ImGui::Button("Begin again", {-1.0f, 0.0f})) progress_.begin_again();
    context.items.mark("help/again");
}

void HelpPanel::draw_step(PanelContext& context, std::size_t index) {
    const platform::Theme& theme = context.theme;
    const TutorialStep& step = tutorial_steps()[index];
    // Only the next step has a button, so that one thing is to be done at a time.
    const bool done = progress_.done(index), next = progress_.next() == index;
    ImGui::Spacing();
    ImGui::TextColored(done ? theme.success : theme.muted, "%s",
                       done ? platform::icon::check : (std::to_string(index + 1) + ".").c_str());
    if (done) context.items.mark(std::string("help/done/") + step.id);
    ImGui::SameLine(28.0f * theme.scale);
    ImGui::PushFont(next ? theme.strong : theme.regular);
    ImGui::TextUnformatted(step.title);
    ImGui::PopFont();
    ImGui::Indent(28.0f * theme.scale);
    muted_text(theme, step.text);
    if (next) {
        if (ImGui::Button((std::string("Show the task ") + commands::task_title(step.task)).c_str()))
            context.window.task = step.task;
        context.items.mark(std::string("help/step/") + step.id);
    }
    ImGui::Unindent(28.0f * theme.scale);
}

void HelpPanel::draw_manual(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    std::string title;
    for (const help::ManualPage& page : help::manual_pages)
        if (page_ == page.name) title = page.title;
    const ImGuiStyle& style = ImGui::GetStyle();
    // Pages and sections share a line if the title of the page fits into half of it.
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - style.ItemSpacing.x);
    const float needed = ImGui::CalcTextSize(title.c_str()).x + 2.0f * style.FramePadding.x + ImGui::GetFrameHeight();
    // Otherwise one list stands below the other.
    const bool beside = needed < half;
    ImGui::SetNextItemWidth(beside ? half : -1.0f);
    const bool pages = ImGui::BeginCombo("##page", title.c_str());
    context.items.mark("help/page");
    if (pages) {
        for (const help::ManualPage& page : help::manual_pages) {
            if (ImGui::Selectable(page.title, page_ == page.name)) open({Part::manual, page.name, ""});
            context.items.mark(std::string("help/page/") + page.name);
        }
        ImGui::EndCombo();
    }
    if (beside) ImGui::SameLine();
    ImGui::SetNextItemWidth(beside ? half : -1.0f);
    const bool sections = ImGui::BeginCombo("##section", "Go to\xe2\x80\xa6");
    context.items.mark("help/section");
    if (sections) {
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            // The title of the page is left out: it is its first line.
            if (blocks_[b].kind != help::Block::Kind::heading || blocks_[b].level < 2) continue;
            const std::string indent(blocks_[b].level == 2 ? 0 : 4, ' ');
            if (ImGui::Selectable((indent + blocks_[b].text + "##" + std::to_string(b)).c_str()))
                target_ = b, draws_ = settling_frames;
            context.items.mark("help/section/" + blocks_[b].text);
        }
        ImGui::EndCombo();
    }
    ImGui::BeginChild(page_.c_str(), {0.0f, 0.0f});
    draw_markdown(theme, blocks_, draws_ > 0 ? target_ : std::nullopt);
    // The target is sought over several frames, as the heights of blocks above it are known only once they were drawn.
    if (draws_ > 0) --draws_;
    ImGui::EndChild();
    context.items.mark("help/text");
}

void HelpPanel::draw_shortcuts(PanelContext& context) {
    const platform::Theme& theme = context.theme;
    if (!ImGui::BeginTable("keys", 2, ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, 110.0f * theme.scale);
    ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch);
    // The list of actions gives the shortcuts of menus, so that both always agree; the mouse and the keys of fields
    // follow.
    const auto row = [&](const std::string& keys, const std::string& what) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(keys.c_str());
        ImGui::TableNextColumn();
        wrapped_text(what);
    };
    for (const Action& action : all_actions())
        if (action.shortcut.label[0] != '\0') {
            row(action.shortcut.label, action.menu + ": " + action.label);
            context.items.mark("help/key/" + action.id);
        }
    row("\xe2\x86\x90, \xe2\x86\x92", "One sample back or forward in time; entries of an open list");
    row("Tab", "Next number field");
    row("Enter, Escape", "Take what is typed, or restore the old value");
    row("Escape", "Closes what is on top: list, dialog, then the tool of the view");
    row("Drag, Shift+drag", "Turns the view, moves it; the wheel zooms");
    ImGui::EndTable();
}

}  // namespace myo::ui::panels
