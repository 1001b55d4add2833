#pragma once

#include "app/editing/angiogram_parts.h"

#include <QObject>
#include <QPointer>

namespace angiopose::ui {
class OpacificationPlot;
}

namespace angiopose::app {

/// Opens the large plot of opacification over time and keeps it up to date.
class OpacificationController : public QObject {
    Q_OBJECT
public:
    explicit OpacificationController(const AngiogramParts& parts, QObject* parent = nullptr);

private:
    void open();
    void show();

    CaseDocument& document_;
    ViewSync& sync_;
    ui::BottomStrip& strip_;
    QWidget& dialogParent_;
    QPointer<ui::OpacificationPlot> plot_;
};

}   // namespace angiopose::app
