#pragma once

#include "commands/backend.hpp"

namespace myo::test {

/// Gives a meshed body the chamber "bladder" and the tendon "thread" along its upper edge.
inline void add_bladder_and_thread(ui::commands::MeshedBody& body) {
    ui::commands::ShownChamber chamber;
    chamber.name = "bladder";
    body.actuators.chambers = {chamber};
    ui::commands::ShownTendon thread;
    thread.name = "thread";
    thread.guides.resize(2);
    thread.guides[1].rest_m = {0.1, 0.015, 0.03};
    body.actuators.tendons = {thread};
}

}  // namespace myo::test
