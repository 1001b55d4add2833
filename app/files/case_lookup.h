#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <memory>
#include <string>

namespace angiopose::app {

enum class CasePresence { Present, Missing, InputsMissing };

/// What is known of a case in the list of recent ones.
struct CaseLook {
    CasePresence state = CasePresence::Present;
    std::string picture;   ///< content of its picture's file; empty: none
};

/// Whether the file of a case and its inputs are there, and its picture.
CaseLook lookAtCase(const std::string& casePath, const std::string& picturePath);

/// Looks after cases on threads of their own, one for each folder: a drive that does not answer keeps neither the
/// window nor the others waiting, and nobody waits for such a thread when the program ends.
class CaseLookup : public QObject {
    Q_OBJECT
public:
    using Look = std::function<CaseLook(const std::string& casePath, const std::string& picturePath)>;
    explicit CaseLookup(Look look, QObject* parent = nullptr);
    ~CaseLookup() override;

    /// A case that is looked after already is looked after once more when that is done.
    void look(const QStringList& paths);

signals:
    void found(const QString& path, const CaseLook& look);
    void told();   ///< for now all that was found

private:
    struct Shared;
    void publish();

    Look look_;
    std::shared_ptr<Shared> shared_;
    QTimer poll_;
};

}   // namespace angiopose::app
