# Writes one C++ file that holds the pages of FOLDER that the window shows. Called as cmake -DOUTPUT=... -DFOLDER=... -P.
set(text "#include \"help/manual_pages.hpp\"\n\nnamespace myo::ui::help {\n\n")
string(APPEND text "std::string_view manual_text(std::string_view name) {\n")
foreach(name ${PAGES})
  file(READ ${FOLDER}/${name}.md content)
  string(APPEND text "    if (name == \"${name}\") {\n        return R\"manual(${content})manual\";\n    }\n")
endforeach()
string(APPEND text "    return {};\n}\n\n}  // namespace myo::ui::help\n")
file(WRITE ${OUTPUT} "${text}")
