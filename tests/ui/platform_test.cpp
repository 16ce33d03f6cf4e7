#include <gtest/gtest.h>

#include "platform/gl_objects.hpp"
#include "platform/image.hpp"
#include "platform/interface.hpp"
#include "platform/offscreen_context.hpp"
#include "platform/shader_sources.hpp"

namespace myo::ui {
namespace {

TEST(Shaders, EveryPairCompiles) {
    auto context = platform::OffscreenContext::make(16, 16);
    ASSERT_TRUE(context) << context.error().text();
    for (const char* name : {"interface", "surface", "line", "marker", "backdrop"}) {
        const auto program = ui::platform::gl::make_program(name);
        EXPECT_TRUE(program) << (program ? "" : program.error().text());
    }
    const auto missing = ui::platform::gl::make_program("no_such_shader");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().text().find("shaders/no_such_shader.vert"), std::string::npos);
}

TEST(OffscreenContext, RefusesImpossibleSizes) {
    EXPECT_FALSE(platform::OffscreenContext::make(0, 16));
    EXPECT_FALSE(platform::OffscreenContext::make(100000, 16));
}

TEST(Image, ReadsTheFrameFromTheTop) {
    auto context = platform::OffscreenContext::make(8, 4);
    ASSERT_TRUE(context);
    ui::platform::gl::ClearColor(0.0f, 0.0f, 1.0f, 1.0f);
    ui::platform::gl::Clear(GL_COLOR_BUFFER_BIT);
    ui::platform::gl::Enable(GL_SCISSOR_TEST);
    ui::platform::gl::Scissor(0, 3, 8, 1);  // OpenGL counts rows from below
    ui::platform::gl::ClearColor(1.0f, 0.0f, 0.0f, 1.0f);
    ui::platform::gl::Clear(GL_COLOR_BUFFER_BIT);
    ui::platform::gl::Disable(GL_SCISSOR_TEST);
    const platform::Image image = platform::read_frame(8, 4);
    EXPECT_EQ(image.color(3, 0), (std::array<int, 3>{255, 0, 0}));
    EXPECT_EQ(image.color(3, 1), (std::array<int, 3>{0, 0, 255}));
}

TEST(Fonts, HoldTheLettersOfTheField) {
    auto context = platform::OffscreenContext::make(64, 64);
    ASSERT_TRUE(context);
    auto interface = platform::Interface::make(platform::ThemeName::dark, 1.0f);
    ASSERT_TRUE(interface) << interface.error().text();
    interface->begin_frame(64, 64, 0.02f);
    interface->end_frame();
    if (!interface->theme().regular->FindGlyphNoFallback(0x3bd))
        GTEST_SKIP() << "skipped: neither Inter nor DejaVu is installed";
    const ImWchar needed[] = {0x2264, 0xb2,   0xb3,   0xb7,  0xb1,   0xb0,   0x2212, 0x39b,  0x3bd,  0x3c1, 0x3b6,
                              0x394,  0x2080, 0x2032, 0x3b1, 0x221e, 0x2013, 0x221a, 0x2081, 0x1d40, 0x1d65};
    for (const ImWchar c : needed) {
        EXPECT_NE(interface->theme().regular->FindGlyphNoFallback(c), nullptr) << "U+" << std::hex << c;
        EXPECT_NE(interface->theme().strong->FindGlyphNoFallback(c), nullptr) << "U+" << std::hex << c;
    }
}

TEST(Fonts, LoadLettersOfOtherScriptsWhenTheyAreNeeded) {
    auto context = platform::OffscreenContext::make(64, 64);
    ASSERT_TRUE(context);
    auto interface = platform::Interface::make(platform::ThemeName::dark, 1.0f);
    ASSERT_TRUE(interface) << interface.error().text();
    const auto frame = [&] {
        interface->begin_frame(64, 64, 0.02f);
        interface->end_frame();
    };
    frame();
    constexpr ImWchar zhe = 0x436, not_a_letter = 0xfffd;
    if (!interface->theme().regular->FindGlyphNoFallback(not_a_letter)) GTEST_SKIP() << "skipped: no DejaVu";
    EXPECT_EQ(interface->theme().regular->FindGlyphNoFallback(zhe), nullptr);
    interface->need_letters("\xd0\xb6 \xe9\xad\x9a");
    frame();
    EXPECT_NE(interface->theme().regular->FindGlyphNoFallback(zhe), nullptr);
    EXPECT_NE(interface->theme().strong->FindGlyphNoFallback(zhe), nullptr);
    EXPECT_EQ(interface->theme().regular->FallbackChar, not_a_letter) << "what no font has is no question mark";
}

class InputRules : public testing::Test {
protected:
    InputRules() { ImGui::CreateContext(); }
    ~InputRules() override { ImGui::DestroyContext(); }
    ImGuiIO& frame() {
        queue.apply_to_next_frame(ImGui::GetIO());
        return ImGui::GetIO();
    }
    platform::InputQueue queue;
};

TEST_F(InputRules, PressNeverComesInTheFrameOfAMove) {
    queue.push(platform::MouseMoved{5, 5});
    queue.push(platform::MouseMoved{10, 20});
    queue.push(platform::MouseButton{0, true, {}});
    queue.push(platform::MouseButton{0, false, {}});
    EXPECT_EQ(frame().MousePos.y, 20.0f);
    EXPECT_FALSE(ImGui::GetIO().MouseDown[0]);
    EXPECT_TRUE(frame().MouseDown[0]);
    EXPECT_FALSE(frame().MouseDown[0]);
    EXPECT_TRUE(queue.empty());
}

TEST_F(InputRules, MoveAfterAReleaseWaits) {
    queue.push(platform::MouseButton{0, true, {}});
    queue.push(platform::MouseMoved{50, 5});
    queue.push(platform::MouseButton{0, false, {}});
    queue.push(platform::MouseMoved{90, 5});
    frame();
    EXPECT_TRUE(frame().MouseDown[0]);
    EXPECT_EQ(ImGui::GetIO().MousePos.x, 50.0f);
    EXPECT_FALSE(frame().MouseDown[0]);
    EXPECT_EQ(ImGui::GetIO().MousePos.x, 50.0f);
    EXPECT_EQ(frame().MousePos.x, 90.0f);
}

TEST_F(InputRules, TextNeverComesInTheFrameOfAKey) {
    queue.push(platform::KeyPressed{ImGuiKey_A, true, {.ctrl = true}});
    queue.push(platform::TextTyped{'7'});
    queue.push(platform::TextTyped{'8'});
    EXPECT_TRUE(frame().KeysDown[ImGuiKey_A]);
    EXPECT_TRUE(ImGui::GetIO().KeyCtrl);
    EXPECT_EQ(ImGui::GetIO().InputQueueCharacters.Size, 0);
    EXPECT_EQ(frame().InputQueueCharacters.Size, 2);
}

TEST(FramePacer, DrawsThreeFramesAfterAnEvent) {
    platform::FramePacer pacer;
    for (int i = 0; i < 3; ++i) pacer.frame_drawn();
    EXPECT_FALSE(pacer.must_draw(false));
    EXPECT_TRUE(pacer.must_draw(true));
    pacer.event_arrived();
    for (int i = 0; i < 3; ++i) {
        EXPECT_TRUE(pacer.must_draw(false));
        pacer.frame_drawn();
    }
    EXPECT_FALSE(pacer.must_draw(false));
}

}  // namespace
}  // namespace myo::ui
