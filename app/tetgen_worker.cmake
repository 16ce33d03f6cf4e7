# TetGen aborts on bad surfaces, may never return and is not safe in threads: it runs in a process of its own.
add_executable(myoloop-tetgen ${CMAKE_CURRENT_LIST_DIR}/tetgen_worker.cpp)
target_include_directories(myoloop-tetgen PRIVATE ${CMAKE_CURRENT_LIST_DIR}/../core)
target_link_libraries(myoloop-tetgen PRIVATE myoloop_tetgen myoloop_flags)
if(MYOLOOP_SANITIZE)
  target_compile_definitions(myoloop-tetgen PRIVATE MYOLOOP_SANITIZED)
endif()
set_target_properties(myoloop-tetgen PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
install(TARGETS myoloop-tetgen RUNTIME DESTINATION bin)
