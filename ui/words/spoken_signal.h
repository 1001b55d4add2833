#pragma once

#include <QObject>

namespace angiopose::ui {

/// Tells all speakers of the program that their words are others now.
class SpokenSignal : public QObject {
    Q_OBJECT
public:
    static SpokenSignal& only()
    {
        static SpokenSignal signal;
        return signal;
    }

signals:
    void again();
};

}   // namespace angiopose::ui