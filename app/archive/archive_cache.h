#pragma once

#include "app/archive/archive_list.h"
#include "app/jobs/job.h"

#include <QObject>

namespace angiopose::ui {
class CacheLine;
class TransferLine;
}   // namespace angiopose::ui

namespace angiopose::app {

/// What the cache holds and may hold: shown, limited, emptied.
class ArchiveCache : public QObject {
    Q_OBJECT
public:
    /// What of the dialog it serves.
    struct Ui {
        ui::CacheLine& line;
        ui::TransferLine& words;
        QWidget& dialog;
    };
    ArchiveCache(ArchiveList& list, const Ui& ui, QObject* parent = nullptr);

    void measure();   ///< and show it

private:
    void limit(double gigabytes);
    void setLimit(std::uint64_t bytes);
    void askDropping(std::uint64_t bytes);
    void askEmptying();
    void empty();

    ArchiveList& list_;
    Ui ui_;
    std::uint64_t held_ = 0;   ///< bytes
    Job<std::uint64_t> measuring_;
    Job<std::size_t> emptying_;
};

}   // namespace angiopose::app
