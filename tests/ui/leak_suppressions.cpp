// Mesa keeps a little memory when an OSMesa context is destroyed; leaks of our own are still reported.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa\n"; }
