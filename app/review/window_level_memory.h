#pragma once

#include "app/document/case_document.h"
#include "core/imaging/display_range.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <memory>
#include <optional>

namespace angiopose::ui {
class AngiogramView;
}   // namespace angiopose::ui

namespace angiopose::app {

/// Remembers the window/level of each series and restores it when the series is opened again. Images of other series
/// start with the automatic window/level of their peak-opacification frame.
class WindowLevelMemory : public QObject {
    Q_OBJECT
public:
    WindowLevelMemory(const CaseDocument& document, ui::AngiogramView& view, QObject* parent = nullptr);
    ~WindowLevelMemory() override;

    std::optional<core::DisplayRange> rangeOf(const core::View& view) const;   ///< range to restore, if any
    void store(const core::View& view, double window, double level);

private:
    void updateFromDocument();
    void restore();
    void store(const QString& series, double window, double level);

    const CaseDocument& document_;
    ui::AngiogramView& view_;
    std::shared_ptr<const core::Angiogram> shownRun_;
    QString series_;   ///< key of the shown series; empty if the image has none
    QStringList entries_;   ///< entries "series window level", most recently used first
    QTimer storeTimer_;
};

}   // namespace angiopose::app
