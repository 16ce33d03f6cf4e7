#include "commands/undo.hpp"

#include <gtest/gtest.h>

#include <string>

namespace myo::ui::undo_stack {
namespace {

using Stack = commands::UndoStack<int>;

/// Undoes everything, and returns the values in the order in which they come back.
std::string undone(Stack& stack, int now) {
    std::string values;
    while (stack.can_undo()) values += std::to_string(now = stack.undo(now)) + " ";
    return values;
}

TEST(UndoStack, GivesTheNewestValueBackFirstAndRepeatsInOrder) {
    Stack stack;
    stack.record(0, "a", false);
    stack.record(1, "b", false);
    EXPECT_EQ(stack.undo(2), 1);
    EXPECT_EQ(stack.undo(1), 0);
    EXPECT_FALSE(stack.can_undo());
    EXPECT_EQ(stack.redo(0), 1);
    EXPECT_EQ(stack.redo(1), 2);
    EXPECT_FALSE(stack.can_redo());
    EXPECT_EQ(undone(stack, 2), "1 0 ");
}

TEST(UndoStack, WithoutAnEntryTheValueStays) {
    Stack stack;
    EXPECT_EQ(stack.undo(7), 7);
    EXPECT_EQ(stack.redo(7), 7);
    EXPECT_FALSE(stack.can_undo());
    EXPECT_FALSE(stack.can_redo()) << "an undo that did nothing leaves nothing to repeat";
}

TEST(UndoStack, ADragIsOneEntryWithTheValueBeforeIt) {
    Stack stack;
    stack.record(0, "modulus", false);
    stack.record(1, "modulus", true);
    stack.record(2, "modulus", true);
    EXPECT_EQ(undone(stack, 3), "0 ");
}

TEST(UndoStack, WhatOnlyLooksLikeADragIsAnEntryOfItsOwn) {
    // The next drag of the same field, and a drag of another field.
    Stack stack;
    stack.record(0, "modulus", false);
    stack.record(1, "modulus", false);
    stack.record(2, "density", true);
    EXPECT_EQ(undone(stack, 3), "2 1 0 ");
    // Nothing is there that it could continue.
    stack.clear();
    stack.record(4, "modulus", true);
    EXPECT_EQ(undone(stack, 5), "4 ");
    // A drag goes on over an undo: the entry before must not swallow it.
    stack.clear();
    stack.record(0, "modulus", false);
    stack.record(1, "modulus", false);
    EXPECT_EQ(stack.undo(2), 1);
    stack.record(1, "modulus", true);
    EXPECT_EQ(undone(stack, 3), "1 0 ");
}

TEST(UndoStack, ANewEditDropsWhatCouldBeRepeatedAlsoInADrag) {
    Stack stack;
    stack.record(0, "a", false);
    stack.record(1, "b", false);
    stack.undo(2);
    ASSERT_TRUE(stack.can_redo());
    stack.record(1, "c", false);
    EXPECT_FALSE(stack.can_redo());
    stack.record(3, "c", true);
    EXPECT_FALSE(stack.can_redo());
    EXPECT_EQ(stack.redo(4), 4);
}

TEST(UndoStack, KeepsTheNewestTwoHundred) {
    Stack stack;
    for (int k = 0; k < 250; ++k) stack.record(k, "edit", false);
    int count = 0, value = 250;
    for (; stack.can_undo(); ++count) value = stack.undo(value);
    EXPECT_EQ(count, 200);
    EXPECT_EQ(value, 50);
    // All of them can be repeated.
    for (; stack.can_redo(); --count) value = stack.redo(value);
    EXPECT_EQ(count, 0);
    EXPECT_EQ(value, 250);
}

TEST(UndoStack, ClearedItBeginsAnew) {
    Stack stack;
    stack.record(0, "a", false);
    stack.record(1, "a", false);
    stack.undo(2);
    stack.clear();
    EXPECT_FALSE(stack.can_undo());
    EXPECT_FALSE(stack.can_redo());
}

}  // namespace
}  // namespace myo::ui::undo_stack
