#pragma once

#include <QString>

namespace angiopose::app {

/// The audit file that is wished, by the environment or in the menu; empty: none.
QString auditPath();

}   // namespace angiopose::app
