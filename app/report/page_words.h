#pragma once

#include <QCoreApplication>

namespace angiopose::app::report {

/// Translation context of the report texts.
struct PageWords {
    Q_DECLARE_TR_FUNCTIONS(angiopose::app::CaseReport)
};

}   // namespace angiopose::app::report
