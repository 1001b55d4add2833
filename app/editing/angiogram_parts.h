#pragma once

#include "app/document/case_document.h"
#include "app/registration/target_provider.h"
#include "app/showing/notices.h"
#include "app/showing/view_sync.h"

namespace angiopose::app {

/// What the controllers of the angiogram work on.
struct AngiogramParts {
    CaseDocument& document;
    TargetProvider& target;
    ViewSync& sync;
    ui::MainWindow& window;
    Notices& notices;
};

}   // namespace angiopose::app