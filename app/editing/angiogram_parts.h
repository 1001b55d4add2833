#pragma once

#include "app/document/case_document.h"
#include "app/registration/target_provider.h"
#include "app/showing/notifications.h"
#include "app/showing/view_sync.h"

class QWidget;

namespace angiopose::ui {
class AngiogramPanel;
class AngiogramView;
class BottomStrip;
class WindowActions;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Objects and parts of the window that the angiogram controllers use.
struct AngiogramParts {
    CaseDocument& document;
    TargetProvider& target;
    ViewSync& sync;
    Notifications& notifications;
    ui::WindowActions& actions;
    ui::AngiogramPanel& panel;
    ui::AngiogramView& view;
    ui::BottomStrip& strip;
    QWidget& dialogParent;
};

}   // namespace angiopose::app
