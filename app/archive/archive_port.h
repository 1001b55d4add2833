#pragma once

#include "app/jobs/job.h"
#include "io/archive/dimse/receiver.h"
#include "ui/archive/archive_rows.h"

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <optional>
#include <set>
#include <string>

namespace angiopose::ui {
class PortDialog;
}   // namespace angiopose::ui

namespace angiopose::app {

/// A port to which others push objects, into the cache. Off until switched on; it goes with this.
class ArchivePort : public QObject {
    Q_OBJECT
public:
    struct Request {
        io::ReceiverOptions options;
        std::string folder;
        std::uint64_t maxBytes = 0;
    };
    /// What came since it was switched on.
    struct Arrived {
        std::size_t objects = 0;
        std::set<std::string> folders;   ///< of the series
        std::optional<core::Message> problem;   ///< the last one: a caller turned away, an object not kept
        std::optional<core::Message> unaudited;   ///< why the audit file lacks some of them
    };

    explicit ArchivePort(QObject* parent = nullptr);

    void open(const Request& request);
    void close();   ///< returns at once; `closed` follows
    bool isOpen() const { return job_.isRunning(); }
    const Arrived& arrived() const { return arrived_; }
    int port() const { return port_; }
    QStringList folders() const;   ///< of the series that came

signals:
    void changed();   ///< something came
    void closed(const QString& problem);   ///< empty: as wished
    void unaudited(const QString& reason);   ///< what came is not in the audit file; once

private:
    void take(const Arrived& arrived);

    int port_ = 0;
    Arrived arrived_;
    Job<io::TransferReport, Arrived> job_;
};

/// Who may push to our port and how, as it was entered last.
io::ReceiverOptions receiverOptions(int port, const QString& title);

/// Asks for that, and remembers it.
class PortSecurity : public QObject {
    Q_OBJECT
public:
    explicit PortSecurity(QWidget& dialogParent, QObject* parent = nullptr);

    void ask();

private:
    void save(const ui::PortEntry& entry);

    QWidget& dialogParent_;
    QPointer<ui::PortDialog> dialog_;
};

}   // namespace angiopose::app
