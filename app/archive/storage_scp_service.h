#pragma once

#include "app/jobs/job.h"
#include "io/archive/dimse/storage_scp.h"
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

/// Storage SCP that receives objects from other nodes into the cache. Off until switched on; stops when this object is
/// destroyed.
class StorageScpService : public QObject {
    Q_OBJECT
public:
    struct Request {
        io::StorageScpOptions options;
        std::string folder;
        std::uint64_t maxBytes = 0;
    };
    /// Objects received since the SCP was switched on.
    struct ReceivedObjects {
        std::size_t objects = 0;
        std::set<std::string> folders;   ///< folders of the series
        std::optional<core::Message>
            problem;   ///< latest problem: a rejected association or an object that was not stored
        std::optional<core::Message> auditFailed;   ///< reason why some objects are missing from the audit file
    };

    explicit StorageScpService(QObject* parent = nullptr);

    void open(const Request& request);
    void close();   ///< returns at once; `closed` is emitted when the SCP has stopped
    bool isOpen() const { return job_.isRunning(); }
    const ReceivedObjects& received() const { return received_; }
    int port() const { return port_; }
    QStringList folders() const;   ///< folders of the received series

signals:
    void changed();   ///< emitted when objects were received
    void closed(const QString& problem);   ///< `problem` is empty if the user stopped the SCP
    void auditFailed(const QString& reason);   ///< emitted once when received objects are missing from the audit file

private:
    void addReceived(const ReceivedObjects& received);

    int port_ = 0;
    ReceivedObjects received_;
    Job<io::TransferReport, ReceivedObjects> job_;
};

/// Builds the storage SCP options from the port, the AE title and the stored access and TLS settings.
io::StorageScpOptions receiverOptions(int port, const QString& title);

/// Asks the user for the access and TLS settings of the storage SCP and stores them.
class StorageScpSecurity : public QObject {
    Q_OBJECT
public:
    explicit StorageScpSecurity(QWidget& dialogParent, QObject* parent = nullptr);

    void openDialog();

private:
    void save(const ui::ScpSettings& entry);

    QWidget& dialogParent_;
    QPointer<ui::PortDialog> dialog_;
};

}   // namespace angiopose::app
