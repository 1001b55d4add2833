#pragma once

#include "app/jobs/file_queue.h"
#include "io/archive/node_file.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <optional>

namespace angiopose::app {

/// List of the user's archives and the archive settings (cache folder and limits). The window and the command line
/// share one file, which is read and written on a worker thread.
class ArchiveList : public QObject {
    Q_OBJECT
public:
    using Change = std::function<core::Status(io::ArchiveSettings&)>;
    /// Receives the reason for a failure, or nullopt on success.
    using Callback = std::function<void(const std::optional<core::Message>& problem)>;

    explicit ArchiveList(QObject* parent = nullptr) : QObject(parent) {}

    void read();
    /// Applies the change to the file as it is now, since another process may have modified it.
    void change(Change change, Callback callback = {});

    const io::ArchiveSettings& settings() const { return settings_; }
    QStringList names() const;
    std::optional<io::ArchiveNode> node(const QString& name) const;

signals:
    void changed();   ///< emitted after the list was read or written
    void failed(const QString& reason);   ///< emitted when the file cannot be read

private:
    io::ArchiveSettings settings_;
    FileQueue files_;
};

}   // namespace angiopose::app
