#pragma once

#include "app/jobs/file_queue.h"
#include "io/archive/node_file.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <optional>

namespace angiopose::app {

/// List of the user's archives and the archive settings (cache folder and limits). The window and the command line
/// share one file, which a worker reads and writes.
class ArchiveList : public QObject {
    Q_OBJECT
public:
    using Change = std::function<core::Status(io::ArchiveSettings&)>;
    /// Receives the reason for a failure, or nothing on success.
    using Callback = std::function<void(const std::optional<core::Message>& problem)>;

    explicit ArchiveList(QObject* parent = nullptr) : QObject(parent) {}

    void read();
    /// Applies the change to the file's current content, which another process may have modified in the meantime.
    void change(Change change, Callback answer = {});

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
