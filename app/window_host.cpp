#include "app/window_host.h"

namespace app {

WindowHost::WindowHost() : controller_(window_)
{
    window_.show();
}

}   // namespace app
