#pragma once

#include <QStringList>

namespace angiopose::app {

/// Name filters of the open dialog, all kinds first.
QStringList openFilters();

}   // namespace angiopose::app
