#include "app/window_host.h"

#include "ui/views/tree_view.h"

namespace angiopose::app {

WindowHost::WindowHost() : controller_(window_)
{
    styleSheetSuspension_.reset();
    window_.treeView().warmUp();
    window_.show();
}

}   // namespace angiopose::app
