// For the leak sanitizer: libraries stay loaded until the end, so that a leak of theirs is known by their name and
// leaks_of_libraries.supp can leave it out. Mesa unloads its drivers with the last window.
extern "C" int dlclose(void* /*library*/)
{
    return 0;
}
