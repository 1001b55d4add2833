#pragma once

#include "app/jobs/file_queue.h"
#include "io/archive/node_file.h"

#include <QObject>
#include <QStringList>

#include <functional>
#include <optional>

namespace angiopose::app {

/// The user's archives and what is kept of what they gave: one file for window and command line, read and written by a
/// worker.
class ArchiveList : public QObject {
    Q_OBJECT
public:
    using Change = std::function<core::Status(io::ArchiveSettings&)>;
    /// Gets why it could not be done; nothing where it was.
    using Answer = std::function<void(const std::optional<core::Message>& problem)>;

    explicit ArchiveList(QObject* parent = nullptr) : QObject(parent) {}

    void read();
    /// Of the file as it is then: others may have changed it meanwhile.
    void change(Change change, Answer answer = {});

    const io::ArchiveSettings& settings() const { return settings_; }
    QStringList names() const;
    std::optional<io::ArchiveNode> node(const QString& name) const;

signals:
    void changed();   ///< read, or written
    void failed(const QString& reason);   ///< to read

private:
    io::ArchiveSettings settings_;
    FileQueue files_;
};

}   // namespace angiopose::app
