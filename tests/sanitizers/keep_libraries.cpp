// For the leak sanitizer: keeps libraries loaded until the end, so that their leaks are reported with their names and
// leaks_of_libraries.supp can suppress them. Mesa unloads its drivers with the last window.
extern "C" int dlclose(void* /*library*/)
{
    return 0;
}
